#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "twin/risk/start_chances.h"

namespace slackwater::twin {

/// Starts one after the other from which a task may be begun.
struct StartWindow {
  std::size_t first = 0;  ///< of the starts
  std::size_t last = 0;   ///< the latest one
  double least = 0;       ///< probability that all limits hold
  double mean = 0;
  double most = 0;
  std::size_t best = 0;          ///< the first of the starts that have it
  std::size_t by_threshold = 0;  ///< starts that the central forecast allows
  std::size_t by_alpha = 0;      ///< and that practice does
  [[nodiscard]] constexpr std::size_t starts() const noexcept { return last - first + 1; }
};

/// The maximal runs of starts whose mark is 1.
/// @param probability  that all limits hold, and @param marks  one a start
[[nodiscard]] std::vector<StartWindow> windows_of(std::span<const StartChance> chances,
                                                  std::span<const double> probability,
                                                  std::span<const std::uint8_t> marks);

/// What a coordinator does about a day.
enum class Verdict { go, marginal, no_go };
/// "go", "marginal", "no-go".
[[nodiscard]] std::string_view name_of(Verdict verdict) noexcept;

/// From which probability on a start is one to take, or to think about.
struct VerdictRule {
  double go = 0.9;
  double marginal = 0.5;
};
/// Of the best start. @param probability  of it; of none 0
[[nodiscard]] Verdict verdict_of(double probability, const VerdictRule& rule) noexcept;

}  // namespace slackwater::twin
