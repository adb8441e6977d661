#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibration/blend/past_pair.h"
#include "calibration/skill/method.h"

namespace slackwater::calibration {

/// A forecast that may take part in the one that is issued.
struct Candidate {
  Method method = Method::forecast;
  bool available = true;      ///< it can be made for the day that is forecast now
  double prior_weight = 0.0;  ///< >= 0, before anything is known of the past; need not sum to 1
  bool baseline = true;       ///< it may be issued in place of the blend
};

/// The methods in use with the prior that is documented: `merged`, where a provider forecasts too,
/// has four fifths and `forecast`, our own alone, the rest; all else has to earn its weight.
///
/// Two forecasts of different origin and like skill are best averaged, and weights fitted to a
/// short past do worse than equal ones: Hagedorn, Doblas-Reyes & Palmer (2005), Tellus 57A, 219;
/// Clemen (1989), Int. J. Forecasting 5, 559. With a longer past fitted weights win: Krishnamurti
/// et al. (1999), Science 285, 1548; (2000), J. Climate 13, 4196.
[[nodiscard]] std::vector<Candidate> standard_candidates();

struct BlendSettings {
  std::string prior_name = "prior weights";  ///< as the provenance calls the prior
  /// Pairs needed before the past may move a weight, in all and per baseline.
  std::size_t fewest_pairs = 5;
  /// E-folding age of what a pair says: follows the season and a provider's change of version. The
  /// memory is then worth 14 daily pairs at most.
  double forgetting_days = 14.0;
  /// Strength of the prior, in pairs. In the twin experiment of tests/calibration/blend 1 to 3 do
  /// alike; 5 costs a percent where a baseline is best, 10 costs several.
  double prior_pairs = 2.0;
  /// A smaller weight is noise of the fit and dropped (the rest is fitted again).
  double least_weight = 0.1;
  /// A baseline is issued alone only if it beat the blend in this many pairs' worth of past,
  std::size_t fewest_pairs_to_replace = 8;
  /// by this many standard errors of the mean difference of the pairs,
  double least_t = 2.5;
  /// and by this share of the blend's root mean square error after shrinkage.
  double least_gain = 0.02;
};

/// What a candidate contributes, and why.
struct CandidateShare {
  Method method = Method::forecast;
  double weight = 0;      ///< of the issued forecast; >= 0, sum 1
  std::size_t pairs = 0;  ///< past pairs it was present in
  /// Root mean square vector error over them, forgetting as the weights do; empty: none.
  std::optional<double> past_rmse_m_s;
};

/// The forecast that past verification earned.
struct Blend {
  std::vector<CandidateShare> share;  ///< in the order of the candidates
  std::size_t pairs = 0;              ///< past pairs used
  bool earned = false;                ///< false: the prior
  /// A baseline is issued alone: it earned all the weight, or it beat the blend (below).
  std::optional<std::size_t> fell_back_to;
  /// Of the blend over the same pairs, each forecast with weights fitted to the others.
  std::optional<double> past_rmse_m_s;
  /// Per past pair as given the weights that the others earned without it: what a spread is held
  /// against, which weights fitted to the pair itself would flatter. Those issued where none are
  /// earned, and where a baseline is issued alone.
  std::vector<std::vector<double>> without_pair;
  std::string provenance;  ///< one sentence
};

/// Weights of the candidates for the day that follows.
///
///   min over w >= 0, sum w = 1 of   sum_i g_i w^T G_i w + n_0 sum_c d_c (w_c - p_c)^2
///
/// G_i: second moments of the errors of past pair i; g_i = exp(-age/forgetting), lowered for a pair
/// in which the candidates erred by more than twice as much as they usually do (weighted median) to
/// what a pair of twice the usual error would say: one storm, or one garbled forecast, does not
/// decide. p: the prior weights of those available now (where none has any: the first available
/// baseline of `standard_candidates` alone, else the first available). n_0 = `prior_pairs`. d_c:
/// mean square of what candidate c says differently from the prior blend e_p, at most its own mean
/// square error: the penalty is what n_0 further pairs would add if that difference were noise. It
/// scales with the errors, so that units do not matter, and it is what shares the weight of
/// candidates that are nearly identical.
///
/// - A candidate absent in a pair has the error of the prior blend there: no evidence for it or
///   against it. Pairs without any candidate of the prior say nothing and are left out.
/// - A candidate without a prior weight needs `fewest_pairs` pairs of its own.
/// - Fewer than `fewest_pairs` pairs: the prior weights.
///
/// Fallback: of the baselines available, the one with the lowest past error against the blend on
/// common pairs is issued alone if, with x_i = (squared error of the blend, its weights fitted
/// without pair i) - (that of the baseline), weighted by g_i,
///
///   n >= 8,   mean(x) >= 2.5 standard errors,   1 - sqrt(1 - k mean(x)/mean(blend^2)) >= 2 %
///
/// n = (sum g)^2 / sum g^2 (1 - r)/(1 + r), r >= 0 the correlation of x from pair to pair: the
/// number of independent pairs; k = n/(n + 4) the shrinkage. One lucky day, however lucky, has a
/// mean of one standard error: it never decides.
///
/// @param past  any order; candidates in the same order; older than six forgetting times is ignored
/// Throws ContractViolation where no candidate is available, a prior weight is not a number >= 0,
/// or a pair has another number of candidates.  Cost: about 1 ms for 8 candidates and 60 pairs.
/// Thread-safe, deterministic.
[[nodiscard]] Blend blend_of(std::span<const Candidate> candidates, std::span<const PastPair> past,
                             const BlendSettings& settings = {});

}  // namespace slackwater::calibration
