#include "calibration/skill/score.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::calibration {
namespace {

constexpr double calm_m_s = 0.05;
constexpr double z_of_80_percent = 1.2815515655446004;  ///< 90 % quantile of the standard normal
constexpr double deg_per_rad = 180.0 / constants::pi;

void score_direction(std::span<const Horizontal> forecast, std::span<const Horizontal> truth,
                     VectorScore& score) {
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (std::abs(forecast[i]) < calm_m_s || std::abs(truth[i]) < calm_m_s) continue;
    sum += std::abs(std::arg(forecast[i] * std::conj(truth[i]))) * deg_per_rad;
    count += 1.0;
  }
  if (count > 0) score.direction_mae_deg = sum / count;
}

void score_correlation(std::span<const Horizontal> forecast, std::span<const Horizontal> truth,
                       VectorScore& score) {
  const auto n = static_cast<double>(truth.size());
  const Horizontal mean_forecast =
      std::accumulate(forecast.begin(), forecast.end(), Horizontal{}) / n;
  const Horizontal mean_truth = std::accumulate(truth.begin(), truth.end(), Horizontal{}) / n;
  Horizontal product{};
  double power_forecast = 0;
  double power_truth = 0;
  double size = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Horizontal f = forecast[i] - mean_forecast;
    const Horizontal t = truth[i] - mean_truth;
    product += std::conj(f) * t;
    power_forecast += std::norm(f);
    power_truth += std::norm(t);
    size = std::max({size, std::norm(forecast[i]), std::norm(truth[i])});
  }
  // A constant has a spread of rounding errors, which correlates with nothing.
  if (std::min(power_forecast, power_truth) <= 1e-24 * n * size) return;
  score.correlation_abs =
      std::min(1.0, std::abs(product) / std::sqrt(power_forecast * power_truth));
  score.correlation_deg = std::arg(product) * deg_per_rad;
}

void score_spread(std::span<const Horizontal> forecast, std::span<const Horizontal> truth,
                  std::span<const double> sigma_m_s, VectorScore& score) {
  double crps = 0;
  double inside = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double sigma = sigma_m_s[i];
    expects(sigma >= 0, "a standard deviation is not negative");
    const auto component = [&](double f, double t) {
      crps += normal_crps(f, sigma, t);
      if (std::abs(f - t) <= z_of_80_percent * sigma) inside += 1.0;
    };
    component(forecast[i].real(), truth[i].real());
    component(forecast[i].imag(), truth[i].imag());
  }
  const double components = 2.0 * static_cast<double>(truth.size());
  score.crps_m_s = crps / components;
  score.coverage_80 = inside / components;
}

}  // namespace

VectorScore score_vectors(std::span<const Horizontal> forecast, std::span<const Horizontal> truth,
                          std::span<const double> sigma_m_s) {
  expects(!truth.empty() && forecast.size() == truth.size(),
          "scores need pairs of forecast and truth");
  expects(sigma_m_s.empty() || sigma_m_s.size() == truth.size(),
          "one standard deviation per forecast");
  const auto n = static_cast<double>(truth.size());
  VectorScore score;
  score.n = truth.size();
  Horizontal bias{};
  double squares = 0;
  double speed = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    bias += forecast[i] - truth[i];
    squares += std::norm(forecast[i] - truth[i]);
    speed += std::abs(forecast[i]) - std::abs(truth[i]);
  }
  score.rmse_m_s = std::sqrt(squares / n);
  score.bias_east_m_s = bias.real() / n;
  score.bias_north_m_s = bias.imag() / n;
  score.speed_bias_m_s = speed / n;
  score_direction(forecast, truth, score);
  score_correlation(forecast, truth, score);
  if (!sigma_m_s.empty()) score_spread(forecast, truth, sigma_m_s, score);
  return score;
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

double normal_crps(double mean, double sigma, double truth) noexcept {
  if (sigma <= 0) return std::abs(truth - mean);
  const double z = (truth - mean) / sigma;
  const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * constants::pi);
  // 2 Phi(z) - 1 = erf(z/sqrt 2)
  return sigma *
         (z * std::erf(z / std::sqrt(2.0)) + 2.0 * density - 1.0 / std::sqrt(constants::pi));
}

double rmse_of_pairs(std::span<const double> pair_rmse_m_s) {
  expects(!pair_rmse_m_s.empty(), "a set has at least one pair");
  double squares = 0;
  for (const double rmse : pair_rmse_m_s) squares += rmse * rmse;
  return std::sqrt(squares / static_cast<double>(pair_rmse_m_s.size()));
}

std::optional<Interval95> bootstrap_rmse(std::span<const double> squared_error,
                                         std::span<const std::size_t> block, Rng& random,
                                         int draws) {
  expects(squared_error.size() == block.size(), "one block id per value");
  expects(draws >= 40, "an interval of 95 % needs at least 40 draws");
  struct Sum {
    double squares = 0;
    double count = 0;
  };
  std::map<std::size_t, Sum> by_id;
  for (std::size_t i = 0; i < block.size(); ++i) {
    by_id[block[i]].squares += squared_error[i];
    by_id[block[i]].count += 1.0;
  }
  if (by_id.size() < 2) return std::nullopt;
  std::vector<Sum> blocks;
  for (const auto& [id, sum] : by_id) blocks.push_back(sum);
  std::vector<double> rmse(static_cast<std::size_t>(draws));
  for (double& result : rmse) {
    Sum drawn;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const auto pick =
          static_cast<std::size_t>(random.uniform() * static_cast<double>(blocks.size()));
      drawn.squares += blocks[pick].squares;
      drawn.count += blocks[pick].count;
    }
    result = std::sqrt(drawn.squares / drawn.count);
  }
  std::sort(rmse.begin(), rmse.end());
  const auto quantile = [&](double share) {
    return rmse[static_cast<std::size_t>(std::lround(share * static_cast<double>(draws - 1)))];
  };
  return Interval95{quantile(0.025), quantile(0.975)};
}

}  // namespace slackwater::calibration
