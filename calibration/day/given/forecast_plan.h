#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibration/propagate/spread.h"
#include "fields/base/time.h"
#include "fields/record/choose.h"
#include "fields/service/wind_policy.h"

namespace slackwater::calibration {

/// What may be looked at of wind and waves.
struct BestInputs {
  /// Under `best` values valid by then, runs issued by then, and files received by then are known.
  UtcTime known_by = UtcTime::max();
  /// What came later is looked at too, and what is made with it is marked.
  bool hindsight = false;
  /// When the forecast is issued: what `WindPolicy::forecast` may look at was published by then.
  /// Absent: at the end of D.
  std::optional<UtcTime> issued{};
  UtcTime seen_by = UtcTime::max();  ///< Knowledge::seen_by, under every policy
  /// Where no run of the wind known then reaches beyond D, the wind analysed later stands for one,
  /// with an error drawn from this seed (`simulated_run`), and what is made with it is marked.
  std::optional<std::uint64_t> simulated_seed{};
  UtcTime analysed_until = UtcTime::max();  ///< of that analysis nothing later is looked at
};

/// What every column of one run shares.
struct ForecastPlan {
  UtcDay day{};  ///< D
  UtcTime issued{};
  UtcTime seen_by = UtcTime::max();  ///< Knowledge::seen_by, of currents
  /// On a rehearsed day: the editions of analysed currents that the store held by then count.
  std::optional<UtcTime> editions_by{};
  WindPolicy wind = WindPolicy::best;
  BestInputs best;
  std::vector<UtcTime> stamps;  ///< hourly from the end of D, both ends included
  std::vector<double> depth_m;  ///< the product's native wet levels
  std::string dataset;          ///< of the currents; empty where there are none
  std::string stands_in_for;    ///< the leading dataset, where that one only stands in; else empty
  Spread spread;                ///< one set of figures for all sites
  std::uint64_t seed = 1;       ///< of the members

  /// What is known of the currents up to the end of D.
  [[nodiscard]] Knowledge knowledge() const {
    return {end_of_day(), issued, UtcTime::min(), editions_by.value_or(seen_by)};
  }
  /// The same of the provider's runs, which count from their publication, however late they came.
  [[nodiscard]] Knowledge knowledge_of_runs() const {
    return {end_of_day(), issued, UtcTime::min(), seen_by};
  }
  [[nodiscard]] UtcTime end_of_day() const noexcept { return UtcTime(day) + std::chrono::days(1); }
};

}  // namespace slackwater::calibration
