#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/show/history/workability_answer.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using twin::WindowStatistics;

/// The steps that most of a history's statistics consist of. NaN becomes null.
json statistics_json(const WindowStatistics& s) {
  const twin::WaitingTime& wait = s.waiting;
  return {{"steps", s.steps},
          {"missing_steps", s.missing_steps},
          {"accessibility", s.accessibility()},
          {"workability", s.workability()},
          {"workable_starts", s.workable_starts},
          {"windows", s.windows},
          {"workable_windows", s.workable_windows},
          {"mean_window_h", s.mean_window_h()},
          {"longest_window_h", static_cast<double>(s.longest_window_steps) * s.step_h},
          {"persistence", s.persistence()},
          {"storms", s.storms},
          {"mean_storm_h", s.mean_storm_h()},
          {"longest_storm_h", static_cast<double>(s.longest_storm_steps) * s.step_h},
          {"censored_steps", wait.censored},
          {"waiting_time_h",
           {{"mean", wait.mean_h},
            {"p10", wait.p10_h},
            {"p50", wait.p50_h},
            {"p80", wait.p80_h},
            {"p90", wait.p90_h}}}};
}

}  // namespace

json gaps_json(const StepClock& clock, const twin::StepRanges& missing) {
  const twin::StepRange* longest = longest_of(missing);
  return {{"count", missing.size()},
          {"longest_h",
           longest == nullptr ? 0.0 : static_cast<double>(longest->steps()) * clock.step_h()},
          {"longest_from",
           longest == nullptr ? json(nullptr) : json(format_utc(clock.time_of(longest->begin)))}};
}

json workability_json(const History& history, const WorkabilityQuestion& question,
                      const WorkabilityAnswer& answer, const ingest::Vocabulary& vocabulary) {
  const StepClock& clock = history.regular.clock;
  json document = statistics_json(answer.workability.overall);
  document["source"] = history.source;
  document["first"] = format_utc(clock.first);
  document["last"] = format_utc(clock.time_of(clock.steps - 1));
  document["step_h"] = clock.step_h();
  document["time_zone"] = zone_text(question.zone);
  document["duration_h"] = hours_of(question.duration);
  document["contingency_h"] = hours_of(question.contingency);
  document["start_hours"] =
      question.start_hours ? json(twin::text_of(*question.start_hours)) : json(nullptr);
  document["limits"] = json::array();
  for (std::size_t l = 0; l < question.limits.size(); ++l) {
    const SeriesLimit& limit = question.limits[l];
    const auto s = static_cast<std::size_t>(
        std::find(history.wanted.begin(), history.wanted.end(), limit.variable) -
        history.wanted.begin());
    document["limits"].push_back(
        {{"limit", limit.text},
         {"standard_name", history.series[s].standard_name},
         {"series", history.series[s].name},
         {"at", std::string(twin::sign_of(limit.bound.side))},
         {"value", limit.table ? json(nullptr) : json(limit.bound.value)},
         {"unit", unit_of(limit, history.series[s], vocabulary)},
         {"holds", share_of(answer.limited.shares[l].holds, clock.steps)},
         {"stops_alone", share_of(answer.limited.shares[l].stops_alone, clock.steps)}});
  }
  document["daylight"] = nullptr;
  if (question.daylight)
    document["daylight"] = {{"light", std::string(twin::name_of(*question.daylight))},
                            {"latitude_deg", history.place->latitude_deg()},
                            {"longitude_deg", history.place->longitude_deg()},
                            {"holds", share_of(answer.light_steps, clock.steps)}};
  document["gaps"] = gaps_json(clock, answer.limited.access.missing);
  document["by_month"] = json::array();
  for (const twin::MonthStatistics& month : answer.workability.by_month) {
    json entry = statistics_json(month.statistics);
    entry["month"] = month.month;
    document["by_month"].push_back(std::move(entry));
  }
  document["by_year"] = json::array();
  for (const twin::YearStatistics& year : answer.workability.by_year) {
    json entry = statistics_json(year.statistics);
    entry["year"] = year.year;
    document["by_year"].push_back(std::move(entry));
  }
  document["notes"] = history.notes;
  for (const std::string& note : answer.notes) document["notes"].push_back(note);
  return document;
}

}  // namespace slackwater::api
