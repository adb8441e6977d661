#include "twin/handling/command_name.h"

#include <array>

#include "fields/base/constants.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::twin {
namespace {

struct CommandSuffix {
  std::string_view text;
  ActuatorUnit unit{};
  double si = 1;
};
/// Besides `_share`, which every channel has. As rows of a scenario have them, and radians.
constexpr std::array<CommandSuffix, 7> command_suffixes{
    {{"_rad_s", ActuatorUnit::rad_s},
     {"_rpm", ActuatorUnit::rad_s, 2 * constants::pi / 60},
     {"_n", ActuatorUnit::n},
     {"_deg", ActuatorUnit::rad, constants::degree},
     {"_rad", ActuatorUnit::rad},
     {"_m", ActuatorUnit::m},
     {"_m3", ActuatorUnit::m3}}};
constexpr std::string_view share_suffix = "_share";

bool is_of(std::string_view column, std::string_view channel, std::string_view suffix) noexcept {
  return column.size() == channel.size() + suffix.size() && column.starts_with(channel) &&
         column.ends_with(suffix);
}

}  // namespace

std::optional<CommandName> command_name(const Vehicle& vehicle, std::string_view column) noexcept {
  for (std::size_t i = 0; i < most_channels; ++i) {
    const auto channel = channel_of(vehicle, i);
    if (!channel || channel->name.empty()) continue;
    if (is_of(column, channel->name, share_suffix)) return CommandName{i, true, 1};
    for (const CommandSuffix& suffix : command_suffixes)
      if (suffix.unit == channel->unit && is_of(column, channel->name, suffix.text))
        return CommandName{i, false, suffix.si};
  }
  return std::nullopt;
}

std::vector<std::string> command_names(const Vehicle& vehicle) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < most_channels; ++i) {
    const auto channel = channel_of(vehicle, i);
    if (!channel || channel->name.empty()) continue;
    for (const CommandSuffix& suffix : command_suffixes)
      if (suffix.unit == channel->unit)
        names.push_back(std::string(channel->name) + std::string(suffix.text));
    names.push_back(std::string(channel->name) + std::string(share_suffix));
  }
  return names;
}

}  // namespace slackwater::twin
