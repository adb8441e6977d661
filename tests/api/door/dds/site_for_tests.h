#pragma once
#include "api/door/dds/message/site_messages.h"

namespace slackwater::tests {

/// A forecast of two levels of water above a bed at 40 m, a third below it; the same for eleven
/// hours.
struct SiteForTests {
  UtcTime time = parse_utc("2025-06-02T06:00:00Z");
  GeoPoint point = GeoPoint::from_degrees(48.5, -2.5);
  Field field{made()};

  [[nodiscard]] dds::SiteWater water() const { return {field, 0, point}; }

 private:
  static std::shared_ptr<const Snapshot> made() {
    constexpr std::size_t hours = 11;
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->site_id = "test";
    snapshot->day = parse_day("2025-06-01");
    snapshot->issued = parse_utc("2025-06-02T05:00:00Z");
    snapshot->depth_m = {0, 10, 50};
    ForecastColumn column;
    column.point = GeoPoint::from_degrees(48.5, -2.5);
    column.water_depth_m = 40;
    for (std::size_t i = 0; i < hours; ++i) {
      snapshot->time.push_back(parse_utc("2025-06-02T00:00:00Z") +
                               std::chrono::hours(static_cast<int>(i)));
      for (const Horizontal velocity_m_s :
           {Horizontal(0.5, -0.125), Horizontal(0.25, -0.25), Horizontal(0, 0)})
        column.current_m_s.push_back(velocity_m_s);
      column.current_sigma_m_s.insert(column.current_sigma_m_s.end(), 3, 0.125);
      for (const SampleStatus status :
           {SampleStatus::ok, SampleStatus::ok, SampleStatus::below_bed})
        column.current_status.push_back(status);
      column.wind_m_s.emplace_back(8, -2);
      column.wind_source.push_back(DataStatus::forecast);
      column.sea_level.level_m.push_back(1.25);
      column.sea_level.sigma_m.push_back(0.1);
      column.sea_level.source.push_back(DataStatus::forecast);
    }
    snapshot->columns.push_back(std::move(column));
    return snapshot;
  }
};

}  // namespace slackwater::tests
