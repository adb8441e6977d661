#include "api/show/rehearse/run_clock.h"

#include <cmath>

namespace slackwater::api {

std::string time_of_day(UtcTime start, double t_s) {
  constexpr std::size_t date = 11, length = 8;  // 2025-06-01T, 18:42:14
  const auto whole = Duration(static_cast<Duration::rep>(std::floor(t_s)) * 1000);
  return format_utc(start + whole).substr(date, length);
}

std::string minute_of_day(UtcTime start, double t_s) {
  return time_of_day(start, t_s).substr(0, 5);
}

}  // namespace slackwater::api
