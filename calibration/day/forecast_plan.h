#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "calibration/propagate/spread.h"
#include "fields/base/time.h"
#include "fields/service/wind_policy.h"

namespace slackwater::calibration {

/// What `WindPolicy::best` may look at of wind and waves.
struct BestInputs {
  /// Values valid by then, runs issued by then, and files received by then are known.
  UtcTime known_by = UtcTime::max();
  /// What came later is looked at too, and what is made with it is marked.
  bool hindsight = false;
};

/// What every column of one run shares.
struct ForecastPlan {
  UtcDay day{};  ///< D
  UtcTime issued{};
  WindPolicy wind = WindPolicy::best;
  BestInputs best;              ///< under that policy
  std::vector<UtcTime> stamps;  ///< hourly from the end of D, both ends included
  std::vector<double> depth_m;  ///< the product's native wet levels
  std::string dataset;          ///< of the currents; empty where there are none
  Spread spread;                ///< one set of figures for all sites
  std::uint64_t seed = 1;       ///< of the members

  [[nodiscard]] UtcTime end_of_day() const noexcept { return UtcTime(day) + std::chrono::days(1); }
};

}  // namespace slackwater::calibration
