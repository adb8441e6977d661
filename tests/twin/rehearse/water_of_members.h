#pragma once
#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests {

/// Speeds of an eastward current hour by hour: of the forecast first, then of its members 1, 2, ...
using HourlySpeeds = std::vector<std::vector<double>>;

/// Made-up water of a scenario as a forecast with members, the same at all depths.
inline twin::Surround water_of_members(const twin::Scenario& mission, const HourlySpeeds& speeds,
                                       UtcTime from) {
  const std::size_t stamps = speeds.front().size();
  twin::Surround surround = surround_of(mission);
  surround.field =
      twin::made_up_field(std::get<twin::MadeUpWater>(mission.water), surround.site, from,
                          from + std::chrono::hours(static_cast<int>(stamps) - 1));
  auto snapshot = std::make_shared<Snapshot>(surround.field->snapshot());
  snapshot->members = speeds.size();
  const std::size_t levels = snapshot->depth_m.size();
  snapshot->time.clear();
  for (std::size_t i = 0; i < stamps; ++i)
    snapshot->time.push_back(from + std::chrono::hours(static_cast<int>(i)));
  const auto hourly = [](auto& values, std::size_t size) {
    if (!values.empty()) values.assign(size, values.front());
  };
  for (ForecastColumn& column : snapshot->columns) {
    hourly(column.current_m_s, levels * stamps);
    hourly(column.current_sigma_m_s, levels * stamps);
    hourly(column.current_status, levels * stamps);
    hourly(column.wind_m_s, stamps);
    hourly(column.wind_source, stamps);
    hourly(column.sea, stamps);
    hourly(column.sea_source, stamps);
    for (std::size_t i = 0; i < column.current_m_s.size(); ++i)
      column.current_m_s[i] = speeds[0][i / levels];
    for (std::size_t f = 1; f < speeds.size(); ++f)
      for (std::size_t i = 0; i < column.current_m_s.size(); ++i)
        column.member_m_s.emplace_back(speeds[f][i / levels]);
  }
  surround.field = std::make_shared<Field>(std::move(snapshot));
  return surround;
}

}  // namespace slackwater::tests
