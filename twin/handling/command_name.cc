#include "twin/handling/command_name.h"

#include "twin/state/units_of_keys.h"

namespace slackwater::twin {
namespace {

/// Beside the units of scenarios: logs have fins in radians.
constexpr std::string_view in_radians = "_rad";

}  // namespace

std::optional<CommandName> command_name(const Vehicle& vehicle, std::string_view column) noexcept {
  if (column.ends_with(in_radians)) {
    const auto fin = channel_named(vehicle, column.substr(0, column.size() - in_radians.size()));
    const bool turns = fin && channel_of(vehicle, *fin)->unit == ActuatorUnit::rad;
    return turns ? std::optional(CommandName{*fin, false, 1}) : std::nullopt;
  }
  const auto key = actuator_key(column);
  const auto at = key ? channel_named(vehicle, key->name) : std::nullopt;
  if (!at) return std::nullopt;
  if (key->unit == KeyUnit::share) return CommandName{*at, true, 1};
  const ActuatorUnit unit = channel_of(vehicle, *at)->unit;
  for (const UnitOfKey& known : units_of_keys)
    if (known.key == key->unit && known.channel == unit)
      return CommandName{*at, false, known.scale};
  return std::nullopt;
}

std::vector<std::string> command_names(const Vehicle& vehicle) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < most_channels; ++i) {
    const auto channel = channel_of(vehicle, i);
    if (!channel || channel->name.empty()) continue;
    const auto put = [&](KeyUnit unit) {
      names.push_back(std::string(channel->name) + std::string(suffix_of(unit)));
    };
    for (const UnitOfKey& known : units_of_keys)
      if (known.channel == channel->unit) put(known.key);
    if (channel->unit == ActuatorUnit::rad)
      names.push_back(std::string(channel->name) + std::string(in_radians));
    put(KeyUnit::share);
  }
  return names;
}

}  // namespace slackwater::twin
