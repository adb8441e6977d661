#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "calibration/day/column/column_calibration.h"
#include "calibration/day/column/layer_of_days.h"
#include "calibration/day/column/tide_of_record.h"
#include "calibration/day/given/forecast_plan.h"
#include "calibration/day/given/horizon.h"
#include "calibration/day/given/known_currents.h"
#include "calibration/day/given/sea_level.h"
#include "calibration/day/part_failure.h"
#include "calibration/propagate/propagate.h"
#include "calibration/provider/provider_runs.h"
#include "calibration/solve/calibration.h"
#include "fields/record/site_data.h"
#include "fields/record/source_use.h"
#include "fields/service/snapshot.h"

namespace slackwater::calibration {

/// What is known of a column up to the end of D, judged once: what its forecast and the candidates
/// beside it start from.
struct KnownColumn {
  Chosen<Horizontal> currents;
  FittedTide tide;        ///< of them
  ProviderRuns provider;  ///< the provider's own forecast
};

/// One column's forecast with the calibration it rests on.
struct ColumnForecast {
  ForecastColumn column;
  std::vector<Calibration> forms;   ///< empty where the column has no current on D
  std::vector<double> form_weight;  ///< probability of each
  std::size_t best_form = 0;
  std::string calibration_problem;     ///< why there is none
  KnownColumn known;                   ///< for the steps that follow; a whole forecast keeps none
  std::vector<std::string> notes;      ///< what an operator should know
  RecordRemarks remarks;               ///< on the record of the currents
  std::vector<const Origin*> origins;  ///< whose values were used
  /// The weather ensemble whose winds the members have (`ForecastColumn::wind_member_number`).
  std::optional<WindEnsembleRun> wind_ensemble;
  bool contains_stokes = false;
  bool fitted_to_a_forecast = false;  ///< the currents of D are of a provider's run, not analysed
  bool hindsight = false;       ///< wind or waves were used that were not known when it was issued
  bool simulated_wind = false;  ///< HorizonWind::simulated
  std::vector<SourceUse> sources;     ///< who speaks for what, when and why, from D on
  std::vector<WindGap> wind_gaps;     ///< HorizonWind::gaps
  std::vector<PartFailure> failures;  ///< parts that it had to do without
  /// No wave product speaks for any hour, nor shortly before: the waves are of the wind alone.
  bool waves_of_wind_alone = false;

  /// Under the form of greatest probability; null where nothing was fitted.
  [[nodiscard]] const Calibration* calibration() const {
    return forms.empty() ? nullptr : &forms[best_form];
  }
};

/// The work on a column by its parts. Those that stand here do the work; tests put others in their
/// place to see one fail.
struct ColumnParts {
  std::function<decltype(horizon_wind)> wind = horizon_wind;
  std::function<decltype(horizon_sea)> waves = horizon_sea;
  std::function<decltype(forecast_level)> sea_level = forecast_level;
  std::function<decltype(known_currents)> record = known_currents;
  std::function<decltype(layer_of_days)> mixed_layer = layer_of_days;
  std::function<decltype(tide_of_record)> tide = tide_of_record;
  std::function<decltype(calibrate_column)> calibration = calibrate_column;
  std::function<decltype(propagate)> propagation = propagate;
};

/// The column where nothing could be made: its place and depth, and no value that is not missing.
[[nodiscard]] ColumnForecast empty_forecast(const ColumnData& column, const ForecastPlan& plan);

/// Calibrates the column on day D and propagates it over the plan's stamps: tide (where the record
/// allows) + Ekman model + memory of D (calibration/propagate), with wind and waves beside it.
/// A part that fails is left out and named in `failures`; all else is what it would be without that
/// part. Pure; safe to run for many columns at once.
[[nodiscard]] ColumnForecast forecast_column(const ColumnData& column, const Site& site,
                                             const ForecastPlan& plan,
                                             const ColumnParts& parts = {});

}  // namespace slackwater::calibration
