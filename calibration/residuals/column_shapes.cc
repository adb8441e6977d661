#include "calibration/residuals/column_shapes.h"

#include <ceres/jet.h>

#include <cmath>
#include <type_traits>

#include "fields/current/column_modes.h"
#include "fields/current/coriolis.h"
#include "fields/current/steady_response.h"

namespace slackwater::calibration {
namespace {

using Dual = ceres::Jet<double, static_cast<int>(shapers)>;

double value_of(double x) { return x; }
double value_of(const Dual& x) { return x.a; }

/// e^x, x the shaper of that place.
template <typename T>
T shaper(double x, [[maybe_unused]] int place) {
  using std::exp;
  if constexpr (std::is_same_v<T, Dual>) {
    return exp(Dual(x, place));
  } else {
    return exp(x);
  }
}

void set(Shaped<Eigen::RowVectorXd>& row, Eigen::Index k, double x) { row.value(k) = x; }
void set(Shaped<Eigen::RowVectorXd>& row, Eigen::Index k, const Dual& x) {
  row.value(k) = x.a;
  for (std::size_t j = 0; j < shapers; ++j) row.by[j](k) = x.v(static_cast<Eigen::Index>(j));
}
void set(Shaped<Eigen::RowVectorXcd>& row, Eigen::Index k, const Complex<double>& x) {
  row.value(k) = to_horizontal(x);
}
void set(Shaped<Eigen::RowVectorXcd>& row, Eigen::Index k, const Complex<Dual>& x) {
  row.value(k) = {x.re.a, x.im.a};
  for (std::size_t j = 0; j < shapers; ++j) {
    const auto v = static_cast<Eigen::Index>(j);
    row.by[j](k) = {x.re.v(v), x.im.v(v)};
  }
}
Shaped<Horizontal> shaped(const Complex<double>& x) { return {to_horizontal(x), {}}; }
Shaped<Horizontal> shaped(const Complex<Dual>& x) {
  Shaped<Horizontal> out{{x.re.a, x.im.a}, {}};
  for (std::size_t j = 0; j < shapers; ++j) {
    const auto v = static_cast<Eigen::Index>(j);
    out.by[j] = {x.re.v(v), x.im.v(v)};
  }
  return out;
}

template <typename Row, typename T>
Shaped<Row> rows_of(Eigen::Index levels) {
  Shaped<Row> rows;
  rows.value.resize(levels);
  if constexpr (std::is_same_v<T, Dual>) {
    for (Row& row : rows.by) row.resize(levels);
  }
  return rows;
}

/// The work for one scalar: plain, or dual.
template <typename T>
class Maker {
 public:
  Maker(const ParameterLayout& layout, Angle latitude, double water_depth_m,
        const std::vector<double>& depth_m, const double* estimate)
      : layout_(layout),
        latitude_(latitude),
        coriolis_rad_s_(coriolis_parameter_rad_s(latitude)),
        water_depth_m_(water_depth_m),
        depth_m_(depth_m),
        levels_(static_cast<Eigen::Index>(depth_m.size())),
        shape_{T(1.0), T(1.0), T(SteadyParameters{}.mixed_layer_depth_m)} {
    if (layout.has_shape) {
      shape_.eddy_viscosity_m2_s = shaper<T>(estimate[ParameterLayout::log_viscosity], 0);
      shape_.bottom = shaper<T>(estimate[ParameterLayout::log_bottom], 1);
    }
    if (layout.has_layer()) shape_.mixed_layer_depth_m = shaper<T>(estimate[layout.log_layer()], 2);
  }

  ColumnShapes make() const {
    ColumnShapes out;
    add_steady(out);
    if (layout_.has_modes()) add_modes(out);
    return out;
  }

 private:
  void add_steady(ColumnShapes& out) const {
    std::vector<LevelResponse<T>> response(depth_m_.size());
    steady_responses<T>(layout_.form, shape_, latitude_, water_depth_m_, depth_m_, response);
    out.interior = rows_of<Eigen::RowVectorXcd, T>(levels_);
    out.stress = rows_of<Eigen::RowVectorXcd, T>(levels_);
    for (Eigen::Index k = 0; k < levels_; ++k) {
      set(out.interior, k, response[static_cast<std::size_t>(k)].interior);
      set(out.stress, k, response[static_cast<std::size_t>(k)].stress);
    }
  }

  void add_modes(ColumnShapes& out) const {
    using std::cos;
    const bool is_layer = layout_.form == SteadyForm::mixed_layer;
    const T layer = is_layer ? shape_.mixed_layer_depth_m : T(water_depth_m_);
    std::vector<ColumnMode<T>> modes =
        column_modes(shape_.eddy_viscosity_m2_s, shape_.bottom, layer, coriolis_rad_s_,
                     [](const T& x) { return value_of(x); });
    if (!layout_.has_wind) modes.resize(1);
    std::vector<T> depth;
    std::vector<T> taper;
    for (const double d : depth_m_) {
      depth.push_back(layer < T(d) ? layer : T(d));
      taper.push_back(is_layer ? MixedLayerColumn<T>::base_taper(layer, d) : T(1.0));
    }
    for (const ColumnMode<T>& mode : modes) {
      ShapedMode shape{shaped(mode.decay_1_s), shaped(mode.per_pascal),
                       rows_of<Eigen::RowVectorXd, T>(levels_)};
      for (Eigen::Index k = 0; k < levels_; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const T cosine = cos(mode.wavenumber_1_m * depth[at]);
        set(shape.profile, k, is_layer ? T(cosine * taper[at]) : cosine);
      }
      out.mode.push_back(std::move(shape));
    }
  }

  const ParameterLayout& layout_;
  Angle latitude_;
  double coriolis_rad_s_;
  double water_depth_m_;
  const std::vector<double>& depth_m_;
  Eigen::Index levels_;
  ColumnShape<T> shape_;
};

}  // namespace

ColumnShapes column_shapes(const ParameterLayout& layout, Angle latitude, double water_depth_m,
                           const std::vector<double>& depth_m, const double* estimate,
                           bool with_derivatives) {
  if (with_derivatives)
    return Maker<Dual>(layout, latitude, water_depth_m, depth_m, estimate).make();
  return Maker<double>(layout, latitude, water_depth_m, depth_m, estimate).make();
}

}  // namespace slackwater::calibration
