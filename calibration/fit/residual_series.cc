#include "calibration/fit/residual_series.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

/// The residuals of one row after the other, by their indices.
std::vector<std::vector<std::size_t>> by_row(std::span<const ResidualPlace> place) {
  std::size_t rows = 0;
  for (const ResidualPlace& one : place) rows = std::max(rows, one.row + 1);
  std::vector<std::vector<std::size_t>> all(rows);
  for (std::size_t i = 0; i < place.size(); ++i) all[place[i].row].push_back(i);
  return all;
}

Eigen::Index at(std::size_t index) { return static_cast<Eigen::Index>(index); }

}  // namespace

double repeats_itself(std::span<const double> residuals) {
  const std::size_t n = residuals.size();
  const double squares =
      std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
  if (!(squares > 0)) return 1;
  const double none = 2 / std::sqrt(static_cast<double>(n));
  double times = 1, last = 0;
  std::size_t lags = 0;
  while (lags < n / 2) {
    double product = 0;
    for (std::size_t i = lags + 1; i < n; ++i) product += residuals[i] * residuals[i - lags - 1];
    if (!(product / squares > none)) break;
    last = product / squares;
    times += 2 * last;
    ++lags;
  }
  if (lags > 0) {
    // What is lost in the noise goes on falling as it fell so far.
    const double falls = std::pow(last, 1 / static_cast<double>(lags));
    times += 2 * last * falls / (1 - falls);
  }
  return std::clamp(times, 1.0, static_cast<double>(n));
}

ResidualErrors errors_in(std::span<const double> residuals, std::span<const ResidualPlace> place) {
  expects(residuals.size() == place.size(), "each residual has a place");
  std::size_t series = 0;
  for (const ResidualPlace& one : place) series = std::max(series, one.series + 1);
  std::vector<std::vector<double>> of_series(series);
  for (std::size_t i = 0; i < place.size(); ++i) of_series[place[i].series].push_back(residuals[i]);
  ResidualErrors errors;
  for (const std::vector<double>& one : of_series) {
    errors.times.push_back(repeats_itself(one));
    errors.effective += static_cast<double>(one.size()) / errors.times.back();
  }
  // Of what is missing 0 is taken, so that it remains a covariance.
  errors.variance.setZero(at(series), at(series));
  for (const std::vector<std::size_t>& row : by_row(place))
    for (const std::size_t i : row)
      for (const std::size_t j : row)
        errors.variance(at(place[i].series), at(place[j].series)) += residuals[i] * residuals[j];
  for (std::size_t k = 0; k < series; ++k)
    for (std::size_t l = 0; l < series; ++l)
      errors.variance(at(k), at(l)) /=
          std::max(1.0, std::sqrt(static_cast<double>(of_series[k].size()) *
                                  static_cast<double>(of_series[l].size())));
  return errors;
}

Eigen::MatrixXd spread_of_gradient(const Eigen::MatrixXd& jacobian,
                                   std::span<const ResidualPlace> place,
                                   const ResidualErrors& errors) {
  expects(jacobian.rows() == at(place.size()), "each residual has a row of the Jacobian");
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(jacobian.cols(), jacobian.cols());
  for (const std::vector<std::size_t>& row : by_row(place))
    for (const std::size_t i : row)
      for (const std::size_t j : row) {
        const std::size_t k = place[i].series, l = place[j].series;
        const double covariance =
            std::sqrt(errors.times[k] * errors.times[l]) * errors.variance(at(k), at(l));
        spread += covariance * (jacobian.row(at(i)).transpose() * jacobian.row(at(j)));
      }
  return spread;
}

}  // namespace slackwater::calibration
