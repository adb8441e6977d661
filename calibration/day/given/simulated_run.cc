#include "calibration/day/given/simulated_run.h"

#include <algorithm>
#include <string>

#include "calibration/propagate/wind_error.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

constexpr Duration run_every = hours(6);
constexpr Duration published_after = hours(7) + minutes(34);

/// Hours from the newest run's reference time to the end of D; 0 where it is later.
double age_of_newest_run(UtcTime end_of_day, UtcTime issued) {
  const Duration since_epoch = (issued - published_after).time_since_epoch();
  const UtcTime reference{since_epoch - since_epoch % run_every};
  return std::max(0.0, hours_between(reference, end_of_day));
}

}  // namespace

bool reaches_beyond(const HorizonWind& wind, std::span<const UtcTime> stamps, UtcTime end_of_day) {
  std::ptrdiff_t asked = 0;
  std::ptrdiff_t known = 0;
  for (std::size_t t = 0; t < std::min(stamps.size(), wind.source.size()); ++t) {
    if (stamps[t] <= end_of_day || stamps[t] > end_of_day + hours(24)) continue;
    ++asked;
    known += wind.source[t] == DataStatus::persisted ? 0 : 1;
  }
  return 2 * known > asked;
}

Chosen<Horizontal> with_simulated_run(Chosen<Horizontal> analysed, UtcTime end_of_day,
                                      const BestInputs& best) {
  VectorColumn& column = analysed.column;
  std::vector<UtcTime> times;
  std::vector<std::size_t> place;
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (column.time[t].centre() <= end_of_day) continue;
    times.push_back(column.time[t].centre());
    place.push_back(t);
  }
  Rng random(best.simulated_seed.value_or(1),
             "calibration/simulated_run/" + format_day(day_of(end_of_day - hours(1))));
  const std::vector<Horizontal> error = draw_wind_departures(
      times, end_of_day,
      forecast_wind_error(age_of_newest_run(end_of_day, best.issued.value_or(end_of_day))), random);
  for (std::size_t i = 0; i < place.size(); ++i) {
    for (std::size_t k = 0; k < column.levels(); ++k)
      column.value[column.offset(place[i], k)] += error[i];
    column.source[place[i]] = DataStatus::forecast;
  }
  return analysed;
}

}  // namespace slackwater::calibration
