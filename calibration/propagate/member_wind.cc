#include "calibration/propagate/member_wind.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "calibration/solve/parameter_set.h"
#include "fields/base/check.h"
#include "fields/current/unsteady_column.h"

namespace slackwater::calibration {

WindDriven::WindDriven(const Calibration& calibration, std::span<const UtcTime> times,
                       UtcTime end_of_day)
    : calibration_(calibration), times_(times), end_of_day_(end_of_day) {
  const VectorColumn& column = calibration.remembered;
  depth_m_ = column.levels_m.empty() ? std::vector<double>{0.0} : column.levels_m;
}

std::vector<Horizontal> WindDriven::under(const StressSeries& stress,
                                          const SteadyParameters& parameters) const {
  const std::size_t levels = depth_m_.size();
  std::vector<Horizontal> stress_pa;
  for (const UtcTime time : times_) stress_pa.push_back(stress.at(time).value_or(Horizontal{}));
  const Calibration& c = calibration_;
  const LevelResponses responses =
      level_responses(c.form, parameters, c.latitude, c.water_depth_m, depth_m_);
  std::vector<Horizontal> driven(times_.size() * levels);
  evaluate_steady(responses, Horizontal{}, stress_pa, driven);
  if (!c.layout.has_modes() || times_.empty()) return driven;
  const double last_h = std::max(0.0, hours_between(end_of_day_, times_.back()));
  const UnsteadyColumn column(
      c.form, parameters, c.latitude, c.water_depth_m, depth_m_,
      HourlyStress::sample(stress, end_of_day_, 24.0 + stress_history_h, last_h));
  std::vector<Horizontal> transient(levels);
  for (std::size_t t = 0; t < times_.size(); ++t) {
    column.transient(TimeCell::instant(times_[t]), transient);
    for (std::size_t k = 0; k < levels; ++k) driven[t * levels + k] += transient[k];
  }
  return driven;
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
