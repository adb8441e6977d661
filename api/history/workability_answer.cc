#include "api/history/workability_answer.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/risk/workable_starts.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using twin::WindowStatistics;

double hours(Duration duration) {
  return std::chrono::duration<double, std::ratio<3600>>(duration).count();
}

double share(std::size_t part, std::size_t of) {
  return of == 0 ? std::nan("") : static_cast<double>(part) / static_cast<double>(of);
}

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

const twin::StepRange* longest_of(const twin::StepRanges& ranges) {
  const auto longest = std::max_element(
      ranges.begin(), ranges.end(),
      [](const twin::StepRange& a, const twin::StepRange& b) { return a.steps() < b.steps(); });
  return longest == ranges.end() ? nullptr : &*longest;
}

std::string zone_text(const WorkabilityQuestion& question) {
  return question.zone ? question.zone->name() : "UTC";
}

/// "43.2"; "-" of none.
std::string percent_text(double value) {
  return std::isfinite(value) ? formatted("{:.1f}", 100 * value) : "-";
}
std::string hours_text(double value) {
  return std::isfinite(value) ? formatted("{:.1f}", value) : "-";
}
/// Hours for a sentence: a decimal only where it says something.
std::string about(double value) {
  return value < 10 ? formatted("{:.1f} h", value) : formatted("{:.0f} h", value);
}

std::string row_text(const std::string& name, const WindowStatistics& s) {
  const twin::WaitingTime& wait = s.waiting;
  return formatted("{:<6} {:>8} {:>9} {:>8} {:>7} {:>7} {:>7} {:>8} {:>7} {:>7} {:>8}\n", name,
                   percent_text(s.accessibility()), percent_text(s.workability()),
                   hours_text(wait.mean_h), hours_text(wait.p50_h), hours_text(wait.p80_h),
                   hours_text(wait.p90_h), s.windows, s.workable_windows,
                   hours_text(s.mean_window_h()),
                   hours_text(static_cast<double>(s.longest_window_steps) * s.step_h));
}

std::string need_text(const WorkabilityQuestion& question) {
  std::string text = formatted("A task of {:g} h", hours(question.duration));
  if (question.contingency > Duration(0))
    text += formatted(" and {:g} h of contingency", hours(question.contingency));
  if (question.start_hours)
    text +=
        ", begun from " + twin::text_of(*question.start_hours) + " " + zone_text(question) + ",";
  return text;
}

/// The answer in a sentence or two.
std::string verdict_text(const WorkabilityQuestion& question, const WindowStatistics& all) {
  const std::string need = need_text(question);
  if (all.workable_starts == 0) {
    return need + " could never be done: " +
           (all.accessible_steps == 0
                ? "the limits never all held.\n"
                : formatted("the longest window lasted {:g} h.\n",
                            static_cast<double>(all.longest_window_steps) * all.step_h));
  }
  const twin::WaitingTime& wait = all.waiting;
  const std::string could =
      need + " could start " + percent_text(all.workability()) + " % of the time.\n";
  if (wait.mean_h == 0) return could + "Nobody waits for a start.\n";
  return could + "Whoever waits for a start waits " + about(wait.mean_h) +
         " on average: half of the time " +
         (wait.p50_h > 0 ? "at most " + about(wait.p50_h) : "not at all") + ", 8 times in 10 " +
         (wait.p80_h > 0 ? "at most " + about(wait.p80_h) : "not at all") + ", 9 in 10 " +
         (wait.p90_h > 0 ? "at most " + about(wait.p90_h) : "not at all") + ".\n";
}

}  // namespace

WorkabilityAnswer answer_of(const History& history, const WorkabilityQuestion& question,
                            const ingest::Vocabulary& vocabulary) {
  const StepClock& clock = history.regular.clock;
  const Duration needed = question.duration + question.contingency;
  if (needed > clock.end() - clock.first)
    throw Error(ErrorKind::invalid_input,
                formatted("found --duration {:g} h{}, longer than the series: it has {:g} h, from "
                          "{} to {}; expected a task that fits into it",
                          hours(question.duration),
                          question.contingency > Duration(0)
                              ? formatted(" and --contingency {:g} h", hours(question.contingency))
                              : std::string(),
                          hours(clock.end() - clock.first), format_utc(clock.first),
                          format_utc(clock.end())));
  WorkabilityAnswer answer;
  answer.limited = limited(history, question.limits, vocabulary, question.zone);
  if (question.daylight) {
    const twin::StepRanges light = light_at(history, *question.daylight, answer.notes);
    answer.light_steps = twin::steps_in(light);
    answer.limited.access.windows = twin::common_to(answer.limited.access.windows, light);
  }
  twin::WindowNeed need;
  need.steps = twin::steps_needed(needed, clock.step);
  if (question.start_hours)
    need.may_start = twin::steps_at(clock, *question.start_hours, question.zone);
  answer.workability = twin::workability_of(answer.limited.access, need);
  return answer;
}

twin::StepRanges light_at(const History& history, twin::Light light,
                          std::vector<std::string>& notes) {
  if (!history.place)
    throw Error(ErrorKind::usage,
                "found daylight asked for and no place; expected --lat and --lon, or --site");
  const StepClock& clock = history.regular.clock;
  twin::StepRanges lit = twin::light_steps(clock, *history.place, light);
  const auto longest_h = [&](const twin::StepRanges& ranges) {
    const twin::StepRange* longest = longest_of(ranges);
    return longest == nullptr ? 0.0 : static_cast<double>(longest->steps()) * clock.step_h();
  };
  const auto tell = [&](const twin::StepRanges& ranges, const std::string& what) {
    if (longest_h(ranges) > 24)
      notes.push_back(formatted("at {} {} for up to {:.0f} days on end",
                                position_text(*history.place), what, longest_h(ranges) / 24));
  };
  tell(twin::outside(lit, clock.steps), "it is dark");
  tell(lit, "it is light");
  return lit;
}

json gaps_json(const StepClock& clock, const twin::StepRanges& missing) {
  const twin::StepRange* longest = longest_of(missing);
  return {{"count", missing.size()},
          {"longest_h",
           longest == nullptr ? 0.0 : static_cast<double>(longest->steps()) * clock.step_h()},
          {"longest_from",
           longest == nullptr ? json(nullptr) : json(format_utc(clock.time_of(longest->begin)))}};
}

std::string extent_text(const StepClock& clock, const twin::StepRanges& missing) {
  std::string text = formatted("{} steps of {:g} h from {} to {}, ", clock.steps, clock.step_h(),
                               format_utc(clock.first), format_utc(clock.end()));
  const twin::StepRange* longest = longest_of(missing);
  if (longest == nullptr) return text + "none missing";
  return text + formatted(
                    "{} of them missing in {} {}, the longest {:g} h from {}: they count as "
                    "not accessible",
                    twin::steps_in(missing), missing.size(), missing.size() == 1 ? "gap" : "gaps",
                    static_cast<double>(longest->steps()) * clock.step_h(),
                    format_utc(clock.time_of(longest->begin)));
}

json workability_json(const History& history, const WorkabilityQuestion& question,
                      const WorkabilityAnswer& answer, const ingest::Vocabulary& vocabulary) {
  const StepClock& clock = history.regular.clock;
  json document = statistics_json(answer.workability.overall);
  document["source"] = history.source;
  document["first"] = format_utc(clock.first);
  document["last"] = format_utc(clock.time_of(clock.steps - 1));
  document["step_h"] = clock.step_h();
  document["time_zone"] = zone_text(question);
  document["duration_h"] = hours(question.duration);
  document["contingency_h"] = hours(question.contingency);
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
         {"at", std::string(twin::sign_of(limit.side))},
         {"value", limit.value},
         {"unit", unit_of(limit, history.series[s], vocabulary)},
         {"holds", share(answer.limited.shares[l].holds, clock.steps)},
         {"stops_alone", share(answer.limited.shares[l].stops_alone, clock.steps)}});
  }
  document["daylight"] = nullptr;
  if (question.daylight)
    document["daylight"] = {{"light", std::string(twin::name_of(*question.daylight))},
                            {"latitude_deg", history.place->latitude_deg()},
                            {"longitude_deg", history.place->longitude_deg()},
                            {"holds", share(answer.light_steps, clock.steps)}};
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

std::string workability_text(const History& history, const WorkabilityQuestion& question,
                             const WorkabilityAnswer& answer) {
  constexpr const char* month_names[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                         "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const twin::Workability& found = answer.workability;
  const StepClock& clock = history.regular.clock;
  std::string text = verdict_text(question, found.overall);
  text +=
      formatted("\n{}: {}.\n", history.source, extent_text(clock, answer.limited.access.missing));
  for (std::size_t l = 0; l < question.limits.size(); ++l) {
    const LimitShare& one = answer.limited.shares[l];
    text += formatted("  {}: holds {} % of the time", question.limits[l].text,
                      percent_text(share(one.holds, clock.steps)));
    if (question.limits.size() > 1)
      text +=
          formatted(", alone in the way {} %", percent_text(share(one.stops_alone, clock.steps)));
    text += "\n";
  }
  if (question.daylight)
    text += formatted("  daylight ({}): holds {} % of the time\n",
                      std::string(twin::name_of(*question.daylight)),
                      percent_text(share(answer.light_steps, clock.steps)));
  text +=
      formatted("  all together: {} % of the time", percent_text(found.overall.accessibility()));
  if (found.overall.windows > 0)
    text += formatted(", in {} {} of {} h on average", found.overall.windows,
                      found.overall.windows == 1 ? "window" : "windows",
                      hours_text(found.overall.mean_window_h()));
  if (found.overall.windows > 0 && found.overall.storms > 0)
    text += formatted(", {} h apart", hours_text(found.overall.mean_storm_h()));
  text += "\n";
  text += formatted("\n{:<6} {:>8} {:>9} {:>32} {:>33}\n", "", "access", "can start",
                    "wait for a start, hours", "windows, hours");
  text += formatted("{:<6} {:>8} {:>9} {:>8} {:>7} {:>7} {:>7} {:>8} {:>7} {:>7} {:>8}\n",
                    zone_text(question).size() > 6 ? "local" : zone_text(question), "%", "%",
                    "mean", "P50", "P80", "P90", "all", "enough", "mean", "longest");
  for (const twin::MonthStatistics& month : found.by_month)
    text += row_text(month_names[month.month - 1], month.statistics);
  if (found.by_year.size() > 1) {
    text += "\n";
    for (const twin::YearStatistics& year : found.by_year)
      text += row_text(formatted("{}", year.year), year.statistics);
  }
  text += "\n" + row_text("all", found.overall);
  if (found.overall.waiting.censored > 0)
    text += formatted(
        "{} steps at the end have no start after them and are left out of the "
        "waiting times\n",
        found.overall.waiting.censored);
  return text;
}

}  // namespace slackwater::api
