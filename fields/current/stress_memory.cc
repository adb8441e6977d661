#include "fields/current/stress_memory.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater {

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
    : first_(stress.first), lambda_per_h_(lambda_per_h), inverse_lambda_h_(1.0 / lambda_per_h) {
  expects(lambda_per_h.real() > 0, "a mode decays");
  const std::size_t n = stress.stress_pa.size();
  slope_pa_h_.assign(n, Horizontal{});
  knot_.assign(n, Knot{});
  const Horizontal decay = std::exp(-lambda_per_h);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (stress.is_known[i] && stress.is_known[i + 1])
      slope_pa_h_[i] = stress.stress_pa[i + 1] - stress.stress_pa[i];
    knot_[i + 1] = step(knot_[i], slope_pa_h_[i], 1.0, decay);
  }
}

// m' = -lambda m + g, solved over a stretch of constant slope g:
//   m = d m_0 + g (1 - d)/lambda,   Int m = (m_0 - m + g t)/lambda,   d = e^{-lambda t},
// and the same differentiated by lambda.
StressMemory::Knot StressMemory::step(const Knot& from, Horizontal slope_pa_h, double hours,
                                      Horizontal decay) const {
  const Value& start = from.value;
  const Horizontal settled = slope_pa_h * (1.0 - decay) * inverse_lambda_h_;
  Knot to;
  to.value.memory_pa = decay * start.memory_pa + settled;
  to.value.by_lambda_pa_h = decay * (start.by_lambda_pa_h - hours * start.memory_pa) +
                            (slope_pa_h * hours * decay - settled) * inverse_lambda_h_;
  const Horizontal part =
      (start.memory_pa - to.value.memory_pa + slope_pa_h * hours) * inverse_lambda_h_;
  to.integral_h.memory_pa = from.integral_h.memory_pa + part;
  to.integral_h.by_lambda_pa_h =
      from.integral_h.by_lambda_pa_h +
      (start.by_lambda_pa_h - to.value.by_lambda_pa_h - part) * inverse_lambda_h_;
  return to;
}

StressMemory::Knot StressMemory::at(UtcTime time) const {
  const double since_h = hours_between(first_, time);
  if (knot_.empty() || since_h <= 0) return {};
  const std::size_t i = std::min(static_cast<std::size_t>(since_h), knot_.size() - 1);
  const double part_h = since_h - static_cast<double>(i);
  if (part_h <= 0) return knot_[i];
  return step(knot_[i], slope_pa_h_[i], part_h, std::exp(-lambda_per_h_ * part_h));
}

StressMemory::Value StressMemory::over(const TimeCell& cell) const {
  if (!cell.is_mean()) return at(cell.start).value;
  const Value from = at(cell.start).integral_h;
  const Value to = at(cell.end).integral_h;
  const double width_h = hours_between(cell.start, cell.end);
  return {(to.memory_pa - from.memory_pa) / width_h,
          (to.by_lambda_pa_h - from.by_lambda_pa_h) / width_h};
}

}  // namespace slackwater
