#include "calibration/propagate/gaussian_memory.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

Index signed_index(std::size_t i) { return static_cast<Index>(i); }

std::vector<std::size_t> by_depth(std::span<const double> depth_m) {
  std::vector<std::size_t> order(depth_m.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return depth_m[a] < depth_m[b]; });
  return order;
}

/// The rows of some cells and the columns of some levels.
template <typename Matrix>
Matrix part_of(const Matrix& all, const std::vector<Index>& rows,
               const std::vector<std::size_t>& levels) {
  Matrix part(signed_index(rows.size()), signed_index(levels.size()));
  for (Index j = 0; j < part.cols(); ++j) {
    for (Index i = 0; i < part.rows(); ++i)
      part(i, j) =
          all(rows[static_cast<std::size_t>(i)], signed_index(levels[static_cast<std::size_t>(j)]));
  }
  return part;
}

/// Answers to the wind of some levels; `all` is times x levels, level fastest.
MatrixXcd answers_of(std::span<const Horizontal> all, std::size_t times, std::size_t levels,
                     const std::vector<std::size_t>& wanted) {
  MatrixXcd part(signed_index(times), signed_index(wanted.size()));
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    for (std::size_t t = 0; t < times; ++t)
      part(signed_index(t), signed_index(j)) = all[t * levels + wanted[j]];
  }
  return part;
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

}  // namespace

GaussianMemory::GaussianMemory(const VectorColumn& residual,
                               std::span<const Horizontal> wind_answer, UtcTime end_of_day,
                               double inertial_damping_per_h, double coriolis_rad_h,
                               const MemoryKernel& kernel,
                               std::span<const double> observation_sigma_m_s)
    : kernel_(kernel),
      covariance_(kernel, inertial_damping_per_h, coriolis_rad_h),
      end_of_day_(end_of_day),
      depth_m_(residual.levels_m) {
  if (depth_m_.empty()) depth_m_ = {0.0};  // one level without a depth
  const HourlyValues values =
      hourly_values(residual, wind_answer, end_of_day, observation_sigma_m_s);
  for (const std::size_t k : by_depth(depth_m_)) {
    if (values.has.col(signed_index(k)).any()) nodes_.push_back(k);
  }
  for (std::size_t k = 0; k < levels(); ++k)
    mix_.push_back(at_depth(depth_m_[k]).value_or(LevelMix{k, k, 0.0}));
  place_.resize(levels());
  group_levels(values);
  for (Group& group : groups_) regress(group, values);
}

bool GaussianMemory::has(std::size_t level) const {
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

void GaussianMemory::group_levels(const HourlyValues& values) {
  for (std::size_t k = 0; k < levels(); ++k) {
    // Without any value at any level, all are one group without cells: the prior.
    if (!nodes_.empty() && !has(k)) continue;
    std::size_t g = 0;
    while (g < groups_.size() && !same_cells_and_errors(values, groups_[g].level.front(), k)) ++g;
    if (g == groups_.size()) groups_.emplace_back();
    place_[k] = {g, signed_index(groups_[g].level.size())};
    groups_[g].level.push_back(k);
  }
}

void GaussianMemory::regress(Group& group, const HourlyValues& values) {
  const std::vector<Index> rows = cells_of(values, group.level.front());
  for (const Index i : rows) group.cell.push_back(values.cell[static_cast<std::size_t>(i)]);
  const Index n = signed_index(rows.size());
  const auto m = signed_index(group.level.size());

  MatrixXcd covariance = covariance_.between(group.cell, group.cell);
  for (Index i = 0; i < n; ++i)
    covariance(i, i) +=
        kernel_.noise_m_s * kernel_.noise_m_s +
        values.error_m2_s2(rows[static_cast<std::size_t>(i)], signed_index(group.level.front()));
  const Eigen::LLT<MatrixXcd> cholesky(covariance);
  expects(n == 0 || cholesky.info() == Eigen::Success, "a covariance with noise has a factor");
  group.factor = cholesky.matrixL();
  const auto whitened = [&](MatrixXcd right) {
    group.factor.triangularView<Eigen::Lower>().solveInPlace(right);
    return right;
  };
  MatrixXcd y = whitened(part_of(values.value_m_s, rows, group.level));
  const MatrixXcd s = whitened(part_of(values.wind_answer_m_s, rows, group.level));

  const double b2 = kernel_.own_share * kernel_.own_share;
  group.share.resize(m);
  group.share_variance.resize(m);
  const double log_determinant = 2.0 * group.factor.diagonal().real().array().log().sum();
  for (Index j = 0; j < m; ++j) {
    const double evidence_of_share = 1.0 + b2 * s.col(j).squaredNorm();
    const Horizontal overlap = s.col(j).dot(y.col(j));  // S^H K^-1 y
    group.share(j) = b2 * overlap / evidence_of_share;
    group.share_variance(j) = b2 / evidence_of_share;
    log_evidence_ -= y.col(j).squaredNorm() - b2 * std::norm(overlap) / evidence_of_share +
                     log_determinant + std::log(evidence_of_share) +
                     static_cast<double>(n) * std::log(constants::pi);
    y.col(j) -= group.share(j) * s.col(j);
  }
  const auto unwhitened = [&](MatrixXcd right) {
    group.factor.adjoint().triangularView<Eigen::Upper>().solveInPlace(right);
    return right;
  };
  group.weights = unwhitened(std::move(y));
  group.share_weights = unwhitened(s);
}

std::vector<HourCell> GaussianMemory::hours_after_day(std::span<const UtcTime> times) const {
  std::vector<HourCell> hours;
  hours.reserve(times.size());
  for (const UtcTime time : times) hours.push_back(HourCell::at(hours_between(end_of_day_, time)));
  return hours;
}

GaussianMemory::Posterior GaussianMemory::posterior(
    const Group& group, std::span<const HourCell> times,
    std::span<const Horizontal> wind_answer_later) const {
  Posterior out;
  const MatrixXcd later = covariance_.between(times, group.cell);
  const MatrixXcd answer = answers_of(wind_answer_later, times.size(), levels(), group.level);
  out.mean = answer * group.share.asDiagonal();
  out.mean.noalias() += later * group.weights;
  out.share_missing = answer;
  out.share_missing.noalias() -= later * group.share_weights;
  out.half = later.adjoint();
  group.factor.triangularView<Eigen::Lower>().solveInPlace(out.half);

  const double noise_m2_s2 = kernel_.noise_m_s * kernel_.noise_m_s;
  const Eigen::VectorXd known = out.half.colwise().squaredNorm();
  out.variance = out.share_missing.cwiseAbs2() * group.share_variance.asDiagonal();
  // Rounding must not make a value surer than its noise.
  out.variance.colwise() +=
      ((covariance_.variance_m2_s2() - known.array()).max(0.0) + noise_m2_s2).matrix();
  return out;
}

void GaussianMemory::predict(std::span<const UtcTime> times,
                             std::span<const Horizontal> wind_answer_later,
                             std::span<Horizontal> mean, std::span<double> variance) const {
  const std::size_t n = times.size() * levels();
  expects(wind_answer_later.size() == n, "one answer to the wind for each time and level");
  expects(mean.size() == n && variance.size() == n, "room for each time and level");
  const std::vector<HourCell> hours = hours_after_day(times);
  std::vector<Posterior> posteriors;
  for (const Group& group : groups_)
    posteriors.push_back(posterior(group, hours, wind_answer_later));
  for (std::size_t k = 0; k < levels(); ++k) {
    const Place above = place_[mix_[k].above];
    const Place below = place_[mix_[k].below];
    for (std::size_t t = 0; t < times.size(); ++t) {
      const Index i = signed_index(t);
      mean[t * levels() + k] = mix_[k].of(posteriors[above.group].mean(i, above.column),
                                          posteriors[below.group].mean(i, below.column));
      variance[t * levels() + k] =
          0.5 * mix_[k].of(posteriors[above.group].variance(i, above.column),
                           posteriors[below.group].variance(i, below.column));
    }
  }
}

MatrixXcd GaussianMemory::draw(Index rows, Rng& random) const {
  MatrixXcd drawn(rows, signed_index(levels()));
  const auto one = [&] {
    const double east = random.normal();
    return Horizontal(east, random.normal()) / std::sqrt(2.0);
  };
  // An exponential correlation along a line is a first-order autoregression from level to level.
  const std::vector<std::size_t> order = by_depth(depth_m_);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double kept =
        k == 0
            ? 0.0
            : std::exp(-(depth_m_[order[k]] - depth_m_[order[k - 1]]) / kernel_.vertical_scale_m);
    const double fresh = std::sqrt(1.0 - kept * kept);
    for (Index i = 0; i < rows; ++i) {
      const Horizontal before = k == 0 ? 0.0 : drawn(i, signed_index(order[k - 1]));
      drawn(i, signed_index(order[k])) = kept * before + fresh * one();
    }
  }
  return drawn;
}

void GaussianMemory::sample(std::span<const UtcTime> times,
                            std::span<const Horizontal> wind_answer_later, Rng& random, int members,
                            std::span<Horizontal> departures) const {
  const std::size_t n = times.size() * levels();
  expects(members >= 0, "a number of members is not negative");
  expects(departures.size() == static_cast<std::size_t>(members) * n,
          "room for each member, time and level");
  std::vector<Horizontal> mean(n);
  std::vector<double> variance(n);
  predict(times, wind_answer_later, mean, variance);

  const std::vector<HourCell> hours = hours_after_day(times);
  const MatrixXcd prior = covariance_.between(hours, hours);
  const Index rows = signed_index(times.size());
  std::vector<Posterior> posteriors;
  std::vector<MatrixXcd> factors;
  for (const Group& group : groups_) {
    posteriors.push_back(posterior(group, hours, wind_answer_later));
    MatrixXcd covariance = prior - posteriors.back().half.adjoint() * posteriors.back().half;
    covariance.diagonal().array() += kernel_.noise_m_s * kernel_.noise_m_s;
    const Eigen::LLT<MatrixXcd> cholesky(covariance);
    expects(rows == 0 || cholesky.info() == Eigen::Success, "a covariance with noise has a factor");
    factors.push_back(cholesky.matrixL());
  }
  for (int member = 0; member < members; ++member) {
    const MatrixXcd drawn = draw(rows + 1, random);
    const std::span<Horizontal> out = departures.subspan(static_cast<std::size_t>(member) * n, n);
    for (std::size_t k = 0; k < levels(); ++k) {
      const std::size_t source = mix_[k].share_below > 0.5 ? mix_[k].below : mix_[k].above;
      const Place place = place_[source];
      const Group& group = groups_[place.group];
      const auto own = drawn.col(signed_index(k));
      VectorXcd departure = factors[place.group].triangularView<Eigen::Lower>() * own.head(rows);
      departure += std::sqrt(group.share_variance(place.column)) * own(rows) *
                   posteriors[place.group].share_missing.col(place.column);
      for (std::size_t t = 0; t < times.size(); ++t) {
        const double scale =
            std::sqrt(variance[t * levels() + k] / variance[t * levels() + source]);
        out[t * levels() + k] = scale * departure(signed_index(t));
      }
    }
  }
}

}  // namespace slackwater::calibration
