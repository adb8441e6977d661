#include "calibration/blend/evidence.h"

#include <algorithm>
#include <cmath>

#include "calibration/blend/simplex_quadratic.h"
#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Part of its own mean square error that is added to a candidate's penalty, so that identical
/// candidates have one answer; it moves a weight by less than 1e-5 where they differ.
constexpr double ridge = 1e-6;
/// The same of the mean over the candidates, for one that was never wrong.
constexpr double ridge_of_all = 1e-12;
/// In forgetting times: what is older has less than 0.3 % of a pair's say.
constexpr double oldest = 6.0;

/// Times the usual mean square error: twice the usual error.
constexpr double unusual = 4.0;

/// Mean over the candidates present of their mean square errors.
double severity(const CompletedPair& pair) { return pair.own.sum() / pair.present.sum(); }

/// The severity that half of the weight lies below.
double usual_severity(const std::vector<CompletedPair>& pairs) {
  std::vector<std::pair<double, double>> by_severity;
  double total = 0;
  for (const CompletedPair& pair : pairs) {
    by_severity.emplace_back(severity(pair), pair.weight);
    total += pair.weight;
  }
  std::sort(by_severity.begin(), by_severity.end());
  double below = 0;
  for (const auto& [value, weight] : by_severity) {
    below += weight;
    if (below >= 0.5 * total) return value;
  }
  return 0.0;
}

void limit_the_unusual(std::vector<CompletedPair>& pairs) {
  const double limit = unusual * usual_severity(pairs);
  for (CompletedPair& pair : pairs) {
    pair.say = pair.weight;
    if (limit > 0 && severity(pair) > limit) pair.say *= limit / severity(pair);
  }
}

std::optional<CompletedPair> completed(const PastPair& raw, const VectorXd& prior) {
  const PastPair pair = without_unusable(raw);
  const Index k = prior.size();
  CompletedPair result;
  result.present = VectorXd::Zero(k);
  for (Index c = 0; c < k; ++c) result.present[c] = pair.present[static_cast<std::size_t>(c)];
  const VectorXd prior_here = prior.cwiseProduct(result.present);
  if (prior_here.sum() <= 0) return std::nullopt;
  const VectorXd stand_in = prior_here / prior_here.sum();

  MatrixXd known = pair.gram;  // absent rows may hold NaN
  MatrixXd errors_from = MatrixXd::Zero(k, k);
  for (Index c = 0; c < k; ++c) {
    if (result.present[c] > 0) {
      errors_from(c, c) = 1.0;
    } else {
      known.row(c).setZero();
      known.col(c).setZero();
      errors_from.row(c) = stand_in.transpose();
    }
  }
  known = (0.5 * (known + known.transpose())).eval();
  result.gram = errors_from * known * errors_from.transpose();
  result.own = result.present.cwiseProduct(result.gram.diagonal());
  const VectorXd with_prior = result.gram * stand_in;
  const double of_prior = stand_in.dot(with_prior);
  result.differs = result.gram.diagonal() - 2.0 * with_prior + VectorXd::Constant(k, of_prior);
  result.differs = result.differs.cwiseMax(0.0).cwiseProduct(result.present);
  return result;
}

CompletedPair nothing(Index k) {
  return {
      0.0, 0.0, 0, MatrixXd::Zero(k, k), VectorXd::Zero(k), VectorXd::Zero(k), VectorXd::Zero(k)};
}

void add(CompletedPair& sum, const CompletedPair& pair, double factor) {
  sum.say += factor;
  sum.gram += factor * pair.gram;
  sum.differs += factor * pair.differs;
  sum.own += factor * pair.own;
  sum.present += factor * pair.present;
}

/// d_c, over the pairs in which c was present, and the ridge.
VectorXd penalties(const CompletedPair& sum, double scale) {
  VectorXd d = VectorXd::Constant(sum.own.size(), ridge_of_all * scale);
  for (Index c = 0; c < d.size(); ++c) {
    // What is left of the sum when its only pair is taken out is rounding.
    if (sum.present[c] <= 1e-12 * sum.say) continue;
    const double own = std::max(0.0, sum.own[c] / sum.present[c]);
    d[c] += std::clamp(sum.differs[c] / sum.present[c], 0.0, own) + ridge * own;
  }
  return d;
}

/// Fits the shares of some candidates; those that come out smaller than `least` are dropped, the
/// smallest first, and the rest is fitted again.
VectorXd fit_and_prune(const MatrixXd& a, const VectorXd& b, std::vector<Index> some,
                       double least) {
  VectorXd shares = minimise_on_simplex(a(some, some), b(some));
  while (true) {
    std::size_t smallest = some.size();
    std::size_t in_use = 0;
    for (std::size_t j = 0; j < some.size(); ++j) {
      const double share = shares[static_cast<Index>(j)];
      if (share <= 0) continue;
      ++in_use;
      if (smallest == some.size() || share < shares[static_cast<Index>(smallest)]) smallest = j;
    }
    if (in_use <= 1 || shares[static_cast<Index>(smallest)] >= least) break;
    some.erase(some.begin() + static_cast<std::ptrdiff_t>(smallest));
    shares = minimise_on_simplex(a(some, some), b(some));
  }
  VectorXd w = VectorXd::Zero(b.size());
  w(some) = shares;
  return w;
}

}  // namespace

Evidence::Evidence(std::span<const Candidate> candidates, std::span<const PastPair> past,
                   VectorXd prior, const BlendSettings& settings)
    : settings_(settings), prior_(std::move(prior)), sum_(nothing(prior_.size())) {
  expects(settings.forgetting_days > 0 && settings.prior_pairs > 0,
          "a blend forgets in a positive time and its prior has a positive strength");
  for (std::size_t i = 0; i < past.size(); ++i) {
    expects(past[i].candidates() == candidates.size(),
            "a past pair has as many candidates as the blend");
    if (past[i].age_days > oldest * settings.forgetting_days) continue;
    std::optional<CompletedPair> pair = completed(past[i], prior_);
    if (!pair) continue;
    pair->place = i;
    pair->weight = std::exp(-past[i].age_days / settings.forgetting_days);
    pairs_.push_back(std::move(*pair));
  }
  std::stable_sort(pairs_.begin(), pairs_.end(),
                   [](const auto& a, const auto& b) { return a.weight < b.weight; });
  limit_the_unusual(pairs_);
  for (const CompletedPair& pair : pairs_) add(sum_, pair, pair.say);
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const auto index = static_cast<Index>(c);
    if (!candidates[c].available) continue;
    if (prior_[index] > 0 || pairs_of(c) >= settings.fewest_pairs) taking_part_.push_back(index);
  }
}

std::size_t Evidence::pairs_of(std::size_t candidate) const noexcept {
  const auto c = static_cast<Index>(candidate);
  return static_cast<std::size_t>(std::count_if(
      pairs_.begin(), pairs_.end(), [c](const auto& pair) { return pair.present[c] > 0; }));
}

std::optional<double> Evidence::rmse_of(std::size_t candidate) const {
  const auto c = static_cast<Index>(candidate);
  double squares = 0;
  double weight = 0;
  for (const CompletedPair& pair : pairs_) {
    if (pair.present[c] <= 0) continue;
    squares += pair.weight * pair.own[c];
    weight += pair.weight;
  }
  if (weight <= 0) return std::nullopt;
  return std::sqrt(squares / weight);
}

VectorXd Evidence::weights(std::optional<std::size_t> left_out) const {
  CompletedPair sum = sum_;
  if (left_out) add(sum, pairs_[*left_out], -pairs_[*left_out].say);
  const double scale = sum.gram.trace() / static_cast<double>(prior_.size());
  // No pairs, or all candidates without error: nothing to choose by.
  if (sum.say <= 0 || !(scale > 0)) return prior_;
  const VectorXd d = penalties(sum, scale) / scale;
  MatrixXd a = sum.gram / scale;
  a.diagonal() += settings_.prior_pairs * d;
  const VectorXd b = settings_.prior_pairs * d.cwiseProduct(prior_);
  return fit_and_prune(a, b, taking_part_, settings_.least_weight);
}

}  // namespace slackwater::calibration
