#pragma once
#include <algorithm>
#include <vector>

#include "tests/support/known_series_for_tests.h"

namespace slackwater::tests {

inline constexpr UtcDay day = std::chrono::year(2024) / 6 / 11;
inline constexpr UtcTime end_of_day = UtcTime(day) + std::chrono::days(1);

inline std::vector<UtcTime> stamps_to(int last_h, int first_h = 0) {
  std::vector<UtcTime> stamps;
  for (int h = first_h; h <= last_h; ++h) stamps.push_back(end_of_day + std::chrono::hours(h));
  return stamps;
}

/// Linear in time, so that interpolation in between is exact.
inline Horizontal rising(UtcTime time, double) {
  const double hour = hours_between(end_of_day, time);
  return {8 + 0.1 * hour, -3 + 0.05 * hour};
}

inline FlowForTests rising_plus(double more) {
  return [more](UtcTime time, double depth) { return rising(time, depth) + more; };
}

inline std::size_t count(const std::vector<DataStatus>& source, DataStatus status) {
  return static_cast<std::size_t>(std::count(source.begin(), source.end(), status));
}

/// Analysed to a day after D; forecasts that were issued before and after the end of D.
inline KnownSeriesForTests analysed_and_forecast() {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"),
           instants(end_of_day - std::chrono::days(4), end_of_day + std::chrono::days(1)), rising);
  const auto run = [&](int issued_h, double more) {
    const UtcTime issued = end_of_day + std::chrono::hours(issued_h);
    sea.wind(forecast_of("wind", issued), instants(issued, issued + std::chrono::days(4)),
             rising_plus(more));
  };
  run(-12, 1);
  run(-6, 2);
  run(6, 3);
  run(36, 4);
  return sea;
}

/// Of a run that takes over at an hour: how much of the difference to the one before is left.
inline double left_of_join(double hours_since) { return std::max(0.0, 1 - hours_since / 6); }

}  // namespace slackwater::tests
