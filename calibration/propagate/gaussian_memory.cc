#include "calibration/propagate/gaussian_memory.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Posterior = LevelRegression::Posterior;

Index signed_index(std::size_t i) { return static_cast<Index>(i); }

bool all_finite(std::span<const Horizontal> values) {
  return std::all_of(values.begin(), values.end(), [](Horizontal value) {
    return std::isfinite(value.real()) && std::isfinite(value.imag());
  });
}

/// The cells in which a level has a value.
std::vector<Index> cells_of(const HourlyValues& values, std::size_t level) {
  std::vector<Index> cells;
  for (Index i = 0; i < values.has.rows(); ++i) {
    if (values.has(i, signed_index(level))) cells.push_back(i);
  }
  return cells;
}

bool same_cells_and_errors(const HourlyValues& values, std::size_t a, std::size_t b) {
  const Index i = signed_index(a);
  const Index j = signed_index(b);
  return (values.has.col(i) == values.has.col(j)).all() &&
         values.error_m2_s2.col(i) == values.error_m2_s2.col(j);
}

/// Of levels that have values in the same cells.
LevelRegression::Values part_of(const HourlyValues& values,
                                const std::vector<std::size_t>& levels) {
  const std::vector<Index> rows = cells_of(values, levels.front());
  const std::vector<Index> columns(levels.begin(), levels.end());
  LevelRegression::Values part;
  for (const Index i : rows) part.cell.push_back(values.cell[static_cast<std::size_t>(i)]);
  part.error_m2_s2 = values.error_m2_s2(rows, columns.front());
  part.value_m_s = values.value_m_s(rows, columns);
  part.wind_answer_m_s = values.wind_answer_m_s(rows, columns);
  return part;
}

}  // namespace

GaussianMemory::GaussianMemory(const VectorColumn& residual,
                               std::span<const Horizontal> wind_answer, UtcTime end_of_day,
                               double inertial_damping_per_h, double coriolis_rad_h,
                               const MemoryKernel& kernel,
                               std::span<const double> observation_sigma_m_s)
    : end_of_day_(end_of_day),
      covariance_(kernel, inertial_damping_per_h, coriolis_rad_h),
      vertical_scale_m_(kernel.vertical_scale_m),
      depth_m_(residual.levels_m),
      place_(residual.levels()) {
  if (depth_m_.empty()) depth_m_ = {0.0};  // one level, which has no depth
  HourlyValues values = hourly_values(residual, wind_answer, end_of_day, observation_sigma_m_s);
  by_depth_.resize(levels());
  std::iota(by_depth_.begin(), by_depth_.end(), std::size_t{0});
  std::sort(by_depth_.begin(), by_depth_.end(),
            [&](std::size_t a, std::size_t b) { return depth_m_[a] < depth_m_[b]; });
  for (const std::size_t k : by_depth_) {
    if (values.has.col(signed_index(k)).any()) nodes_.push_back(k);
  }
  for (std::size_t k = 0; k < levels(); ++k)
    mix_.push_back(at_depth(depth_m_[k]).value_or(LevelMix{k, k, 0.0}));
  regress(std::move(values), kernel);
}

bool GaussianMemory::has(std::size_t level) const {
  expects(level < levels(), "a level of the column");
  return std::find(nodes_.begin(), nodes_.end(), level) != nodes_.end();
}

std::optional<LevelMix> GaussianMemory::at_depth(double depth_m) const {
  if (nodes_.empty()) return std::nullopt;
  const auto after =
      std::lower_bound(nodes_.begin(), nodes_.end(), depth_m,
                       [&](std::size_t node, double depth) { return depth_m_[node] < depth; });
  if (after == nodes_.begin()) return LevelMix{nodes_.front(), nodes_.front(), 0.0};
  if (after == nodes_.end()) return LevelMix{nodes_.back(), nodes_.back(), 0.0};
  const std::size_t below = *after;
  if (depth_m_[below] == depth_m) return LevelMix{below, below, 0.0};
  const std::size_t above = *std::prev(after);
  return LevelMix{above, below, (depth_m - depth_m_[above]) / (depth_m_[below] - depth_m_[above])};
}

void GaussianMemory::regress(HourlyValues values, const MemoryKernel& kernel) {
  for (std::size_t k = 0; k < levels(); ++k) {
    const double amplitude = kernel.amplitude_at(depth_m_[k]);
    amplitude_.push_back(amplitude);
    values.value_m_s.col(signed_index(k)) /= amplitude;
    values.wind_answer_m_s.col(signed_index(k)) /= amplitude;
    values.error_m2_s2.col(signed_index(k)) /= amplitude * amplitude;
    // The density of the values themselves, complex.
    const auto count = static_cast<double>(values.has.col(signed_index(k)).count());
    log_evidence_ -= 2.0 * count * std::log(amplitude);
  }
  for (std::size_t k = 0; k < levels(); ++k) {
    // Where no level has a value, all of them are one regression without cells.
    if (!nodes_.empty() && !has(k)) continue;
    const auto alike = std::find_if(members_.begin(), members_.end(), [&](const auto& group) {
      return same_cells_and_errors(values, group.front(), k);
    });
    const auto group = static_cast<std::size_t>(alike - members_.begin());
    if (alike == members_.end()) members_.emplace_back();
    place_[k] = {group, signed_index(members_[group].size())};
    members_[group].push_back(k);
  }
  double chi_squared = 0;
  for (const std::vector<std::size_t>& group : members_) {
    regressions_.emplace_back(kernel, covariance_, part_of(values, group));
    chi_squared += regressions_.back().chi_squared();
    log_evidence_ += regressions_.back().log_evidence();
  }
  if (nodes_.empty()) return;
  const double per_value = chi_squared / static_cast<double>(values.has.count());
  surprise_ =
      std::sqrt((1.0 + kernel.surprise_weight * per_value) / (1.0 + kernel.surprise_weight));
}

std::vector<HourCell> GaussianMemory::hours_of(std::span<const UtcTime> times) const {
  std::vector<HourCell> hours;
  hours.reserve(times.size());
  for (const UtcTime time : times) hours.push_back(HourCell::at(hours_between(end_of_day_, time)));
  return hours;
}

std::vector<Posterior> GaussianMemory::posteriors(
    std::span<const HourCell> hours, std::span<const Horizontal> wind_answer_later) const {
  expects(wind_answer_later.size() == hours.size() * levels(),
          "one answer to the wind for each time and level");
  expects(all_finite(wind_answer_later), "an answer to the wind is finite");
  const Eigen::Map<const MatrixXcd> by_level(wind_answer_later.data(), signed_index(levels()),
                                             signed_index(hours.size()));
  std::vector<Posterior> out;
  for (std::size_t g = 0; g < regressions_.size(); ++g) {
    const std::vector<Index> rows(members_[g].begin(), members_[g].end());
    MatrixXcd answer = by_level(rows, Eigen::all).transpose();
    Eigen::VectorXd amplitude(answer.cols());
    for (Index j = 0; j < amplitude.size(); ++j)
      amplitude(j) = amplitude_[members_[g][static_cast<std::size_t>(j)]];
    answer = answer * amplitude.cwiseInverse().asDiagonal();
    Posterior posterior = regressions_[g].at(hours, answer);
    posterior.mean = posterior.mean * amplitude.asDiagonal();
    posterior.variance =
        posterior.variance * (surprise_ * surprise_ * amplitude.cwiseAbs2()).asDiagonal();
    out.push_back(std::move(posterior));
  }
  return out;
}

void GaussianMemory::predict(std::span<const UtcTime> times,
                             std::span<const Horizontal> wind_answer_later,
                             std::span<Horizontal> mean, std::span<double> variance) const {
  const std::size_t n = times.size() * levels();
  expects(mean.size() == n && variance.size() == n, "room for each time and level");
  const std::vector<Posterior> at = posteriors(hours_of(times), wind_answer_later);
  for (std::size_t k = 0; k < levels(); ++k) {
    const LevelMix& mix = mix_[k];
    const Place above = place_[mix.above];
    const Place below = place_[mix.below];
    for (std::size_t t = 0; t < times.size(); ++t) {
      const Index i = signed_index(t);
      mean[t * levels() + k] = mix.of(at[above.regression].mean(i, above.column),
                                      at[below.regression].mean(i, below.column));
      variance[t * levels() + k] = 0.5 * variance_at(at, i, k);
    }
  }
}

double GaussianMemory::variance_at(const std::vector<Posterior>& at, Index time,
                                   std::size_t level) const {
  const Place above = place_[mix_[level].above];
  const Place below = place_[mix_[level].below];
  return mix_[level].of(at[above.regression].variance(time, above.column),
                        at[below.regression].variance(time, below.column));
}

}  // namespace slackwater::calibration
