#pragma once
#include <Eigen/Core>
#include <vector>

#include "calibration/residuals/parameter_layout.h"
#include "fields/current/stress_memory.h"

namespace slackwater::calibration {

/// What the model of a day is evaluated on.
struct ColumnDay {
  ParameterLayout layout;
  Angle latitude;
  double water_depth_m = 0;
  std::vector<double> depth_m;        ///< levels, positive down
  std::vector<TimeCell> time;         ///< instants or means
  std::vector<Horizontal> stress_pa;  ///< of each time; 0 where no wind is used
  HourlyStress hourly;                ///< the stress before and through D; unsteady alone
  UtcTime start{};                    ///< 00:00 of D: phase of tide, inertial motion and trend
};

/// The model of a day at all its times and levels, with its exact derivatives by every parameter.
///
///   W(z,t) = (W_g + W_g' (t - noon)) A(z) + F [T(t) B(z) - sum_n B_n(z) m_n(t)]
///            + c e^{-lambda_0 (t - start)} phi_0(z) + sum_l sum_+- W_l+- e^{+-i w_l (t - start)} S_l+-(z)
///
/// the lines of fields/current evaluated in dual numbers over the three logarithms that shape them
/// (viscosity, bottom, mixed-layer depth), everything else being linear. F the stress factor, W_g'
/// per day, c the free inertial motion of the gravest mode at the start of D. Where a time is a mean
/// every term is averaged over it exactly.
class ColumnRows {
 public:
  using Matrix = Eigen::Matrix<Horizontal, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  explicit ColumnRows(ColumnDay day);

  /// Evaluates at a point (logarithms where so). A quarter of a millisecond for 24 x 35 with ten modes.
  void evaluate(const double* estimate, bool with_derivatives);

  /// m/s, times x levels.
  [[nodiscard]] const Matrix& model() const noexcept { return model_; }
  /// The part that the wind makes.
  [[nodiscard]] const Matrix& wind_driven() const noexcept { return wind_; }
  /// By parameter i, of the last evaluation with derivatives.
  [[nodiscard]] const Matrix& derivative(std::size_t i) const { return derivative_[i]; }
  [[nodiscard]] const ColumnDay& day() const noexcept { return day_; }

 private:
  struct Shapes;
  [[nodiscard]] Shapes shapes(const double* estimate) const;
  void add_wind(const Shapes& shapes, const double* estimate, bool with_derivatives);
  void add_interior(const Shapes& shapes, const double* estimate, bool with_derivatives);
  void add_inertial(const Shapes& shapes, const double* estimate, bool with_derivatives);
  void add_tide(const Shapes& shapes, const double* estimate, bool with_derivatives);

  ColumnDay day_;
  Matrix model_;
  Matrix wind_;
  std::vector<Matrix> derivative_;
};

}  // namespace slackwater::calibration
