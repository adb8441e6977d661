#include "fields/current/stress_series.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater {

StressSeries::StressSeries(const VectorColumn& wind_10m, DragLaw law) {
  for (std::size_t t = 0; t < wind_10m.times(); ++t) {
    if (!wind_10m.has(t)) continue;
    const Horizontal wind = wind_10m.value[wind_10m.offset(t, 0)];
    if (!std::isfinite(wind.real()) || !std::isfinite(wind.imag())) continue;
    const UtcTime centre = wind_10m.time[t].centre();
    expects(time_.empty() || time_.back() < centre, "the times of a wind column must ascend");
    time_.push_back(centre);
    stress_pa_.push_back(wind_stress_pa(wind, law));
  }
}

std::optional<Horizontal> StressSeries::at(UtcTime time) const {
  if (time_.empty()) return std::nullopt;
  const auto after = std::lower_bound(time_.begin(), time_.end(), time);
  if (after == time_.end()) {
    if (time - time_.back() > longest_hold) return std::nullopt;
    return stress_pa_.back();
  }
  const auto i = static_cast<std::size_t>(after - time_.begin());
  if (*after == time) return stress_pa_[i];
  if (i == 0) {
    if (time_.front() - time > longest_hold) return std::nullopt;
    return stress_pa_.front();
  }
  if (time_[i] - time_[i - 1] > longest_gap) return std::nullopt;
  const double weight =
      seconds_between(time_[i - 1], time) / seconds_between(time_[i - 1], time_[i]);
  return (1.0 - weight) * stress_pa_[i - 1] + weight * stress_pa_[i];
}

std::optional<Horizontal> StressSeries::over(const TimeCell& cell) const {
  if (!cell.is_mean()) return at(cell.start);
  expects(cell.start < cell.end, "a mean ends after it starts");
  // Piecewise linear: trapezia between the ends of the interval and the samples inside it are
  // exact.
  UtcTime from = cell.start;
  std::optional<Horizontal> stress_from = at(from);
  if (!stress_from) return std::nullopt;
  Horizontal integral_pa_s{};
  auto next = std::upper_bound(time_.begin(), time_.end(), from);
  while (from < cell.end) {
    const UtcTime to = next == time_.end() ? cell.end : std::min(*next, cell.end);
    if (next != time_.begin() && next != time_.end() && *next - *std::prev(next) > longest_gap) {
      return std::nullopt;
    }
    const std::optional<Horizontal> stress_to = at(to);
    if (!stress_to) return std::nullopt;
    integral_pa_s += 0.5 * seconds_between(from, to) * (*stress_from + *stress_to);
    from = to;
    stress_from = stress_to;
    if (next != time_.end()) ++next;
  }
  return integral_pa_s / seconds_between(cell.start, cell.end);
}

}  // namespace slackwater
