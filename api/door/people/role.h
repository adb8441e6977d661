#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace slackwater::people {

/// What a person may do in a session; each may what those before it may.
enum class Role : std::uint8_t {
  looks_on,    ///< "spectator"
  drives,      ///< "operator"
  supervises,  ///< "supervisor"
};
[[nodiscard]] std::string_view name_of(Role role) noexcept;
[[nodiscard]] std::optional<Role> role_of(std::string_view name) noexcept;

/// Milliseconds of a session's clock, which never goes back.
using Milliseconds = std::int64_t;
[[nodiscard]] constexpr double seconds(Milliseconds ms) noexcept {
  return static_cast<double>(ms) / 1000;
}

}  // namespace slackwater::people
