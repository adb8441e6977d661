#include "api/json/plot_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace slackwater::api {

using nlohmann::json;

json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value * 1e4) / 1e4;
}

json number(const std::optional<double>& value) { return value ? number(*value) : json(nullptr); }

json numbers(const std::vector<double>& values) {
  json out = json::array();
  for (const double value : values) out.push_back(number(value));
  return out;
}

json times(const std::vector<UtcTime>& values) {
  json out = json::array();
  for (const UtcTime value : values) out.push_back(value.time_since_epoch().count());
  return out;
}

json vectors(const std::vector<Horizontal>& values) {
  std::vector<double> east;
  std::vector<double> north;
  for (const Horizontal value : values) {
    east.push_back(value.real());
    north.push_back(value.imag());
  }
  return {{"east", numbers(east)}, {"north", numbers(north)}};
}

std::string script_safe(const json& value) {
  const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace slackwater::api
