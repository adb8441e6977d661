#pragma once
#include <string>

namespace slackwater::api {

/// How one sees, beyond what a run's scenario states.
struct SightChoice {
  std::string water_type = "coastal_3";  ///< of data/waters: how the water takes colours
  std::string warmth = "summer_day";     ///< of data/warmth: how warm all is, to infrared
  bool is_overcast = false;              ///< no sun; else a clear sky, and the sun where it stood
};

}  // namespace slackwater::api
