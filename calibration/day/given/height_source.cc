#include "calibration/day/given/height_source.h"

#include <algorithm>
#include <cmath>

#include "calibration/day/given/horizon_wind_error.h"
#include "fields/base/constants.h"
#include "fields/wave/growth.h"
#include "fields/wave/height_error.h"

namespace slackwater::calibration {
namespace {

/// Half and twice an assumed fetch are what eight of ten hold.
double fetch_spread(double wind_m_s, const Fetch& fetch, double from_deg, double depth_m) {
  const double fetch_m = fetch.at_m(from_deg);
  const auto logarithm = [&](double times) {
    return std::log(fetch_limited_sea(wind_m_s, times * fetch_m, depth_m).significant_height_m +
                    height_error::shift_m);
  };
  return (logarithm(2) - logarithm(0.5)) / (2 * constants::normal_p90);
}

}  // namespace

HeightSource height_source_of(DataStatus source) noexcept {
  if (source == DataStatus::persisted) return HeightSource::kept;
  return source == DataStatus::modelled ? HeightSource::computed : HeightSource::product;
}

std::vector<double> spread_beforehand(const HorizonSea& sea, const HorizonWind& wind,
                                      const ColumnData& column, const Site& site,
                                      const ForecastPlan& plan) {
  const std::vector<UtcTime>& stamps = plan.stamps;
  std::vector<double> wind_sigma_m_s;
  if (!wind.wind_m_s.empty())
    wind_sigma_m_s =
        departure_sigma_m_s(stamps, plan.end_of_day(), horizon_wind_error(column.wind, wind, plan));
  const double depth_m = std::max(1.0, column.water_depth.depth_m);
  std::vector<double> spread;
  const bool without_swell = sea.origins.empty();
  UtcTime known = sea.carried_from.value_or(stamps.front());
  for (std::size_t t = 0; t < sea.sea.size(); ++t) {
    const double height_m = sea.sea[t].significant_height_m;
    if (std::isnan(height_m)) {
      spread.push_back(constants::nan);
      continue;
    }
    const double of_product =
        height_error::of_product(height_m, hours_between(stamps.front(), stamps[t]));
    switch (height_source_of(sea.source[t])) {
      case HeightSource::product:
        known = stamps[t];
        spread.push_back(of_product);
        break;
      case HeightSource::computed: {
        double computed = height_error::of_computed(wind_sigma_m_s[t], without_swell);
        if (!site.fetch)
          computed =
              std::hypot(computed, fetch_spread(std::abs(wind.wind_m_s[t]), assumed_fetch(),
                                                from_direction_deg(wind.wind_m_s[t]), depth_m));
        spread.push_back(std::max(of_product, computed));
        break;
      }
      case HeightSource::kept:
        spread.push_back(height_error::of_kept(hours_between(known, stamps[t])));
        break;
    }
  }
  return spread;
}

}  // namespace slackwater::calibration
