#include "twin/environment/made_up_field.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

constexpr double half_width_deg = 0.25;

}  // namespace

std::shared_ptr<const Field> made_up_field(std::vector<UtcTime> times, std::vector<double> depths_m,
                                           const std::vector<Horizontal>& current,
                                           Horizontal wind_m_s, const GeoPoint& origin,
                                           double water_depth_m) {
  expects(current.size() == times.size() * depths_m.size(), "a current for each time and depth");
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->site_id = "made-up";
  snapshot->site_name = "made-up water";
  snapshot->day = day_of(times.front());
  snapshot->issued = times.front();
  snapshot->headline = "Made-up water.";
  snapshot->time = std::move(times);
  snapshot->depth_m = std::move(depths_m);
  const std::size_t values = current.size();
  for (const double north : {-half_width_deg, half_width_deg}) {
    for (const double east : {-half_width_deg, half_width_deg}) {
      ForecastColumn column;
      column.point = GeoPoint::from_degrees(std::clamp(origin.latitude_deg() + north, -90.0, 90.0),
                                            origin.longitude_deg() + east);
      column.water_depth_m = water_depth_m;
      column.water_depth_source = "site";
      column.current_m_s = current;
      column.current_sigma_m_s.assign(values, 0);
      column.current_status.assign(values, SampleStatus::ok);
      column.wind_m_s.assign(snapshot->time.size(), wind_m_s);
      column.wind_source.assign(snapshot->time.size(), DataStatus::modelled);
      snapshot->columns.push_back(std::move(column));
    }
  }
  return std::make_shared<Field>(std::move(snapshot));
}

std::shared_ptr<const Field> made_up_field(const MadeUpWater& water, const GeoPoint& origin,
                                           UtcTime from, UtcTime to) {
  std::vector<double> depths_m;
  std::vector<Horizontal> profile;
  for (const MadeUpLevel& level : water.current) {
    depths_m.push_back(level.depth_m);
    profile.emplace_back(level.east_m_s, level.north_m_s);
  }
  if (depths_m.empty()) {
    depths_m.push_back(0);
    profile.emplace_back(0, 0);
  }
  // Two stamps, however short the run, and the second not before its end.
  const std::vector<UtcTime> times{from, std::max(to, from + std::chrono::hours(1))};
  std::vector<Horizontal> current = profile;
  current.insert(current.end(), profile.begin(), profile.end());
  return made_up_field(times, depths_m, current,
                       vector_from_direction(water.wind_speed_m_s, water.wind_from_deg), origin,
                       water.depth_m);
}

}  // namespace slackwater::twin
