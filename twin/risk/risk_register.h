#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "twin/chance/success_interval.h"
#include "twin/risk/consequence.h"
#include "twin/risk/risk_cause.h"

namespace slackwater::twin {

/// How likely, in classes: below 1 %, 5 %, 20 %, 50 %, and more. A convention of this program.
enum class Likelihood : std::uint8_t { rare, unlikely, possible, likely, expected };
[[nodiscard]] Likelihood likelihood_of(double probability) noexcept;

/// Likelihood (1 to 5) times the worst consequence (1 to 5): below 6 low, below 15 medium, else
/// high. A convention of this program.
enum class RiskLevel : std::uint8_t { low, medium, high };
[[nodiscard]] RiskLevel level_of(Likelihood likelihood, int worst_grade) noexcept;
[[nodiscard]] std::string_view name_of(RiskLevel level) noexcept;

/// A line of a register of risks.
struct RiskEntry {
  RiskCause cause{};
  std::size_t flights = 0;
  std::size_t befell = 0;
  SuccessInterval probability;             ///< of the cause; holds however many flights there were
  std::optional<Consequence> consequence;  ///< absent: the task says none
  RiskLevel at_least = RiskLevel::low;     ///< by the lower bound of its probability
  RiskLevel at_worst = RiskLevel::low;     ///< by the upper bound

  [[nodiscard]] double share() const noexcept {
    return flights > 0 ? static_cast<double>(befell) / static_cast<double>(flights) : 0;
  }
};

/// The class that the bounds of its probability allow: "possible (5 to 20 %)"; where they are in
/// two, from one to the other: "rare to likely". What never befell in few flights is no class.
[[nodiscard]] std::string likelihood_text(const RiskEntry& entry);
/// The level that they allow: "medium", "low to high".
[[nodiscard]] std::string level_text(const RiskEntry& entry);

/// All risks, the gravest first: by the level at least, then at worst, then by share.
/// A cause whose consequence nobody states is taken to be of the middle class.
/// @param flights       what befell each
/// @param consequences  of the tasks of the mission, the worse of two counts
/// @param level         of the intervals
[[nodiscard]] std::vector<RiskEntry> risk_register(std::span<const RiskCauses> flights,
                                                   std::span<const Consequence> consequences,
                                                   double level = 0.95);

}  // namespace slackwater::twin
