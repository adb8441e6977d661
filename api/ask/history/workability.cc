#include "api/ask/history/workability.h"

#include <algorithm>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/risk/workability/workable_starts.h"

namespace slackwater::api {

const twin::StepRange* longest_of(const twin::StepRanges& ranges) {
  const auto longest = std::max_element(
      ranges.begin(), ranges.end(),
      [](const twin::StepRange& a, const twin::StepRange& b) { return a.steps() < b.steps(); });
  return longest == ranges.end() ? nullptr : &*longest;
}

WorkabilityAnswer answer_of(const History& history, const WorkabilityQuestion& question,
                            const ingest::Vocabulary& vocabulary) {
  const StepClock& clock = history.regular.clock;
  const Duration needed = question.duration + question.contingency;
  if (needed > clock.end() - clock.first)
    throw Error(
        ErrorKind::invalid_input,
        formatted("found --duration {:g} h{}, longer than the series: it has {:g} h, from "
                  "{} to {}; expected a task that fits into it",
                  hours_of(question.duration),
                  question.contingency > Duration(0)
                      ? formatted(" and --contingency {:g} h", hours_of(question.contingency))
                      : std::string(),
                  hours_of(clock.end() - clock.first), format_utc(clock.first),
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

}  // namespace slackwater::api
