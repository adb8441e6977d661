#include <cmath>
#include <nlohmann/json.hpp>

#include "api/show/history/campaign_answer.h"
#include "api/show/history/workability_answer.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

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

}  // namespace slackwater::api
