#pragma once
#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "fields/base/constants.h"
#include "twin/risk/workability/calendar.h"
#include "twin/risk/workability/task_history.h"

namespace slackwater::twin {

/// A task of a campaign, done some times one after the other.
struct CampaignTask {
  TaskHistory history;
  std::size_t times = 1;
};

/// The end of a campaign that begins at a step: a team does one task after the other, and each next
/// task goes to the team that is free first. More teams never end later. Nothing where the history
/// ends before it.
/// @param teams  1 at least
[[nodiscard]] std::optional<std::size_t> end_of(const std::vector<CampaignTask>& tasks,
                                                std::size_t begin, std::size_t teams = 1);

/// A campaign begun in one year of a history.
struct CampaignYear {
  int year = 0;
  std::size_t begin = 0;
  std::optional<std::size_t> end;  ///< absent: the history ends first
};

/// A campaign begun on one date of every year.
struct CampaignSeason {
  std::chrono::month_day date;
  std::size_t teams = 1;
  std::vector<CampaignYear> years;
  std::size_t censored = 0;  ///< years without an end: left out of the percentiles
  /// Hours from the beginning to the end, over the years with an end; NaN of none.
  double p10_h = constants::nan;
  double p50_h = constants::nan;
  double p80_h = constants::nan;
  double p90_h = constants::nan;
};

/// Simulates a campaign over a history, once for each year that holds the date.
[[nodiscard]] CampaignSeason season_of(const std::vector<CampaignTask>& tasks,
                                       const StepClock& clock, const std::chrono::month_day& date,
                                       const std::optional<TimeZone>& zone, std::size_t teams = 1);

}  // namespace slackwater::twin
