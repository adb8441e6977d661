#pragma once
#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "calibration/residuals/column_shapes.h"
#include "calibration/residuals/parameter_layout.h"
#include "calibration/residuals/separable_sum.h"
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
  UtcTime start{};                    ///< 00:00 of D: phase of inertial motion and trend
};

/// The model of a day at all its times and levels, with its exact derivatives by every parameter.
///
///   W(z,t) = (W_g + W_g' (t - noon)) A(z) + F [T(t) B(z) - sum_n B_n(z) m_n(t)]
///            + c e^{-lambda_0 (t - start)} phi_0(z)
///
/// the lines of fields/current evaluated in dual numbers over the three logarithms that shape them
/// (viscosity, bottom, mixed-layer depth), everything else being linear. F the stress factor, W_g'
/// per day, c the free inertial motion of the gravest mode at the start of D. Where a time is a
/// mean every term is averaged over it exactly. Every term is a function of time times a function
/// of depth, so that the model, and each derivative, is one small matrix product.
class ColumnRows {
 public:
  using Matrix = Eigen::Matrix<Horizontal, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  explicit ColumnRows(ColumnDay day);

  /// Evaluates at a point (logarithms where so). A fifth of a millisecond for 24 x 35 with twenty
  /// modes.
  void evaluate(const double* estimate, bool with_derivatives);

  /// Another wind over the same times: of each time, and by the hour.
  void set_stress(std::vector<Horizontal> stress_pa, const HourlyStress& hourly);

  /// m/s, times x levels.
  [[nodiscard]] const Matrix& model() const noexcept { return model_; }
  /// The part that the wind makes.
  [[nodiscard]] const Matrix& wind_driven() const noexcept { return wind_; }
  /// By parameter i, of the last evaluation with derivatives.
  [[nodiscard]] Matrix derivative(std::size_t i) const;

  /// The model again, and a column of derivatives for each parameter, as real numbers: east at all
  /// times and levels (level fastest), then north.
  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> stacked_model() const;
  [[nodiscard]] const Eigen::MatrixXd& stacked_derivatives() const noexcept { return derivatives_; }
  [[nodiscard]] const ColumnDay& day() const noexcept { return day_; }

 private:
  void add_wind(const ColumnShapes& shapes, const double* estimate, bool with_derivatives);
  void add_interior(const ColumnShapes& shapes, const double* estimate, bool with_derivatives);
  void add_inertial(const ColumnShapes& shapes, const double* estimate, bool with_derivatives);
  /// What a vector parameter of value `x` multiplies: adds x p(t) s(z) with its derivatives.
  template <typename Row>
  void add_vector(std::size_t index, const double* estimate, const OverTime& p,
                  const Shaped<Row>& s, bool with_derivatives);
  void write_vector_columns(std::size_t index, const OverTime& p, const OverLevels& s);
  [[nodiscard]] Eigen::Map<Planes> planes_of(std::size_t parameter);

  ColumnDay day_;
  std::shared_ptr<const StressChanges> changes_;
  OverTime ones_;
  OverTime days_since_noon_;
  std::array<std::size_t, shapers> place_;    ///< in the estimate; count() where a day has none
  SeparableSum sum_;                          ///< the model but for the wind's part
  std::array<SeparableSum, shapers> sum_by_;  ///< all of it, by the shapers
  Planes model_planes_;
  Planes wind_planes_;
  Matrix model_;
  Matrix wind_;
  Eigen::MatrixXd derivatives_;
};

}  // namespace slackwater::calibration
