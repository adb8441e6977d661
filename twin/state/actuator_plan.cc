#include "twin/state/actuator_plan.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "twin/state/units_of_keys.h"

namespace slackwater::twin {
namespace {

/// "left_rad_s, left_rpm or left_share"
std::string keys_of(const ActuatorChannel& channel) {
  std::string keys;
  for (const UnitOfKey& unit : units_of_keys)
    if (unit.channel == channel.unit)
      keys += std::string(channel.name) + std::string(suffix_of(unit.key)) + " or ";
  return keys + std::string(channel.name) + "_share";
}

void put_setting(const ActuatorRow& row, const std::string& key, double value,
                 const Vehicle& vehicle, ActuatorValues& asked) {
  const ActuatorKey parts = actuator_key(key).value();
  const auto at = channel_named(vehicle, parts.name);
  if (!at)
    refuse_at(row.place,
              formatted("{}: found {}, which the {} has not; expected one of {}, with its unit",
                        key, parts.name, vehicle.name, channel_names(vehicle)));
  const ActuatorChannel channel = channel_of(vehicle, *at).value();
  if (asked.has(*at))
    refuse_at(row.place, formatted("{}: found {} twice in a row; give it once", key, parts.name));
  if (parts.unit == KeyUnit::share) return asked.give(*at, channel.of_share(value));
  for (const auto& [of_key, of_channel, scale] : units_of_keys) {
    if (of_key != parts.unit || of_channel != channel.unit) continue;
    const double physical = scale * value;
    if (!channel.reaches(physical))
      refuse_at(row.place,
                formatted("{}: found {:g}, expected {:g} to {:g}, the limits of the {}", key, value,
                          channel.least / scale, channel.most / scale, vehicle.name));
    return asked.give(*at, std::clamp(physical, channel.least, channel.most));
  }
  refuse_at(row.place, formatted("{}: found a unit that {} has not; expected {}", key, parts.name,
                                 keys_of(channel)));
}

/// Which channels no row names and the autopilot has, for what it is to keep.
void leave_to_autopilot(const ActuatorTable& table, const Vehicle& vehicle,
                        const ActuatorValues& named, ActuatorPlan& plan) {
  const bool has_rudder = channel_of(vehicle, rudder_channel).has_value();
  const bool has_elevator = channel_of(vehicle, elevator_channel).has_value();
  const bool by_thrusters = table.keeps_speed || (table.keeps_heading && !has_rudder) ||
                            (table.keeps_depth && !has_elevator);
  bool has_thruster = false;
  for (std::size_t i = 0; i < most_channels; ++i) {
    const bool is_wanted = i < vehicle.mounts    ? by_thrusters
                           : i == rudder_channel ? table.keeps_heading
                                                 : table.keeps_depth;
    plan.is_kept[i] = is_wanted && !named.has(i) && channel_of(vehicle, i).has_value();
    has_thruster = has_thruster || (i < vehicle.mounts && plan.is_kept[i]);
  }
  const auto expect = [&](bool is_kept, bool can, const char* what) {
    if (is_kept && !can)
      refuse_at(table.place,
                std::string("keep: found ") + what +
                    ", and the table has all that would keep it; leave one of the two out");
  };
  expect(table.keeps_speed, has_thruster, "speed");
  expect(table.keeps_heading, has_rudder ? plan.is_kept[rudder_channel] : has_thruster, "heading");
  expect(table.keeps_depth, has_elevator ? plan.is_kept[elevator_channel] : has_thruster, "depth");
}

}  // namespace

ActuatorPlan plan_actuators(const ActuatorTable& table, const Vehicle& vehicle, double speed_m_s) {
  ActuatorPlan plan;
  plan.keeps_depth = table.keeps_depth;
  plan.keeps_heading = table.keeps_heading;
  plan.keeps_speed = table.keeps_speed;
  plan.speed_m_s = table.speed_m_s.value_or(speed_m_s);
  if (table.keeps_depth && vehicle.body.hull.strips > 0)
    refuse_at(table.place,
              "keep: found depth, and the " + vehicle.name + " floats; leave depth out");
  ActuatorValues named;
  for (const ActuatorRow& row : table.rows) {
    ActuatorValues of_row;
    for (const auto& [key, value] : row.setting) put_setting(row, key, value, vehicle, of_row);
    for (std::size_t i = 0; i < most_channels; ++i)
      if (of_row.has(i)) named.give(i, of_row.value[i]);
    plan.steps.push_back({row.at_s, named});
  }
  leave_to_autopilot(table, vehicle, named, plan);
  if (plan.steps.front().at_s > 0) plan.steps.insert(plan.steps.begin(), ActuatorPlan::Step{});
  // What a row names later on, and what nobody names, is at rest until then.
  for (ActuatorPlan::Step& step : plan.steps)
    for (std::size_t i = 0; i <= elevator_channel; ++i)
      if (!plan.is_kept[i] && !step.asked.has(i) && channel_of(vehicle, i)) step.asked.give(i, 0);
  return plan;
}

void put_asked(const ActuatorPlan& plan, const ActuatorValues& asked,
               const VehicleState<double>& vehicle, VehicleCommand<double>& command) noexcept {
  const auto put = [&](std::size_t channel, double otherwise, double& commanded) {
    if (!plan.is_kept[channel]) commanded = asked.value_or(channel, otherwise);
  };
  for (std::size_t i = 0; i < most_mounts; ++i) put(i, 0, command.thruster[i]);
  put(rudder_channel, 0, command.rudder_rad);
  put(elevator_channel, 0, command.elevator_rad);
  put(moving_mass_channel, vehicle.moving_mass_m, command.moving_mass_m);
  put(volume_channel, vehicle.volume_m3, command.volume_m3);
}

}  // namespace slackwater::twin
