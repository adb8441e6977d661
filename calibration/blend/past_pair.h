#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "fields/base/frame.h"

namespace slackwater::calibration {

/// What one past pair of days D -> D+1 says of the candidates: the second moments of their errors.
/// The risk of any blend w of them over the pair is w^T G w, so that years of verification over any
/// number of columns are a small matrix a day.
struct PastPair {
  double age_days = 0;  ///< from the pair's D+1 to the D that is forecast from, >= 0
  std::size_t values = 0;
  /// G[a][b] = mean over the pair's values of Re(conj(e_a) e_b), m2/s2, e = forecast - truth of the
  /// vector; candidates x candidates. Rows of an absent candidate mean nothing and may hold NaN.
  Eigen::MatrixXd gram;
  std::vector<bool> present;  ///< per candidate

  [[nodiscard]] std::size_t candidates() const noexcept { return present.size(); }
};

/// Second moments from the errors themselves.
///
/// A candidate with no errors, or one that lacks more than a tenth of the values that the fullest
/// candidate has, is absent; the values that count are those which all present candidates have.
///
/// @param errors  per candidate: forecast - truth at every value of the pair, m/s, NaN where it has
///                none; or empty: absent. All that are not empty are equally long.
/// @param age_days  >= 0, a pair of the future is a bug
[[nodiscard]] PastPair pair_of_errors(std::span<const std::vector<Horizontal>> errors,
                                      double age_days);

/// The pair with every candidate absent whose moments cannot be used: its row not finite (of two
/// that are not finite together the one with more such moments goes, the later of equals), its mean
/// square negative or beyond (1000 m/s)^2, or no values at all. What is left is taken for second
/// moments, that is positive semi-definite, as those of `pair_of_errors` are.
/// Throws ContractViolation where sizes do not agree, the age is negative or not finite.
[[nodiscard]] PastPair without_unusable(PastPair pair);

}  // namespace slackwater::calibration
