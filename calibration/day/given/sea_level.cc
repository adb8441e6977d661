#include "calibration/day/given/sea_level.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "calibration/day/given/horizon_input.h"
#include "calibration/tide/level_tide.h"
#include "calibration/tide/surge.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/averaging.h"
#include "fields/base/text.h"
#include "fields/interpolate/temporal.h"
#include "fields/record/product_run.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

constexpr double provider_sigma_m = 0.10;
constexpr std::size_t fewest_runs = 5;
/// Between values of the provider further apart than this nothing is said: the tide turns between.
constexpr Duration widest_step = hours(1);
constexpr Duration widest_tidal_step = hours(3);

/// The pieces that hold the level of an hour, and why others are left out.
ScalarRecord pieces_with_tide(const ScalarRecord& record, std::vector<std::string>& notes) {
  ScalarRecord kept;
  kept.on_land = record.on_land;
  std::set<std::string> told;
  for (const PieceColumn<double>& piece : record.pieces) {
    const Duration averaging = averaging_of(piece.column.time);
    std::string why;
    if (hides_the_tide(averaging)) why = "are " + averaging_text(averaging) + ", without the tide";
    if (piece.origin->rank.has_tide == false) why = "lack the tide";
    if (why.empty()) {
      kept.pieces.push_back(piece);
    } else {
      told.insert("the sea level of " + piece.origin->product_id + " is not used: its values " +
                  why);
    }
  }
  notes.insert(notes.end(), told.begin(), told.end());
  return kept;
}

/// What past runs of the provider's forecast have erred by, by day of lead.
double provider_error_m(const ScalarRecord& record, const ScalarColumn& known,
                        const ForecastPlan& plan) {
  std::map<UtcTime, double> analysed;
  for (std::size_t t = 0; t < known.times(); ++t) {
    if (known.has(t)) analysed[known.time[t].centre()] = known.value[t];
  }
  double sum_m2 = 0;
  std::size_t count = 0;
  std::size_t judged = 0;
  for (const ProductRun<double>& run :
       runs_of(record, plan.knowledge_of_runs(), {.only_forecasts = true, .only_grids = true})) {
    const std::size_t before = count;
    for (const RunValue<double>& value : run.values) {
      const auto truth = analysed.find(value.cell.centre());
      const ScalarColumn& column = value.piece->column;
      if (truth == analysed.end() || !column.has(value.t)) continue;
      const double error_m = column.value[column.offset(value.t, 0)] - truth->second;
      sum_m2 += error_m * error_m;
      ++count;
    }
    judged += count > before ? 1 : 0;
  }
  if (judged < fewest_runs) return provider_sigma_m;
  return std::max(least_level_sigma_m, std::sqrt(sum_m2 / static_cast<double>(count)));
}

/// A series of hours at an instant: a value of its own, or smooth between neighbours that are no
/// further apart than an hour.
std::optional<double> smooth_at(const ScalarColumn& series, UtcTime time) {
  std::vector<UtcTime> centres;
  for (const TimeCell& cell : series.time) centres.push_back(cell.centre());
  const auto place = place_in(centres, time);
  if (!place || !series.has(place->low)) return std::nullopt;
  if (!(place->upper > 0)) return series.value[place->low];
  // As many even neighbours as there are on both sides, six at most.
  std::size_t first = place->low;
  std::size_t last = place->low + 1;
  const Duration step = centres[last] - centres[first];
  if (!series.has(last) || step > widest_step) return std::nullopt;
  const auto is_even = [&](std::size_t a) {
    return series.has(a) && series.has(a + 1) && centres[a + 1] - centres[a] == step;
  };
  while (first > 0 && last - first < 5 && is_even(first - 1)) {
    --first;
    if (last + 1 < centres.size() && is_even(last)) ++last;
  }
  return smooth_between(std::span(series.value).subspan(first, last - first + 1),
                        {place->low - first, place->upper});
}

/// Whether a tide would show in the values: a sea without one has a level too.
bool shows_a_tide(const ScalarColumn& known) {
  const auto values = std::count_if(known.status.begin(), known.status.end(),
                                    [](SampleStatus status) { return has_value(status); });
  return values > 1 && known.time.back().centre() - known.time.front().centre() <=
                           widest_tidal_step * (values - 1);
}

void add_origins(const Chosen<double>& chosen, LevelForecast& result) {
  result.origins.insert(result.origins.end(), chosen.origin.begin(), chosen.origin.end());
}

std::string note_on(const LevelHindcast& hindcast, Duration length) {
  const double record_d = hours_of(length) / 24;
  std::string text = formatted("sea level: harmonic tide of {:.1f} days", record_d);
  const double memory_h = hours_of(hindcast.surge.memory);
  text += memory_h > 0 ? formatted(", the difference from the tide decays over {:.0f} h", memory_h)
                       : std::string(", the difference from the tide is not carried on");
  if (hindcast.days == 0)
    return text + "; too few past days to check it: its spread is an estimate";
  return text +
         formatted(
             "; error on {} past days: {:.2f} m up to 12 h ahead, {:.2f} m at the longest lead",
             hindcast.days, hindcast.errors.sigma_m.front(), hindcast.errors.sigma_m.back());
}

/// The provider's own forecast, as long as it lasts.
/// @return at how many stamps
std::size_t add_provider(const ScalarRecord& usable, const ScalarColumn& known,
                         const ForecastPlan& plan, SeaLevel& level, LevelForecast& result) {
  const Chosen<double> provider =
      choose(usable, plan.knowledge_of_runs(),
             {.only_forecasts = true, .only_grids = true, .ramp = join_ramp});
  if (provider.empty()) return 0;
  const double sigma_m = provider_error_m(usable, known, plan);
  std::size_t next = 0;
  for (; next < plan.stamps.size(); ++next) {
    const auto value = smooth_at(provider.column, plan.stamps[next]);
    if (!value) break;
    level.level_m[next] = *value;
    level.sigma_m[next] = sigma_m;
    level.source[next] = DataStatus::forecast;
  }
  if (next > 0) add_origins(provider, result);
  return next;
}

/// Tide and surge from the stamp `next` on.
void add_tide(const ScalarColumn& known, Duration length, const ForecastPlan& plan,
              std::size_t next, SeaLevel& level, LevelForecast& result) {
  const TideFit fit = fit_level_tide(known.time, known.value, known.status);
  const LevelHindcast hindcast = hindcast_level(known, plan.stamps.back() - plan.end_of_day());
  UtcTime from = known.time.back().centre();
  double departure_m = departure_at_end(known, fit, hindcast.surge.window);
  double least_m = 0;
  if (next > 0) {  // the provider knows more of the surge than the record
    from = plan.stamps[next - 1];
    departure_m = level.level_m[next - 1] - level_over(fit, TimeCell::instant(from));
    least_m = level.sigma_m[next - 1];
  }
  for (; next < plan.stamps.size(); ++next) {
    const UtcTime stamp = plan.stamps[next];
    level.level_m[next] = level_over(fit, TimeCell::instant(stamp)) +
                          departure_m * share_left(hindcast.surge, stamp - from);
    level.sigma_m[next] = std::max(least_m, hindcast.errors.at(stamp - from));
  }
  result.notes.push_back(note_on(hindcast, length));
}

}  // namespace

LevelForecast forecast_level(const ScalarRecord& record, const ForecastPlan& plan) {
  LevelForecast result;
  if (record.pieces.empty()) return result;
  const ScalarRecord usable = pieces_with_tide(record, result.notes);
  Chosen<double> past = choose(usable, plan.knowledge(), {.only_grids = true});
  if (past.empty()) past = choose(usable, plan.knowledge(), {.only_series = true});
  const ScalarColumn known = slice(past.column, UtcTime::min(), plan.end_of_day());
  const Duration length =
      known.time.empty() ? Duration(0) : record_length(known.time, known.status);

  const std::size_t size = plan.stamps.size();
  SeaLevel level{std::vector<double>(size, constants::nan), std::vector<double>(size, 0),
                 std::vector<DataStatus>(size, DataStatus::modelled)};
  const std::size_t next = add_provider(usable, known, plan, level, result);
  const bool has_tide = length >= shortest_tide_record && shows_a_tide(known);
  if (next < size && has_tide) {
    add_tide(known, length, plan, next, level, result);
    add_origins(past, result);
  } else if (next < size && !usable.pieces.empty()) {
    // Mean water over a tidal sea would be a number that is wrong at most hours.
    result.notes.push_back(
        formatted("no sea level is forecast{}: its record of {:.1f} days shows no tide; "
                  "expected three days with a value at least every three hours",
                  next > 0 ? " beyond the provider's" : "", hours_of(length) / 24));
  }
  if (next > 0 || has_tide) result.level = std::move(level);
  return result;
}

}  // namespace slackwater::calibration
