#include "calibration/day/forecast_column.h"

#include <algorithm>
#include <cmath>

#include "calibration/day/column_calibration.h"
#include "calibration/day/known_currents.h"
#include "calibration/day/layer_of_days.h"
#include "calibration/propagate/propagate.h"
#include "fields/record/choose.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

/// Why a level of a column holds nothing, from the record itself.
SampleStatus level_status(const VectorColumn& column, std::size_t k) {
  SampleStatus worst = SampleStatus::missing;
  for (std::size_t t = 0; t < column.times(); ++t) {
    const SampleStatus status = column.status[column.offset(t, k)];
    if (has_value(status)) return SampleStatus::ok;
    worst = status;
  }
  return worst;
}

/// How wrong the wind after D may be, by where it comes from.
WindErrorGrowth wind_error_of(const VectorRecord& record, const HorizonWind& wind,
                              const ForecastPlan& plan) {
  const auto count = [&](DataStatus status) {
    return std::count(wind.source.begin(), wind.source.end(), status);
  };
  if (plan.wind == WindPolicy::persist ||
      2 * count(DataStatus::persisted) > static_cast<std::ptrdiff_t>(wind.source.size())) {
    // A run issued by then reaches beyond D: the climate is that of the record, which ends with D.
    const VectorColumn known = slice(choose(record, {plan.end_of_day(), plan.issued}, {}).column,
                                     UtcTime::min(), plan.end_of_day());
    std::vector<UtcTime> times;
    for (const TimeCell& cell : known.time) times.push_back(cell.centre());
    const std::size_t levels = known.levels();
    std::vector<Horizontal> values;
    for (std::size_t t = 0; t < times.size(); ++t) values.push_back(known.value[t * levels]);
    return persisted_wind_error(climate_sigma_m_s(times, values));
  }
  return count(DataStatus::forecast) > 0 ? forecast_wind_error() : analysed_wind_error();
}

}  // namespace

ColumnForecast forecast_column(const ColumnData& data, const Site& site, const ForecastPlan& plan) {
  ColumnForecast result;
  ForecastColumn& out = result.column;
  out.point = data.point;
  out.water_depth_m = data.water_depth.depth_m;
  out.water_depth_source = data.water_depth.source;
  const std::size_t levels = plan.depth_m.size();
  out.current_m_s.assign(plan.stamps.size() * levels, {});
  out.current_sigma_m_s.assign(plan.stamps.size() * levels, 0);
  out.current_status.assign(plan.stamps.size() * levels, SampleStatus::missing);

  const HorizonWind wind =
      horizon_wind(data.wind, plan.wind, plan.end_of_day(), plan.stamps, plan.best);
  out.wind_m_s = wind.wind_m_s;
  out.wind_source = wind.source;
  result.origins = wind.origins;
  HorizonSea sea =
      horizon_sea(data, site, plan.wind, plan.end_of_day(), plan.stamps, wind, plan.best);
  result.hindsight = wind.hindsight || sea.hindsight;
  out.sea = std::move(sea.sea);
  out.sea_source = std::move(sea.source);
  result.origins.insert(result.origins.end(), sea.origins.begin(), sea.origins.end());

  const Chosen<Horizontal> known = known_currents(data, plan);
  const VectorColumn day = slice(known.column, UtcTime(plan.day), plan.end_of_day());
  if (day.time.empty()) {
    result.calibration_problem = "no currents of " + format_day(plan.day) + " at this column";
    return result;
  }
  for (const Origin* origin : known.origin) {
    result.contains_stokes = result.contains_stokes || origin->contains_stokes;
  }
  result.origins.insert(result.origins.end(), known.origin.begin(), known.origin.end());
  ColumnCalibration fitted =
      calibrate_column(known.column, plan.day, data.point.latitude, data.water_depth.depth_m,
                       wind.series, layer_of_days(data, plan));
  const FittedTide& tide = fitted.tide;
  result.notes = tide.notes;
  if (fitted.forms.empty()) {
    result.calibration_problem = fitted.problem;
    return result;
  }
  const std::size_t fitted_best = fitted.best();
  const Propagated propagated =
      propagate(fitted.forms, plan.stamps, wind.series, plan.end_of_day(),
                wind_error_of(data.wind, wind, plan), plan.spread, plan.seed);
  const std::size_t members = propagated.mean_m_s.empty()
                                  ? 0
                                  : propagated.departure_m_s.size() / propagated.mean_m_s.size();
  out.member_m_s.assign(members * plan.stamps.size() * levels, {});
  // Levels of the plan are those of the dataset; a column whose product has fewer levels keeps them
  // in order.
  for (std::size_t k = 0; k < levels; ++k) {
    const SampleStatus status =
        k < day.levels() ? level_status(known.column, k) : SampleStatus::below_bed;
    for (std::size_t t = 0; t < plan.stamps.size(); ++t) {
      const std::size_t o = t * levels + k;
      out.current_status[o] = status;
      if (!has_value(status)) continue;
      const std::size_t own = t * day.levels() + k;
      out.current_m_s[o] = propagated.mean_m_s[own] + tide.at(k, TimeCell::instant(plan.stamps[t]));
      out.current_sigma_m_s[o] = propagated.sigma_m_s[own];
      for (std::size_t m = 0; m < members; ++m) {
        out.member_m_s[m * plan.stamps.size() * levels + o] =
            out.current_m_s[o] + propagated.departure_m_s[m * propagated.mean_m_s.size() + own];
      }
    }
  }
  if (propagated.wind_missing > 0) {
    result.notes.push_back("no wind at " + std::to_string(propagated.wind_missing) +
                           " of the forecast's times: the wind-driven part is left out there");
  }
  if (!out.wind_m_s.empty()) {
    for (std::size_t i = 0; i < propagated.wind_departure_m_s.size(); ++i) {
      out.wind_member_m_s.push_back(out.wind_m_s[i % plan.stamps.size()] +
                                    propagated.wind_departure_m_s[i]);
    }
  }
  result.form_weight = propagated.form_weight;
  result.forms = std::move(fitted.forms);
  result.best_form = fitted_best;
  return result;
}

}  // namespace slackwater::calibration
