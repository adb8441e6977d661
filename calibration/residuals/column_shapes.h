#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "calibration/residuals/parameter_layout.h"
#include "fields/base/angle.h"
#include "fields/base/frame.h"

namespace slackwater::calibration {

/// The three logarithms that the model is not linear in, beside the stress factor: viscosity,
/// bottom, mixed-layer depth.
inline constexpr std::size_t shapers = 3;

/// A quantity with its derivatives by the shapers (not set where only values were asked for).
template <typename Value>
struct Shaped {
  Value value{};
  std::array<Value, shapers> by{};
};

/// One mode of the moving layer.
struct ShapedMode {
  Shaped<Horizontal> decay_1_s;        ///< lambda_n
  Shaped<Horizontal> per_pascal;       ///< 1/(rho N_n lambda_n)
  Shaped<Eigen::RowVectorXd> profile;  ///< cosine and taper
};

/// Everything in a day's model that depends on the shapers, over its levels.
struct ColumnShapes {
  Shaped<Eigen::RowVectorXcd> interior;  ///< A
  Shaped<Eigen::RowVectorXcd> stress;    ///< B
  std::vector<ShapedMode> mode;          ///< empty where steady; the gravest alone without wind
};

/// The lines of fields/current at the estimate; with derivatives, in dual numbers.
[[nodiscard]] ColumnShapes column_shapes(const ParameterLayout& layout, Angle latitude,
                                         double water_depth_m, const std::vector<double>& depth_m,
                                         const double* estimate, bool with_derivatives);

}  // namespace slackwater::calibration
