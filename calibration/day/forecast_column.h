#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "calibration/day/forecast_plan.h"
#include "calibration/day/horizon.h"
#include "calibration/solve/calibration.h"
#include "fields/record/site_data.h"
#include "fields/service/snapshot.h"

namespace slackwater::calibration {

/// One column's forecast with the calibration it rests on.
struct ColumnForecast {
  ForecastColumn column;
  std::vector<Calibration> forms;   ///< empty where the column has no current on D
  std::vector<double> form_weight;  ///< probability of each
  std::size_t best_form = 0;
  std::string calibration_problem;     ///< why there is none
  std::vector<std::string> notes;      ///< what an operator should know
  std::vector<const Origin*> origins;  ///< whose values were used
  bool contains_stokes = false;
  bool hindsight = false;  ///< wind or waves were used that were not known when it was issued

  /// Under the form of greatest probability; null where nothing was fitted.
  [[nodiscard]] const Calibration* calibration() const {
    return forms.empty() ? nullptr : &forms[best_form];
  }
};

/// Calibrates the column on day D and propagates it over the plan's stamps: tide (where the record
/// allows) + Ekman model + memory of D (calibration/propagate), with wind and waves beside it.
/// Pure; safe to run for many columns at once.
[[nodiscard]] ColumnForecast forecast_column(const ColumnData& column, const Site& site,
                                             const ForecastPlan& plan);

}  // namespace slackwater::calibration
