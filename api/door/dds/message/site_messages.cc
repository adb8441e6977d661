#include "api/door/dds/message/site_messages.h"

#include <limits>

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/map_frame.h"
#include "api/door/dds/message/parts.h"
#include "api/door/dds/message/profile_message.h"
#include "fields/base/constants.h"
#include "rosgraph_msgs.h"

namespace slackwater::dds {
namespace {

using constants::nan;

Place place_of(const SiteWater& water, double vertical_m, UtcTime time) {
  return {water.point.longitude_deg(), water.point.latitude_deg(), vertical_m, time};
}

}  // namespace

Bytes clock(const Stamp& now) {
  rosgraph_msgs::msg::Clock message;
  message.clock(time_message(now));
  return encoded(message);
}

slackwater_msgs::msg::CurrentProfile profile_message(const SiteWater& water, UtcTime time,
                                                     const Stamp& stamp) {
  slackwater_msgs::msg::CurrentProfile message;
  const Snapshot& forecast = water.field.snapshot();
  message.header(header_message(stamp, map_frame));
  message.instance(forecast.site_id + " " + format_day(forecast.day) + " issued " +
                   format_utc(forecast.issued));
  message.latitude(water.point.latitude_deg());
  message.longitude(water.point.longitude_deg());
  std::vector<CurrentSample> central(forecast.depth_m.size()), own(forecast.depth_m.size());
  const double longitude = water.point.longitude_deg(), latitude = water.point.latitude_deg();
  water.field.sample_profile(longitude, latitude, time, forecast.depth_m, central);
  water.field.sample_profile(longitude, latitude, time, forecast.depth_m, own, water.member);
  for (std::size_t i = 0; i < central.size(); ++i) {
    if (!has_value(central[i].status) || !has_value(own[i].status)) continue;
    const CurrentQuantiles bounds = quantiles_of(central[i]);
    message.depth_m().push_back(forecast.depth_m[i]);
    message.east_m_s().push_back(own[i].velocity_m_s.real());
    message.north_m_s().push_back(own[i].velocity_m_s.imag());
    message.east_p10().push_back(bounds.p10_m_s.real());
    message.east_p90().push_back(bounds.p90_m_s.real());
    message.north_p10().push_back(bounds.p10_m_s.imag());
    message.north_p90().push_back(bounds.p90_m_s.imag());
  }
  return message;
}

Bytes current_profile(const SiteWater& water, UtcTime time, const Stamp& stamp) {
  return encoded(profile_message(water, time, stamp));
}

Bytes wind(const SiteWater& water, UtcTime time, const Stamp& stamp) {
  constexpr double height_m = 10;
  const Place place = place_of(water, height_m, time);
  WindSample sample;
  water.field.sample_wind({&place, 1}, {&sample, 1}, water.member);
  twin::Triple<double> towards{nan, nan, nan};
  if (has_value(sample.status))
    towards = {sample.velocity_m_s.real(), sample.velocity_m_s.imag(), 0};
  geometry_msgs::msg::Vector3Stamped message;
  message.header(header_message(stamp, map_frame));
  message.vector(xyz_message<geometry_msgs::msg::Vector3>(towards));
  return encoded(message);
}

Bytes wave(const SeaSample& sea, const Stamp& stamp) {
  const bool has = has_value(sea.status);
  slackwater_msgs::msg::SeaState message;
  message.header(header_message(stamp, map_frame));
  message.hs_m(has ? sea.sea.significant_height_m : nan);
  message.tp_s(has ? sea.sea.peak_period_s : nan);
  message.from_deg(has ? sea.sea.from_direction_deg : nan);
  return encoded(message);
}

Bytes tide_level(const SiteWater& water, UtcTime time) {
  const Place place = place_of(water, 0, time);
  SeaLevelSample sample;
  water.field.sample_sea_level({&place, 1}, {&sample, 1}, water.member);
  std_msgs::msg::Float64 message;
  message.data(has_value(sample.status) ? sample.level_m : nan);
  return encoded(message);
}

Bytes turbine_power(std::span<const double> power_w) {
  std_msgs::msg::Float64MultiArray message;
  std_msgs::msg::MultiArrayDimension turbines;
  turbines.label("turbine");
  turbines.size(static_cast<std::uint32_t>(power_w.size()));
  turbines.stride(turbines.size());
  message.layout().dim({turbines});
  message.data().assign(power_w.begin(), power_w.end());
  return encoded(message);
}

Bytes ais_target(const AisTarget& target, const Stamp& stamp) {
  slackwater_msgs::msg::AisTarget message;
  message.header(header_message(stamp, map_frame));
  message.mmsi(target.mmsi);
  message.name(target.name);
  message.latitude(target.point.latitude_deg());
  message.longitude(target.point.longitude_deg());
  message.sog_m_s(target.speed_m_s);
  message.cog_deg(target.course_deg);
  message.cpa_m(target.cpa_m);
  message.tcpa_s(target.tcpa_s);
  return encoded(message);
}

}  // namespace slackwater::dds
