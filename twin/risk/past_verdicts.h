#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "twin/risk/chance_calibration.h"
#include "twin/risk/start_windows.h"

namespace slackwater::twin {

/// Past starts of which about the same was said.
struct SaidAndCame {
  std::size_t starts = 0;
  double said = 0;  ///< summed over them
  std::size_t held = 0;
};

/// What today's way of telling chances would have said on past mornings, each told from the others,
/// and what came.
struct PastVerdicts {
  std::size_t mornings = 0;
  std::size_t goes = 0;       ///< mornings whose best start was a go
  std::size_t goes_held = 0;  ///< of them those on which it held
  std::size_t lost = 0;       ///< mornings without a go whose best start would have held
  /// Starts that were said to be a go, marginal, no go, and those below a tenth.
  std::array<SaidAndCame, 4> classes{};

  PastVerdicts& operator+=(const PastVerdicts& more) noexcept;
};

/// @param mornings  of one task
[[nodiscard]] PastVerdicts past_verdicts(std::span<const PastStarts> mornings,
                                         const VerdictRule& rule);

}  // namespace slackwater::twin
