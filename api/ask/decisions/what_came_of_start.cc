#include "api/ask/decisions/what_came_of_start.h"

#include "fields/base/attempt.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

WhatCame cannot_be_known(std::string why) {
  WhatCame what;
  what.came = Came::cannot_be_known;
  what.why = std::move(why);
  return what;
}

/// @param to  up to where something is known
WhatCame not_known(const store::DecisionRow& decision, const Snapshot& forecast, UtcTime to) {
  const UtcTime end = forecast.time.back();
  const std::string work =
      decision.work ? formatted("of {:.1f} h ", hours_of(*decision.work)) : std::string();
  if (to >= end)
    return cannot_be_known("the work " + work + "ends after the forecast that it was decided on (" +
                           format_utc(end) + ")");
  WhatCame what;
  what.why = to < forecast.time.front()
                 ? std::string("nothing of its hours is analysed or measured in the store")
                 : "what is analysed or measured in the store goes on to " + format_utc(to) +
                       " without a gap, and the work " + work + "ends later";
  return what;
}

/// As of a forecast of one future that errs nowhere.
WindowsQuestion question_about(const WindowsQuestion& asked, const store::DecisionRow& decision,
                               const std::shared_ptr<const Snapshot>& came) {
  WindowsQuestion question = asked;
  question.tasks = {decision.task};
  if (!decision.turbine.empty()) question.turbines = {decision.turbine};
  question.water = water_of(came, {});
  question.waves_as_forecast = question.chances_as_futures_say = question.is_over = true;
  question.from = decision.start;
  // Visits are made until midnight.
  question.to = std::min(UtcTime(day_of(decision.start)) + std::chrono::days(1), came->time.back());
  question.threads = 1;
  return question;
}

}  // namespace

WhatCame what_came_of_start(const WindowsQuestion& asked, const store::DecisionRow& decision,
                            const ForecastAndCame& forecast,
                            const std::filesystem::path& store_folder) {
  if (forecast.forecast == nullptr) return cannot_be_known(forecast.fault);
  const Snapshot& said = *forecast.forecast;
  if (forecast.came == nullptr) return not_known(decision, said, UtcTime::min());
  const UtcTime to = forecast.came->time.back();
  if (to <= decision.start || (decision.work && to < decision.start + *decision.work))
    return not_known(decision, said, to);
  TaskWindows task;
  const WindowsQuestion question = question_about(asked, decision, forecast.came);
  const auto failure = attempt([&] { task = windows_of(question, store_folder).tasks.front(); });
  if (failure) {
    // The work, or the vessel's way home, may just be longer than what is known so far.
    const bool may_be_longer = to < said.time.back();
    return may_be_longer && failure->kind == ErrorKind::invalid_input
               ? not_known(decision, said, to)
               : cannot_be_known(failure->why);
  }
  if (task.starts.empty() || task.starts.front().start != decision.start)
    return cannot_be_known(
        "the vessel's way out began before the hours of the forecast that it was "
        "decided on (" +
        format_utc(said.time.front()) + ")");
  const TaskStart& start = task.starts.front();
  const bool has_held = start.chance.held > 0;
  const bool is_day_known = to >= UtcTime(day_of(decision.start)) + std::chrono::days(1);
  // Visits that nobody knows of yet are not visits that failed.
  if (task.is_split && !has_held && !is_day_known) return not_known(decision, said, to);
  WhatCame what;
  what.came = has_held ? Came::held : Came::did_not_hold;
  what.not_checked = task.not_checked;
  if (has_held) return what;
  if (!start.forbidden.empty()) {
    what.broken = start.forbidden;
  } else if (start.chance.binding && start.chance.binding->is_exceeded) {
    const TaskLimit& limit = task.limits[start.chance.binding->limit];
    what.broken = text_of(limit);
    what.broken_at = start.binds_at;
  }
  return what;
}

}  // namespace slackwater::api
