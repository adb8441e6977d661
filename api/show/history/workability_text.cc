#include <cmath>

#include "api/show/history/workability_answer.h"
#include "fields/base/month_names.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using twin::WindowStatistics;

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
  std::string text = formatted("A task of {:g} h", hours_of(question.duration));
  if (question.contingency > Duration(0))
    text += formatted(" and {:g} h of contingency", hours_of(question.contingency));
  if (question.start_hours)
    text += ", begun from " + twin::text_of(*question.start_hours) + " " +
            zone_text(question.zone) + ",";
  return text;
}

/// What a record that ends before the next start leaves open.
std::string censored_text(const twin::WaitingTime& wait) {
  return formatted(
      "For {:.0f} % of the time the record ends before the next start comes. These waits are left "
      "out: waits are at least as long as is said.\n",
      100 * share_of(wait.censored, wait.censored + wait.counted));
}

/// The answer in a sentence or two.
std::string verdict_text(const WorkabilityQuestion& question, const WindowStatistics& all) {
  const std::string need = need_text(question);
  if (all.workable_starts == 0) {
    return need + " could never be done: " +
           (all.accessible_steps == 0
                ? "there was no time at which all limits held.\n"
                : formatted("the longest window lasted {:g} h.\n",
                            static_cast<double>(all.longest_window_steps) * all.step_h));
  }
  const twin::WaitingTime& wait = all.waiting;
  const std::string could =
      need + " could start " + percent_text(all.workability()) + " % of the time.\n";
  if (wait.counted == 0 || wait.mean_h == 0)
    return could + (wait.censored == 0 ? "There is no wait for a start.\n" : censored_text(wait));
  return could + "The wait for a start is " + about(wait.mean_h) +
         " on average: half of the time " +
         (wait.p50_h > 0 ? "at most " + about(wait.p50_h) : "0 h") + ", 8 times in 10 " +
         (wait.p80_h > 0 ? "at most " + about(wait.p80_h) : "0 h") + ", 9 in 10 " +
         (wait.p90_h > 0 ? "at most " + about(wait.p90_h) : "0 h") + ".\n" +
         (wait.censored == 0 ? std::string() : censored_text(wait));
}

}  // namespace

double share_of(std::size_t part, std::size_t of) noexcept {
  return of == 0 ? std::nan("") : static_cast<double>(part) / static_cast<double>(of);
}

std::string zone_text(const std::optional<TimeZone>& zone) { return zone ? zone->name() : "UTC"; }

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

std::string workability_text(const History& history, const WorkabilityQuestion& question,
                             const WorkabilityAnswer& answer) {
  const twin::Workability& found = answer.workability;
  const StepClock& clock = history.regular.clock;
  std::string text = verdict_text(question, found.overall);
  text +=
      formatted("\n{}: {}.\n", history.source, extent_text(clock, answer.limited.access.missing));
  for (std::size_t l = 0; l < question.limits.size(); ++l) {
    const LimitShare& one = answer.limited.shares[l];
    text += formatted("  {}: holds {} % of the time", question.limits[l].text,
                      percent_text(share_of(one.holds, clock.steps)));
    if (question.limits.size() > 1)
      text += formatted(", is the only one exceeded {} % of the time",
                        percent_text(share_of(one.stops_alone, clock.steps)));
    text += "\n";
  }
  if (question.daylight)
    text += formatted("  daylight ({}): holds {} % of the time\n",
                      std::string(twin::name_of(*question.daylight)),
                      percent_text(share_of(answer.light_steps, clock.steps)));
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
                    zone_text(question.zone).size() > 6 ? "local" : zone_text(question.zone), "%",
                    "%", "mean", "P50", "P80", "P90", "all", "enough", "mean", "longest");
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
