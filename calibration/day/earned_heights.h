#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "calibration/day/forecast_column.h"
#include "calibration/day/forecast_plan.h"
#include "calibration/day/horizon.h"
#include "fields/record/site_data.h"

/// How far the wave heights of a forecast may be off, and what past days say of it.
namespace slackwater::calibration {

/// How a height was had: errors of the three have nothing in common.
enum class HeightSource {
  product,   ///< a provider's, or measured
  computed,  ///< from the wind
  kept,      ///< as last known
};
inline constexpr std::size_t height_sources = 3;
[[nodiscard]] HeightSource height_source_of(DataStatus source) noexcept;

/// The spread of ln(Hs + 0.3 m) (fields/wave/height_error.h) per stamp, by source and lead, before
/// anything is known of the site. Waves that are computed are no surer than a provider's of their
/// lead; where their fetch is assumed, half and twice of it are what eight of ten hold.
[[nodiscard]] std::vector<double> spread_beforehand(const HorizonSea& sea, const HorizonWind& wind,
                                                    const ColumnData& column, const Site& site,
                                                    const ForecastPlan& plan);

/// What the errors of past days say of the heights of one source, shrunk to nothing known.
struct EarnedHeight {
  double factor = 1;  ///< on the spread
  double bias = 0;    ///< of ln(Hs + 0.3 m), forecast minus truth
  std::size_t days = 0;
  std::size_t hours = 0;
};
struct EarnedHeights {
  std::array<EarnedHeight, height_sources> of_source;
};

/// The waves of up to 21 days before D at one column, forecast from what was known then and held
/// against what is known of them now: measured, else analysed, never a forecast, nor the analysis
/// that was itself the forecast. Each day counts as two pairs, for errors last half a day; eight
/// pairs without bias and with `spread_beforehand` stand for nothing known.
///
/// @param column  its waves are held against its own
[[nodiscard]] EarnedHeights earned_heights(const ColumnData& column, const Site& site,
                                           const ForecastPlan& plan, const ColumnParts& parts,
                                           int threads);

/// Takes the bias out of the heights of a column, and scales their spread.
void apply(const EarnedHeights& earned, ForecastColumn& column);

/// What a reader should know of a bias that was taken out; empty where it is below 3 %.
[[nodiscard]] std::string note_on(const EarnedHeights& earned, const ForecastColumn& column);

}  // namespace slackwater::calibration
