#include "calibration/provider/provider_forecast.h"

#include <algorithm>
#include <cmath>

#include "calibration/provider/run_error.h"
#include "calibration/provider/series_at.h"
#include "fields/base/constants.h"
#include "fields/current/coriolis.h"

namespace slackwater::calibration {
namespace {

constexpr std::size_t most_runs = 4;
constexpr std::size_t most_values_of_a_run = 12;

std::vector<double> depths_of(const Chosen<Horizontal>& known) {
  return known.column.levels_m.empty() ? std::vector<double>{0.0} : known.column.levels_m;
}

bool lacks_tide(const Origin& origin) { return origin.rank.has_tide == false; }

/// The record's tide is the runs' own, unless they are said to lack what the record has.
TideBetween tide_between(const ProviderRuns& runs, const Chosen<Horizontal>& known,
                         const FittedTide& tide) {
  const bool record_lacks = !known.origin.empty() &&
                            std::all_of(known.origin.begin(), known.origin.end(),
                                        [](const Origin* origin) { return lacks_tide(*origin); });
  return {&tide, record_lacks || !lacks_tide(*runs.runs.front().origin)};
}

RunMoment moment_of(const TimeCell& cell, const ProviderRun& run, std::size_t index,
                    UtcTime end_of_day) {
  return {hours_between(end_of_day, cell.centre()), index,
          std::max(0.0, hours_between(*run.origin->reference_time, cell.centre()))};
}

/// What the runs have erred on the last days.
struct SeenError {
  std::vector<RunMoment> moments;
  std::vector<Horizontal> error;  ///< moments x levels; NaN where not known
};

/// Whether the record took its value at a cell from the run itself: it says nothing of its error.
bool is_of_run(const Chosen<Horizontal>& known, const ProviderRun& run, const TimeCell& cell) {
  const std::vector<TimeCell>& time = known.column.time;
  const auto after =
      std::lower_bound(time.begin(), time.end(), cell.centre(),
                       [](const TimeCell& one, UtcTime when) { return one.end < when; });
  if (after == time.end()) return false;
  const auto i = static_cast<std::size_t>(after - time.begin());
  const Origin* origin = i < known.origin.size() ? known.origin[i] : nullptr;
  return origin != nullptr && origin->status == DataStatus::forecast &&
         origin->dataset == run.origin->dataset &&
         origin->reference_time == run.origin->reference_time;
}

void add_error_of(const ProviderRun& run, std::size_t index, const Chosen<Horizontal>& known,
                  const TideBetween& between, UtcTime end_of_day, SeenError& seen) {
  const std::vector<double> depths = depths_of(known);
  std::vector<TimeCell> cells;
  for (const TimeCell& cell : run.column.time) {
    if (cell.end <= end_of_day && cell.centre() > end_of_day - runs_looked_back &&
        !is_of_run(known, run, cell))
      cells.push_back(cell);
  }
  // The newest of them counts always.
  const std::size_t stride = (cells.size() + most_values_of_a_run - 1) / most_values_of_a_run;
  std::vector<TimeCell> some;
  for (std::size_t back = 0; back < cells.size(); back += stride)
    some.push_back(cells[cells.size() - 1 - back]);
  const BaselineForecast water = series_at(known.column, {between.tide, true}, some, depths);
  const BaselineForecast said = series_at(run.column, between, some, depths);
  using constants::nan;
  for (std::size_t t = 0; t < some.size(); ++t) {
    seen.moments.push_back(moment_of(some[t], run, index, end_of_day));
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const std::size_t o = t * depths.size() + k;
      seen.error.push_back(water.has(o) && said.has(o) ? water.value[o] - said.value[o]
                                                       : Horizontal(nan, nan));
    }
  }
}

/// Of which run an asked cell is: the newest that reaches it; else the one that reaches furthest.
std::size_t run_at(const ProviderRuns& runs, const TimeCell& cell) {
  std::size_t furthest = 0;
  for (std::size_t r = 0; r < runs.runs.size(); ++r) {
    const VectorColumn& column = runs.runs[r].column;
    if (column.time.front().start <= cell.centre() && cell.centre() <= column.time.back().end)
      return r;
    if (column.time.back().end > runs.runs[furthest].column.time.back().end) furthest = r;
  }
  return furthest;
}

}  // namespace

BaselineForecast provider_as_it_is(const ProviderRuns& runs, const Chosen<Horizontal>& known,
                                   const FittedTide& tide, std::span<const TimeCell> cells) {
  return series_at(runs.series, tide_between(runs, known, tide), cells, depths_of(known));
}

ProviderForecast provider_forecast(const ProviderRuns& runs, const Chosen<Horizontal>& known,
                                   const FittedTide& tide, Angle latitude,
                                   std::span<const TimeCell> cells, UtcTime end_of_day) {
  ProviderForecast made;
  made.as_it_is = provider_as_it_is(runs, known, tide, cells);
  const TideBetween between = tide_between(runs, known, tide);
  SeenError seen;
  for (std::size_t r = 0; r < std::min(runs.runs.size(), most_runs); ++r)
    add_error_of(runs.runs[r], r, known, between, end_of_day, seen);
  const std::vector<double> depths = depths_of(known);
  const auto levels = static_cast<Eigen::Index>(depths.size());
  const auto rows = static_cast<Eigen::Index>(seen.moments.size());
  const Eigen::MatrixXcd error =
      Eigen::Map<const Eigen::MatrixXcd>(seen.error.data(), levels, rows).transpose();
  const RunError errors(depths, std::move(seen.moments), error,
                        3600.0 * coriolis_parameter_rad_s(latitude));
  std::vector<RunMoment> asked;
  for (const TimeCell& cell : cells) {
    const std::size_t r = run_at(runs, cell);
    asked.push_back(moment_of(cell, runs.runs[r], r, end_of_day));
  }
  const RunError::Expected expected = errors.at(asked);
  made.corrected = made.as_it_is;
  made.corrected_sigma_m_s.resize(made.corrected.value.size());
  for (std::size_t t = 0; t < cells.size(); ++t) {
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const std::size_t o = t * depths.size() + k;
      const auto i = static_cast<Eigen::Index>(t);
      const auto j = static_cast<Eigen::Index>(k);
      made.corrected.value[o] += expected.error_m_s(i, j);
      made.corrected_sigma_m_s[o] = std::sqrt(expected.variance_m2_s2(i, j));
    }
  }
  return made;
}

}  // namespace slackwater::calibration
