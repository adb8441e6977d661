#include "calibration/day/given/horizon_wind_error.h"

#include <algorithm>

#include "fields/record/choose.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

/// How wrong the wind after D may be, by where it comes from.
WindErrorGrowth wind_error_of(const VectorRecord& record, const HorizonWind& wind,
                              const ForecastPlan& plan) {
  const auto count = [&](DataStatus status) {
    return std::count(wind.source.begin(), wind.source.end(), status);
  };
  if (plan.wind == WindPolicy::persist ||
      2 * count(DataStatus::persisted) > static_cast<std::ptrdiff_t>(wind.source.size())) {
    // A run issued by then reaches beyond D: the climate is that of the record, which ends with D.
    const VectorColumn known =
        slice(choose(record, plan.knowledge(), {}).column, UtcTime::min(), plan.end_of_day());
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

WindErrorGrowth horizon_wind_error(const VectorRecord& record, const HorizonWind& wind,
                                   const ForecastPlan& plan) {
  WindErrorGrowth growth = wind_error_of(record, wind, plan);
  const bool any = std::any_of(wind.extra_sigma_m_s.begin(), wind.extra_sigma_m_s.end(),
                               [](double sigma) { return sigma > 0; });
  if (!any) return growth;
  growth.extra_at = plan.stamps;
  growth.extra_sigma_m_s = wind.extra_sigma_m_s;
  return growth;
}

}  // namespace slackwater::calibration
