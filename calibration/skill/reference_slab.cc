#include "calibration/skill/reference_slab.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "calibration/skill/history.h"
#include "calibration/skill/slab_response.h"
#include "calibration/skill/tide_baseline.h"
#include "fields/current/coriolis.h"

namespace slackwater::calibration {
namespace {

using Eigen::Index;
using Eigen::Matrix3cd;
using Eigen::Vector3cd;

constexpr std::array damping_choices_per_h{1.0 / 24.0, 1.0 / 48.0, 1.0 / 96.0};
constexpr std::array penalty{0.0, 1.5e-4, 1.0e-3};
constexpr double longest_spin_up_h = 72.0;
constexpr double residual_memory_h = 24.0;
constexpr double residual_window_h = 3.0;
constexpr std::size_t least_samples = 3;

/// A cell in hours from the end of D.
struct Interval {
  double start_h = 0;
  double end_h = 0;
  [[nodiscard]] double centre_h() const { return 0.5 * (start_h + end_h); }
  [[nodiscard]] double width_h() const { return end_h - start_h; }
};

Interval interval_of(const TimeCell& cell, UtcTime end) {
  return {hours_between(end, cell.start), hours_between(end, cell.end)};
}

/// e^{-lambda t} at an instant, or its average over an interval.
Horizontal decaying(Horizontal lambda, const Interval& at) {
  const Horizontal half = 0.5 * lambda * at.width_h();
  const Horizontal widened = std::abs(half) < 1e-6 ? Horizontal(1.0) : std::sinh(half) / half;
  return std::exp(-lambda * at.centre_h()) * widened;
}

/// A series at whole hours, linear between them, constant beyond its ends.
class HourlySeries {
 public:
  HourlySeries(double first_h, std::vector<Horizontal> value)
      : first_h_(first_h), value_(std::move(value)), integral_(value_.size()) {
    for (std::size_t i = 1; i < value_.size(); ++i)
      integral_[i] = integral_[i - 1] + 0.5 * (value_[i - 1] + value_[i]);
  }
  [[nodiscard]] Horizontal over(const Interval& at) const {
    if (at.width_h() <= 0) return value_at(at.start_h);
    return (integral_to(at.end_h) - integral_to(at.start_h)) / at.width_h();
  }

 private:
  [[nodiscard]] Horizontal value_at(double t_h) const {
    const double x = std::clamp(t_h - first_h_, 0.0, static_cast<double>(value_.size() - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(x), value_.size() - 2);
    const double share = x - static_cast<double>(i);
    return (1.0 - share) * value_[i] + share * value_[i + 1];
  }
  [[nodiscard]] Horizontal integral_to(double t_h) const {
    const double last = static_cast<double>(value_.size() - 1);
    const double x = t_h - first_h_;
    if (x <= 0) return value_.front() * x;
    if (x >= last) return integral_.back() + value_.back() * (x - last);
    const auto i = static_cast<std::size_t>(x);
    const double share = x - static_cast<double>(i);
    return integral_[i] + 0.5 * share * (value_[i] + value_at(t_h));
  }

  double first_h_;
  std::vector<Horizontal> value_;
  std::vector<Horizontal> integral_;
};

/// Stress at whole hours about the end of D.
struct HourlyStress {
  double first_h = 0;
  std::vector<Horizontal> stress_pa;
};

/// Linear between the stamps, held beyond them.
Horizontal wind_at(const LevelSeries& wind, UtcTime end, double t_h) {
  const auto hour = [&](std::size_t i) { return hours_between(end, wind.time[i].centre()); };
  const auto above = std::partition_point(
      wind.time.begin(), wind.time.end(),
      [&](const TimeCell& cell) { return hours_between(end, cell.centre()) < t_h; });
  const auto i = static_cast<std::size_t>(above - wind.time.begin());
  if (i == 0) return wind.value.front();
  if (i == wind.size()) return wind.value.back();
  const double share = (t_h - hour(i - 1)) / (hour(i) - hour(i - 1));
  return (1.0 - share) * wind.value[i - 1] + share * wind.value[i];
}

std::optional<HourlyStress> hourly_stress(const BaselineInput& input, double last_h) {
  if (input.wind == nullptr) return std::nullopt;
  const UtcTime end = end_of_day(input.day);
  const LevelSeries wind = level_series(*input.wind, 0);
  if (wind.empty()) return std::nullopt;
  HourlyStress hourly;
  hourly.first_h = std::max(-24.0 - longest_spin_up_h,
                            std::ceil(hours_between(end, wind.time.front().centre()) - 1e-9));
  if (hourly.first_h >= 0) return std::nullopt;
  const int hours = static_cast<int>(std::ceil(last_h - hourly.first_h)) + 1;
  for (int i = 0; i < hours; ++i) {
    const double t_h = hourly.first_h + i;
    hourly.stress_pa.push_back(
        reference_stress_pa(wind_at(wind, end, input.persist_wind ? std::min(t_h, 0.0) : t_h)));
  }
  return hourly;
}

/// One level of D, freed of its tide.
struct LevelOfDay {
  std::vector<Interval> at;
  std::vector<Horizontal> value;
};

std::vector<LevelOfDay> levels_of_day(const BaselineInput& input, const ColumnTide& tide) {
  const VectorColumn& current = input.current;
  std::vector<std::size_t> times;
  std::vector<TimeCell> cells;
  for (std::size_t t = 0; t < current.times(); ++t) {
    if (!belongs_to_day(current.time[t], input.day)) continue;
    times.push_back(t);
    cells.push_back(current.time[t]);
  }
  const std::vector<Horizontal> oscillation = tide.oscillation(cells);
  std::vector<LevelOfDay> levels(current.levels());
  for (std::size_t k = 0; k < levels.size(); ++k) {
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (!current.has(times[i], k)) continue;
      levels[k].at.push_back(interval_of(cells[i], end_of_day(input.day)));
      levels[k].value.push_back(current.value[current.offset(times[i], k)] -
                                oscillation[i * levels.size() + k]);
    }
    if (levels[k].at.size() < least_samples) levels[k] = {};
  }
  return levels;
}

/// The three functions of time for one r.
struct Model {
  Horizontal lambda_per_h;
  std::optional<HourlySeries> slab;
  [[nodiscard]] Vector3cd row(const Interval& at) const {
    return {1.0, slab ? slab->over(at) : Horizontal{}, decaying(lambda_per_h, at)};
  }
};

struct LevelFit {
  Vector3cd coefficients = Vector3cd::Zero();
  Horizontal late_residual{};
  double squared_misfit = 0;
};

LevelFit fit_level(const LevelOfDay& level, const Model& model) {
  LevelFit fit;
  if (level.at.empty()) return fit;
  Eigen::Matrix<Horizontal, Eigen::Dynamic, 3> a(static_cast<Index>(level.at.size()), 3);
  for (std::size_t i = 0; i < level.at.size(); ++i)
    a.row(static_cast<Index>(i)) = model.row(level.at[i]).transpose();
  const Eigen::Map<const Eigen::VectorXcd> y(level.value.data(), a.rows());
  Matrix3cd normal = a.adjoint() * a;
  const auto n = static_cast<double>(level.at.size());
  for (Index j = 0; j < 3; ++j) normal(j, j) += n * penalty[static_cast<std::size_t>(j)];
  fit.coefficients = normal.ldlt().solve(a.adjoint() * y);
  const Eigen::VectorXcd residual = y - a * fit.coefficients;
  fit.squared_misfit = residual.squaredNorm();
  double late = 0;
  for (std::size_t i = 0; i < level.at.size(); ++i) {
    if (level.at[i].centre_h() <= -residual_window_h + 1e-9) continue;
    fit.late_residual += residual(static_cast<Index>(i));
    late += 1.0;
  }
  if (late > 0) fit.late_residual /= late;
  return fit;
}

}  // namespace

BaselineOutcome reference_slab_forecast(const BaselineInput& input,
                                        std::span<const TimeCell> truth_time) {
  const UtcTime end = end_of_day(input.day);
  const std::size_t levels = input.current.levels();
  std::optional<ColumnTide> own;
  if (input.tide == nullptr) own.emplace(input.current, input.day, input.tide_since);
  const ColumnTide& tide = own ? *own : *input.tide;
  const std::vector<LevelOfDay> day = levels_of_day(input, tide);
  double last_h = 24.0;
  for (const TimeCell& cell : truth_time) last_h = std::max(last_h, hours_between(end, cell.end));
  const std::optional<HourlyStress> stress = hourly_stress(input, last_h);

  const double coriolis_rad_h = 3600.0 * coriolis_parameter_rad_s(input.latitude);
  std::optional<Model> best;
  std::vector<LevelFit> best_fit;
  double least = std::numeric_limits<double>::infinity();
  for (const double damping_per_h : damping_choices_per_h) {
    Model model{{damping_per_h, coriolis_rad_h}, std::nullopt};
    if (stress)
      model.slab.emplace(stress->first_h,
                         slab_response(stress->stress_pa, {damping_per_h, coriolis_rad_h}));
    std::vector<LevelFit> fit;
    double misfit = 0;
    for (const LevelOfDay& level : day) {
      fit.push_back(fit_level(level, model));
      misfit += fit.back().squared_misfit;
    }
    if (misfit < least) least = misfit, best = std::move(model), best_fit = std::move(fit);
  }

  BaselineForecast forecast = nothing_yet(truth_time.size(), levels);
  forecast.value = tide.oscillation(truth_time);
  for (std::size_t t = 0; best && t < truth_time.size(); ++t) {
    const Interval at = interval_of(truth_time[t], end);
    const Vector3cd row = best->row(at);
    const Horizontal fading = decaying(1.0 / residual_memory_h, at);
    for (std::size_t k = 0; k < levels; ++k) {
      if (day[k].at.empty()) continue;
      forecast.value[t * levels + k] +=
          row.cwiseProduct(best_fit[k].coefficients).sum() + best_fit[k].late_residual * fading;
      forecast.status[t * levels + k] = SampleStatus::ok;
    }
  }
  return outcome_of(std::move(forecast),
                    "fewer than 3 values on " + format_day(input.day) +
                        " at every level; reference-slab needs 3 at one level");
}

}  // namespace slackwater::calibration
