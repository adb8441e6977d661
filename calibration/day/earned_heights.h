#pragma once
#include <array>
#include <cstddef>
#include <string>

#include "calibration/day/forecast_column.h"
#include "calibration/day/given/forecast_plan.h"
#include "calibration/day/given/height_source.h"
#include "fields/record/site_data.h"

/// What past days say of the wave heights of a forecast.
namespace slackwater::calibration {

/// The height that a column usually had in the 21 days until the end of D, the mean by
/// ln(Hs + 0.3 m) of what is known of them by then: measured, else analysed. NaN where less than
/// two days of hours are known.
[[nodiscard]] double usual_height_m(const ColumnData& column, const ForecastPlan& plan);

/// What the errors of past days say of the heights of one source, shrunk to nothing known.
struct EarnedHeight {
  double factor = 1;  ///< on the spread
  double bias = 0;    ///< of ln(Hs + 0.3 m), forecast minus truth
  /// How much of a forecast's distance from the usual height is error, at a long lead: high seas
  /// fall and low ones rise. Of ln(Hs + 0.3 m); 0: none, 1: the usual height is as good.
  double regression = 0;
  std::size_t days = 0;
  std::size_t hours = 0;

  /// What is taken out of ln(Hs + 0.3 m) of a forecast.
  /// @param usual_m  NaN: no regression
  [[nodiscard]] double off(double height_m, double usual_m, double lead_h) const noexcept;
};
struct EarnedHeights {
  std::array<EarnedHeight, height_sources> of_source;
};

/// The waves of up to 21 days before D at one column, forecast from what was known then and held
/// against what is known of them now: measured, else analysed, never a forecast, nor the analysis
/// that was itself the forecast. Bias and regression are least squares of
///
///   error = bias + regression (1 - exp(-lead / 30 h)) ln((Hs + 0.3 m) / (usual + 0.3 m))
///
/// by the spread beforehand. Each day counts as two pairs, for errors last half a day; eight pairs
/// without bias and with `spread_beforehand`, and a regression of 0 +- 0.5 (of a product 0 +- 0.1),
/// stand for nothing known.
///
/// Of a kept sea at alpha ventus, 2002 to 2014, every fifth day, the error of ln(Hs + 0.3 m) falls
/// from 0.37 to 0.33 at 24 h and from 0.43 to 0.35 at 48 h.
///
/// @param column  its waves are held against its own
[[nodiscard]] EarnedHeights earned_heights(const ColumnData& column, const Site& site,
                                           const ForecastPlan& plan, const ColumnParts& parts,
                                           int threads);

/// Takes out of the heights of a column what they are off, and scales their spread.
/// @param usual_m  of this column
void apply(const EarnedHeights& earned, const ForecastPlan& plan, double usual_m,
           ForecastColumn& column);

/// What a reader should know of what was taken out; empty where the bias is below 3 % and the
/// regression below a tenth.
[[nodiscard]] std::string note_on(const EarnedHeights& earned, double usual_m,
                                  const ForecastColumn& column);

}  // namespace slackwater::calibration
