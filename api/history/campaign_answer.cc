#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/history/campaign_file.h"
#include "api/history/workability_answer.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/risk/workable_starts.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

double hours_of(Duration duration) {
  return std::chrono::duration<double, std::ratio<3600>>(duration).count();
}

twin::TaskHistory history_of(const CampaignTaskText& task, const LimitedHistory& limited,
                             const StepClock& clock, const std::optional<TimeZone>& zone) {
  const std::size_t work = twin::steps_needed(task.duration, clock.step);
  twin::StepRanges usable = limited.access.windows;
  if (task.working_hours)
    usable = twin::common_to(usable, twin::steps_at(clock, *task.working_hours, zone));
  if (task.split) {
    twin::TaskHistory::Visits visits;
    visits.shortest = twin::steps_needed(task.split->shortest_visit, clock.step);
    if (task.split->lost > Duration(0))
      visits.lost = twin::steps_needed(task.split->lost, clock.step);
    visits.shortest = std::max(visits.shortest, visits.lost + 1);
    return twin::TaskHistory::split(std::move(usable), work, visits);
  }
  const std::size_t needed = twin::steps_needed(task.duration + task.contingency, clock.step);
  twin::StepRanges starts = twin::workable_starts(usable, needed);
  if (task.start_hours)
    starts = twin::common_to(starts, twin::steps_at(clock, *task.start_hours, zone));
  return twin::TaskHistory::whole(std::move(starts), work);
}

std::string date_text(const std::chrono::month_day& date) {
  return formatted("{:02}-{:02}", static_cast<unsigned>(date.month()),
                   static_cast<unsigned>(date.day()));
}

/// The date so many hours after a date, in a year without 29 February; a year later with "+1y".
std::string date_after(const std::chrono::month_day& date, double after_h) {
  if (!std::isfinite(after_h)) return "-";
  const std::chrono::sys_days begin = std::chrono::year(2001) / date.month() / date.day();
  const auto end = begin + std::chrono::days(static_cast<int>(std::floor(after_h / 24)));
  const std::chrono::year_month_day found(end);
  const int years = static_cast<int>(found.year()) - 2001;
  return date_text(found.month() / found.day()) +
         (years > 0 ? formatted(" +{}y", years) : std::string());
}

json percentiles_json(const twin::CampaignSeason& season) {
  return {
      {"p10", season.p10_h}, {"p50", season.p50_h}, {"p80", season.p80_h}, {"p90", season.p90_h}};
}

json completion_json(const twin::CampaignSeason& season) {
  json dates = json::object();
  const std::pair<const char*, double> all[] = {
      {"p10", season.p10_h}, {"p50", season.p50_h}, {"p80", season.p80_h}, {"p90", season.p90_h}};
  for (const auto& [name, after_h] : all)
    dates[name] = std::isfinite(after_h) ? json(date_after(season.date, after_h)) : json(nullptr);
  return dates;
}

std::size_t missing_between(const twin::StepRanges& missing, std::size_t begin, std::size_t end) {
  return begin < end ? twin::steps_in(twin::common_to(missing, {{begin, end}})) : 0;
}

}  // namespace

CampaignAnswer answer_of(const History& history, const CampaignFile& campaign,
                         const ingest::Vocabulary& vocabulary) {
  const StepClock& clock = history.regular.clock;
  CampaignAnswer answer;
  std::vector<twin::CampaignTask> tasks;
  twin::StepRanges known{{0, clock.steps}};
  for (const CampaignTaskText& task : campaign.tasks) {
    if (!task.split && task.duration + task.contingency > clock.end() - clock.first)
      throw Error(ErrorKind::invalid_input,
                  formatted("task '{}': found {:g} h, longer than the series: it has {:g} h",
                            task.name, hours_of(task.duration + task.contingency),
                            hours_of(clock.end() - clock.first)));
    LimitedHistory limited = api::limited(history, task.limits, vocabulary, campaign.zone);
    known = twin::common_to(known, twin::outside(limited.access.missing, clock.steps));
    if (task.daylight) {
      std::vector<std::string> notes;
      limited.access.windows =
          twin::common_to(limited.access.windows, light_at(history, *task.daylight, notes));
      for (std::string& note : notes) {
        if (std::find(answer.notes.begin(), answer.notes.end(), note) == answer.notes.end())
          answer.notes.push_back(std::move(note));
      }
    }
    tasks.push_back({history_of(task, limited, clock, campaign.zone), task.times});
    answer.work += task.duration * static_cast<Duration::rep>(task.times);
  }
  answer.missing = twin::outside(known, clock.steps);
  for (const std::chrono::month_day& date : campaign.begin)
    for (const std::size_t teams : campaign.teams)
      answer.seasons.push_back(twin::season_of(tasks, clock, date, campaign.zone, teams));
  return answer;
}

json campaign_json(const History& history, const CampaignFile& campaign,
                   const CampaignAnswer& answer) {
  const StepClock& clock = history.regular.clock;
  json document = {{"campaign", campaign.name},
                   {"source", history.source},
                   {"first", format_utc(clock.first)},
                   {"last", format_utc(clock.time_of(clock.steps - 1))},
                   {"step_h", clock.step_h()},
                   {"steps", clock.steps},
                   {"missing_steps", twin::steps_in(answer.missing)},
                   {"gaps", gaps_json(clock, answer.missing)},
                   {"time_zone", campaign.zone ? campaign.zone->name() : "UTC"},
                   {"work_h", hours_of(answer.work)},
                   {"tasks", json::array()},
                   {"seasons", json::array()},
                   {"notes", history.notes}};
  for (const CampaignTaskText& task : campaign.tasks) {
    json limits = json::array();
    for (const SeriesLimit& limit : task.limits) limits.push_back(limit.text);
    document["tasks"].push_back({{"name", task.name},
                                 {"times", task.times},
                                 {"duration_h", hours_of(task.duration)},
                                 {"contingency_h", hours_of(task.contingency)},
                                 {"split", task.split.has_value()},
                                 {"limits", limits}});
  }
  for (const twin::CampaignSeason& season : answer.seasons) {
    json years = json::array();
    for (const twin::CampaignYear& year : season.years) {
      json one = {{"year", year.year}, {"begin", format_utc(clock.time_of(year.begin))}};
      one["end"] = year.end ? json(format_utc(clock.time_of(*year.end))) : json(nullptr);
      one["elapsed_h"] = year.end
                             ? json(static_cast<double>(*year.end - year.begin) * clock.step_h())
                             : json(nullptr);
      one["missing_steps"] =
          missing_between(answer.missing, year.begin, year.end.value_or(clock.steps));
      years.push_back(std::move(one));
    }
    document["seasons"].push_back({{"begin", date_text(season.date)},
                                   {"teams", season.teams},
                                   {"years", season.years.size()},
                                   {"censored_years", season.censored},
                                   {"elapsed_h", percentiles_json(season)},
                                   {"completion", completion_json(season)},
                                   {"by_year", years}});
  }
  for (const std::string& note : answer.notes) document["notes"].push_back(note);
  return document;
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
        "left out, since the series ends before the campaign does: {} of all begun; the "
        "others look better for it\n",
        censored);
  return text;
}

}  // namespace slackwater::api
