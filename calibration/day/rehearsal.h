#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

#include "calibration/blend/blend.h"
#include "calibration/blend/earned_spread.h"
#include "calibration/day/forecast_column.h"
#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// One past day D' forecast as if live and held against D'+1, with every other method beside it.
struct RehearsedDay {
  std::vector<std::vector<Horizontal>> errors;  ///< per standard candidate; empty: absent
  std::vector<double> sigma_m_s;                ///< of our forecast, per value; unscaled
  std::optional<Failure> failure;               ///< a bug that cost a forecast, or all of the day
};

/// What the past of a site has earned: the weights of the candidates, and the factor on the spread.
struct Earned {
  Blend blend;
  EarnedSpread spread;
  std::size_t failed_days = 0;           ///< that could not be rehearsed as they should
  std::optional<Failure> first_failure;  ///< of them
};

/// Rehearses past days of the data at a few columns and remembers them, so that a hindcast
/// rehearses each day once. A day D' is forecast from what was known at its own end (plus the
/// latency of the run; wind and waves under `best` when D'+1 had ended, plus that) and held against
/// the currents of D'+1, which end by the D that is forecast from: nothing later is seen. A day
/// that fails is passed over and counted. Thread-safe.
class Rehearsals {
 public:
  /// @param parts  of a column's forecast; waves are not rehearsed
  explicit Rehearsals(const SiteData& data, ColumnParts parts = {});

  /// What the pairs up to the plan's D have earned.
  /// @param available  whether each standard candidate can be made for D
  [[nodiscard]] Earned earned(const ForecastPlan& plan, const std::vector<bool>& available,
                              int threads);

  static constexpr int longest_days = 21;
  static constexpr std::size_t most_columns = 4;

 private:
  [[nodiscard]] std::shared_ptr<const RehearsedDay> day(const ForecastPlan& plan, UtcDay day);
  [[nodiscard]] RehearsedDay rehearse(const ForecastPlan& plan, UtcDay day) const;

  /// All of a plan that a rehearsed day rests on: the day, wind policy, dataset, issue time, by
  /// when the best wind was known and whether with hindsight, seed, depths.
  using Key = std::tuple<UtcDay, WindPolicy, std::string, UtcTime, UtcTime, bool, std::uint64_t,
                         std::vector<double>, UtcTime>;

  const SiteData& data_;
  ColumnParts parts_;
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const RehearsedDay>> done_;
};

/// The methods of the standard candidates, in order.
[[nodiscard]] std::vector<Method> candidate_methods();

}  // namespace slackwater::calibration
