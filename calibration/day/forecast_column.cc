#include "calibration/day/forecast_column.h"

#include <algorithm>
#include <cmath>

#include "calibration/day/column/methods.h"
#include "calibration/day/given/driving_ensemble.h"
#include "calibration/day/given/height_source.h"
#include "calibration/day/given/horizon_wind_error.h"
#include "calibration/day/sources.h"
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

/// The current at the plan's stamps and levels: the propagated day and its tide.
void set_current(ForecastColumn& out, const Propagated& propagated, const FittedTide& tide,
                 const VectorColumn& known, std::size_t known_levels, const ForecastPlan& plan) {
  const std::size_t levels = plan.depth_m.size();
  const std::size_t members = propagated.mean_m_s.empty()
                                  ? 0
                                  : propagated.departure_m_s.size() / propagated.mean_m_s.size();
  out.member_m_s.assign(members * plan.stamps.size() * levels, {});
  // Levels of the plan are those of the dataset; a column whose product has fewer levels keeps them
  // in order.
  for (std::size_t k = 0; k < levels; ++k) {
    const SampleStatus status = k < known_levels ? level_status(known, k) : SampleStatus::below_bed;
    for (std::size_t t = 0; t < plan.stamps.size(); ++t) {
      const std::size_t o = t * levels + k;
      out.current_status[o] = status;
      if (!has_value(status)) continue;
      const std::size_t own = t * known_levels + k;
      out.current_m_s[o] = propagated.mean_m_s[own] + tide.at(k, TimeCell::instant(plan.stamps[t]));
      out.current_sigma_m_s[o] = propagated.sigma_m_s[own];
      for (std::size_t m = 0; m < members; ++m) {
        out.member_m_s[m * plan.stamps.size() * levels + o] =
            out.current_m_s[o] + propagated.departure_m_s[m * propagated.mean_m_s.size() + own];
      }
    }
  }
  if (out.wind_m_s.empty()) return;
  out.wind_member_number = propagated.wind_member_number;
  for (std::size_t i = 0; i < propagated.wind_departure_m_s.size(); ++i) {
    out.wind_member_m_s.push_back(out.wind_m_s[i % plan.stamps.size()] +
                                  propagated.wind_departure_m_s[i]);
  }
}

/// Notes whose wind the members have.
void name_ensemble(const HorizonWind& wind, const WindDepartures& ensemble,
                   const ForecastPlan& plan, ColumnForecast& result) {
  const WindEnsembleRun& run = result.wind_ensemble.emplace(wind.member_run);
  result.notes.push_back(note_on(run, ensemble, result.column.wind_member_number.size(), plan));
  result.origins.insert(result.origins.end(), run.origins.begin(), run.origins.end());
  result.hindsight = result.hindsight || looks_ahead(run, plan);
}

/// The current of the column from its record, or `calibration_problem`.
void forecast_current(const ColumnData& data, const ForecastPlan& plan, const ColumnParts& parts,
                      const HorizonWind& wind, const LayerOfDays& layer, ColumnForecast& result) {
  const auto attempt_this = [&](Part part, const std::function<void()>& work) {
    const bool is_done = attempt_part(part, result.failures, work);
    if (!is_done && loses_the_current(part)) {
      const std::string where = part == Part::calibration ? "" : std::string(name_of(part)) + ": ";
      result.calibration_problem = where + result.failures.back().failure.why;
    }
    return is_done;
  };
  const bool is_known = attempt_this(Part::record, [&] {
    KnownCurrents currents = parts.record(data, plan);
    result.known.currents = std::move(currents.record);
    result.remarks = std::move(currents.remarks);
  });
  if (!is_known) return;
  const Chosen<Horizontal>& known = result.known.currents;
  const VectorColumn day = slice(known.column, UtcTime(plan.day), plan.end_of_day());
  if (day.time.empty()) {
    result.calibration_problem = "no currents of " + format_day(plan.day) + " at this column";
    return;
  }
  result.fitted_to_a_forecast = is_of_a_forecast(known, day);
  for (const Origin* origin : known.origin) {
    result.contains_stokes = result.contains_stokes || origin->contains_stokes;
  }
  result.origins.insert(result.origins.end(), known.origin.begin(), known.origin.end());
  FittedTide& tide = result.known.tide;
  attempt_this(Part::tide, [&] { tide = parts.tide(known, plan.day, data.point.latitude); });
  result.notes = tide.notes;
  ColumnCalibration fitted;
  const bool is_fitted = attempt_this(Part::calibration, [&] {
    fitted = parts.calibration(known.column, tide, plan.day, data.point.latitude,
                               data.water_depth.depth_m, wind.series, layer, known.noise_m_s);
  });
  if (!is_fitted) return;
  if (fitted.forms.empty()) {
    result.calibration_problem = fitted.problem;
    return;
  }
  if (!fitted.problem.empty())
    result.notes.push_back("a form of the model could not be fitted: " + fitted.problem);
  attempt_this(Part::propagation, [&] {
    const WindDepartures ensemble = departures_of(wind, plan.stamps);
    const Propagated propagated = parts.propagation(
        fitted.forms, plan.stamps, wind.series, plan.end_of_day(),
        horizon_wind_error(data.wind, wind, plan), plan.spread, plan.seed, ensemble);
    ForecastColumn carried = result.column;
    set_current(carried, propagated, tide, known.column, day.levels(), plan);
    result.best_form = fitted.best();
    if (propagated.wind_missing > 0) {
      result.notes.push_back("no wind at " + std::to_string(propagated.wind_missing) +
                             " times of the forecast: the wind-driven current is left out there");
    }
    result.form_weight = propagated.form_weight;
    result.forms = std::move(fitted.forms);
    result.column = std::move(carried);
    if (!propagated.wind_member_number.empty()) name_ensemble(wind, ensemble, plan, result);
  });
}

}  // namespace

ColumnForecast empty_forecast(const ColumnData& data, const ForecastPlan& plan) {
  ColumnForecast result;
  ForecastColumn& out = result.column;
  out.point = data.point;
  out.water_depth_m = data.water_depth.depth_m;
  out.water_depth_source = data.water_depth.source;
  const std::size_t values = plan.stamps.size() * plan.depth_m.size();
  out.current_m_s.assign(values, {});
  out.current_sigma_m_s.assign(values, 0);
  out.current_status.assign(values, SampleStatus::missing);
  return result;
}

ColumnForecast forecast_column(const ColumnData& data, const Site& site, const ForecastPlan& plan,
                               const ColumnParts& parts) {
  ColumnForecast result = empty_forecast(data, plan);
  HorizonWind wind;
  attempt_part(Part::wind, result.failures, [&] {
    wind = parts.wind(data.wind, plan.wind, plan.end_of_day(), plan.stamps, plan.best);
  });
  HorizonSea waves;
  attempt_part(Part::waves, result.failures, [&] {
    waves = parts.waves(data, site, plan.wind, plan.end_of_day(), plan.stamps, wind, plan.best);
  });
  result.column.wind_m_s = wind.wind_m_s;
  result.column.wind_source = wind.source;
  result.column.sea = waves.sea;
  result.column.sea_source = waves.source;
  result.column.height_spread = spread_beforehand(waves, wind, data, site, plan);
  result.hindsight = wind.hindsight || waves.hindsight;
  result.simulated_wind = wind.simulated;
  result.waves_of_wind_alone = !result.column.sea.empty() && waves.origins.empty();
  result.origins = wind.origins;
  result.origins.insert(result.origins.end(), waves.origins.begin(), waves.origins.end());
  result.wind_gaps = wind.gaps;
  attempt_part(Part::blend, result.failures,
               [&] { result.known.provider = known_provider(data, plan); });
  LayerRecord layer;
  LayerOfDays layer_depths;
  attempt_part(Part::mixed_layer, result.failures, [&] {
    layer = layer_record(data, plan);
    layer_depths = parts.mixed_layer(layer, plan.day);
  });
  forecast_current(data, plan, parts, wind, layer_depths, result);
  attempt_part(Part::sea_level, result.failures, [&] {
    LevelForecast level = parts.sea_level(data.sea_level, plan);
    result.column.sea_level = std::move(level.level);
    result.origins.insert(result.origins.end(), level.origins.begin(), level.origins.end());
    result.notes.insert(result.notes.end(), level.notes.begin(), level.notes.end());
  });
  result.sources =
      sources_of(result.known.currents, wind, waves, result.known.provider, layer, plan);
  return result;
}

}  // namespace slackwater::calibration
