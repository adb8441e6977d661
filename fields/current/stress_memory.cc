#include "fields/current/stress_memory.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater {
namespace {

Complex<double> complex_of(Horizontal value) { return {value.real(), value.imag()}; }

}  // namespace

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

StressChanges::StressChanges(const HourlyStress& stress)
    : first_(stress.first),
      slope_pa_h_(stress.stress_pa.size()),
      since_first_pa_(stress.stress_pa.size()) {
  for (std::size_t i = 0; i + 1 < slope_pa_h_.size(); ++i) {
    if (stress.is_known[i] && stress.is_known[i + 1])
      slope_pa_h_[i] = complex_of(stress.stress_pa[i + 1] - stress.stress_pa[i]);
    since_first_pa_[i + 1] = since_first_pa_[i] + slope_pa_h_[i];
  }
}

StressChanges::Place StressChanges::place_of(UtcTime time) const {
  const double since_h = hours_between(first_, time);
  if (slope_pa_h_.empty() || since_h <= 0) return {};
  const std::size_t hour = std::min(static_cast<std::size_t>(since_h), slope_pa_h_.size() - 1);
  return {hour, since_h - static_cast<double>(hour)};
}

Complex<double> StressChanges::since_first_pa(const Place& place) const {
  if (slope_pa_h_.empty()) return {};
  return since_first_pa_[place.hour] + scaled(slope_pa_h_[place.hour], place.part_h);
}

// m' = -lambda m + g, solved over a stretch of constant slope g:
//   m = d m_0 + g s,   d = e^{-lambda t},   s = (1 - d)/lambda,   ds/dlambda = (t d - s)/lambda
struct StressMemory::Stretch {
  double hours;
  Complex<double> decay;
  Complex<double> settled_h;
  Complex<double> settled_by_lambda_h2;

  Stretch(double length_h, const Complex<double>& lambda_per_h,
          const Complex<double>& inverse_lambda_h)
      : hours(length_h),
        decay(exp(scaled(lambda_per_h, -length_h))),
        settled_h(-expm1(scaled(lambda_per_h, -length_h)) * inverse_lambda_h),
        settled_by_lambda_h2((scaled(decay, length_h) - settled_h) * inverse_lambda_h) {}

  [[nodiscard]] Knot after(const Knot& from, const Complex<double>& slope_pa_h) const {
    return {decay * from.memory_pa + slope_pa_h * settled_h,
            decay * (from.by_lambda_pa_h - scaled(from.memory_pa, hours)) +
                slope_pa_h * settled_by_lambda_h2};
  }
};

StressMemory::StressMemory(std::shared_ptr<const StressChanges> changes, Horizontal lambda_per_h)
    : changes_(std::move(changes)),
      lambda_per_h_(complex_of(lambda_per_h)),
      inverse_lambda_h_(reciprocal(lambda_per_h_)),
      knot_(changes_->hours()) {
  expects(lambda_per_h.real() > 0, "a mode decays");
  const Stretch hour(1.0, lambda_per_h_, inverse_lambda_h_);
  for (std::size_t i = 0; i + 1 < knot_.size(); ++i)
    knot_[i + 1] = hour.after(knot_[i], changes_->slope_pa_h(i));
}

StressMemory::Knot StressMemory::at(const StressChanges::Place& place) const {
  if (knot_.empty()) return {};
  if (place.part_h <= 0) return knot_[place.hour];
  return Stretch(place.part_h, lambda_per_h_, inverse_lambda_h_)
      .after(knot_[place.hour], changes_->slope_pa_h(place.hour));
}

// A mean: m' = -lambda m + g integrated over the interval gives
//   lambda Int m = m(start) - m(end) + T(end) - T(start),   and the same differentiated by lambda.
StressMemory::Value StressMemory::over(const TimeCell& cell) const {
  const StressChanges::Place start = changes_->place_of(cell.start);
  const Knot from = at(start);
  if (!cell.is_mean()) return {to_horizontal(from.memory_pa), to_horizontal(from.by_lambda_pa_h)};
  const StressChanges::Place end = changes_->place_of(cell.end);
  const Knot to = at(end);
  const Complex<double> changed_pa =
      changes_->since_first_pa(end) - changes_->since_first_pa(start);
  const Complex<double> integral_pa_h =
      (from.memory_pa - to.memory_pa + changed_pa) * inverse_lambda_h_;
  const Complex<double> integral_by_lambda =
      (from.by_lambda_pa_h - to.by_lambda_pa_h - integral_pa_h) * inverse_lambda_h_;
  const double width_h = hours_between(cell.start, cell.end);
  return {to_horizontal(integral_pa_h) / width_h, to_horizontal(integral_by_lambda) / width_h};
}

}  // namespace slackwater
