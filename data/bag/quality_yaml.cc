#include "data/bag/quality_yaml.h"

#include <limits>
#include <sstream>

#include "fields/base/config.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

// rmw/types.h
constexpr int keep_last = 1;
constexpr int reliable = 1;
constexpr int best_effort = 2;
constexpr int transient_local = 1;
constexpr int volatile_durability = 2;
constexpr int automatic = 1;

std::string forever(const std::string& key) {
  // RMW_DURATION_INFINITE: 2^63 - 1 nanoseconds.
  return "  " + key + ":\n    sec: 9223372036\n    nsec: 854775807\n";
}

Quality parsed(const std::string& yaml) {
  // Configurations are mappings: the list goes below a key.
  std::istringstream lines(yaml);
  std::string text = "profiles:\n";
  for (std::string line; std::getline(lines, line);) text += " " + line + "\n";
  const auto profiles = Config::parse(text, "offered_qos_profiles").children("profiles");
  Quality quality;
  if (profiles.empty()) return quality;
  const std::string is = profiles.front().optional_text("reliability").value_or("");
  quality.is_reliable = is != std::to_string(best_effort) && is != "best_effort";
  const std::string lasts = profiles.front().optional_text("durability").value_or("");
  quality.is_transient_local =
      lasts == std::to_string(transient_local) || lasts == "transient_local";
  quality.depth =
      profiles.front().optional_integer("depth", 0, std::numeric_limits<int>::max()).value_or(0);
  return quality;
}

}  // namespace

std::string yaml_of(const Quality& quality) {
  return "- history: " + std::to_string(keep_last) + "\n  depth: " + std::to_string(quality.depth) +
         "\n  reliability: " + std::to_string(quality.is_reliable ? reliable : best_effort) +
         "\n  durability: " +
         std::to_string(quality.is_transient_local ? transient_local : volatile_durability) + "\n" +
         forever("deadline") + forever("lifespan") + "  liveliness: " + std::to_string(automatic) +
         "\n" + forever("liveliness_lease_duration") + "  avoid_ros_namespace_conventions: false\n";
}

Quality quality_of(const std::string& yaml) {
  if (yaml.empty()) return {};
  try {
    return parsed(yaml);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace slackwater::bag
