#include "calibration/day/earned_heights.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "calibration/day/given/surface_truth.h"
#include "calibration/day/past_plan.h"
#include "fields/base/constants.h"
#include "fields/base/parallel.h"
#include "fields/base/text.h"
#include "fields/wave/height_error.h"

namespace slackwater::calibration {
namespace {

constexpr int days_back = 21;
constexpr double pairs_a_day = 2;
constexpr double pairs_beforehand = 8;
/// Standard deviations by source. Providers see to it that theirs do not regress.
constexpr std::array<double, height_sources> regression_beforehand{0.1, 0.5, 0.5};
/// Nearly the whole regression is there two days ahead; little of it in the first hours.
constexpr double regression_time_h = 30;
constexpr std::size_t least_hours = 48;
/// Lower ones are told apart by instruments' noise alone.
constexpr double lowest_m = 0.1;

double logarithm_of(double height_m) { return std::log(height_m + height_error::shift_m); }

/// What a regression of 1 takes out.
double distance_from_usual(double height_m, double usual_m, double lead_h) {
  if (std::isnan(usual_m)) return 0;
  return (1 - std::exp(-lead_h / regression_time_h)) *
         (logarithm_of(height_m) - logarithm_of(usual_m));
}

struct HeightPair {
  double error = 0;     ///< of ln(Hs + 0.3 m), forecast minus truth
  double distance = 0;  ///< `distance_from_usual` of the forecast
  double spread = 1;
};
using PairsOfDay = std::array<std::vector<HeightPair>, height_sources>;

PairsOfDay pairs_of(const ColumnData& column, const Site& site, const ForecastPlan& past,
                    const Chosen<double>& truth, double usual_m, const ColumnParts& parts) {
  PairsOfDay pairs;
  const HorizonWind wind =
      parts.wind(column.wind, past.wind, past.end_of_day(), past.stamps, past.best);
  const HorizonSea made =
      parts.waves(column, site, past.wind, past.end_of_day(), past.stamps, wind, past.best);
  if (made.sea.empty()) return pairs;
  const std::vector<double> spread = spread_beforehand(made, wind, column, site, past);
  for (std::size_t t = 0; t < truth.column.times(); ++t) {
    const UtcTime time = truth.column.time[t].centre();
    const double height_m = truth.column.value[t];
    if (!truth.column.has(t) || !(height_m >= lowest_m) || time <= past.end_of_day()) continue;
    if (is_its_own_truth(past.stamps, made.source, time, *truth.origin[t])) continue;
    const auto place = place_in(past.stamps, time);
    if (!place) continue;
    const std::size_t near = place->upper > 0.5 ? place->low + 1 : place->low;
    const double forecast_m = made.sea[near].significant_height_m;
    if (std::isnan(forecast_m) || made.source[near] == DataStatus::observation) continue;
    pairs[static_cast<std::size_t>(height_source_of(made.source[near]))].push_back(
        {logarithm_of(forecast_m) - logarithm_of(height_m),
         distance_from_usual(forecast_m, usual_m, hours_between(past.end_of_day(), time)),
         spread[near]});
  }
  return pairs;
}

/// The mean over a day's pairs.
template <typename Value>
double mean_of(const std::vector<HeightPair>& pairs, const Value& value) {
  double sum = 0;
  for (const HeightPair& pair : pairs) sum += value(pair);
  return sum / static_cast<double>(pairs.size());
}

/// The sums of the normal equations, each day's mean as `pairs_a_day`.
struct Normal {
  double one = 0, distance = 0, distance2 = 0, error = 0, error_distance = 0;

  explicit Normal(std::span<const PairsOfDay> past, std::size_t source) {
    for (const PairsOfDay& day : past) {
      if (day[source].empty()) continue;
      const auto add = [&](double& sum, auto value) {
        sum += pairs_a_day * mean_of(day[source], [&](const HeightPair& pair) {
                 return value(pair) / (pair.spread * pair.spread);
               });
      };
      add(one, [](const HeightPair&) { return 1.0; });
      add(distance, [](const HeightPair& pair) { return pair.distance; });
      add(distance2, [](const HeightPair& pair) { return pair.distance * pair.distance; });
      add(error, [](const HeightPair& pair) { return pair.error; });
      add(error_distance, [](const HeightPair& pair) { return pair.error * pair.distance; });
    }
  }
};

EarnedHeight earned_from(std::span<const PairsOfDay> past, std::size_t source) {
  EarnedHeight earned;
  for (const PairsOfDay& day : past) {
    if (day[source].empty()) continue;
    ++earned.days;
    earned.hours += day[source].size();
  }
  if (earned.days == 0) return earned;
  const double pairs = pairs_a_day * static_cast<double>(earned.days);
  Normal sums(past, source);
  sums.one *= 1 + pairs_beforehand / pairs;
  sums.distance2 += 1 / (regression_beforehand[source] * regression_beforehand[source]);
  const double determinant = sums.one * sums.distance2 - sums.distance * sums.distance;
  earned.bias = (sums.error * sums.distance2 - sums.error_distance * sums.distance) / determinant;
  earned.regression = (sums.error_distance * sums.one - sums.error * sums.distance) / determinant;
  double squares = pairs_beforehand;
  for (const PairsOfDay& day : past) {
    if (day[source].empty()) continue;
    squares += pairs_a_day * mean_of(day[source], [&](const HeightPair& pair) {
                 const double off = pair.error - earned.bias - earned.regression * pair.distance;
                 return off * off / (pair.spread * pair.spread);
               });
  }
  earned.factor = std::sqrt(squares / (pairs + pairs_beforehand));
  return earned;
}

}  // namespace

double usual_height_m(const ColumnData& column, const ForecastPlan& plan) {
  const Chosen<double> known = surface_truth(column.significant_height, plan.knowledge());
  const UtcTime end = plan.end_of_day();
  double sum = 0;
  std::size_t hours = 0;
  for (std::size_t t = 0; t < known.column.times(); ++t) {
    const UtcTime time = known.column.time[t].centre();
    if (!known.column.has(t) || time > end || time < end - std::chrono::days(days_back)) continue;
    sum += logarithm_of(known.column.value[t]);
    ++hours;
  }
  if (hours < least_hours) return constants::nan;
  return std::exp(sum / static_cast<double>(hours)) - height_error::shift_m;
}

double EarnedHeight::off(double height_m, double usual_m, double lead_h) const noexcept {
  return bias + regression * distance_from_usual(height_m, usual_m, lead_h);
}

EarnedHeights earned_heights(const ColumnData& column, const Site& site, const ForecastPlan& plan,
                             const ColumnParts& parts, int threads) {
  Knowledge knowledge = plan.knowledge();
  const Chosen<double> truth = surface_truth(column.significant_height, knowledge);
  EarnedHeights earned;
  if (truth.empty()) return earned;
  const double usual_m = usual_height_m(column, plan);
  std::vector<PairsOfDay> days(days_back);
  for_all(days.size(), threads, [&](std::size_t i) {
    const UtcDay day = plan.day - std::chrono::days(static_cast<int>(i) + 1);
    days[i] = pairs_of(column, site, past_plan(plan, day), truth, usual_m, parts);
  });
  for (std::size_t source = 0; source < height_sources; ++source)
    earned.of_source[source] = earned_from(days, source);
  return earned;
}

void apply(const EarnedHeights& earned, const ForecastPlan& plan, double usual_m,
           ForecastColumn& column) {
  for (std::size_t t = 0; t < column.sea.size(); ++t) {
    const EarnedHeight& of =
        earned.of_source[static_cast<std::size_t>(height_source_of(column.sea_source[t]))];
    double& height_m = column.sea[t].significant_height_m;
    const double lead_h = std::max(0.0, hours_between(plan.end_of_day(), plan.stamps[t]));
    height_m = height_error::height_at(height_m, 1, -of.off(height_m, usual_m, lead_h));
    column.height_spread[t] *= of.factor;
  }
}

std::string note_on(const EarnedHeights& earned, double usual_m, const ForecastColumn& column) {
  constexpr std::array<const char*, height_sources> whose{"of the wave product",
                                                          "computed from the wind", "kept"};
  constexpr double worth_a_word = 0.03;
  constexpr double regression_worth_a_word = 0.1;
  std::string text;
  const auto say = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  for (std::size_t source = 0; source < height_sources; ++source) {
    const EarnedHeight& of = earned.of_source[source];
    const bool is_used =
        std::any_of(column.sea_source.begin(), column.sea_source.end(), [&](DataStatus status) {
          return static_cast<std::size_t>(height_source_of(status)) == source;
        });
    if (!is_used) continue;
    if (std::abs(of.bias) >= worth_a_word)
      say(
          formatted("the wave heights {} are {} by {:.0f} %: on {} past days they were that much "
                    "too {}",
                    whose[source], of.bias > 0 ? "lowered" : "raised",
                    100 * std::abs(std::expm1(-of.bias)), of.days, of.bias > 0 ? "high" : "low"));
    if (of.regression >= regression_worth_a_word && !std::isnan(usual_m))
      say(formatted(
          "the wave heights {} are drawn to the {:.1f} m that are usual here, by {:.0f} % "
          "of the way two days ahead: on {} past days high seas fell and low ones rose",
          whose[source], usual_m, 100 * of.regression * (1 - std::exp(-48 / regression_time_h)),
          of.days));
  }
  return text;
}

}  // namespace slackwater::calibration
