#include "calibration/skill/vector_tally.h"

#include <algorithm>
#include <cmath>

#include "calibration/skill/score.h"
#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::calibration {
namespace {

constexpr double calm_m_s = 0.05;
constexpr double deg_per_rad = 180.0 / constants::pi;

}  // namespace

PairContribution contribution_of(Horizontal forecast, Horizontal truth) noexcept {
  PairContribution pair{forecast, truth, std::norm(forecast - truth), 0, {}, {}};
  const double speed = std::abs(forecast);
  const double true_speed = std::abs(truth);
  pair.speed_error = speed - true_speed;
  if (speed >= calm_m_s && true_speed >= calm_m_s)
    pair.direction_error_deg = std::abs(std::arg(forecast * std::conj(truth))) * deg_per_rad;
  return pair;
}

PairContribution contribution_of(Horizontal forecast, Horizontal truth, double sigma_m_s) {
  expects(sigma_m_s >= 0, "a standard deviation is not negative");
  PairContribution pair = contribution_of(forecast, truth);
  pair.spread = {score_of_normal(forecast.real(), sigma_m_s, truth.real()),
                 score_of_normal(forecast.imag(), sigma_m_s, truth.imag())};
  return pair;
}

void VectorTally::add(const PairContribution& pair) noexcept {
  ++n_;
  squares_ += pair.squared_error;
  error_ += pair.forecast - pair.truth;
  speed_error_ += pair.speed_error;
  if (pair.direction_error_deg) {
    direction_error_deg_ += *pair.direction_error_deg;
    ++directions_;
  }
  forecast_ += pair.forecast;
  truth_ += pair.truth;
  product_ += std::conj(pair.forecast) * pair.truth;
  forecast_power_ += std::norm(pair.forecast);
  truth_power_ += std::norm(pair.truth);
  if (!pair.spread) return;
  ++spreads_;
  for (const ComponentScore& component : *pair.spread) {
    crps_ += component.crps;
    const auto cell = static_cast<std::size_t>(component.probability_below * pit_cells);
    ++pit_[std::min(cell, pit_cells - 1)];
  }
}

void VectorTally::merge(const VectorTally& other) noexcept {
  n_ += other.n_;
  squares_ += other.squares_;
  error_ += other.error_;
  speed_error_ += other.speed_error_;
  direction_error_deg_ += other.direction_error_deg_;
  directions_ += other.directions_;
  forecast_ += other.forecast_;
  truth_ += other.truth_;
  product_ += other.product_;
  forecast_power_ += other.forecast_power_;
  truth_power_ += other.truth_power_;
  spreads_ += other.spreads_;
  crps_ += other.crps_;
  for (std::size_t i = 0; i < pit_cells; ++i) pit_[i] += other.pit_[i];
}

VectorScore VectorTally::score() const {
  expects(n_ > 0, "scores need pairs of forecast and truth");
  const auto n = static_cast<double>(n_);
  VectorScore score;
  score.n = n_;
  score.rmse_m_s = std::sqrt(squares_ / n);
  score.bias_east_m_s = error_.real() / n;
  score.bias_north_m_s = error_.imag() / n;
  score.speed_bias_m_s = speed_error_ / n;
  if (directions_ > 0)
    score.direction_mae_deg = direction_error_deg_ / static_cast<double>(directions_);
  score_correlation(score);
  // Some pairs without a spread would make the shares those of another sample than the errors.
  if (spreads_ == n_) score_spread(score);
  return score;
}

void VectorTally::score_correlation(VectorScore& score) const {
  const auto n = static_cast<double>(n_);
  const Horizontal product = product_ - std::conj(forecast_) * truth_ / n;
  const double forecast_power = forecast_power_ - std::norm(forecast_) / n;
  const double truth_power = truth_power_ - std::norm(truth_) / n;
  // A constant has a spread of rounding errors (some 1e-16 of its power), which correlates with
  // nothing.
  if (std::min(forecast_power, truth_power) <= 1e-12 * (forecast_power_ + truth_power_)) return;
  score.correlation_abs =
      std::min(1.0, std::abs(product) / std::sqrt(forecast_power * truth_power));
  score.correlation_deg = std::arg(product) * deg_per_rad;
}

void VectorTally::score_spread(VectorScore& score) const {
  const double components = 2.0 * static_cast<double>(spreads_);
  std::array<double, pit_cells + 1> below{};  // share of truths below each edge of 5 %
  for (std::size_t i = 0; i < pit_cells; ++i)
    below[i + 1] = below[i] + static_cast<double>(pit_[i]) / components;
  const auto share_below = [&](double probability) {
    return below[static_cast<std::size_t>(std::lround(probability * pit_cells))];
  };
  score.crps_m_s = crps_ / components;
  score.coverage_80 = share_below(0.9) - share_below(0.1);
  Reliability reliability;
  for (std::size_t i = 0; i < reliability.below.size(); ++i)
    reliability.below[i] = share_below(Reliability::probability[i]);
  constexpr auto tenths = static_cast<double>(Reliability::pit_bins);
  for (std::size_t i = 0; i < reliability.pit.size(); ++i) {
    const auto from = static_cast<double>(i);
    reliability.pit[i] = share_below((from + 1) / tenths) - share_below(from / tenths);
  }
  score.reliability = reliability;
}

}  // namespace slackwater::calibration
