#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "calibration/blend/blend.h"

namespace slackwater::calibration {

/// A past pair in the form in which it is summed: no candidate is absent any more.
struct CompletedPair {
  double weight = 0;  ///< g
  double say = 0;     ///< g, lowered where its errors are out of keeping with those of other pairs
  std::size_t place = 0;    ///< in the past as given
  Eigen::MatrixXd gram;     ///< absent candidates have the error of the prior blend
  Eigen::VectorXd differs;  ///< mean |e_c - e_prior|^2; 0 where absent
  Eigen::VectorXd own;      ///< mean |e_c|^2; 0 where absent
  Eigen::VectorXd present;  ///< 1 or 0
};

/// All that the past says, and the weights that follow from it or from all of it but one pair.
class Evidence {
 public:
  /// @param prior  sums to 1; 0 for candidates that are not available now
  Evidence(std::span<const Candidate> candidates, std::span<const PastPair> past,
           Eigen::VectorXd prior, const BlendSettings& settings);

  /// Oldest first.
  [[nodiscard]] const std::vector<CompletedPair>& pairs() const noexcept { return pairs_; }
  /// Pairs in which a candidate was present.
  [[nodiscard]] std::size_t pairs_of(std::size_t candidate) const noexcept;
  /// sqrt of the mean of |e_c|^2 over them, weighted by g.
  [[nodiscard]] std::optional<double> rmse_of(std::size_t candidate) const;
  /// The weights, all pairs but `left_out` counting.
  [[nodiscard]] Eigen::VectorXd weights(std::optional<std::size_t> left_out = {}) const;
  [[nodiscard]] const Eigen::VectorXd& prior() const noexcept { return prior_; }

 private:
  BlendSettings settings_;
  Eigen::VectorXd prior_;
  std::vector<CompletedPair> pairs_;
  std::vector<Eigen::Index> taking_part_;
  CompletedPair sum_;  ///< of the pairs, each times its say
};

}  // namespace slackwater::calibration
