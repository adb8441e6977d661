#pragma once
#include <string>

#include "api/ask/traffic/traffic_about.h"

namespace slackwater::api {

/// Some sentences: what is wrong with the logs, how many vessels there are, when traffic was heard
/// last.
[[nodiscard]] std::string traffic_in_words(const TrafficQuestion& question,
                                           const TrafficHeard& heard, const TrafficAnswer& answer);
/// For people: those sentences, and a line for each vessel.
[[nodiscard]] std::string traffic_text(const TrafficQuestion& question, const TrafficHeard& heard,
                                       const TrafficAnswer& answer);
/// "passes 210 m from T3 in 12 min", "goes away, past at 900 m from the site 4 min ago", "lies
/// 120 m from T3".
[[nodiscard]] std::string approach_words(const Approach& approach);

}  // namespace slackwater::api
