#pragma once
#include <vector>

#include "calibration/day/given/forecast_plan.h"
#include "calibration/day/given/horizon.h"
#include "fields/record/site_data.h"

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

}  // namespace slackwater::calibration
