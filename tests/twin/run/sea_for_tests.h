#pragma once
#include <vector>

#include "tests/twin/run/run_for_tests.h"
#include "twin/environment/made_up_field.h"

namespace slackwater::tests {

inline UtcTime sea_start() { return parse_utc("2025-06-02T06:00:00Z"); }

/// A forecast with these seas, one for each hour from the start on, everywhere the same, in water
/// of 40 m without a current. All members have its wind and water.
inline twin::Surround in_forecast_sea(const twin::Scenario& scenario,
                                      const std::vector<SeaState>& hourly,
                                      std::size_t members = 1) {
  twin::Surround surround;
  surround.data_folder = source_folder() / "data";
  surround.site = twin::origin_of(scenario, {});
  std::vector<UtcTime> times;
  for (std::size_t i = 0; i < hourly.size(); ++i)
    times.push_back(sea_start() + static_cast<int>(i) * std::chrono::hours(1));
  const std::vector<Horizontal> still(2 * times.size());
  const auto field = twin::made_up_field(times, {0, 40}, still, {0, 0}, surround.site, 40);
  auto snapshot = std::make_shared<Snapshot>(field->snapshot());
  snapshot->members = members;
  snapshot->seed = 11;
  for (ForecastColumn& column : snapshot->columns) {
    column.sea = hourly;
    for (std::size_t m = 1; m < members; ++m) {
      column.member_m_s.insert(column.member_m_s.end(), still.begin(), still.end());
      column.wind_member_m_s.resize(column.wind_member_m_s.size() + times.size());
    }
  }
  surround.field = std::make_shared<Field>(std::move(snapshot));
  return surround;
}

/// A scenario of made-up water whose waves are to be those of the forecast that it is put in.
inline twin::Scenario with_forecast_waves(const std::string& yaml, bool errs = false) {
  twin::Scenario scenario = twin::parse_scenario(yaml, "test.yaml");
  scenario.water = twin::ForecastWater{};
  scenario.waves.from_forecast = true;
  scenario.waves.have_height_errors = errs;
  return scenario;
}

}  // namespace slackwater::tests
