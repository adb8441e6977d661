#pragma once
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "fields/service/snapshot.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::tests {

/// A forecast of the currents of one column whose error everybody knows: hourly over a horizon, on
/// these levels, without wind or waves; NaN: no value there.
[[nodiscard]] inline Snapshot forecast_of_known_error(const std::string& site, UtcDay day,
                                                      UtcTime issued, const GeoPoint& point,
                                                      const std::vector<double>& depth_m,
                                                      const FlowForTests& flow, int hours = 24) {
  Snapshot s;
  s.site_id = s.site_name = site;
  s.day = day;
  s.issued = issued;
  s.wind_policy = WindPolicy::best;
  s.headline = "Made up.";
  s.depth_m = depth_m;
  ForecastColumn column;
  column.point = point;
  column.water_depth_m = 30;
  column.water_depth_source = "site";
  for (int t = 0; t <= hours; ++t) {
    s.time.push_back(UtcTime(day) + std::chrono::hours(24 + t));
    for (const double depth : depth_m) {
      const Horizontal value = flow(s.time.back(), depth);
      const bool there = !std::isnan(value.real());
      column.current_m_s.push_back(there ? value : Horizontal{});
      column.current_sigma_m_s.push_back(there ? 0.1 : 0.0);
      column.current_status.push_back(there ? SampleStatus::ok : SampleStatus::missing);
    }
  }
  s.columns.push_back(std::move(column));
  return s;
}

}  // namespace slackwater::tests
