#include "calibration/blend/blend.h"

#include <algorithm>
#include <cmath>

#include "calibration/blend/evidence.h"
#include "calibration/blend/weighted_mean.h"
#include "fields/base/check.h"
#include "fields/base/text.h"

namespace slackwater::calibration {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Pairs' worth of belief that a baseline gains nothing on the blend.
constexpr double pairs_of_doubt = 4.0;

void check(std::span<const Candidate> candidates) {
  expects(std::any_of(candidates.begin(), candidates.end(),
                      [](const Candidate& c) { return c.available; }),
          "a blend needs a candidate that is available");
  for (const Candidate& candidate : candidates) {
    expects(std::isfinite(candidate.prior_weight) && candidate.prior_weight >= 0,
            "a prior weight is a number >= 0");
  }
}

/// The candidate that stands alone where none of the prior is available.
std::size_t first_in_line(std::span<const Candidate> candidates) {
  for (const Candidate& standard : standard_candidates()) {
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (candidates[c].available && candidates[c].method == standard.method) return c;
    }
  }
  const auto first = std::find_if(candidates.begin(), candidates.end(),
                                  [](const Candidate& c) { return c.available; });
  return static_cast<std::size_t>(first - candidates.begin());
}

VectorXd prior_of(std::span<const Candidate> candidates) {
  VectorXd prior = VectorXd::Zero(static_cast<Index>(candidates.size()));
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (candidates[c].available) prior[static_cast<Index>(c)] = candidates[c].prior_weight;
  }
  if (prior.sum() > 0) return prior / prior.sum();
  return VectorXd::Unit(prior.size(), static_cast<Index>(first_in_line(candidates)));
}

/// For each pair the weights fitted to the others.
std::vector<VectorXd> weights_without(const Evidence& evidence) {
  std::vector<VectorXd> weights;
  for (std::size_t i = 0; i < evidence.pairs().size(); ++i) weights.push_back(evidence.weights(i));
  return weights;
}

/// Squared error of the blend in each pair with those.
std::vector<double> squares_of_blend(const Evidence& evidence, std::span<const VectorXd> without) {
  std::vector<double> squares;
  for (std::size_t i = 0; i < without.size(); ++i)
    squares.push_back(std::max(0.0, without[i].dot(evidence.pairs()[i].gram * without[i])));
  return squares;
}

std::vector<double> as_list(const VectorXd& weights) {
  return {weights.data(), weights.data() + weights.size()};
}

/// A baseline against the blend, over the pairs in which it was present.
struct Contest {
  std::size_t baseline = 0;
  WeightedMean gain;       ///< of squared error, m2/s2
  double of_blend = 0;     ///< mean squared error
  double shrunk_gain = 0;  ///< share of the root mean square error
};

Contest contest(const Evidence& evidence, std::span<const double> squares, std::size_t baseline) {
  const auto c = static_cast<Index>(baseline);
  std::vector<double> gain;
  std::vector<double> weight;
  std::vector<double> of_blend;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const CompletedPair& pair = evidence.pairs()[i];
    if (pair.present[c] <= 0) continue;
    gain.push_back(squares[i] - pair.gram(c, c));
    of_blend.push_back(squares[i]);
    weight.push_back(pair.weight);
  }
  Contest result{baseline, weighted_mean(gain, weight), weighted_mean(of_blend, weight).mean, 0.0};
  const double n = result.gain.independent;
  const double shrinkage = n / (n + pairs_of_doubt);
  if (result.of_blend > 0) {
    const double left = 1.0 - shrinkage * result.gain.mean / result.of_blend;
    result.shrunk_gain = 1.0 - std::sqrt(std::max(0.0, left));
  }
  return result;
}

/// The baseline with the greatest gain over the blend, where there is any at all.
std::optional<Contest> best_baseline(std::span<const Candidate> candidates,
                                     const Evidence& evidence, std::span<const double> squares,
                                     const BlendSettings& settings) {
  std::optional<Contest> best;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (!candidates[c].available || !candidates[c].baseline) continue;
    if (evidence.pairs_of(c) < settings.fewest_pairs_to_replace) continue;
    const Contest one = contest(evidence, squares, c);
    if (!best || one.gain.mean > best->gain.mean) best = one;
  }
  return best;
}

bool replaces(const Contest& contest, const BlendSettings& settings) {
  return contest.gain.independent >= static_cast<double>(settings.fewest_pairs_to_replace) &&
         contest.gain.mean > 0 &&
         contest.gain.mean >= settings.least_t * contest.gain.standard_error &&
         contest.shrunk_gain >= settings.least_gain;
}

std::string list_of(std::span<const CandidateShare> shares) {
  std::string list;
  for (const CandidateShare& share : shares) {
    if (share.weight <= 0) continue;
    list += (list.empty() ? "" : ", ") + std::string(name_of(share.method)) + " " +
            formatted("{:.2f}", share.weight);
  }
  return list;
}

std::string pairs_text(std::size_t pairs) {
  return std::to_string(pairs) + (pairs == 1 ? " past pair" : " past pairs");
}

std::string provenance_of(const Blend& blend, const std::optional<Contest>& contest,
                          const BlendSettings& settings) {
  if (!blend.earned) {
    return settings.prior_name + " (" + list_of(blend.share) + "): " + pairs_text(blend.pairs) +
           " verified so far; " + std::to_string(settings.fewest_pairs) +
           " are needed for other weights";
  }
  if (contest && replaces(*contest, settings)) {
    const double of_baseline = std::max(0.0, contest->of_blend - contest->gain.mean);
    return std::string(name_of(blend.share[contest->baseline].method)) + " alone: over " +
           pairs_text(blend.pairs) + " it beat the blend, " +
           formatted("{:.4f}", std::sqrt(of_baseline)) + " against " +
           formatted("{:.4f}", std::sqrt(contest->of_blend)) + " m/s";
  }
  return "weights by the errors of " + pairs_text(blend.pairs) + " (memory " +
         formatted("{:.0f}", settings.forgetting_days) + " days): " + list_of(blend.share) +
         "; past error of the blend " + formatted("{:.4f}", blend.past_rmse_m_s.value_or(0.0)) +
         " m/s";
}

}  // namespace

std::vector<Candidate> standard_candidates() {
  return {{Method::forecast, true, 1.0, false},      {Method::provider, true, 0.0, true},
          {Method::reference_slab, true, 0.0, true}, {Method::tide_harmonic, true, 0.0, true},
          {Method::tide_phase, true, 0.0, true},     {Method::day_mean, true, 0.0, true},
          {Method::same_hour, true, 0.0, true},      {Method::persistence, true, 0.0, true},
          {Method::merged, true, 4.0, false}};
}

Blend blend_of(std::span<const Candidate> candidates, std::span<const PastPair> past,
               const BlendSettings& settings) {
  check(candidates);
  const Evidence evidence(candidates, past, prior_of(candidates), settings);
  Blend result;
  result.pairs = evidence.pairs().size();
  result.earned = result.pairs >= settings.fewest_pairs;
  VectorXd weights = result.earned ? evidence.weights() : evidence.prior();
  const std::vector<VectorXd> without = weights_without(evidence);
  const std::vector<double> squares = squares_of_blend(evidence, without);
  std::optional<Contest> best;
  if (result.earned) {
    std::vector<double> g;
    for (const CompletedPair& pair : evidence.pairs()) g.push_back(pair.weight);
    result.past_rmse_m_s = std::sqrt(weighted_mean(squares, g).mean);
    best = best_baseline(candidates, evidence, squares, settings);
  }
  const bool is_replaced = best && replaces(*best, settings);
  if (is_replaced) weights = VectorXd::Unit(weights.size(), static_cast<Index>(best->baseline));
  result.without_pair.assign(past.size(), as_list(weights));
  if (result.earned && !is_replaced) {
    for (std::size_t i = 0; i < without.size(); ++i)
      result.without_pair[evidence.pairs()[i].place] = as_list(without[i]);
  }
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    result.share.push_back({candidates[c].method, weights[static_cast<Index>(c)],
                            evidence.pairs_of(c), evidence.rmse_of(c)});
    if (result.earned && candidates[c].baseline && result.share.back().weight == 1.0) {
      result.fell_back_to = c;
    }
  }
  result.provenance = provenance_of(result, best, settings);
  return result;
}

}  // namespace slackwater::calibration
