#include <string>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/control/autopilot.h"

namespace slackwater::twin {
namespace {

using constants::degree;

double read(const Config& config, std::string_view key, Range range, double absent) {
  return config.optional_number(key, range).value_or(absent);
}

void expect_slower(const Config& config, std::string_view key, double period_s, double than_s,
                   const char* why) {
  if (period_s >= than_s) return;
  config.refuse(key, formatted("found {:g} s, expected at least {:g} s: ", period_s, than_s) + why);
}

void expect_stable(const Config& config, VehicleKind kind, const AutopilotSettings& s,
                   double largest_step_s) {
  const double fastest_s = 20 * largest_step_s;
  constexpr auto step = "a loop needs some twenty steps (largest_step_s) in its period";
  expect_slower(config, "horizontal_period_s", s.horizontal_period_s, fastest_s, step);
  expect_slower(config, "vertical_period_s", s.vertical_period_s, fastest_s, step);
  expect_slower(config, "heading_period_s", s.heading_period_s, fastest_s, step);
  expect_slower(config, "tilt_period_s", s.tilt_period_s, fastest_s, step);
  if (kind == VehicleKind::uav)
    expect_slower(config, "horizontal_period_s", s.horizontal_period_s, 3 * s.tilt_period_s,
                  "a multirotor moves by its tilt, which must be settled much sooner "
                  "(3 tilt_period_s)");
  if (kind == VehicleKind::auv) {
    expect_slower(config, "vertical_period_s", s.vertical_period_s, 2 * s.tilt_period_s,
                  "an auv dives by its pitch, which must be settled sooner (2 tilt_period_s)");
    if (s.most_speed_m_s > 0 && s.least_speed_m_s > s.most_speed_m_s)
      config.refuse("least_speed_m_s",
                    formatted("found {:g} m/s, more than most_speed_m_s, {:g} m/s",
                              s.least_speed_m_s, s.most_speed_m_s));
  }
}

}  // namespace

AutopilotSettings default_autopilot(VehicleKind kind) noexcept {
  AutopilotSettings s;
  s.damping_ratio = 0.9;
  switch (kind) {
    case VehicleKind::rov:
      // Slower than thrusters of 0.2 s lag by an order of magnitude, but for the tilt, see
      // steer_free.cc.
      s.horizontal_period_s = 6;
      s.vertical_period_s = 5;
      s.heading_period_s = 4;
      s.tilt_period_s = 1.5;
      s.most_acceleration_m_s2 = 0.5;
      s.most_climb_m_s = s.most_descent_m_s = 0.5;
      s.most_yaw_rate_rad_s = 45 * degree;
      break;
    case VehicleKind::auv:
      s.horizontal_period_s = 30;
      s.vertical_period_s = 40;
      s.heading_period_s = 20;
      s.tilt_period_s = 15;
      s.most_acceleration_m_s2 = 0.05;
      s.most_climb_m_s = s.most_descent_m_s = 0.3;
      s.most_yaw_rate_rad_s = 3 * degree;
      s.most_tilt_rad = 20 * degree;
      s.least_speed_m_s = 0.3;
      s.holding_radius_m = 30;
      break;
    case VehicleKind::uav:
      // PX4 1.14: MPC_XY_VEL_MAX 12, MPC_Z_VEL_MAX_UP 3, _DN 1.5 m/s, MPC_ACC_HOR 3 m/s2,
      // MPC_TILTMAX_AIR 45 degrees; loops of about its MPC_XY_P 0.95, MPC_Z_P 1, MC_ROLL_P 6.5 per
      // s.
      s.horizontal_period_s = 3.7;
      s.vertical_period_s = 3.5;
      s.heading_period_s = 2;
      s.tilt_period_s = 0.6;
      s.most_speed_m_s = 12;
      s.most_acceleration_m_s2 = 3;
      s.most_climb_m_s = 3;
      s.most_descent_m_s = 1.5;
      s.most_yaw_rate_rad_s = 60 * degree;
      s.most_tilt_rad = 45 * degree;
      break;
    case VehicleKind::usv:
      s.horizontal_period_s = 15;
      s.vertical_period_s = 10;
      s.heading_period_s = 8;
      s.tilt_period_s = 10;
      s.most_acceleration_m_s2 = 0.3;
      s.most_yaw_rate_rad_s = 20 * degree;
      break;
    case VehicleKind::vessel:
      s.horizontal_period_s = 40;
      s.vertical_period_s = 30;
      s.heading_period_s = 20;
      s.tilt_period_s = 30;
      s.most_acceleration_m_s2 = 0.3;
      s.most_yaw_rate_rad_s = 5 * degree;
      break;
  }
  return s;
}

AutopilotSettings read_autopilot(const Config& vehicle, VehicleKind kind, double largest_step_s) {
  AutopilotSettings s = default_autopilot(kind);
  const auto c = vehicle.optional_child("autopilot");
  if (!c) {
    expect_stable(vehicle, kind, s, largest_step_s);
    return s;
  }
  const Range period{0.05, 1000};
  s.horizontal_period_s = read(*c, "horizontal_period_s", period, s.horizontal_period_s);
  s.vertical_period_s = read(*c, "vertical_period_s", period, s.vertical_period_s);
  s.heading_period_s = read(*c, "heading_period_s", period, s.heading_period_s);
  s.tilt_period_s = read(*c, "tilt_period_s", period, s.tilt_period_s);
  s.damping_ratio = read(*c, "damping_ratio", {0.5, 2}, s.damping_ratio);
  s.most_speed_m_s = read(*c, "most_speed_m_s", {0.05, 60}, s.most_speed_m_s);
  s.most_acceleration_m_s2 =
      read(*c, "most_acceleration_m_s2", {0.001, 20}, s.most_acceleration_m_s2);
  s.most_yaw_rate_rad_s =
      degree * read(*c, "most_yaw_rate_deg_s", {0.1, 360}, s.most_yaw_rate_rad_s / degree);
  // A key that means nothing to a kind is not asked for, and so refused.
  const bool floats = kind == VehicleKind::usv || kind == VehicleKind::vessel;
  if (!floats) {
    s.most_climb_m_s = read(*c, "most_climb_m_s", {0.01, 20}, s.most_climb_m_s);
    s.most_descent_m_s = read(*c, "most_descent_m_s", {0.01, 20}, s.most_descent_m_s);
  }
  if (kind == VehicleKind::uav || kind == VehicleKind::auv)
    s.most_tilt_rad = degree * read(*c, "most_tilt_deg", {1, 60}, s.most_tilt_rad / degree);
  if (kind == VehicleKind::auv) {
    s.least_speed_m_s = read(*c, "least_speed_m_s", {0.01, 10}, s.least_speed_m_s);
    s.holding_radius_m = read(*c, "holding_radius_m", {1, 1000}, s.holding_radius_m);
  }
  s.current_feed_forward =
      c->optional_flag("current_feed_forward").value_or(s.current_feed_forward);
  expect_stable(*c, kind, s, largest_step_s);
  return s;
}

}  // namespace slackwater::twin
