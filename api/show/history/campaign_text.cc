#include <cmath>

#include "api/show/history/campaign_answer.h"
#include "api/show/history/workability_answer.h"
#include "fields/base/text.h"

namespace slackwater::api {

std::string date_text(const std::chrono::month_day& date) {
  return formatted("{:02}-{:02}", static_cast<unsigned>(date.month()),
                   static_cast<unsigned>(date.day()));
}

std::string date_after(const std::chrono::month_day& date, double after_h) {
  if (!std::isfinite(after_h)) return "-";
  const std::chrono::sys_days begin = std::chrono::year(2001) / date.month() / date.day();
  const auto end = begin + std::chrono::days(static_cast<int>(std::floor(after_h / 24)));
  const std::chrono::year_month_day found(end);
  const int years = static_cast<int>(found.year()) - 2001;
  return date_text(found.month() / found.day()) +
         (years > 0 ? formatted(" +{}y", years) : std::string());
}

std::string campaign_text(const History& history, const CampaignFile& campaign,
                          const CampaignAnswer& answer) {
  const StepClock& clock = history.regular.clock;
  std::string text =
      formatted("{}: {:g} h of work without the weather.\n{}: {}.\n\n", campaign.name,
                hours_of(answer.work), history.source, extent_text(clock, answer.missing));
  // One team is what is meant where nothing is said.
  const bool says_teams = campaign.teams != std::vector<std::size_t>{1};
  if (says_teams) text += formatted("{:>5}  ", "teams");
  text += formatted("{:<7} {:>5}   {:>9} {:>9} {:>9}   {:>8} {:>8} {:>8}\n", "begun", "years",
                    "done P10", "P50", "P90", "days P10", "P50", "P90");
  std::size_t censored = 0;
  for (const twin::CampaignSeason& season : answer.seasons) {
    const auto days = [](double hours_found) {
      return std::isfinite(hours_found) ? formatted("{:.1f}", hours_found / 24) : std::string("-");
    };
    if (says_teams) text += formatted("{:>5}  ", season.teams);
    text +=
        formatted("{:<7} {:>5}   {:>9} {:>9} {:>9}   {:>8} {:>8} {:>8}\n", date_text(season.date),
                  season.years.size() - season.censored, date_after(season.date, season.p10_h),
                  date_after(season.date, season.p50_h), date_after(season.date, season.p90_h),
                  days(season.p10_h), days(season.p50_h), days(season.p90_h));
    censored += season.censored;
  }
  if (censored > 0)
    text += formatted(
        "left out because the series ends before the campaign does: {} of all campaigns; the "
        "figures above are too good for this reason\n",
        censored);
  return text;
}

}  // namespace slackwater::api
