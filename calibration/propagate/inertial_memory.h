#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calibration/propagate/stress_memory.h"
#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// What is believed of a level before its day is seen. Each is the standard deviation of a component.
struct MemoryPrior {
  /// Of what the terms below cannot explain: 3 cm/s, the noise of a regional analysis and its eddies.
  double unexplained_m_s = 0.03;
  /// How long such an error repeats itself: an hour's value of the day is not a new witness.
  double unexplained_memory_h = 6.0;
  /// Free inertial oscillation: 0.15 m/s, usual after a storm (D'Asaro 1985, J. Phys. Oceanogr. 15,
  /// 1043; Pollard and Millard 1970, Deep-Sea Res. 17, 813).
  double oscillation_m_s = 0.15;
  /// Share of a 25 m slab's answer that the deep form is short of, or has too much: as large as
  /// itself, since the layer that moves may be thinner or thicker by a factor of two.
  double slab_share = 1.0;
};

/// The functions of time in which the residual of a day is remembered:
///
///   1,   s(t) of a slab driven by the wind,   e^{-lambda (t - t_D)},   lambda = r + i f,
///
/// s = (T - m)/(rho h lambda) with m the stress memory: the solution of s' = -lambda s + T/(rho h).
/// Where T is unknown its share is left out, as it is in the steady part of a forecast.
class InertialBasis {
 public:
  static constexpr double slab_depth_m = 25.0;  ///< h, as the baseline reference-slab has it

  InertialBasis(UtcTime end_of_day, Horizontal lambda_per_h);
  InertialBasis(UtcTime end_of_day, Horizontal lambda_per_h, StressSeries series,
                const HourlyStress& hourly);

  /// The three functions at an instant, or their exact means over the interval; s = 0 without wind.
  [[nodiscard]] Eigen::Vector3cd over(const TimeCell& cell) const;
  [[nodiscard]] UtcTime end_of_day() const noexcept { return end_of_day_; }
  [[nodiscard]] Horizontal lambda_per_h() const noexcept { return lambda_per_h_; }

 private:
  UtcTime end_of_day_;
  Horizontal lambda_per_h_;
  StressSeries series_;
  std::optional<StressMemory> memory_;
};

/// What one level remembers of D.
struct InertialMemory {
  /// m/s; no dimension; m/s at the end of D.
  Eigen::Vector3cd coefficients = Eigen::Vector3cd::Zero();
  /// Covariance of the coefficients, each a vector: half of it belongs to a component.
  Eigen::Matrix3cd covariance = Eigen::Matrix3cd::Zero();
  double left_over_m_s = 0;  ///< standard deviation of a component of what the fit leaves
  bool has_motion = false;   ///< the level has values enough for more than a mean

  [[nodiscard]] Horizontal at(const Eigen::Vector3cd& basis) const {
    return (basis.transpose() * coefficients).value();
  }
  /// Variance of a component that the doubt about the coefficients gives.
  [[nodiscard]] double variance_at(const Eigen::Vector3cd& basis) const {
    return 0.5 * (basis.transpose() * covariance * basis.conjugate()).value().real();
  }
};

/// Rate at which free inertial motion dies out, 1/h: that of the mixed layer (e-folding `decay_h`), and where the
/// column feels the bed (finite_depth) the spin-down r/H of its linear drag beside it: 20 h in 35 m of water.
[[nodiscard]] double inertial_damping_per_h(const Calibration& calibration, double decay_h);

/// Ridge least squares over the cells of D that have a value; means are fitted as means. The
/// penalties are the ratio of the variance of the unexplained to those of the prior, the day counted
/// as the independent values it holds; the constant has none. Where more is left over than the prior
/// expects (a tide badly known, a front that passed) the fit is repeated with that as the
/// unexplained: such a day is believed less. A level with fewer than `least_values_of_a_motion` says
/// nothing of a motion in time: its memory is the mean.
///
/// @param residual   observation minus model, m/s; levels as in the calibration
/// @param level      index of the level
/// @return nothing where the level has no value
/// Rotation-equivariant: turned residual and stress turn the constant and the oscillation and leave the
/// slab's share.
[[nodiscard]] std::optional<InertialMemory> fit_inertial_memory(const VectorColumn& residual,
                                                                std::size_t level,
                                                                const InertialBasis& basis,
                                                                const MemoryPrior& prior);

inline constexpr std::size_t least_values_of_a_motion = 4;

}  // namespace slackwater::calibration
