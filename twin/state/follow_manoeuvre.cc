#include "twin/state/follow_manoeuvre.h"

#include <cmath>

#include "fields/base/turn.h"

namespace slackwater::twin {
namespace {

constexpr double soon_s = 1e-6;  // what rounding leaves of a number of steps

Course bow_course(const Measured& measured) { return bow_of(rotation_of(measured.attitude)); }

void order(Ordered what, double value, double t_s, MissionState& state) {
  state.orders.push_back({t_s, static_cast<double>(state.task), static_cast<double>(what), value});
}

void put_helm_over(const ManoeuvrePlan& plan, double t_s, MissionState& state) {
  ManoeuvreState& own = state.manoeuvre;
  own.leg += 1;
  own.leg_began_s = state.held_s;
  order(Ordered::helm, plan.legs[static_cast<std::size_t>(own.leg) - 1].helm, t_s, state);
}

/// Whether the heading is where the helm in force is for.
bool has_turned(const ManoeuvrePlan& plan, const ManoeuvreState& own) {
  const auto leg = static_cast<std::size_t>(own.leg);
  if (plan.kind == ManoeuvreKind::turning_circle)
    return plan.side * own.turned_rad >= plan.heading_change_rad;
  if (plan.kind != ManoeuvreKind::zig_zag) return false;
  const double way = leg % 2 == 1 ? plan.side : -plan.side;
  // After the last one it comes back to the course of the approach, its overshoot behind it.
  return way * own.turned_rad >= (leg == plan.legs.size() ? 0 : plan.heading_change_rad);
}

bool keep_steps(const ManoeuvrePlan& plan, double t_s, MissionState& state) {
  ManoeuvreState& own = state.manoeuvre;
  if (state.held_s >= plan.lasts_s - soon_s) return false;
  for (auto next = static_cast<std::size_t>(own.leg); next < plan.steps.size(); ++next) {
    const KeptStep& step = plan.steps[next];
    if (state.held_s < step.at_s - soon_s) break;
    own.leg += 1;
    if (step.heading_rad) {
      state.kept_heading = course_of(*step.heading_rad);
      order(Ordered::heading, bearing_rad(state.kept_heading), t_s, state);
    }
    if (step.speed_m_s) {
      own.speed_m_s = *step.speed_m_s;
      order(Ordered::speed, own.speed_m_s, t_s, state);
    }
    if (step.depth_m) {
      state.kept_m.z = *step.depth_m;
      order(Ordered::depth, state.kept_m.z, t_s, state);
    }
  }
  return true;
}

bool turn(const ManoeuvrePlan& plan, double t_s, MissionState& state) {
  ManoeuvreState& own = state.manoeuvre;
  if (own.leg == 0) {
    if (state.held_s < plan.approach_s - soon_s) return true;
    own.executed_s = state.held_s;
    put_helm_over(plan, t_s, state);
    return true;
  }
  if (state.held_s - own.executed_s >= plan.lasts_s - soon_s) return false;
  const ManoeuvrePlan::Leg& leg = plan.legs[static_cast<std::size_t>(own.leg) - 1];
  if (state.held_s - own.leg_began_s < leg.lasts_s - soon_s && !has_turned(plan, own)) return true;
  if (static_cast<std::size_t>(own.leg) == plan.legs.size()) return false;
  put_helm_over(plan, t_s, state);
  return true;
}

}  // namespace

void begin_manoeuvre(const ManoeuvrePlan& plan, const Measured& measured, double t_s,
                     MissionState& state) {
  state.held_s = 0;
  state.kept_heading = bow_course(measured);
  state.route = {};
  ManoeuvreState& own = state.manoeuvre;
  own = {};
  own.heading_rad = bearing_rad(state.kept_heading);
  own.last_s = t_s;
  own.speed_m_s = plan.speed_m_s;
  std::erase_if(state.orders, [&](const TaskOrder& of_before) {
    return of_before.task == static_cast<double>(state.task);
  });
  state.orders.reserve(state.orders.size() + plan.most_orders());
  order(Ordered::begin, 0, t_s, state);
  order(Ordered::heading, own.heading_rad, t_s, state);
  order(Ordered::speed, own.speed_m_s, t_s, state);
  if (plan.keeps_depth) order(Ordered::depth, state.kept_m.z, t_s, state);
}

bool go_on(const ManoeuvrePlan& plan, const Measured& measured, double t_s, double dt_s,
           MissionState& state) {
  ManoeuvreState& own = state.manoeuvre;
  if (t_s - own.last_s > 1.5 * dt_s) {
    state.kept_m = measured.position_m;
    begin_manoeuvre(plan, measured, t_s, state);
  }
  own.last_s = t_s;
  const double heading_rad = bearing_rad(bow_course(measured));
  if (own.leg > 0) own.turned_rad += wrapped_rad(heading_rad - own.heading_rad);
  own.heading_rad = heading_rad;
  const bool goes_on =
      plan.kind == ManoeuvreKind::steps ? keep_steps(plan, t_s, state) : turn(plan, t_s, state);
  if (!goes_on) order(Ordered::over, 0, t_s, state);
  state.held_s += dt_s;
  return goes_on;
}

Reference reference_of(const ManoeuvrePlan& plan, const Measured& measured,
                       const MissionState& state) {
  Reference reference;
  reference.target = Target::cruise;
  reference.position_m = measured.position_m;
  if (plan.keeps_depth) reference.position_m.z = state.kept_m.z;
  if (plan.kind == ManoeuvreKind::steps || state.manoeuvre.leg == 0) {
    reference.heading = state.kept_heading;
    reference.velocity_m_s = {state.manoeuvre.speed_m_s, 0, 0};
    return reference;
  }
  reference.heading = bow_course(measured);
  reference.velocity_m_s = {measured.has_log() ? measured.log_m_s : measured.nu.linear.x,
                            measured.nu.linear.y, 0};
  return reference;
}

void note_propulsion(const ManoeuvrePlan& plan, double push_n, double advance_m_s, double voltage_v,
                     double dt_s, MissionState& state) noexcept {
  constexpr double from_share = 0.8;
  ManoeuvreState& own = state.manoeuvre;
  if (state.held_s < from_share * plan.approach_s) return;
  own.settled_s += dt_s;
  const double share = dt_s / own.settled_s;
  own.push_n += share * (push_n - own.push_n);
  own.advance_m_s += share * (advance_m_s - own.advance_m_s);
  own.voltage_v += share * (voltage_v - own.voltage_v);
}

}  // namespace slackwater::twin
