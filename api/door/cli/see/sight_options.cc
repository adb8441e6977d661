#include "api/door/cli/see/sight_options.h"

#include <CLI/CLI.hpp>

namespace slackwater::api {

void add_sight_options(CLI::App& command, SightChoice& sight) {
  command.add_option("--water", sight.water_type,
                     "how the water takes colours, a file in data/waters (default coastal_3)");
  command.add_option("--warmth", sight.warmth,
                     "how warm all is, to infrared, a file in data/warmth (default summer_day)");
  command.add_flag("--overcast", sight.is_overcast,
                   "no sun (default: a clear sky, the sun where it stood)");
}

}  // namespace slackwater::api
