#include "api/door/live/host_check.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "twin/body/body_dynamics.h"

namespace slackwater::live {
namespace {

using twin::BodyState;
using twin::length_of;
using twin::Triple;

bool is_finite(const Triple<double>& v) { return std::isfinite(v.x + v.y + v.z); }
bool is_finite(const twin::Spatial<double>& s) {
  return is_finite(s.linear) && is_finite(s.angular);
}

std::optional<std::string> unphysical_state(const BodyState<double>& body,
                                            const twin::HostedStep& step) {
  constexpr double fastest_m_s = 100, fastest_rad_s = 20, most_m_s2 = 200;
  const twin::Attitude<double>& q = body.attitude;
  if (!is_finite(body.position_m) || !is_finite(body.nu) || !std::isfinite(q.w + q.x + q.y + q.z))
    return "a pose or twist that is not a number";
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (std::abs(length - 1) > 1e-3) return formatted("an orientation of length {:g}, not 1", length);
  const double speed_m_s = length_of(body.nu.linear);
  if (speed_m_s > fastest_m_s || length_of(body.nu.angular) > fastest_rad_s)
    return formatted("{:g} m/s and {:g} rad/s", speed_m_s, length_of(body.nu.angular));
  const BodyState<double>& before = step.state.vehicle.body;
  const double dt_s = step.time.length_s;
  const Triple<double> v0 = twin::rotation_of(before.attitude).to_ned(before.nu.linear);
  const Triple<double> v1 = twin::rotation_of(q).to_ned(body.nu.linear);
  if (const double change_m_s = length_of(v1 - v0); change_m_s > most_m_s2 * dt_s + 0.01)
    return formatted("a change of speed of {:g} m/s within {:g} s", change_m_s, dt_s);
  const double way_m = 0.5 * dt_s * (length_of(v0) + length_of(v1));
  const Triple<double> led_to = before.position_m + (0.5 * dt_s) * (v0 + v1);
  const double off_m = length_of(body.position_m - led_to);
  if (off_m > 0.1 + 0.1 * way_m)
    return formatted("a jump of {:g} m from the place that its velocities lead to", off_m);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> unphysical(const dds::PhysicsMade& made, const twin::HostedStep& step) {
  constexpr double most_power_w = 1e8;
  if (!(made.power_w >= 0 && made.power_w <= most_power_w))
    return formatted("a power of {:g} W", made.power_w);
  if (made.kind == 1) return unphysical_state(made.body, step);
  if (made.kind != 2)
    return formatted("an answer of kind {}; 1 is a state, 2 a wrench", int{made.kind});
  const twin::Body& body = step.agent.vehicle->body;
  const double most_n = 100 * 9.81 * body.mass_kg;
  if (!is_finite(made.wrench) || length_of(made.wrench.linear) > most_n ||
      length_of(made.wrench.angular) > most_n)
    return formatted("a wrench of {:g} N and {:g} N m", length_of(made.wrench.linear),
                     length_of(made.wrench.angular));
  return std::nullopt;
}

twin::VehicleState<double> state_after(const dds::PhysicsMade& made, const twin::HostedStep& step) {
  twin::VehicleState<double> next = step.state.vehicle;
  const twin::Vehicle& vehicle = *step.agent.vehicle;
  const double dt_s = step.time.length_s;
  if (made.kind == 1) {
    next.body = made.body;
    next.body.attitude = twin::normalised(next.body.attitude);
  } else {
    twin::Forcing<double> forcing;
    forcing.fluid = step.input.around.water;
    forcing.tau = made.wrench;
    if (vehicle.body.hull.strips > 0)
      forcing.waves = twin::waves_met(vehicle.body.hull, step.input.around.at_strips);
    const auto steps = static_cast<int>(std::ceil(dt_s / vehicle.largest_step_s - 1e-9));
    for (int i = 0; i < steps; ++i)
      next.body = twin::stepped(vehicle.body, next.body, forcing, dt_s / steps);
  }
  // What it drew, from the battery that we keep.
  next.electrical_w = made.power_w;
  next.drawn_j += made.power_w * dt_s;
  if (vehicle.battery && next.battery.off < 0.5) {
    const auto out = twin::discharge(*vehicle.battery, twin::battery_step(*vehicle.battery, dt_s),
                                     next.battery, made.power_w);
    next.bus_voltage_v = out.terminal_voltage_v;
    next.current_a = out.current_a;
  }
  return next;
}

}  // namespace slackwater::live
