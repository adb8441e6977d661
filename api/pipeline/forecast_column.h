#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/pipeline/horizon.h"
#include "api/pipeline/site_data.h"
#include "calibration/propagate/spread.h"
#include "calibration/solve/calibration.h"
#include "fields/service/snapshot.h"

namespace slackwater::api {

/// What every column of one run shares.
struct ForecastPlan {
  UtcDay day{};  ///< D
  UtcTime issued{};
  WindPolicy wind = WindPolicy::best;
  std::vector<UtcTime> stamps;  ///< hourly from the end of D, both ends included
  std::vector<double> depth_m;  ///< the product's native wet levels
  std::string dataset;          ///< of the currents; empty where there are none
  calibration::Spread spread;   ///< one set of figures for all sites
  std::uint64_t seed = 1;       ///< of the members

  [[nodiscard]] UtcTime end_of_day() const noexcept { return UtcTime(day) + std::chrono::days(1); }
};

/// One column's forecast with the calibration it rests on.
struct ColumnForecast {
  ForecastColumn column;
  std::vector<calibration::Calibration> forms;  ///< empty where the column has no current on D
  std::vector<double> form_weight;              ///< probability of each
  std::size_t best_form = 0;
  std::string calibration_problem;     ///< why there is none
  std::vector<std::string> notes;      ///< what an operator should know
  std::vector<const Origin*> origins;  ///< whose values were used
  bool contains_stokes = false;

  /// Under the form of greatest probability; null where nothing was fitted.
  [[nodiscard]] const calibration::Calibration* calibration() const {
    return forms.empty() ? nullptr : &forms[best_form];
  }
};

/// Calibrates the column on day D and propagates it over the plan's stamps: tide (where the record
/// allows) + Ekman model + decaying residual, with wind and waves beside it. Pure; safe to run for
/// many columns at once.
[[nodiscard]] ColumnForecast forecast_column(const ColumnData& column, const Site& site,
                                             const ForecastPlan& plan);

}  // namespace slackwater::api
