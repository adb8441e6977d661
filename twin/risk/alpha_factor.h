#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "twin/mission/limit.h"

namespace slackwater::twin {

/// A factor of practice, or why there is none.
struct AlphaFactor {
  std::optional<double> value;
  std::string why;  ///< of none: "the table has no factor for limits below 1 m"
};

/// Factors for what a forecast does not know: operate only if
///
///   forecast <= alpha(TPOP, limit) x limit
///
/// throughout. TPOP, the planned operation period, runs from the issue of the forecast to the end
/// of the task; the row is that of the next longer period, in between limits it is linear, above
/// the last limit as at it. Below the first limit and beyond the last row a table says nothing, and
/// neither does this one.
/// Source: DNV-OS-H101 (2011), section 4 C; twin/docs/operations.md, section 4.
struct AlphaTable {
  std::string name;
  std::string source;
  std::string status;
  LimitVariable variable = LimitVariable::significant_wave_height;
  std::vector<double> limits;  ///< ascending, in the unit of the variable
  struct Row {
    double period_h = 0;         ///< TPOP up to this
    std::vector<double> factor;  ///< one a limit
  };
  std::vector<Row> rows;  ///< by period, ascending

  [[nodiscard]] AlphaFactor at(double period_h, double limit) const;
};

/// A table of data/alpha, or a user's:
///
///     name: DNV-OS-H101 (2011), table 4-1
///     source: ...
///     status: confirmed
///     variable: significant_wave_height_m       # as limits are called
///     limits: [1, 2, 4, 6]
///     rows:
///       - {up_to_h: 12, alpha: [0.65, 0.76, 0.79, 0.80]}
///
/// @throws Error(invalid_input) with file and line; also for factors that are not in (0, 1] and for
/// rows or limits out of order
[[nodiscard]] AlphaTable read_alpha_table(const Config& config);

}  // namespace slackwater::twin
