#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace slackwater::twin {

/// What a part of a mission is for. A task of a vehicle belongs to one.
enum class Phase : std::uint8_t { transit, launch, work, recovery, return_home };
inline constexpr std::size_t phase_count = 5;

/// transit, launch, work, recovery, return.
[[nodiscard]] const char* name_of(Phase phase) noexcept;
/// Nothing for another word.
[[nodiscard]] std::optional<Phase> phase_of(std::string_view word) noexcept;

/// Some of the phases.
struct PhaseSet {
  std::uint8_t bits = 0x1F;  ///< all of them

  [[nodiscard]] bool has(Phase phase) const noexcept {
    return (bits >> static_cast<unsigned>(phase) & 1U) != 0;
  }
  void add(Phase phase) noexcept {
    bits = static_cast<std::uint8_t>(bits | 1U << static_cast<unsigned>(phase));
  }
  [[nodiscard]] bool operator==(const PhaseSet&) const = default;
};

}  // namespace slackwater::twin
