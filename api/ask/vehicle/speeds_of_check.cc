#include "api/ask/vehicle/speeds_of_check.h"

#include <algorithm>
#include <cmath>

#include "twin/battery/lasts.h"
#include "twin/vehicle/cruise_power.h"
#include "twin/vehicle/own_autopilot.h"

namespace slackwater::api {
namespace {

using twin::Vehicle;
using twin::VehicleKind;

std::vector<double> asked_m_s(const Vehicle& vehicle, double top_m_s) {
  const double cruise_m_s = std::min(vehicle.cruise_speed_m_s, top_m_s);
  // An AUV goes no slower than its fins steer it.
  const double slow_m_s =
      vehicle.kind == VehicleKind::auv
          ? std::min(std::max(0.5 * cruise_m_s, vehicle.autopilot.least_speed_m_s), cruise_m_s)
          : 0.5 * cruise_m_s;
  std::vector<double> speeds{slow_m_s, cruise_m_s, 0.5 * (cruise_m_s + top_m_s), top_m_s};
  if (vehicle.kind == VehicleKind::uav) speeds.insert(speeds.begin(), 0.0);
  // A top speed that is hardly more than the cruise is the same row.
  std::vector<double> apart;
  for (const double speed_m_s : speeds)
    if (apart.empty() || speed_m_s > 1.02 * apart.back()) apart.push_back(speed_m_s);
  return apart;
}

AtSpeed at_speed(const Vehicle& vehicle, const twin::Autopilot& autopilot, double speed_m_s) {
  AtSpeed at;
  at.speed_m_s = speed_m_s;
  at.power_w = twin::cruise_power_w(vehicle, autopilot, twin::usual_voltage_v(vehicle), speed_m_s);
  if (vehicle.battery && at.power_w > 0) {
    at.lasts_s = twin::lasts_s(*vehicle.battery, at.power_w);
    at.range_m = speed_m_s * *at.lasts_s;
  }
  if (vehicle.kind == VehicleKind::uav) return at;
  at.modes = twin::plane_modes(vehicle, speed_m_s);
  at.course = twin::kept_course(vehicle, autopilot, speed_m_s);
  if (vehicle.kind == VehicleKind::auv)
    at.level = twin::level_flight(vehicle, speed_m_s, twin::balance_of(vehicle).net_buoyancy_n);
  return at;
}

}  // namespace

std::vector<AtSpeed> speeds_of_check(const Vehicle& vehicle, const twin::Autopilot& autopilot,
                                     double top_speed_m_s) {
  std::vector<AtSpeed> speeds;
  for (const double speed_m_s : asked_m_s(vehicle, top_speed_m_s)) {
    AtSpeed at = at_speed(vehicle, autopilot, speed_m_s);
    at.is_cruise = std::abs(speed_m_s / vehicle.cruise_speed_m_s - 1) < 1e-9;
    speeds.push_back(std::move(at));
  }
  speeds.back().is_top = speeds.back().speed_m_s > top_speed_m_s / 1.03;
  return speeds;
}

}  // namespace slackwater::api
