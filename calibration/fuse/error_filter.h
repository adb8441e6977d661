#pragma once
#include <Eigen/Core>
#include <vector>

namespace slackwater::calibration {

/// Follows the difference between what an instrument sees and a product, over depth and time:
/// optimal interpolation in depth at each time, with what earlier times taught (a Kalman filter).
///
///   s = b + q,   Cov b = B exp(-|dz|/L),   Cov q = Q exp(-|dz|/L),   both forgotten exponentially
///   y = H s + n, Cov n = diag R
///
/// The components east and north are independent and share the covariances, so complex numbers
/// carry both. Causal: an analysis knows nothing later.
class ErrorFilter {
 public:
  struct Kind {
    double variance_m2_s2 = 0;
    double memory_h = 1;
  };
  /// @param depths_m  of the state, ascending
  /// @param slow, quick  the two parts; @param length_m  e-folding distance in depth, > 0
  ErrorFilter(const std::vector<double>& depths_m, Kind slow, Kind quick, double length_m);

  /// Lets time pass.
  void forget(double hours);

  /// Takes in observations y of the state at rows of H (observations x depths).
  /// @param noise_m2_s2  R of each observation, > 0
  void observe(const Eigen::MatrixXd& h, const Eigen::VectorXcd& y,
               const Eigen::VectorXd& noise_m2_s2);

  /// The state at each depth and its variance there.
  [[nodiscard]] Eigen::VectorXcd mean() const;
  [[nodiscard]] Eigen::VectorXd variance() const;
  /// What the noise of the last observation adds to that variance: K R K^T. The next one's noise is
  /// independent of it. Zero before any.
  [[nodiscard]] Eigen::VectorXd fresh_noise() const;

 private:
  Eigen::Index n_;
  Kind slow_;
  Kind quick_;
  Eigen::MatrixXd shape_;       ///< exp(-|dz|/L)
  Eigen::VectorXcd state_;      ///< b, then q
  Eigen::MatrixXd covariance_;  ///< of both

  struct Step {
    double hours = 0;
    Eigen::MatrixXd h;
    Eigen::VectorXd noise_m2_s2;
    bool operator==(const Step& other) const {
      return hours == other.hours && h.rows() == other.h.rows() && h == other.h &&
             noise_m2_s2 == other.noise_m2_s2;
    }
  };
  void spread_for(double hours);
  void take_in(const Step& step);

  double pending_h_ = 0;  ///< time passed that the covariance has not heard of
  Step last_;             ///< of the gain
  Eigen::MatrixXd gain_;
  bool settled_ = false;
};

}  // namespace slackwater::calibration
