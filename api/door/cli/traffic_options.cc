#include "api/door/cli/traffic_options.h"

#include <CLI/CLI.hpp>

#include "api/door/cli/command.h"
#include "api/program/paths.h"

namespace slackwater::api {

void add_alarm_options(CLI::App& command, AlarmWords& words) {
  command
      .add_option("--cpa", words.cpa_m,
                  "mark vessels that will pass nearer than so many metres (default 500)")
      ->check(CLI::Range(1.0, 100'000.0));
  command.add_option("--tcpa", words.tcpa, "and sooner than this (default 30min)");
}

TrafficRule traffic_rule(const AlarmWords& words) {
  TrafficRule rule = read_traffic_rule(data_folder() / "traffic" / "rule.yaml");
  if (words.cpa_m > 0) rule.alarm.distance_m = words.cpa_m;
  if (words.tcpa.empty()) return rule;
  const Duration tcpa = option_value("--tcpa", words.tcpa, parse_duration);
  if (tcpa <= Duration(0) || tcpa > std::chrono::hours(24))
    throw Error(ErrorKind::usage,
                "found --tcpa " + words.tcpa + ", expected up to 24h, e.g. 30min");
  rule.alarm.time_s = std::chrono::duration<double>(tcpa).count();
  return rule;
}

}  // namespace slackwater::api
