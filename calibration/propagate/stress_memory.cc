#include "calibration/propagate/stress_memory.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::calibration {

HourlyStress HourlyStress::sample(const StressSeries& series, UtcTime end_of_day, double history_h,
                                  double lead_h) {
  HourlyStress hourly;
  const auto before = static_cast<int>(std::ceil(history_h));
  const auto after = static_cast<int>(std::ceil(std::max(lead_h, 0.0)));
  hourly.first = add_hours(end_of_day, -before);
  for (int hour = -before; hour <= after; ++hour) {
    const std::optional<Horizontal> stress = series.at(add_hours(end_of_day, hour));
    hourly.stress_pa.push_back(stress.value_or(Horizontal{}));
    hourly.is_known.push_back(stress.has_value());
  }
  return hourly;
}

StressMemory::StressMemory(const HourlyStress& stress, Horizontal lambda_per_h)
    : first_(stress.first), lambda_per_h_(lambda_per_h) {
  expects(lambda_per_h.real() > 0, "a mode decays");
  const std::size_t n = stress.stress_pa.size();
  slope_pa_h_.assign(n, Horizontal{});
  knot_.assign(n, At{});
  const Horizontal decay = std::exp(-lambda_per_h);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (stress.is_known[i] && stress.is_known[i + 1])
      slope_pa_h_[i] = stress.stress_pa[i + 1] - stress.stress_pa[i];
    const At& from = knot_[i];
    At& to = knot_[i + 1];
    to.value = decay * from.value + slope_pa_h_[i] * (1.0 - decay) / lambda_per_h;
    // m' = -lambda m + slope, integrated over the hour.
    to.integral_h = from.integral_h + (from.value - to.value + slope_pa_h_[i]) / lambda_per_h;
  }
}

StressMemory::At StressMemory::at(UtcTime time) const {
  const double since_h = hours_between(first_, time);
  if (knot_.empty() || since_h <= 0) return {};
  const std::size_t i = std::min(static_cast<std::size_t>(since_h), knot_.size() - 1);
  const double part_h = since_h - static_cast<double>(i);
  const Horizontal decay = std::exp(-lambda_per_h_ * part_h);
  At at;
  at.value = decay * knot_[i].value + slope_pa_h_[i] * (1.0 - decay) / lambda_per_h_;
  at.integral_h =
      knot_[i].integral_h + (knot_[i].value - at.value + slope_pa_h_[i] * part_h) / lambda_per_h_;
  return at;
}

Horizontal StressMemory::over(const TimeCell& cell) const {
  if (!cell.is_mean()) return at(cell.start).value;
  return (at(cell.end).integral_h - at(cell.start).integral_h) /
         hours_between(cell.start, cell.end);
}

}  // namespace slackwater::calibration
