#include "twin/vehicle/actuator_channels.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

ActuatorUnit unit_of(ThrusterKind kind) noexcept {
  switch (kind) {
    case ThrusterKind::table:
      return ActuatorUnit::command;
    case ThrusterKind::propeller:
    case ThrusterKind::rotor:
      return ActuatorUnit::rad_s;
    case ThrusterKind::drive:
      return ActuatorUnit::n;
  }
  return ActuatorUnit::command;
}

std::optional<ActuatorChannel> channel_of_fins(const char* name, const FinPair& fins) noexcept {
  if (!(fins.area_m2 > 0)) return std::nullopt;
  return ActuatorChannel{name, ActuatorUnit::rad, -fins.limit_rad, fins.limit_rad};
}

}  // namespace

const char* symbol_of(ActuatorUnit unit) noexcept {
  switch (unit) {
    case ActuatorUnit::command:
      return "";
    case ActuatorUnit::rad_s:
      return "rad/s";
    case ActuatorUnit::n:
      return "N";
    case ActuatorUnit::rad:
      return "rad";
    case ActuatorUnit::m:
      return "m";
    case ActuatorUnit::m3:
      return "m3";
  }
  return "";
}

bool ActuatorChannel::reaches(double value) const noexcept {
  constexpr double rounding = 0.005;
  return value >= least - rounding * std::abs(least) && value <= most + rounding * std::abs(most);
}

double ActuatorChannel::of_share(double share) const noexcept {
  const double held = std::clamp(share, -1.0, 1.0);
  return held < 0 ? -held * std::min(least, 0.0) : held * most;
}

std::optional<ActuatorChannel> channel_of(const Vehicle& vehicle, std::size_t channel) noexcept {
  if (channel < vehicle.mounts) {
    const Thruster& thruster = thruster_of(vehicle, channel);
    return ActuatorChannel{vehicle.mount[channel].name, unit_of(thruster.kind),
                           thruster.least_command, thruster.most_command};
  }
  const Trim& trim = vehicle.trim;
  if (channel == rudder_channel) return channel_of_fins("rudder", vehicle.rudder);
  if (channel == elevator_channel) return channel_of_fins("elevator", vehicle.elevator);
  if (channel == moving_mass_channel && trim.moving_mass_kg > 0 && trim.travel_m > 0)
    return ActuatorChannel{"moving_mass", ActuatorUnit::m, -trim.travel_m, trim.travel_m};
  if (channel == volume_channel && trim.most_volume_m3 > trim.least_volume_m3)
    return ActuatorChannel{"volume", ActuatorUnit::m3, trim.least_volume_m3, trim.most_volume_m3};
  return std::nullopt;
}

std::optional<std::size_t> channel_named(const Vehicle& vehicle, std::string_view name) noexcept {
  for (std::size_t i = 0; i < most_channels; ++i)
    if (const auto channel = channel_of(vehicle, i); channel && channel->name == name) return i;
  return std::nullopt;
}

std::string channel_names(const Vehicle& vehicle) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < most_channels; ++i)
    if (const auto channel = channel_of(vehicle, i)) names.emplace_back(channel->name);
  return joined(names, ", ");
}

ActuatorValues in_units(const Vehicle& vehicle, const ActuatorValues& given,
                        bool is_physical) noexcept {
  ActuatorValues out;
  for (std::size_t i = 0; i < most_channels; ++i) {
    const auto channel = given.has(i) ? channel_of(vehicle, i) : std::nullopt;
    if (!channel) continue;
    out.give(i, is_physical ? std::clamp(given.value[i], channel->least, channel->most)
                            : channel->of_share(given.value[i]));
  }
  return out;
}

ActuatorValues values_by_name(const Vehicle& vehicle, std::span<const std::string> names,
                              std::span<const double> values) {
  if (names.size() != values.size())
    throw Error(ErrorKind::invalid_input,
                formatted("actuators: found {} names and {} values; give one value for each name",
                          names.size(), values.size()));
  ActuatorValues out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto channel = channel_named(vehicle, names[i]);
    if (!channel)
      throw Error(ErrorKind::invalid_input,
                  formatted("actuators: found {}, expected one of those of the {}: {}", names[i],
                            vehicle.name, channel_names(vehicle)));
    if (out.has(*channel))
      throw Error(ErrorKind::invalid_input,
                  formatted("actuators: found {} twice; give it one value", names[i]));
    out.give(*channel, values[i]);
  }
  return out;
}

}  // namespace slackwater::twin
