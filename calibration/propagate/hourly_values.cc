#include "calibration/propagate/hourly_values.h"

#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

/// Times that make one cell.
struct Hour {
  HourCell cell;
  std::vector<std::size_t> times;
};

std::vector<Hour> hours_of(const VectorColumn& residual, UtcTime end_of_day) {
  std::vector<Hour> hours;
  std::chrono::hours previous{-1};
  for (std::size_t t = 0; t < residual.times(); ++t) {
    const TimeCell& time = residual.time[t];
    if (time.end > end_of_day) continue;
    const HourCell cell = HourCell::of(time, end_of_day);
    const auto before_end = std::chrono::floor<std::chrono::hours>(end_of_day - time.centre());
    const bool joins = !hours.empty() && before_end == previous && cell.is_instant() &&
                       hours.back().cell.is_instant();
    if (!joins) hours.push_back({cell, {}});
    Hour& hour = hours.back();
    hour.times.push_back(t);
    if (joins) {
      const auto n = static_cast<double>(hour.times.size());
      hour.cell = HourCell::at(hour.cell.from_h + (cell.from_h - hour.cell.from_h) / n);
    }
    previous = before_end;
  }
  return hours;
}

}  // namespace

HourlyValues hourly_values(const VectorColumn& residual,
                           std::span<const Horizontal> wind_answer_m_s, UtcTime end_of_day,
                           std::span<const double> sigma_m_s) {
  const std::size_t n = residual.times() * residual.levels();
  expects(residual.value.size() == n && residual.status.size() == n,
          "a residual has a value and a status for each time and level");
  expects(wind_answer_m_s.size() == n, "one answer to the wind for each value of the residual");
  expects(sigma_m_s.empty() || sigma_m_s.size() == n, "one stated error for each value, or none");
  const std::vector<Hour> hours = hours_of(residual, end_of_day);
  const auto rows = static_cast<Eigen::Index>(hours.size());
  const auto levels = static_cast<Eigen::Index>(residual.levels());
  HourlyValues out;
  out.value_m_s.setZero(rows, levels);
  out.wind_answer_m_s.setZero(rows, levels);
  out.error_m2_s2.setZero(rows, levels);
  out.has.setConstant(rows, levels, false);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Hour& hour = hours[static_cast<std::size_t>(i)];
    out.cell.push_back(hour.cell);
    for (Eigen::Index k = 0; k < levels; ++k) {
      double count = 0;
      for (const std::size_t t : hour.times) {
        if (!residual.has(t, static_cast<std::size_t>(k))) continue;
        const std::size_t o = residual.offset(t, static_cast<std::size_t>(k));
        out.value_m_s(i, k) += residual.value[o];
        out.wind_answer_m_s(i, k) += wind_answer_m_s[o];
        if (!sigma_m_s.empty()) out.error_m2_s2(i, k) += 2.0 * sigma_m_s[o] * sigma_m_s[o];
        count += 1;
      }
      if (count == 0) continue;
      out.has(i, k) = true;
      out.value_m_s(i, k) /= count;
      out.wind_answer_m_s(i, k) /= count;
      out.error_m2_s2(i, k) /= count * count;
    }
  }
  return out;
}

}  // namespace slackwater::calibration
