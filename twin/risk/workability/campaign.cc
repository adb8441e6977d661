#include "twin/risk/workability/campaign.h"

#include <algorithm>

#include "fields/base/check.h"
#include "fields/base/numbers/quantile.h"

namespace slackwater::twin {

std::optional<std::size_t> end_of(const std::vector<CampaignTask>& tasks, std::size_t begin,
                                  std::size_t teams) {
  expects(teams > 0, "somebody does the work");
  std::vector<std::size_t> free_from(teams, begin);
  for (const CampaignTask& task : tasks) {
    for (std::size_t i = 0; i < task.times; ++i) {
      const auto first = std::min_element(free_from.begin(), free_from.end());
      const std::optional<StepRange> done = task.history.done_from(*first);
      if (!done) return std::nullopt;
      *first = done->end;
    }
  }
  return *std::max_element(free_from.begin(), free_from.end());
}

CampaignSeason season_of(const std::vector<CampaignTask>& tasks, const StepClock& clock,
                         const std::chrono::month_day& date, const std::optional<TimeZone>& zone,
                         std::size_t teams) {
  CampaignSeason season;
  season.date = date;
  season.teams = teams;
  std::vector<double> hours;
  for (const YearDate& begin : dates_of(clock, date, zone)) {
    const CampaignYear one{begin.year, begin.step, end_of(tasks, begin.step, teams)};
    if (one.end)
      hours.push_back(static_cast<double>(*one.end - one.begin) * clock.step_h());
    else
      ++season.censored;
    season.years.push_back(one);
  }
  if (hours.empty()) return season;
  std::sort(hours.begin(), hours.end());
  season.p10_h = percentile(hours, 10);
  season.p50_h = percentile(hours, 50);
  season.p80_h = percentile(hours, 80);
  season.p90_h = percentile(hours, 90);
  return season;
}

}  // namespace slackwater::twin
