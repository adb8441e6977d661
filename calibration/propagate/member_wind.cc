#include "calibration/propagate/member_wind.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "calibration/solve/parameter_set.h"
#include "fields/base/check.h"
#include "fields/current/steady_column.h"

namespace slackwater::calibration {

namespace {

double last_hour(std::span<const UtcTime> times, UtcTime end_of_day) {
  return times.empty() ? 0.0 : std::max(0.0, hours_between(end_of_day, times.back()));
}

std::vector<Horizontal> stress_at(std::span<const UtcTime> times, const StressSeries& stress) {
  std::vector<Horizontal> stress_pa;
  for (const UtcTime time : times) stress_pa.push_back(stress.at(time).value_or(Horizontal{}));
  return stress_pa;
}

HourlyStress stress_by_the_hour(std::span<const UtcTime> times, UtcTime end_of_day,
                                const StressSeries& stress) {
  return HourlyStress::sample(stress, end_of_day, 24.0 + stress_history_h,
                              last_hour(times, end_of_day));
}

}  // namespace

ColumnDay day_of_horizon(const Calibration& calibration, std::span<const UtcTime> times,
                         UtcTime end_of_day, const StressSeries& stress) {
  const VectorColumn& column = calibration.remembered;
  ColumnDay day;
  day.layout = calibration.layout;
  day.latitude = calibration.latitude;
  day.water_depth_m = calibration.water_depth_m;
  day.depth_m = column.levels_m.empty() ? std::vector<double>{0.0} : column.levels_m;
  day.start = calibration.start;
  for (const UtcTime time : times) day.time.push_back(TimeCell::instant(time));
  day.stress_pa = stress_at(times, stress);
  day.hourly = stress_by_the_hour(times, end_of_day, stress);
  return day;
}

WindDriven::WindDriven(const Calibration& calibration, std::span<const UtcTime> times,
                       UtcTime end_of_day)
    : calibration_(calibration),
      times_(times),
      end_of_day_(end_of_day),
      rows_(day_of_horizon(calibration, times, end_of_day, StressSeries())) {}

std::vector<Horizontal> WindDriven::under(const StressSeries& stress,
                                          const SteadyParameters& parameters) {
  rows_.set_stress(stress_at(times_, stress), stress_by_the_hour(times_, end_of_day_, stress));
  const ParameterLayout& layout = rows_.day().layout;
  std::vector<double> estimate(layout.count());
  if (layout.has_shape) {
    estimate[ParameterLayout::log_viscosity] = std::log(parameters.eddy_viscosity_m2_s);
    estimate[ParameterLayout::log_bottom] =
        std::log(shape_of(calibration_.form, parameters).bottom);
  }
  if (layout.has_wind) estimate[layout.log_factor()] = std::log(parameters.stress_factor);
  if (layout.has_layer()) estimate[layout.log_layer()] = std::log(parameters.mixed_layer_depth_m);
  rows_.evaluate(estimate.data(), false);
  const ColumnRows::Matrix& driven = rows_.wind_driven();
  return {driven.data(), driven.data() + driven.size()};
}

SteadyParameters drawn_parameters(const Calibration& calibration, std::span<const double> normals) {
  const auto n = static_cast<Eigen::Index>(calibration.parameters.size());
  expects(normals.size() == calibration.parameters.size(), "one number per parameter");
  const Eigen::Map<const Eigen::MatrixXd> covariance(calibration.covariance.data(), n, n);
  const Eigen::Map<const Eigen::VectorXd> z(normals.data(), n);
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  const Eigen::VectorXd step = factor.matrixL() * z;
  std::vector<Parameter> drawn = calibration.parameters;
  for (Eigen::Index i = 0; i < n; ++i) {
    Parameter& p = drawn[static_cast<std::size_t>(i)];
    if (!p.is_logarithmic) continue;
    p.value = std::clamp(physical(p, estimated(p, p.value) + step(i)), p.lower, p.upper);
  }
  return steady_parameters(drawn);
}

VectorColumn departed_wind(const VectorColumn& wind, UtcTime end_of_day,
                           std::span<const Horizontal> departures) {
  VectorColumn departed = wind;
  std::size_t next = 0;
  for (std::size_t t = 0; t < wind.times(); ++t) {
    if (wind.time[t].centre() <= end_of_day) continue;
    expects(next < departures.size(), "one departure per sample after D");
    departed.value[departed.offset(t, 0)] += departures[next++];
  }
  return departed;
}

}  // namespace slackwater::calibration
