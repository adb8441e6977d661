#include "twin/state/manoeuvre_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/control/control_laws.h"
#include "twin/vehicle/actuator_channels.h"
#include "twin/vehicle/driven.h"

namespace slackwater::twin {
namespace {

using constants::degree;

constexpr std::array<const char*, 6> order_words{"begin", "heading", "speed",
                                                 "depth", "helm",    "over"};
constexpr double zig_zag_helm_rad = 20 * degree;
constexpr double without_end_s = std::numeric_limits<double>::infinity();

bool floats(const Vehicle& vehicle) { return vehicle.body.hull.strips > 0; }

/// By a rudder.
double rudder_rad(const ManoeuvreTask& task, const Vehicle& vehicle, double helm) {
  const ActuatorChannel rudder = channel_of(vehicle, rudder_channel).value();
  if (task.helms_are_shares) return rudder.of_share(helm);
  if (!rudder.reaches(helm))
    refuse_at(task.helm_place,
              formatted("helm_deg: found {:g}{}, expected {:.4g} to {:.4g}, the limits of the "
                        "rudder of the {}",
                        helm / degree, task.helms.empty() ? ", which a zig-zag has by default" : "",
                        rudder.least / degree, rudder.most / degree, vehicle.name));
  return std::clamp(helm, rudder.least, rudder.most);
}

/// Whether the thrusters have room for that share of their yaw moment beside the thrust of a speed
/// through still water.
bool has_room(const Vehicle& vehicle, const Autopilot& autopilot, double speed_m_s,
              double voltage_v, double share) {
  constexpr double rounding = 1e-6;
  const double drag_n = resistance(autopilot, {{speed_m_s, 0, 0}, {}}).linear.x;
  const Allocation& allocation = autopilot.allocation;
  const double yaw_n_m = share * allocation.most_either_way(Axis::yaw);
  const Thrusts thrusts = allocate(allocation, {{drag_n, 0, 0}, {0, 0, yaw_n_m}});
  if (thrusts.share[0] < 1 - rounding || thrusts.share[5] < 1 - rounding) return false;
  ThrusterSurroundings<double> around;
  around.voltage_v = voltage_v;
  for (std::size_t i = 0; i < vehicle.mounts; ++i) {
    const Thruster& thruster = thruster_of(vehicle, i);
    around.advance_m_s = vehicle.mount[i].direction.x * speed_m_s;
    const double most_n = run(thruster, thruster.most_command, around).thrust_n;
    const double least_n = run(thruster, thruster.least_command, around).thrust_n;
    const double slack_n = 1e-3 * (allocation.most_n[i] - allocation.least_n[i]);
    if (thrusts.thrust_n[i] > most_n + slack_n || thrusts.thrust_n[i] < least_n - slack_n)
      return false;
  }
  return true;
}

/// By thrusters.
double yaw_share(const ManoeuvreTask& task, const Vehicle& vehicle, const Autopilot& autopilot,
                 double speed_m_s, double voltage_v, double helm) {
  const auto fits = [&](double share) {
    return has_room(vehicle, autopilot, speed_m_s, voltage_v, share);
  };
  if (!fits(std::abs(helm)))
    refuse_at(task.helm_place,
              formatted("helm_share: found {:g}, expected at most {:.2f}: beside the thrust of "
                        "{:g} m/s, which is held, the thrusters of the {} have no room for more of "
                        "the {:.4g} N m that they turn it with. Ask for less of either",
                        helm, std::floor(100 * greatest(1, fits)) / 100, speed_m_s, vehicle.name,
                        autopilot.allocation.most_either_way(Axis::yaw)));
  return helm;
}

/// Those of the task, or its default.
std::vector<double> helms_of(const ManoeuvreTask& task, const Vehicle& vehicle, bool has_rudder) {
  if (!task.helms.empty()) return task.helms;
  if (task.kind != ManoeuvreKind::zig_zag)
    return {has_rudder ? channel_of(vehicle, rudder_channel)->most : 1.0};
  if (!has_rudder)
    refuse_at(task.place,
              formatted("helm_share: missing; the {} has no rudder to put to 20 degrees: "
                        "give the share of its thrusters' yaw moment, such as 0.3",
                        vehicle.name));
  return {zig_zag_helm_rad};
}

void plan_legs(const ManoeuvreTask& task, const std::vector<double>& helms, ManoeuvrePlan& plan) {
  const double first = plan.side * helms.front();
  switch (task.kind) {
    case ManoeuvreKind::turning_circle:
      plan.legs = {{first, task.lasts_s}};
      return;
    case ManoeuvreKind::pull_out:
      plan.legs = {{first, task.turn_s}, {0, task.lasts_s}};
      plan.lasts_s += task.turn_s;
      return;
    case ManoeuvreKind::zig_zag:
      for (std::size_t i = 0; i < task.executes; ++i)
        plan.legs.push_back({i % 2 == 0 ? first : -first, without_end_s});
      return;
    case ManoeuvreKind::spiral:
      plan.lasts_s = without_end_s;
      for (const double helm : helms) plan.legs.push_back({helm, task.each_s});
      return;
    case ManoeuvreKind::steps:
      return;
  }
}

void expect_steps(const ManoeuvreTask& task, const Vehicle& vehicle) {
  for (const KeptStep& step : task.steps) {
    if (!step.depth_m) continue;
    if (floats(vehicle))
      refuse_at(step.place, "depth_m: found " + formatted("{:g}", *step.depth_m) + ", and the " +
                                vehicle.name + " floats; leave it out");
    if (vehicle.rated_depth_m && *step.depth_m > *vehicle.rated_depth_m)
      refuse_at(step.place, formatted("depth_m: found {:g}, expected at most {:g}, the depth that "
                                      "the {} is rated for",
                                      *step.depth_m, *vehicle.rated_depth_m, vehicle.name));
  }
}

}  // namespace

const char* name_of(Ordered what) noexcept { return order_words[static_cast<std::size_t>(what)]; }

ManoeuvrePlan plan_manoeuvre(const ManoeuvreTask& task, const Vehicle& vehicle,
                             const Autopilot& autopilot, double speed_m_s, double voltage_v) {
  if (vehicle.kind == VehicleKind::uav)
    refuse_at(task.place, formatted("do: found {}, and the {} flies; manoeuvres are for what swims "
                                    "or floats",
                                    name_of(task.kind), vehicle.name));
  ManoeuvrePlan plan;
  plan.is_there = true;
  plan.kind = task.kind;
  plan.keeps_depth = !floats(vehicle);
  plan.speed_m_s = task.speed_m_s.value_or(speed_m_s);
  plan.approach_s = task.approach_s;
  plan.lasts_s = task.lasts_s;
  plan.heading_change_rad = task.heading_change_rad;
  plan.side = task.to_port ? -1 : 1;
  plan.steps = task.steps;
  expect_steps(task, vehicle);
  if (task.kind == ManoeuvreKind::steps) return plan;
  plan.by_rudder = channel_of(vehicle, rudder_channel).has_value();
  plan.most_yaw_n_m = autopilot.allocation.most_either_way(Axis::yaw);
  if (!plan.by_rudder && !autopilot.allocation.commands(Axis::yaw))
    refuse_at(task.place, formatted("do: found {}, and the {} has nothing that turns it",
                                    name_of(task.kind), vehicle.name));
  if (!plan.by_rudder && !task.helms.empty() && !task.helms_are_shares)
    refuse_at(task.helm_place,
              formatted("helm_deg: found an angle, and the {} has no rudder: its "
                        "thrusters turn it. Give helm_share (of a spiral helms_share) "
                        "of the {:.4g} N m that they give either way",
                        vehicle.name, plan.most_yaw_n_m));
  std::vector<double> helms = helms_of(task, vehicle, plan.by_rudder);
  for (double& helm : helms)
    helm = plan.by_rudder ? rudder_rad(task, vehicle, helm)
                          : yaw_share(task, vehicle, autopilot, plan.speed_m_s, voltage_v, helm);
  plan_legs(task, helms, plan);
  return plan;
}

}  // namespace slackwater::twin
