#include "api/show/morning/morning_json.h"

#include <nlohmann/json.hpp>

#include "api/ask/morning/recent_skill.h"
#include "api/ask/windows/worth.h"
#include "api/show/decisions/decisions_json.h"
#include "api/show/morning/morning_text.h"
#include "api/show/plan/plan_json.h"
#include "api/show/rehearse/advice_report.h"
#include "api/show/windows/past_words.h"
#include "api/show/windows/windows_answer.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

std::string utc(UtcTime time) { return format_utc(time); }

json best_json(const TaskWindows& task) {
  const TaskStart* best = best_of(task);
  if (best == nullptr) return nullptr;
  json out{{"start", utc(best->start)},
           {"probability", best->probability},
           {"worth", best->worth},
           {"interval_95", {best->interval.low, best->interval.high}},
           {"stopped_by", stopping_text(task, *best, utc)},
           {"flown", nullptr}};
  if (best->twin)
    out["flown"] = {
        {"probability", best->twin->probability},
        {"interval_95", {best->twin->interval.low, best->twin->interval.high}},
        {"flights", best->twin->flights},
        {"done", best->twin->p_done.flights},
        {"seen", best->twin->p_seen ? json(best->twin->p_seen->flights) : json(nullptr)},
        {"stopped_by",
         best->twin->stopped_by.empty() ? json(nullptr) : json(best->twin->stopped_by)}};
  return out;
}

/// What would change the answer of a task that is not a go; null of a go.
json help_json(const TaskWindows& task) {
  if (task.verdict == twin::Verdict::go) return nullptr;
  json limits = json::array();
  for (const Relief& relief : task.reliefs) {
    const TaskLimit& limit = task.limits[relief.limit];
    limits.push_back({{"without", limit.text},
                      {"worker", limit.worker.empty() ? json(nullptr) : json(limit.worker)},
                      {"start", utc(relief.start)},
                      {"probability", relief.probability}});
  }
  json flown = nullptr;
  if (task.advice)
    flown = {{"start", utc(task.advice->start)}, {"changes", advice_json(task.advice->changes)}};
  return {{"limits", limits}, {"flown", flown}};
}

json task_json(const Morning& morning, const TaskWindows& task) {
  json windows = json::array();
  for (const WorthRun& run : runs_of_worth(task, morning.question.windows.rule.marginal, 2))
    windows.push_back({{"from", utc(task.starts[run.first].start)},
                       {"to", utc(task.starts[run.last].start)},
                       {"worth", {{"min", run.least}, {"max", run.most}}}});
  return {{"task", task.id},
          {"name", task.name},
          {"turbines", task.turbines},
          {"verdict", twin::name_of(task.verdict)},
          {"best", best_json(task)},
          {"past", past_json(task)},
          {"windows", windows},
          {"would_help", help_json(task)},
          {"not_checked", task.not_checked},
          {"assumed", task.assumed}};
}

json trust_json(const std::vector<calibration::SkillEntry>& past, WindPolicy wind) {
  json out = json::array();
  for (const RecentSkill& of : trust_of(past, wind)) {
    const auto& best = of.verdict.best;
    out.push_back({{"variable", of.variable},
                   {"unit", of.unit},
                   {"forecasts", best ? best->pairs : of.verdict.forecast.score.pairs},
                   {"rmse", best ? best->forecast_rmse : of.verdict.forecast.score.rmse},
                   {"outcome", name_of(of.verdict.outcome)},
                   {"best_rival", best ? json(name_of(best->method)) : json(nullptr)},
                   {"rival_rmse", best ? json(best->rmse) : json(nullptr)}});
  }
  return out;
}

json today_json(const Morning& morning) {
  if (!morning.today) return nullptr;
  const Morning today = today_of(morning);
  json tasks = json::array();
  for (const TaskWindows& task : today.windows.tasks) tasks.push_back(task_json(today, task));
  return {{"from", utc(today.windows.from)},
          {"to", utc(today.windows.to)},
          {"verdict", twin::name_of(today.windows.verdict)},
          {"headline", headline_of(today)},
          {"tasks", tasks},
          {"left_out", left_out_json(today.windows.left_out)}};
}

/// Of the days that the morning speaks of, and the record; null where there are none.
json decisions_of_morning(const Morning& morning) {
  if (!morning.decisions) return nullptr;
  json of_the_day = json::array();
  for (const auto& [task, decisions] : morning.decisions->by_task)
    for (const DecisionAnswer& one : decisions) of_the_day.push_back(decision_json(one));
  return {{"of_the_day", of_the_day},
          {"record_days", record_goes_back.count()},
          {"record", record_json(morning.decisions->record)}};
}

}  // namespace

json morning_json(const Morning& morning, const std::vector<calibration::SkillEntry>& past,
                  const std::string& verified) {
  const WindowsAnswer& windows = morning.windows;
  const Snapshot& forecast = windows.water.surround.field->snapshot();
  json tasks = json::array();
  for (const TaskWindows& task : windows.tasks) tasks.push_back(task_json(morning, task));
  json out{{"schema", "morning/1"},
           {"site", windows.site_id},
           {"site_name", windows.site_name},
           {"day", format_day(day_of(windows.from))},
           {"from", utc(windows.from)},
           {"to", utc(windows.to)},
           {"forecast",
            {{"name", windows.water.forecast_name},
             {"sha256", windows.water.forecast_sha256},
             {"issued", utc(forecast.issued)},
             {"degraded", forecast.degraded},
             {"headline", forecast.headline}}},
           {"futures", futures_of(morning)},
           {"verdict", twin::name_of(windows.verdict)},
           {"headline", headline_of(morning)},
           {"tasks", tasks},
           {"left_out", left_out_json(windows.left_out)},
           {"today", today_json(morning)},
           {"decisions", decisions_of_morning(morning)},
           {"plan", nullptr},
           {"no_plan", morning.no_plan.empty() ? json(nullptr) : json(morning.no_plan)},
           {"trust", trust_json(past, forecast.wind_policy.value_or(WindPolicy::best))},
           {"verified", verified},
           {"notes", windows.notes}};
  if (morning.plan) out["plan"] = plan_json(morning.plan->problem, morning.plan->answer);
  return out;
}

}  // namespace slackwater::api
