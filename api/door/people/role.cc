#include "api/door/people/role.h"

#include <array>

namespace slackwater::people {
namespace {

constexpr std::array<std::string_view, 3> names{"spectator", "operator", "supervisor"};

}  // namespace

std::string_view name_of(Role role) noexcept { return names[static_cast<std::size_t>(role)]; }

std::optional<Role> role_of(std::string_view name) noexcept {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<Role>(i);
  return std::nullopt;
}

}  // namespace slackwater::people
