#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

#include "calibration/day/earned.h"
#include "calibration/day/forecast_column.h"
#include "calibration/day/rehearsed_day.h"
#include "fields/record/site_data.h"

namespace slackwater::calibration {

/// Rehearses past days of the data at a few columns and remembers them, so that a hindcast
/// rehearses each day once. A day D' is forecast from what was known when it would have been issued
/// (with `hindsight` all wind that came later) and held against the currents of the days after it
/// that end by the D that is forecast from: nothing later is seen. It starts from the editions of
/// the currents that the store held then, and is held against those of now. Where a run of the wind
/// is known now and none was kept of then, one is simulated (simulated_run.h). A day that fails is
/// passed over and counted. Thread-safe.
class RehearsedDays {
 public:
  /// @param parts  of a column's forecast; waves are not rehearsed
  explicit RehearsedDays(const SiteData& data, ColumnParts parts = {});

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
  /// when the best wind was known and whether with hindsight, seed, depths, stamps, and from what
  /// analysis runs that were not kept are simulated.
  using Key = std::tuple<UtcDay, WindPolicy, std::string, UtcTime, UtcTime, bool, std::uint64_t,
                         std::vector<double>, UtcTime, std::size_t, UtcTime>;

  const SiteData& data_;
  ColumnParts parts_;
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const RehearsedDay>> done_;
};

}  // namespace slackwater::calibration
