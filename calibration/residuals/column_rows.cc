#include "calibration/residuals/column_rows.h"

#include <ceres/jet.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/check.h"
#include "fields/current/column_modes.h"
#include "fields/current/coriolis.h"
#include "fields/current/tidal_shape.h"

namespace slackwater::calibration {
namespace {

constexpr int shapers = 3;  ///< ln viscosity, ln bottom, ln mixed-layer depth
using Dual = ceres::Jet<double, shapers>;
using RowVector = Eigen::Matrix<Horizontal, 1, Eigen::Dynamic>;
constexpr Horizontal i_unit{0.0, 1.0};

/// A row over levels with its derivatives by the shapers.
struct ShapedRow {
  RowVector value;
  std::array<RowVector, shapers> by;

  explicit ShapedRow(std::size_t n) : value(static_cast<Eigen::Index>(n)) {
    for (RowVector& row : by) row.resize(static_cast<Eigen::Index>(n));
  }
  void set(std::size_t k, const Complex<Dual>& x) {
    const auto at = static_cast<Eigen::Index>(k);
    value(at) = {x.re.a, x.im.a};
    for (int j = 0; j < shapers; ++j) by[static_cast<std::size_t>(j)](at) = {x.re.v[j], x.im.v[j]};
  }
};

Horizontal vector_at(const double* estimate, std::size_t i) {
  return {estimate[i], estimate[i + 1]};
}

/// e^{-lambda t} at an instant or averaged over a mean, t in seconds from `start`.
Complex<Dual> fading(const Complex<Dual>& lambda_1_s, const TimeCell& cell, UtcTime start) {
  const auto at = [&](UtcTime time) {
    return exp(scaled(lambda_1_s, Dual(-seconds_between(start, time))));
  };
  if (!cell.is_mean()) return at(cell.start);
  return (at(cell.start) - at(cell.end)) *
         reciprocal(scaled(lambda_1_s, Dual(seconds_between(cell.start, cell.end))));
}

/// e^{i w t} likewise; w of either sign.
Horizontal turning(double speed_rad_s, const TimeCell& cell, UtcTime start) {
  const double half = 0.5 * speed_rad_s * seconds_between(cell.start, cell.end);
  const double blunted = cell.is_mean() ? std::sin(half) / half : 1.0;
  return std::polar(1.0, speed_rad_s * seconds_between(start, cell.centre())) * blunted;
}

}  // namespace

struct ColumnRows::Shapes {
  ShapedRow interior;                  ///< A
  ShapedRow stress;                    ///< B
  std::vector<ColumnMode<Dual>> mode;  ///< empty where steady
  std::vector<ShapedRow> mode_shape;   ///< cosine and taper, without 1/(rho N lambda)
  std::vector<ShapedRow> tide;         ///< S+ and S- of each line

  explicit Shapes(std::size_t levels) : interior(levels), stress(levels) {}
};

ColumnRows::ColumnRows(ColumnDay day) : day_(std::move(day)) {
  expects(day_.time.size() == day_.stress_pa.size(), "one stress per time");
  const auto times = static_cast<Eigen::Index>(day_.time.size());
  const auto levels = static_cast<Eigen::Index>(day_.depth_m.size());
  model_.resize(times, levels);
  wind_.resize(times, levels);
  derivative_.assign(day_.layout.count(), Matrix(times, levels));
}

ColumnRows::Shapes ColumnRows::shapes(const double* estimate) const {
  const ParameterLayout& layout = day_.layout;
  const std::size_t levels = day_.depth_m.size();
  Shapes out(levels);
  const SteadyParameters typical;
  ColumnShape<Dual> shape{Dual(1.0), Dual(1.0), Dual(typical.mixed_layer_depth_m)};
  if (layout.has_shape) {
    shape.eddy_viscosity_m2_s = exp(Dual(estimate[ParameterLayout::log_viscosity], 0));
    shape.bottom = exp(Dual(estimate[ParameterLayout::log_bottom], 1));
  }
  if (layout.has_layer()) shape.mixed_layer_depth_m = exp(Dual(estimate[layout.log_layer()], 2));
  std::vector<LevelResponse<Dual>> response(levels);
  steady_responses<Dual>(layout.form, shape, day_.latitude, day_.water_depth_m, day_.depth_m,
                         response);
  for (std::size_t k = 0; k < levels; ++k) {
    out.interior.set(k, response[k].interior);
    out.stress.set(k, response[k].stress);
  }
  const double coriolis_rad_s = coriolis_parameter_rad_s(day_.latitude);
  if (layout.has_modes()) {
    const bool is_layer = layout.form == SteadyForm::mixed_layer;
    const Dual layer = is_layer ? shape.mixed_layer_depth_m : Dual(day_.water_depth_m);
    out.mode = column_modes(shape.eddy_viscosity_m2_s, shape.bottom, layer, coriolis_rad_s,
                            [](const Dual& x) { return x.a; });
    if (!layout.has_wind) out.mode.resize(1);
    for (const ColumnMode<Dual>& mode : out.mode) {
      out.mode_shape.emplace_back(levels);
      for (std::size_t k = 0; k < levels; ++k) {
        const Dual depth = layer < Dual(day_.depth_m[k]) ? layer : Dual(day_.depth_m[k]);
        Dual phi = cos(mode.wavenumber_1_m * depth);
        if (is_layer) phi *= MixedLayerColumn<Dual>::base_taper(layer, day_.depth_m[k]);
        out.mode_shape.back().set(k, {phi, Dual(0.0)});
      }
    }
  }
  for (const TideLine& line : layout.tide) {
    for (const double speed : {line.speed_rad_s, -line.speed_rad_s}) {
      out.tide.emplace_back(levels);
      const bool has_bed = layout.has_shape && layout.form == SteadyForm::finite_depth;
      if (has_bed) {
        const TidalShape<Dual> tidal(shape.eddy_viscosity_m2_s, shape.bottom, coriolis_rad_s, speed,
                                     day_.water_depth_m);
        for (std::size_t k = 0; k < levels; ++k)
          out.tide.back().set(k, tidal.at_depth(day_.depth_m[k]));
      } else {
        for (std::size_t k = 0; k < levels; ++k) out.tide.back().set(k, {Dual(1.0), Dual(0.0)});
      }
    }
  }
  return out;
}

void ColumnRows::evaluate(const double* estimate, bool with_derivatives) {
  const Shapes at = shapes(estimate);
  model_.setZero();
  if (with_derivatives) {
    for (Matrix& d : derivative_) d.setZero();
  }
  add_wind(at, estimate, with_derivatives);
  add_interior(at, estimate, with_derivatives);
  add_inertial(at, estimate, with_derivatives);
  add_tide(at, estimate, with_derivatives);
}

namespace {

/// Where the shapers stand in the estimate; count() where a day does not have one.
std::array<std::size_t, shapers> places(const ParameterLayout& layout) {
  const std::size_t none = layout.count();
  return {layout.has_shape ? ParameterLayout::log_viscosity : none,
          layout.has_shape ? ParameterLayout::log_bottom : none,
          layout.has_layer() ? layout.log_layer() : none};
}

}  // namespace

// Columns of `time_part`: the stress, then per mode -m_n and -dm_n/d lambda. The rows that they multiply
// hold B, then B_n and B_n dlambda_n.
void ColumnRows::add_wind(const Shapes& at, const double* estimate, bool with_derivatives) {
  wind_.setZero();
  const ParameterLayout& layout = day_.layout;
  if (!layout.has_wind) return;
  const auto times = model_.rows();
  const auto levels = model_.cols();
  const auto modes = static_cast<Eigen::Index>(at.mode.size());
  Eigen::MatrixXcd time_part(times, 1 + 2 * modes);
  for (Eigen::Index t = 0; t < times; ++t)
    time_part(t, 0) = day_.stress_pa[static_cast<std::size_t>(t)];
  Matrix value(1 + modes, levels);
  std::array<Matrix, shapers> by;
  value.row(0) = at.stress.value;
  for (std::size_t j = 0; j < shapers; ++j) {
    by[j].resize(1 + 2 * modes, levels);
    by[j].row(0) = at.stress.by[j];
  }
  for (Eigen::Index n = 0; n < modes; ++n) {
    const ColumnMode<Dual>& mode = at.mode[static_cast<std::size_t>(n)];
    const ShapedRow& phi = at.mode_shape[static_cast<std::size_t>(n)];
    const StressMemory memory(day_.hourly,
                              3600.0 * Horizontal(mode.decay_1_s.re.a, mode.decay_1_s.im.a));
    for (Eigen::Index t = 0; t < times; ++t) {
      const StressMemory::Value m = memory.over(day_.time[static_cast<std::size_t>(t)]);
      time_part(t, 1 + n) = -m.memory_pa;
      time_part(t, 1 + modes + n) = -m.by_lambda_pa_h;
    }
    const Horizontal scale(mode.per_pascal.re.a, mode.per_pascal.im.a);
    value.row(1 + n) = scale * phi.value;
    for (std::size_t j = 0; j < shapers; ++j) {
      const auto v = static_cast<Eigen::Index>(j);
      const Horizontal scale_by(mode.per_pascal.re.v[v], mode.per_pascal.im.v[v]);
      const Horizontal decay_by_h(3600.0 * mode.decay_1_s.re.v[v], 0.0);
      by[j].row(1 + n) = scale_by * phi.value + scale * phi.by[j];
      by[j].row(1 + modes + n) = decay_by_h * scale * phi.value;
    }
  }
  const double factor = std::exp(estimate[layout.log_factor()]);
  wind_.noalias() = factor * (time_part.leftCols(1 + modes) * value);
  model_ += wind_;
  if (!with_derivatives) return;
  derivative_[layout.log_factor()] += wind_;
  const auto place = places(layout);
  for (std::size_t j = 0; j < shapers; ++j) {
    if (place[j] < layout.count()) derivative_[place[j]].noalias() += factor * (time_part * by[j]);
  }
}

void ColumnRows::add_interior(const Shapes& at, const double* estimate, bool with_derivatives) {
  const ParameterLayout& layout = day_.layout;
  const UtcTime noon = add_hours(day_.start, 12.0);
  const auto place = places(layout);
  for (Eigen::Index t = 0; t < model_.rows(); ++t) {
    const TimeCell& cell = day_.time[static_cast<std::size_t>(t)];
    const double day_part = hours_between(noon, cell.centre()) / 24.0;
    Horizontal flow = vector_at(estimate, ParameterLayout::interior);
    if (layout.is_unsteady) flow += day_part * vector_at(estimate, layout.trend());
    model_.row(t) += flow * at.interior.value;
    if (!with_derivatives) continue;
    derivative_[ParameterLayout::interior].row(t) = at.interior.value;
    derivative_[ParameterLayout::interior + 1].row(t) = i_unit * at.interior.value;
    if (layout.is_unsteady) {
      derivative_[layout.trend()].row(t) = day_part * at.interior.value;
      derivative_[layout.trend() + 1].row(t) = (i_unit * day_part) * at.interior.value;
    }
    for (std::size_t j = 0; j < shapers; ++j) {
      if (place[j] < layout.count()) derivative_[place[j]].row(t) += flow * at.interior.by[j];
    }
  }
}

void ColumnRows::add_inertial(const Shapes& at, const double* estimate, bool with_derivatives) {
  const ParameterLayout& layout = day_.layout;
  if (!layout.has_modes()) return;
  const auto place = places(layout);
  const ShapedRow& phi = at.mode_shape.front();
  const Horizontal amplitude = vector_at(estimate, layout.inertial());
  for (Eigen::Index t = 0; t < model_.rows(); ++t) {
    const Complex<Dual> fade =
        fading(at.mode.front().decay_1_s, day_.time[static_cast<std::size_t>(t)], day_.start);
    const Horizontal value(fade.re.a, fade.im.a);
    model_.row(t) += (amplitude * value) * phi.value;
    if (!with_derivatives) continue;
    derivative_[layout.inertial()].row(t) = value * phi.value;
    derivative_[layout.inertial() + 1].row(t) = (i_unit * value) * phi.value;
    for (std::size_t j = 0; j < shapers; ++j) {
      if (place[j] >= layout.count()) continue;
      const auto v = static_cast<Eigen::Index>(j);
      const Horizontal by(fade.re.v[v], fade.im.v[v]);
      derivative_[place[j]].row(t) += amplitude * (by * phi.value + value * phi.by[j]);
    }
  }
}

void ColumnRows::add_tide(const Shapes& at, const double* estimate, bool with_derivatives) {
  const ParameterLayout& layout = day_.layout;
  const auto place = places(layout);
  for (std::size_t line = 0; line < layout.tide.size(); ++line) {
    for (std::size_t sense = 0; sense < 2; ++sense) {
      const ShapedRow& shape = at.tide[2 * line + sense];
      const std::size_t i = layout.tide_at(line) + 2 * sense;
      const double speed = (sense == 0 ? 1.0 : -1.0) * layout.tide[line].speed_rad_s;
      const Horizontal phasor = vector_at(estimate, i);
      for (Eigen::Index t = 0; t < model_.rows(); ++t) {
        const Horizontal turn = turning(speed, day_.time[static_cast<std::size_t>(t)], day_.start);
        model_.row(t) += (phasor * turn) * shape.value;
        if (!with_derivatives) continue;
        derivative_[i].row(t) = turn * shape.value;
        derivative_[i + 1].row(t) = (i_unit * turn) * shape.value;
        for (std::size_t j = 0; j < shapers; ++j) {
          if (place[j] < layout.count())
            derivative_[place[j]].row(t) += (phasor * turn) * shape.by[j];
        }
      }
    }
  }
}

}  // namespace slackwater::calibration
