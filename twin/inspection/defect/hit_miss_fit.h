#pragma once
#include <optional>
#include <span>

#include "twin/inspection/defect/detection_method.h"

namespace slackwater::twin {

/// A defect that was looked for, and whether it was found.
struct HitMiss {
  double size = 0;  ///< above 0, in the curve's unit
  bool is_found = false;
};

/// A number with the range that 95 of 100 such trials would have about the truth.
struct Within95 {
  double value = 0;
  double low = 0;
  double high = 0;
};

/// The curve of hits and misses.
struct HitMissFit {
  LogLogisticPod curve;
  Within95 x0;  ///< found in half of the cases
  Within95 b;
  Within95 a90;  ///< found in nine of ten: x0 9^(1/b)
  std::size_t looks = 0;
  std::size_t hits = 0;
};

/// The log-logistic curve of the greatest likelihood, for hits and misses, as MIL-HDBK-1823A (2009,
/// appendix G; logit link, logarithm of the size) and Berens (1989, ASM Handbook 17) have it:
///
///     logit POD = b (ln a - ln x0),   maximise  sum ln p (hits) + sum ln(1 - p) (misses)
///
/// by Newton's steps on (b, -b ln x0). The ranges are those of the inverse information matrix
/// (Wald), of ln x0, b and ln a90, two-sided 1.96 deviations.
///
/// Nothing where no curve rises: all found or all missed, or hits and misses parted by one size
/// without an overlap (the likelihood then has no greatest value), or b not above 0.
[[nodiscard]] std::optional<HitMissFit> fit_hit_miss(std::span<const HitMiss> looks);

}  // namespace slackwater::twin
