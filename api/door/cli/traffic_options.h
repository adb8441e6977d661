#pragma once
#include <string>

#include "api/ask/traffic/traffic_rule.h"

namespace CLI {
class App;
}

namespace slackwater::api {

/// Limits of closest approach that somebody says in place of the rule's.
struct AlarmWords {
  double cpa_m = 0;  ///< 0: nobody says
  std::string tcpa;
};

void add_alarm_options(CLI::App& command, AlarmWords& words);

/// `data/traffic/rule.yaml`, with the limits that were said. @throws Error(usage)
[[nodiscard]] TrafficRule traffic_rule(const AlarmWords& words);

}  // namespace slackwater::api
