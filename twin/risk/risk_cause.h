#pragma once
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace slackwater::twin {

/// What can befall a vehicle on its mission: the causes of a register of risks.
enum class RiskCause : std::uint8_t {
  limit,      ///< a limit was exceeded at work
  energy,     ///< its reserve was touched, or its battery empty
  tether,     ///< its line parted or was fouled
  station,    ///< the water or the wind was faster than it, or it capsized
  collision,  ///< it struck something, or came nearer than its rule of keeping clear allows
  recovery,   ///< it was still out when its time was over, or where nobody knows
  work,       ///< none of these, and the work was not done for all that
  unseen,     ///< done or not, an inspection covered less than is asked of it
};
inline constexpr std::size_t risk_cause_count = 8;

/// "limit", "energy", ...: the word of YAML and JSON.
[[nodiscard]] std::string_view name_of(RiskCause cause) noexcept;
/// "a limit is exceeded at work".
[[nodiscard]] std::string_view meaning_of(RiskCause cause) noexcept;
/// @throws Error(invalid_input) for another word, naming those there are
[[nodiscard]] RiskCause parse_risk_cause(std::string_view text);

/// What befell one flight.
class RiskCauses {
 public:
  void add(RiskCause cause) noexcept { bits_.set(static_cast<std::size_t>(cause)); }
  void add(const RiskCauses& others) noexcept { bits_ |= others.bits_; }
  [[nodiscard]] bool has(RiskCause cause) const noexcept {
    return bits_.test(static_cast<std::size_t>(cause));
  }
  [[nodiscard]] bool none() const noexcept { return bits_.none(); }
  bool operator==(const RiskCauses&) const = default;

 private:
  std::bitset<risk_cause_count> bits_;
};

}  // namespace slackwater::twin
