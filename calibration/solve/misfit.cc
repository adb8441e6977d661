#include "calibration/solve/misfit.h"

#include <cmath>

#include "fields/base/numbers/statistics.h"

namespace slackwater::calibration {

VectorColumn residual_column(const VectorColumn& current, const Observations& observations,
                             const ColumnRows::Matrix& model) {
  VectorColumn residual = current;
  residual.value.assign(current.value.size(), Horizontal{});
  residual.status.assign(current.value.size(), SampleStatus::missing);
  for (const Pair& pair : observations.pairs) {
    const std::size_t at = residual.offset(pair.time, pair.level);
    residual.value[at] = pair.observed_m_s - model(static_cast<Eigen::Index>(pair.time),
                                                   static_cast<Eigen::Index>(pair.level));
    residual.status[at] = SampleStatus::ok;
  }
  return residual;
}

std::vector<MisfitAtDepth> misfit_by_depth(const VectorColumn& residual,
                                           const std::vector<double>& depth_m) {
  std::vector<MisfitAtDepth> misfit;
  for (std::size_t k = 0; k < residual.levels(); ++k) {
    MisfitAtDepth level;
    level.depth_m = depth_m[k];
    Horizontal sum{};
    double squares = 0;
    for (std::size_t t = 0; t < residual.times(); ++t) {
      if (!residual.has(t, k)) continue;
      const Horizontal r = residual.value[residual.offset(t, k)];
      ++level.n;
      sum += r;
      squares += std::norm(r);
    }
    if (level.n == 0) continue;
    const auto n = static_cast<double>(level.n);
    level.rms_m_s = std::sqrt(squares / n);
    level.bias_east_m_s = sum.real() / n;
    level.bias_north_m_s = sum.imag() / n;
    misfit.push_back(level);
  }
  return misfit;
}

double rms_m_s(const VectorColumn& residual) {
  double squares = 0;
  double n = 0;
  for (std::size_t i = 0; i < residual.value.size(); ++i) {
    if (!has_value(residual.status[i])) continue;
    squares += std::norm(residual.value[i]);
    n += 1;
  }
  return n > 0 ? std::sqrt(squares / n) : 0.0;
}

double robust_component_sigma_m_s(const VectorColumn& residual) {
  std::vector<double> modulus;
  modulus.reserve(residual.value.size());
  for (std::size_t i = 0; i < residual.value.size(); ++i) {
    if (has_value(residual.status[i])) modulus.push_back(std::abs(residual.value[i]));
  }
  if (modulus.empty()) return 0.0;
  return upper_median(std::move(modulus)) / std::sqrt(2.0 * std::log(2.0));
}

}  // namespace slackwater::calibration
