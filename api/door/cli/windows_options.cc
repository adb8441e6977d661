#include "api/door/cli/windows_options.h"

#include <CLI/CLI.hpp>

namespace slackwater::api {
void add_windows_options(CLI::App& command, WindowsArguments& arguments) {
  command.add_option("--site", arguments.site, "id, or path of a site file")->required();
  command.add_option("--day", arguments.day,
                     "day D of the forecast (default: the one in force); starts are those of the "
                     "first full UTC day after its issue");
  command.add_option("--forecast", arguments.forecast, "a forecast's file instead of the store's");
  command.add_option("--task", arguments.tasks,
                     "id of data/tasks or a file, as often as wanted (default: the site's)");
  command.add_option("--turbine", arguments.turbines,
                     "where (default: the first that the task can be done at)");
  command.add_option("--from", arguments.from, "first start, UTC time");
  command.add_option("--to", arguments.to, "starts before this, UTC time");
  command.add_option("--every", arguments.every, "from one start to the next (default 30min)");
  command.add_option("--contingency", arguments.contingency,
                     "beyond the planned time, e.g. 1h (default: the task sheet's)");
  command.add_option("--members", arguments.members, "futures (default: all that were issued)")
      ->check(CLI::Range(1, 100000));
  command
      .add_option("--waves", arguments.waves,
                  "error: each future's waves err as forecasts do (default); forecast: all have "
                  "the forecast's")
      ->check(CLI::IsMember({"error", "forecast"}));
  command.add_option("--assume", arguments.assume,
                     "what no forecast serves, e.g. visibility_m=5000");
  command.add_option("--light", arguments.light,
                     "sun_up, civil or nautical: the task is done in that light");
  command.add_option(
      "--shift", arguments.shift,
      "06:00-18:00: the task is done in these hours (default: the site's, else all; 0-24 is all)");
  command.add_option(
      "--timezone,--zone", arguments.zone,
      "of the shift and the table, e.g. Europe/Paris (default: the site's, else UTC)");
  command.add_option("--alpha", arguments.alpha,
                     "FILE.yaml of factors for one variable, as often as wanted; errors: those of "
                     "wave heights, worked out from the site's wave forecasts (default of wave "
                     "heights: DNV-OS-H101 table 4-1)");
  command
      .add_option("--alpha-from", arguments.period_from,
                  "issue or start: from when the planned period of alpha counts (default issue)")
      ->check(CLI::IsMember({"issue", "start"}));
  command.add_option("--fly", arguments.fly,
                     "fly the starts that the limits leave open too, for so long at most, e.g. "
                     "15min: the twin's probability of success with its reserve");
  command.add_option("--fly-every", arguments.fly_every,
                     "time between the starts that are flown (default 1h)");
  command.add_option("--go", arguments.go, "P of a start that is a go (default 0.9)")
      ->check(CLI::Range(0.0, 1.0));
  command.add_option("--marginal", arguments.marginal, "P of a marginal one (default 0.5)")
      ->check(CLI::Range(0.0, 1.0));
  command.add_flag("--verdict-exit", arguments.verdict_exit,
                   "exit with 10 for go, 11 for marginal, 12 for no-go");
  command.add_option("--threads", arguments.threads, "1 to 64 (default: one a core)")
      ->check(CLI::Range(1, 64));
}

WindowsQuestion windows_question(const WindowsArguments& arguments, const Context& context) {
  return windows_question(arguments, WordsSaid{"--", context.store_folder, [&context] {
                                                 return context.time_of("--from", "now");
                                               }});
}

std::optional<FlyWindows> flights_wanted(const WindowsArguments& arguments) {
  if (arguments.fly.empty()) return std::nullopt;
  FlyWindows settings;
  settings.most_wall_s =
      std::chrono::duration<double>(positive_duration("--fly", arguments.fly)).count();
  settings.every = positive_duration("--fly-every", arguments.fly_every);
  return settings;
}

int exit_code_of(twin::Verdict verdict) noexcept { return 10 + static_cast<int>(verdict); }

}  // namespace slackwater::api
