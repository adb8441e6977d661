#include "api/door/live/topics/sensor_asked.h"

#include <charconv>
#include <cmath>

#include "fields/base/error.h"

namespace slackwater::live {

SensorAsked sensor_asked(const std::string& text) {
  const std::size_t at = text.rfind('@');
  const std::size_t slash = text.rfind('/', at);
  SensorAsked asked;
  if (at != std::string::npos && slash != std::string::npos) {
    asked.vehicle = text.substr(0, slash);
    asked.sensor = text.substr(slash + 1, at - slash - 1);
    const char* const end = text.data() + text.size();
    const auto [rest, problem] = std::from_chars(text.data() + at + 1, end, asked.rate_hz);
    if (problem != std::errc() || rest != end) asked.rate_hz = 0;
  }
  if (asked.vehicle.empty() || asked.sensor.empty() || !std::isfinite(asked.rate_hz) ||
      asked.rate_hz <= 0)
    throw Error(ErrorKind::usage, "--see: found '" + text +
                                      "', expected VEHICLE/SENSOR@RATE with a rate above 0 Hz, as "
                                      "in rov/rov_camera@2");
  return asked;
}

}  // namespace slackwater::live
