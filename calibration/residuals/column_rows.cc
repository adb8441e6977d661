#include "calibration/residuals/column_rows.h"

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

Horizontal vector_at(const double* estimate, std::size_t i) {
  return {estimate[i], estimate[i + 1]};
}

/// e^{-lambda t} and its derivative by lambda, at an instant or averaged over a mean, t in seconds
/// from `start`.
struct Fading {
  Horizontal value;
  Horizontal by_lambda_s;
};

Fading fading(Horizontal lambda_1_s, const TimeCell& cell, UtcTime start) {
  const auto at = [&](UtcTime time) {
    const double t_s = seconds_between(start, time);
    const Horizontal value = std::exp(-lambda_1_s * t_s);
    return Fading{value, -t_s * value};
  };
  if (!cell.is_mean()) return at(cell.start);
  const Fading from = at(cell.start);
  const Fading to = at(cell.end);
  const Horizontal inverse_width = 1.0 / (lambda_1_s * seconds_between(cell.start, cell.end));
  const Horizontal mean = (from.value - to.value) * inverse_width;
  return {mean, (from.by_lambda_s - to.by_lambda_s) * inverse_width - mean / lambda_1_s};
}

std::array<std::size_t, shapers> places(const ParameterLayout& layout) {
  const std::size_t none = layout.count();
  return {layout.has_shape ? ParameterLayout::log_viscosity : none,
          layout.has_shape ? ParameterLayout::log_bottom : none,
          layout.has_layer() ? layout.log_layer() : none};
}

void to_complex(const Planes& planes, ColumnRows::Matrix& out) {
  out.real() = planes.topRows(out.rows());
  out.imag() = planes.bottomRows(out.rows());
}

}  // namespace

ColumnRows::ColumnRows(ColumnDay day)
    : day_(std::move(day)),
      place_(places(day_.layout)),
      sum_(static_cast<Eigen::Index>(day_.time.size()),
           static_cast<Eigen::Index>(day_.depth_m.size())),
      sum_by_{sum_, sum_, sum_} {
  const auto times = static_cast<Eigen::Index>(day_.time.size());
  const auto levels = static_cast<Eigen::Index>(day_.depth_m.size());
  set_stress(std::move(day_.stress_pa), day_.hourly);
  ones_ = OverTime::Ones(times);
  days_since_noon_.resize(times);
  const UtcTime noon = add_hours(day_.start, 12.0);
  for (Eigen::Index t = 0; t < times; ++t) {
    const TimeCell& cell = day_.time[static_cast<std::size_t>(t)];
    days_since_noon_(t) = hours_between(noon, cell.centre()) / 24.0;
  }
  model_planes_.resize(2 * times, levels);
  wind_planes_.resize(2 * times, levels);
  model_.resize(times, levels);
  wind_.resize(times, levels);
}

void ColumnRows::set_stress(std::vector<Horizontal> stress_pa, const HourlyStress& hourly) {
  expects(day_.time.size() == stress_pa.size(), "one stress per time");
  day_.stress_pa = std::move(stress_pa);
  changes_ = std::make_shared<const StressChanges>(hourly);
}

ColumnRows::Matrix ColumnRows::derivative(std::size_t i) const {
  const Eigen::Map<const Planes> planes(derivatives_.col(static_cast<Eigen::Index>(i)).data(),
                                        2 * model_.rows(), model_.cols());
  Matrix out(model_.rows(), model_.cols());
  to_complex(planes, out);
  return out;
}

Eigen::Map<const Eigen::VectorXd> ColumnRows::stacked_model() const {
  return {model_planes_.data(), model_planes_.size()};
}

Eigen::Map<Planes> ColumnRows::planes_of(std::size_t parameter) {
  return {derivatives_.col(static_cast<Eigen::Index>(parameter)).data(), model_planes_.rows(),
          model_planes_.cols()};
}

void ColumnRows::evaluate(const double* estimate, bool with_derivatives) {
  const ColumnShapes shapes = column_shapes(day_.layout, day_.latitude, day_.water_depth_m,
                                            day_.depth_m, estimate, with_derivatives);
  if (with_derivatives && derivatives_.size() == 0)
    derivatives_.resize(model_planes_.size(), static_cast<Eigen::Index>(day_.layout.count()));
  sum_.clear();
  for (SeparableSum& by : sum_by_) by.clear();
  add_wind(shapes, estimate, with_derivatives);
  add_interior(shapes, estimate, with_derivatives);
  add_inertial(shapes, estimate, with_derivatives);
  sum_.write(model_planes_);
  model_planes_ += wind_planes_;
  to_complex(model_planes_, model_);
  to_complex(wind_planes_, wind_);
  if (!with_derivatives) return;
  for (std::size_t j = 0; j < shapers; ++j) {
    if (place_[j] < day_.layout.count()) sum_by_[j].write(planes_of(place_[j]));
  }
}

// F [T B - sum_n b_n m_n phi_n], b_n = 1/(rho N_n lambda_n), and by a shaper
// F [T B' - sum_n (b_n' m_n + b_n lambda_n' dm_n/dlambda) phi_n + b_n m_n phi_n'].
void ColumnRows::add_wind(const ColumnShapes& shapes, const double* estimate,
                          bool with_derivatives) {
  wind_planes_.setZero();
  const ParameterLayout& layout = day_.layout;
  if (!layout.has_wind) return;
  const auto times = static_cast<Eigen::Index>(day_.time.size());
  const double factor = std::exp(estimate[layout.log_factor()]);
  SeparableSum wind(times, model_.cols());
  const OverTime stress = factor * Eigen::Map<const OverTime>(day_.stress_pa.data(), times);
  const auto add_by_shapers = [&](const auto& add) {
    for (std::size_t j = 0; j < shapers; ++j) {
      if (with_derivatives && place_[j] < layout.count()) add(j);
    }
  };
  wind.add(stress, shapes.stress.value);
  add_by_shapers([&](std::size_t j) { sum_by_[j].add(stress, shapes.stress.by[j]); });
  OverTime memory(times);
  OverTime by_lambda_s(times);
  for (const ShapedMode& mode : shapes.mode) {
    const StressMemory remembered(changes_, 3600.0 * mode.decay_1_s.value);
    for (Eigen::Index t = 0; t < times; ++t) {
      const StressMemory::Value m = remembered.over(day_.time[static_cast<std::size_t>(t)]);
      memory(t) = -factor * m.memory_pa;
      by_lambda_s(t) = -factor * 3600.0 * m.by_lambda_pa_h;
    }
    const Horizontal scale = mode.per_pascal.value;
    const OverTime scaled = scale * memory;
    wind.add(scaled, mode.profile.value);
    add_by_shapers([&](std::size_t j) {
      const Horizontal decay_by = scale * mode.decay_1_s.by[j];
      sum_by_[j].add(mode.per_pascal.by[j] * memory + decay_by * by_lambda_s, mode.profile.value);
      sum_by_[j].add(scaled, mode.profile.by[j]);
    });
  }
  wind.write(wind_planes_);
  if (with_derivatives) planes_of(layout.log_factor()) = wind_planes_;
}

// A vector x = a + i b: the column of b is i times the column of a.
void ColumnRows::write_vector_columns(std::size_t index, const OverTime& p, const OverLevels& s) {
  const auto times = model_.rows();
  Eigen::Map<Planes> a = planes_of(index);
  const Eigen::RowVectorXd east = s.real();
  const Eigen::RowVectorXd north = s.imag();
  for (Eigen::Index t = 0; t < times; ++t) {
    a.row(t) = p(t).real() * east - p(t).imag() * north;
    a.row(times + t) = p(t).imag() * east + p(t).real() * north;
  }
  Eigen::Map<Planes> b = planes_of(index + 1);
  b.topRows(times) = -a.bottomRows(times);
  b.bottomRows(times) = a.topRows(times);
}

template <typename Row>
void ColumnRows::add_vector(std::size_t index, const double* estimate, const OverTime& p,
                            const Shaped<Row>& s, bool with_derivatives) {
  const OverTime flow = vector_at(estimate, index) * p;
  sum_.add(flow, s.value);
  if (!with_derivatives) return;
  write_vector_columns(index, p, s.value.template cast<Horizontal>());
  for (std::size_t j = 0; j < shapers; ++j) {
    if (place_[j] < day_.layout.count()) sum_by_[j].add(flow, s.by[j]);
  }
}

void ColumnRows::add_interior(const ColumnShapes& shapes, const double* estimate,
                              bool with_derivatives) {
  add_vector(ParameterLayout::interior, estimate, ones_, shapes.interior, with_derivatives);
  if (day_.layout.is_unsteady)
    add_vector(day_.layout.trend(), estimate, days_since_noon_, shapes.interior, with_derivatives);
}

void ColumnRows::add_inertial(const ColumnShapes& shapes, const double* estimate,
                              bool with_derivatives) {
  const ParameterLayout& layout = day_.layout;
  if (!layout.has_modes()) return;
  const ShapedMode& gravest = shapes.mode.front();
  const auto times = static_cast<Eigen::Index>(day_.time.size());
  OverTime fade(times);
  OverTime by_lambda_s(times);
  for (Eigen::Index t = 0; t < times; ++t) {
    const Fading at =
        fading(gravest.decay_1_s.value, day_.time[static_cast<std::size_t>(t)], day_.start);
    fade(t) = at.value;
    by_lambda_s(t) = at.by_lambda_s;
  }
  add_vector(layout.inertial(), estimate, fade, gravest.profile, with_derivatives);
  if (!with_derivatives) return;
  const Horizontal amplitude = vector_at(estimate, layout.inertial());
  for (std::size_t j = 0; j < shapers; ++j) {
    const Horizontal decay_by = amplitude * gravest.decay_1_s.by[j];
    if (place_[j] < layout.count()) sum_by_[j].add(decay_by * by_lambda_s, gravest.profile.value);
  }
}

}  // namespace slackwater::calibration
