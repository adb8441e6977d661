#include "twin/handling/kept_course.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "twin/step/command_thrusters.h"
#include "twin/step/vehicle_step.h"
#include "twin/vehicle/own_autopilot.h"

namespace slackwater::twin {
namespace {

using constants::degree;

constexpr double deep_m = 1000;  // nothing of the surface is felt there, nor of the bed

/// From the least to the greatest.
struct Swing {
  double least = 1e9, greatest = -1e9;
  void note(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  [[nodiscard]] double size() const { return std::max(greatest - least, 0.0); }
};

double slowest_s(const AutopilotSettings& s) {
  return std::max(
      {s.heading_period_s, s.vertical_period_s, s.tilt_period_s, s.horizontal_period_s});
}
double flight_s(const AutopilotSettings& s) {
  constexpr double periods = 12, least_s = 60, most_s = 600;
  return std::clamp(periods * slowest_s(s), least_s, most_s);
}

/// Upright and a number.
bool is_upright(const BodyState<double>& body) { return rotation_of(body.attitude).down.z > 0; }

}  // namespace

KeptCourse kept_course(const Vehicle& vehicle, const Autopilot& autopilot, double speed_m_s) {
  expects(vehicle.kind != VehicleKind::uav, "a multirotor has no course to keep");
  const Body& craft = vehicle.body;
  const bool floats = craft.hull.strips > 0;
  const double voltage_v = usual_voltage_v(vehicle);
  const StepPlan plan = plan_step(vehicle, vehicle.largest_step_s, voltage_v);
  const double depth_m =
      floats ? floating_depth_m(craft.hull, craft.mass_kg, craft.fluid_density_kg_m3) : deep_m;
  constexpr double begins_off_rad = 10 * degree;
  VehicleState<double> state = placed(vehicle, {0, 0, depth_m}, begins_off_rad);
  state.bus_voltage_v = voltage_v;
  state.body.nu.linear.x = speed_m_s;

  Reference reference;
  reference.target = Target::cruise;
  reference.position_m.z = depth_m;
  reference.velocity_m_s.x = speed_m_s;
  ControlState control;
  VehicleCommand<double> command;
  Surroundings<double> around;
  around.height_above_m = floats ? 0 : -deep_m;

  KeptCourse out;
  out.speed_m_s = speed_m_s;
  out.lasts_s = flight_s(autopilot.settings);
  const int steps = static_cast<int>(std::ceil(out.lasts_s / plan.dt_s));
  Swing heading, pitch;
  double sum_m_s = 0;
  int judged = 0;
  for (int i = 0; i < steps; ++i) {
    const BodyState<double>& body = state.body;
    Measured measured;
    measured.position_m = body.position_m;
    measured.attitude = body.attitude;
    measured.nu = body.nu;
    measured.log_m_s = body.nu.linear.x;
    measured.altitude_m = deep_m;
    const Effort effort = effort_of(autopilot, measured, reference, plan.dt_s, control);
    command_effort(vehicle, effort, {body.nu.linear, voltage_v, around.height_above_m}, command);
    step(vehicle, plan, state, command, around);
    if (!is_upright(state.body)) {
      out.over_at_s = (i + 1) * plan.dt_s;
      break;
    }
    if (2 * i < steps) continue;
    const EulerAngles angles = euler_angles(state.body.attitude);
    heading.note(angles.yaw_rad);
    pitch.note(angles.pitch_rad);
    out.heading_off_rad = std::max(out.heading_off_rad, std::abs(angles.yaw_rad));
    if (!floats)
      out.depth_off_m = std::max(out.depth_off_m, std::abs(state.body.position_m.z - depth_m));
    sum_m_s += state.body.nu.linear.x;
    ++judged;
  }
  out.heading_swing_rad = heading.size();
  out.pitch_swing_rad = pitch.size();
  constexpr double enough_periods = 6;
  out.is_judged =
      judged > 0 && out.lasts_s >= enough_periods * slowest_s(autopilot.settings) - 1e-9;
  if (judged > 0) out.made_m_s = sum_m_s / judged;
  return out;
}

bool is_kept(const KeptCourse& c) noexcept {
  return !c.over_at_s && c.is_judged && c.heading_off_rad <= 5 * degree && c.depth_off_m <= 1;
}

bool is_lost(const KeptCourse& c) noexcept {
  return c.over_at_s || (c.is_judged && (c.heading_off_rad > 20 * degree || c.depth_off_m > 3));
}

}  // namespace slackwater::twin
