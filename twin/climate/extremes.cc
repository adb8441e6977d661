#include "twin/climate/extremes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/numbers/quantile.h"
#include "fields/base/numbers/random.h"
#include "twin/climate/known_months.h"
#include "twin/risk/workability/calendar.h"

namespace slackwater::twin {
namespace {

constexpr double hours_of_year = 365.25 * 24;
constexpr const char* stream = "twin/climate/extremes";

/// A Poisson number, by the arrivals of a process of rate 1 up to its mean.
std::size_t poisson(double mean, Rng& random) {
  std::size_t count = 0;
  for (double at = -std::log(1 - random.uniform()); at <= mean; ++count)
    at -= std::log(1 - random.uniform());
  return count;
}

Interval90 interval_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {percentile(values, 5), percentile(values, 95)};
}

/// What a storm exceeds once in so many years.
double return_value(double threshold, const Pareto& fit, double storms_per_year, double years) {
  return threshold + fit.exceeded_with(std::min(1.0, 1 / (storms_per_year * years)));
}

double return_value(const ExtremeValue& fit, double years) {
  return fit.not_exceeded_with(std::exp(-1 / years));
}

std::vector<ReturnValue> asked(const ExtremesQuestion& question, double history_years) {
  std::vector<ReturnValue> returns;
  for (const double years : question.return_years) {
    ReturnValue one;
    one.years = years;
    // A day or two that whole years lack take nothing away.
    if (years > 1.01 * most_histories * history_years) one.support = ReturnSupport::beyond_history;
    returns.push_back(one);
  }
  return returns;
}

double days_of(int year, int month) {
  const auto last = std::chrono::year(year) / month / std::chrono::last;
  return static_cast<unsigned>(std::chrono::year_month_day_last(last).day());
}

/// Storms over each possible threshold, from the greatest threshold on.
struct Tried {
  double threshold = 0;
  std::vector<StormPeak> peaks;
};

class Thresholds {
 public:
  Thresholds(std::span<const double> values, double years, std::size_t separation_steps)
      : years_(years) {
    for (const double threshold : possible_thresholds(values))
      tried_.push_back({threshold, storm_peaks(values, threshold, separation_steps)});
  }

  /// The greatest with at least so many storms a year; where none has, that with most.
  [[nodiscard]] const Tried* with(double storms_per_year) const {
    const Tried* most = nullptr;
    for (const Tried& one : tried_) {
      if (most == nullptr || one.peaks.size() > most->peaks.size()) most = &one;
      if (static_cast<double>(one.peaks.size()) >= storms_per_year * years_) return &one;
    }
    return most;
  }

 private:
  double years_;
  std::vector<Tried> tried_;
};

}  // namespace

std::optional<PeaksFit> peaks_fit(std::span<const StormPeak> peaks, double threshold, double years,
                                  const ExtremesQuestion& question) {
  expects(years > 0, "a history lasts");
  if (peaks.size() < 3) return std::nullopt;
  std::vector<double> excesses;
  excesses.reserve(peaks.size());
  for (const StormPeak& peak : peaks) excesses.push_back(peak.value - threshold);
  const double greatest = *std::max_element(excesses.begin(), excesses.end());
  const std::optional<Pareto> fit = fitted_pareto(excesses);
  if (!fit) return std::nullopt;
  PeaksFit result;
  result.threshold = threshold;
  result.storms = peaks.size();
  result.storms_per_year = static_cast<double>(peaks.size()) / years;
  result.fit = *fit;
  result.greatest_seen = threshold + greatest;
  result.returns = asked(question, years);
  Rng random(question.seed, stream);
  std::vector<double> shapes;
  std::vector<std::vector<double>> values(result.returns.size());
  for (std::size_t r = 0; r < question.resamples; ++r) {
    const std::size_t storms = poisson(static_cast<double>(peaks.size()), random);
    excesses.resize(storms);
    for (double& excess : excesses) excess = fit->exceeded_with(1 - random.uniform());
    if (storms < 3) continue;
    const std::optional<Pareto> again = fitted_pareto(excesses);
    if (!again) continue;
    shapes.push_back(again->shape);
    for (std::size_t v = 0; v < values.size(); ++v)
      values[v].push_back(return_value(threshold, *again, static_cast<double>(storms) / years,
                                       result.returns[v].years));
  }
  result.shape = interval_of(std::move(shapes));
  for (std::size_t v = 0; v < values.size(); ++v) {
    ReturnValue& one = result.returns[v];
    if (one.support == ReturnSupport::supported && !result.is_good())
      one.support = ReturnSupport::no_good_fit;
    if (one.support == ReturnSupport::supported && result.storms_per_year * one.years <= 1)
      one.support = ReturnSupport::below_threshold;
    if (one.support != ReturnSupport::supported) continue;
    one.value = return_value(threshold, *fit, result.storms_per_year, one.years);
    one.interval = interval_of(std::move(values[v]));
  }
  return result;
}

std::optional<MaximaFit> maxima_fit(const std::vector<double>& maxima, bool has_shape,
                                    const ExtremesQuestion& question) {
  const auto fitted = [has_shape](const std::vector<double>& values) {
    return has_shape ? fitted_extreme_value(values) : fitted_gumbel(values);
  };
  const std::optional<ExtremeValue> fit = fitted(maxima);
  if (!fit) return std::nullopt;
  MaximaFit result{*fit, *std::max_element(maxima.begin(), maxima.end()),
                   asked(question, static_cast<double>(maxima.size()))};
  Rng random(question.seed, stream);
  std::vector<std::vector<double>> values(result.returns.size());
  std::vector<double> sample(maxima.size());
  for (std::size_t r = 0; r < question.resamples; ++r) {
    for (double& value : sample)
      value = fit->not_exceeded_with(std::max(random.uniform(), 0x1p-53));
    const std::optional<ExtremeValue> again = fitted(sample);
    if (!again) continue;
    for (std::size_t v = 0; v < values.size(); ++v)
      values[v].push_back(return_value(*again, result.returns[v].years));
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    ReturnValue& one = result.returns[v];
    if (one.support == ReturnSupport::supported && !result.is_good())
      one.support = ReturnSupport::no_good_fit;
    if (one.support == ReturnSupport::supported && one.years < 1)
      one.support = ReturnSupport::below_year;
    if (one.support != ReturnSupport::supported) continue;
    one.value = return_value(*fit, one.years);
    one.interval = interval_of(std::move(values[v]));
  }
  return result;
}

std::vector<YearMaximum> year_maxima(std::span<const double> values, const StepClock& clock) {
  std::vector<YearMaximum> maxima;
  const std::vector<MonthSteps> months = months_of(clock, std::nullopt);
  for (auto month = months.begin(); month != months.end();) {
    const int year = month->year;
    YearMaximum maximum{year, month->steps.begin, -std::numeric_limits<double>::infinity()};
    double known_h = 0;
    std::size_t known_months = 0;
    for (; month != months.end() && month->year == year; ++month) {
      std::size_t known = 0;
      for (std::size_t i = month->steps.begin; i < month->steps.end; ++i) {
        if (std::isnan(values[i])) continue;
        if (values[i] > maximum.value) maximum = {year, i, values[i]};
        ++known;
      }
      const double month_h = static_cast<double>(known) * clock.step_h();
      known_h += month_h;
      known_months += month_h >= month_share * 24 * days_of(year, month->month) ? 1 : 0;
    }
    const double days = std::chrono::year(year).is_leap() ? 366 : 365;
    if (known_months == 12 && known_h >= complete_share * days * 24) maxima.push_back(maximum);
  }
  return maxima;
}

Extremes extremes_of(std::span<const double> values, const StepClock& clock,
                     const ExtremesQuestion& question) {
  expects(values.size() == clock.steps, "a value for each step");
  Extremes result;
  const KnownMonths known = known_months(values, months_of(clock, std::nullopt));
  result.years_known = static_cast<double>(known.all.known) * clock.step_h() / hours_of_year;
  result.separation_h = static_cast<double>(question.separation_steps) * clock.step_h();
  const Duration value_step = std::max(clock.step, question.value_step);
  result.step_h = clock.step_h();
  result.value_step_h = hours_of(value_step);
  if (value_step > longest_step || result.value_step_h > result.separation_h) {
    result.no_peaks = NoPeaks::coarse_steps;
    return result;
  }
  result.maxima = year_maxima(values, clock);
  std::vector<double> maxima;
  for (const YearMaximum& one : result.maxima) maxima.push_back(one.value);
  if (maxima.size() >= least_gumbel_years) result.gumbel = maxima_fit(maxima, false, question);
  if (maxima.size() >= least_shape_years) result.extreme_value = maxima_fit(maxima, true, question);
  if (result.years_known < least_years) {
    result.no_peaks = NoPeaks::short_history;
    return result;
  }
  result.months_missing = known.unknown();
  for (const int month : known.thin()) result.months_missing.push_back(month);
  if (!result.months_missing.empty()) {
    std::sort(result.months_missing.begin(), result.months_missing.end());
    result.no_peaks = NoPeaks::seasons_missing;
    return result;
  }
  const Thresholds thresholds(values, result.years_known, question.separation_steps);
  if (!question.threshold)
    result.rate =
        std::max(question.storms_per_year, static_cast<double>(least_storms) / result.years_known);
  Tried chosen;
  if (question.threshold) {
    chosen = {*question.threshold,
              storm_peaks(values, *question.threshold, question.separation_steps)};
  } else if (const Tried* found = thresholds.with(result.rate)) {
    chosen = *found;
  } else {
    result.no_peaks = NoPeaks::all_alike;
    return result;
  }
  result.storms_found = chosen.peaks.size();
  if (chosen.peaks.size() < least_storms) {
    result.no_peaks = NoPeaks::few_storms;
    return result;
  }
  result.peaks = peaks_fit(chosen.peaks, chosen.threshold, result.years_known, question);
  if (!result.peaks) {
    result.no_peaks = NoPeaks::all_alike;
    return result;
  }
  if (!result.peaks->is_good()) result.no_peaks = NoPeaks::no_good_fit;
  result.other_thresholds.push_back(*result.peaks);
  for (const double factor : {2.0, 1.6, 1.25, 0.8, 0.6, 0.4}) {
    const Tried* other = thresholds.with(factor * result.peaks->storms_per_year);
    if (other == nullptr || other->peaks.size() < least_storms) continue;
    const bool is_there =
        std::any_of(result.other_thresholds.begin(), result.other_thresholds.end(),
                    [&](const PeaksFit& fit) { return fit.threshold == other->threshold; });
    if (is_there) continue;
    if (auto fit = peaks_fit(other->peaks, other->threshold, result.years_known, question))
      result.other_thresholds.push_back(std::move(*fit));
  }
  std::sort(result.other_thresholds.begin(), result.other_thresholds.end(),
            [](const PeaksFit& a, const PeaksFit& b) { return a.threshold < b.threshold; });
  return result;
}

}  // namespace slackwater::twin
