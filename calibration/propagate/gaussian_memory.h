#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "calibration/propagate/hourly_values.h"
#include "calibration/propagate/memory_kernel.h"
#include "fields/base/random.h"

namespace slackwater::calibration {

/// A depth between two levels that have values.
struct LevelMix {
  std::size_t above = 0;  ///< equal to `below` at a level, and beyond the outermost
  std::size_t below = 0;
  double share_below = 0;

  template <typename T>
  [[nodiscard]] T of(const T& at_above, const T& at_below) const {
    return (1.0 - share_below) * at_above + share_below * at_below;
  }
};

/// What each level of a column remembers of day D, by Gaussian-process regression (Rasmussen and
/// Williams 2006, ch. 2) with the kernel of memory_kernel.h. With y the values of a level, K_0 the
/// kernel without the own share, K = K_0 + n^2 + stated errors, k_* its covariance with later times
/// and S the answer to the wind (S_* later):
///
///   mean(t) = k_* K^-1 (y - g S) + g S_*,      g = b^2 S^H K^-1 y / e,   e = 1 + b^2 S^H K^-1 S
///   cov     = k_** + n^2 - k_* K^-1 k_*^H + x x^H b^2 / e,               x = S_* - k_* K^-1 S
///
/// The levels are regressed each by itself: the term b is a rank-one update of what all levels that
/// miss the same values share, one Cholesky factor. `cov` is that of a value the product would give,
/// its noise n included.
///
/// A level without values is as its neighbours with values are, linear in depth, and held beyond the
/// outermost. Where no level has any the prior is left: mean 0.
///
/// Times may lie anywhere, within D too; a level is not asked to agree with its own values there, only
/// to their noise. Turning y turns the mean and leaves the rest: rotation-equivariant. Thread-safe
/// after construction. Cost of 24 cells x 35 levels: 0.3 ms, and 0.5 ms to predict 73 times.
class GaussianMemory {
 public:
  /// @param residual      observation minus tide minus the calibrated answer to the wind, up to the
  ///                      end of D (later cells are not read); instants or means. The cost is cubic
  ///                      in the hours that have values: cut a long record to a few days
  /// @param wind_answer   S at the residual's cells, m/s, times x levels; a mean over a mean
  /// @param end_of_day    24:00 of D
  /// @param inertial_damping_per_h  r > 0
  /// @param coriolis_rad_h          f, rad per HOUR, positive in the north
  /// @param observation_sigma_m_s   stated errors beside the kernel's noise, white: standard
  ///                                deviation of a component, times x levels; empty: none
  GaussianMemory(const VectorColumn& residual, std::span<const Horizontal> wind_answer,
                 UtcTime end_of_day, double inertial_damping_per_h, double coriolis_rad_h,
                 const MemoryKernel& kernel = {},
                 std::span<const double> observation_sigma_m_s = {});

  [[nodiscard]] std::size_t levels() const noexcept { return depth_m_.size(); }
  /// Whether the level has a value of its own.
  [[nodiscard]] bool has(std::size_t level) const;
  /// The levels with values about any depth; nothing where there are none.
  [[nodiscard]] std::optional<LevelMix> at_depth(double depth_m) const;

  /// Mean and variance of a component at instants; arrays over times x levels.
  /// @param wind_answer_later  S at these times, m/s
  void predict(std::span<const UtcTime> times, std::span<const Horizontal> wind_answer_later,
               std::span<Horizontal> mean, std::span<double> variance) const;

  /// Departures from that mean, members x times x levels: drawn from the posterior covariance in
  /// time, exactly. Two levels use random numbers of correlation e^{-|dz|/L}: the regression does not
  /// know how errors hang together in depth, and water of one layer errs as one. A level without
  /// values departs as the nearer of its neighbours would there, to its own variance.
  void sample(std::span<const UtcTime> times, std::span<const Horizontal> wind_answer_later,
              Rng& random, int members, std::span<Horizontal> departures) const;

  /// log p(y) under the kernel, summed over levels: complex Gaussian, natural logarithm.
  [[nodiscard]] double log_evidence() const noexcept { return log_evidence_; }

 private:
  /// Levels that have values in the same cells, with the same stated errors.
  struct Group {
    std::vector<std::size_t> level;
    std::vector<HourCell> cell;
    Eigen::MatrixXcd factor;         ///< L of K = L L^H
    Eigen::MatrixXcd weights;        ///< K^-1 (y - g S), cells x levels of the group
    Eigen::MatrixXcd share_weights;  ///< K^-1 S
    Eigen::VectorXcd share;          ///< g
    Eigen::VectorXd share_variance;  ///< b^2 / e
  };
  /// Where a level stands among the groups; meaningless for a level without values.
  struct Place {
    std::size_t group = 0;
    Eigen::Index column = 0;
  };
  /// Of the levels of a group, at asked times.
  struct Posterior {
    Eigen::MatrixXcd mean;           ///< times x levels
    Eigen::MatrixXcd half;           ///< L^-1 k_*^H, cells x times
    Eigen::MatrixXcd share_missing;  ///< x, times x levels
    Eigen::MatrixXd variance;        ///< of the vector
  };

  void group_levels(const HourlyValues& values);
  void regress(Group& group, const HourlyValues& values);
  [[nodiscard]] Posterior posterior(const Group& group, std::span<const HourCell> times,
                                    std::span<const Horizontal> wind_answer_later) const;
  [[nodiscard]] std::vector<HourCell> hours_after_day(std::span<const UtcTime> times) const;
  /// Random vectors, times + 1 a level (the last for its own share), hanging together in depth.
  [[nodiscard]] Eigen::MatrixXcd draw(Eigen::Index rows, Rng& random) const;

  MemoryKernel kernel_;
  MemoryCovariance covariance_;
  UtcTime end_of_day_;
  std::vector<double> depth_m_;
  std::vector<std::size_t> nodes_;  ///< levels with values, by depth
  std::vector<LevelMix> mix_;       ///< per level
  std::vector<Place> place_;        ///< per level
  std::vector<Group> groups_;
  double log_evidence_ = 0;
};

}  // namespace slackwater::calibration
