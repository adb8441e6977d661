#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "calibration/propagate/hourly_values.h"
#include "calibration/propagate/level_regression.h"
#include "calibration/propagate/memory_kernel.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration {

/// A depth between two levels that have values.
struct LevelMix {
  std::size_t above = 0;  ///< equal to `below` at a level, and beyond the outermost
  std::size_t below = 0;
  double share_below = 0;

  [[nodiscard]] std::size_t nearer() const noexcept { return share_below > 0.5 ? below : above; }
  template <typename T>
  [[nodiscard]] T of(const T& at_above, const T& at_below) const {
    return (1.0 - share_below) * at_above + share_below * at_below;
  }
};

/// What each level of a column remembers of day D, and how it is said of later: the kernel of
/// memory_kernel.h, regressed on the level's own values (level_regression.h). Levels that miss the
/// same values share the factor that costs most: in units of its own amplitude s(z) each level has
/// the same kernel.
///
/// A level without values is as its neighbours with values are, linear in depth, and held beyond
/// the outermost. Where no level has any the prior is left: mean 0.
///
/// Times may lie anywhere, within D too. Turning the values turns the mean and leaves the variance.
/// Thread-safe once made. Cost of 24 cells x 35 levels: 0.1 ms, 0.25 ms to predict 73 times, 0.4 ms
/// a member.
class GaussianMemory {
 public:
  /// @param residual      observation minus tide minus the calibrated answer to the wind, m/s, up
  ///                      to the end of D (later cells are not read); instants or means. The cost
  ///                      is cubic in the hours that have values: cut a long record to a few days
  /// @param wind_answer   S at the residual's cells, m/s, times x levels; a mean over a mean
  /// @param end_of_day    24:00 of D
  /// @param inertial_damping_per_h  r > 0
  /// @param coriolis_rad_h          f in rad per HOUR, positive in the north
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

  /// Mean and variance of a COMPONENT at instants; arrays over times x levels, level fastest. The
  /// variance is that of a value of the product, its noise included.
  /// @param wind_answer_later  S at these times, m/s; finite
  void predict(std::span<const UtcTime> times, std::span<const Horizontal> wind_answer_later,
               std::span<Horizontal> mean, std::span<double> variance) const;

  /// Departures from that mean, members x times x levels: of the exact posterior covariance in
  /// time. Two levels draw random numbers of correlation e^{-|dz|/L}: each is regressed by itself,
  /// which leaves open how their errors hang together, and water of one layer errs as one. A level
  /// without values departs as the nearer of its neighbours would, to its own variance.
  void sample(std::span<const UtcTime> times, std::span<const Horizontal> wind_answer_later,
              Rng& random, int members, std::span<Horizontal> departures) const;

  /// kappa of the kernel: how much wider the column's bands are than what is believed of all seas.
  [[nodiscard]] double surprise() const noexcept { return surprise_; }
  /// log p(residual) under the kernel with kappa = 1, summed over levels as if independent; natural
  /// logarithm.
  [[nodiscard]] double log_evidence() const noexcept { return log_evidence_; }

 private:
  /// Where a level stands among the regressions.
  struct Place {
    std::size_t regression = 0;
    Eigen::Index column = 0;
  };

  void regress(HourlyValues values, const MemoryKernel& kernel);
  [[nodiscard]] std::vector<HourCell> hours_of(std::span<const UtcTime> times) const;
  /// In units of m/s.
  [[nodiscard]] std::vector<LevelRegression::Posterior> posteriors(
      std::span<const HourCell> hours, std::span<const Horizontal> wind_answer_later) const;
  /// Complex random numbers, rows x levels, of variance 1, that hang together in depth.
  [[nodiscard]] Eigen::MatrixXcd draw(Eigen::Index rows, Rng& random) const;
  /// Variance of the vector at a level, from the levels it stands between.
  [[nodiscard]] double variance_at(const std::vector<LevelRegression::Posterior>& at,
                                   Eigen::Index time, std::size_t level) const;

  UtcTime end_of_day_;
  MemoryCovariance covariance_;
  double vertical_scale_m_;
  std::vector<double> depth_m_;
  std::vector<double> amplitude_;      ///< s(z), per level
  std::vector<std::size_t> by_depth_;  ///< all levels
  std::vector<std::size_t> nodes_;     ///< levels with values, by depth
  std::vector<LevelMix> mix_;          ///< per level
  std::vector<Place> place_;           ///< per level; meaningless for one without values
  std::vector<std::vector<std::size_t>> members_;  ///< per regression, its levels
  std::vector<LevelRegression> regressions_;       ///< in units of the amplitude
  double surprise_ = 1;
  double log_evidence_ = 0;
};

}  // namespace slackwater::calibration
