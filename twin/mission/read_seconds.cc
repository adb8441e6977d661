#include "twin/mission/read_seconds.h"

#include <string>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/base/time.h"

namespace slackwater::twin {

bool has_seconds(const Config& config, std::string_view key) {
  return config.has(key) || config.has(std::string(key) + "_s");
}

double read_seconds(const Config& config, std::string_view key, Range range) {
  const std::string in_seconds = std::string(key) + "_s";
  if (config.has(in_seconds)) {
    if (config.has(key)) config.refuse(in_seconds, "found beside " + std::string(key));
    return config.number(in_seconds, range);
  }
  const std::string text = config.text(key);
  double value_s = 0;
  try {
    value_s = std::chrono::duration<double>(parse_duration(text)).count();
  } catch (const Error& problem) {
    config.refuse(key, problem.message());
  }
  if (!(value_s >= range.low && value_s <= range.high))
    config.refuse(key, formatted("found {}, expected {:g} to {:g} s", text, range.low, range.high));
  return value_s;
}

}  // namespace slackwater::twin
