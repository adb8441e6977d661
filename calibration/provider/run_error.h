#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "fields/base/frame.h"

namespace slackwater::calibration {

/// What is believed of the error e = water - run of a provider's runs before any is seen, at one
/// level: a Gaussian process of mean zero in time. Standard deviations are of the vector.
///
///   what all runs share   s^2 [ 0.6 e^{-|d|/T} + 0.2 e^{-r|d| - i f d}
///                               + 0.1 (cos w_M2 d + cos w_K1 d) e^{-|d|/T} ]
///   what a run gathers    g^2 [ e^{-|d|/t} - e^{-(l + l')/t} ]      within one run, leads l, l'
///   noise                 n^2 where the times are the same
///
/// d: lag of the times of validity, hours. The first is the model: its bias, an inertial motion
/// that it has not, a tide that it has wrong. The second starts from nothing at the reference time,
/// where the run is its analysis, and wanders off. How large s and g are is read from what the runs
/// of the last days have erred (`RunError`). Shares and times are round numbers, the same for all
/// products; error growth by a first-order process from an analysis: Dalcher & Kalnay (1987),
/// Tellus 39A, 474.
struct RunErrorKernel {
  double shared_h = 120.0;         ///< T: the time scale of the mesoscale, as for a level's memory
  double inertial_decay_h = 96.0;  ///< 1/r
  double gathering_h = 48.0;       ///< t
  double noise_m_s = 0.004;        ///< n
  /// Sizes that s and g may have, each with each, all as likely before anything is seen.
  std::vector<double> sizes_m_s{0.01, 0.03, 0.06, 0.12, 0.24};
  /// Levels of a column that are independent witnesses of them: neighbours err together.
  double independent_levels = 2.0;
};

/// A value of a run: when it holds, in hours from any one moment, of which run it is, and how long
/// after the run's reference time it holds; before it, 0.
struct RunMoment {
  double hour = 0;
  std::size_t run = 0;
  double lead_h = 0;
};

/// What the runs of a provider have erred of late at a column, and what one will: Gaussian process
/// regression under every pair of sizes of the kernel, each believed as its evidence says. Levels
/// are regressed by themselves and share the sizes; amplitudes fade with depth as those of a
/// level's memory do (memory_kernel.h). A level without a value has the error of nothing seen.
/// Thread-safe once made. 70 values x 30 levels: 25 factors of that size.
class RunError {
 public:
  /// @param error  moments x levels, m/s; NaN where it is not known
  /// @param coriolis_rad_h  f in rad per HOUR, positive in the north
  RunError(std::vector<double> depth_m, std::vector<RunMoment> seen, Eigen::MatrixXcd error,
           double coriolis_rad_h, const RunErrorKernel& kernel = {});

  struct Expected {
    Eigen::MatrixXcd error_m_s;      ///< moments x levels
    Eigen::MatrixXd variance_m2_s2;  ///< of a component
  };
  [[nodiscard]] Expected at(std::span<const RunMoment> moments) const;

 private:
  /// The levels that have values at the same moments, regressed with one factor a size.
  struct Group {
    std::vector<std::size_t> levels;
    std::vector<RunMoment> seen;
    std::vector<Eigen::MatrixXcd> factor;  ///< per pair of sizes
    std::vector<Eigen::MatrixXcd> weights;
  };
  struct Size {
    double shared = 0;
    double gathered = 0;
  };

  [[nodiscard]] Horizontal covariance(const RunMoment& a, const RunMoment& b,
                                      const Size& size) const;
  [[nodiscard]] Eigen::MatrixXcd covariance(std::span<const RunMoment> a,
                                            std::span<const RunMoment> b, const Size& size) const;
  void regress(Group& group, const Eigen::MatrixXcd& error, std::vector<double>& log_evidence);

  RunErrorKernel kernel_;
  double coriolis_rad_h_;
  std::vector<double> amplitude_;
  std::vector<Size> sizes_;
  std::vector<double> belief_;  ///< in each pair of sizes, sum 1
  std::vector<Group> groups_;
};

}  // namespace slackwater::calibration
