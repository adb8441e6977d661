#include "calibration/skill/score.h"

#include <cmath>

#include "calibration/skill/vector_tally.h"
#include "fields/base/check.h"

namespace slackwater::calibration {

VectorScore score_vectors(std::span<const Horizontal> forecast, std::span<const Horizontal> truth,
                          std::span<const double> sigma_m_s) {
  expects(!truth.empty() && forecast.size() == truth.size(),
          "scores need pairs of forecast and truth");
  expects(sigma_m_s.empty() || sigma_m_s.size() == truth.size(),
          "one standard deviation per forecast");
  VectorTally tally;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    tally.add(sigma_m_s.empty() ? contribution_of(forecast[i], truth[i])
                                : contribution_of(forecast[i], truth[i], sigma_m_s[i]));
  }
  return tally.score();
}

ScalarScore score_scalars(std::span<const double> forecast, std::span<const double> truth) {
  expects(!truth.empty() && forecast.size() == truth.size(),
          "scores need pairs of forecast and truth");
  const auto n = static_cast<double>(truth.size());
  ScalarScore score;
  score.n = truth.size();
  double squares = 0;
  double mean_truth = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double error = forecast[i] - truth[i];
    squares += error * error;
    score.bias += error / n;
    score.mae += std::abs(error) / n;
    mean_truth += truth[i] / n;
  }
  score.rmse = std::sqrt(squares / n);
  double departures = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double departure = forecast[i] - truth[i] - score.bias;
    departures += departure * departure;
  }
  if (mean_truth > 0) score.scatter_index = std::sqrt(departures / n) / mean_truth;
  return score;
}

double rmse_of_pairs(std::span<const double> pair_rmse) {
  expects(!pair_rmse.empty(), "a set has at least one pair");
  double squares = 0;
  for (const double rmse : pair_rmse) squares += rmse * rmse;
  return std::sqrt(squares / static_cast<double>(pair_rmse.size()));
}

}  // namespace slackwater::calibration
