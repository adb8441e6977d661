#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/ask/windows/as_told.h"
#include "api/ask/windows/vessel_access.h"
#include "api/ask/windows/worth.h"
#include "api/show/rehearse/rehearsal_json.h"
#include "api/show/rehearse/risk_report.h"
#include "api/show/windows/past_words.h"
#include "api/show/windows/windows_answer.h"
#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// Numbers that are none are null.
json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return as_told(value);
}

constexpr double degree = constants::degree;

json table_json(const twin::Limit& limit) {
  if (!limit.table) return nullptr;
  const twin::HeightTable& table = *limit.table;
  json angles = json::array(), rows = json::array();
  for (const double rad : table.off_bow_rad) angles.push_back(number(rad / degree));
  const std::size_t periods = std::max<std::size_t>(1, table.peak_period_s.size());
  for (std::size_t i = 0; i < table.at_most_m.size(); ++i) {
    if (i % periods == 0) rows.push_back(json::array());
    rows.back().push_back(number(table.at_most_m[i]));
  }
  return {{"peak_period_s", table.peak_period_s},
          {"from_bow_deg", angles},
          {"heading_deg", table.heading_rad ? number(*table.heading_rad / degree) : json(nullptr)},
          {"at_most", rows}};
}

/// Of a limit with a table what it was at the binding step.
json bound_then_json(const TaskWindows& task, const TaskStart& start) {
  if (!start.bound_then) return nullptr;
  const twin::HeightBound& bound = *start.bound_then;
  return {{"at_most", number(bound.at_most_m)},
          {"unit", "m"},
          {"peak_period_s", bound.peak_period_s ? number(*bound.peak_period_s) : json(nullptr)},
          {"from_bow_deg", bound.off_bow_rad ? number(*bound.off_bow_rad / degree) : json(nullptr)},
          {"text", bound_then_text(task, start)}};
}

json limit_json(const TaskLimit& of) {
  json out{{"worker", of.worker.empty() ? json(nullptr) : json(of.worker)},
           {"limit", of.text},
           {"variable", nullptr},
           {"bound", nullptr},
           {"table", nullptr},
           {"unit", ""},
           {"phases", json::array()},
           {"source", ""},
           {"status", ""}};
  if (!of.limit) return out;
  const twin::LimitWord& word = twin::word_of(of.limit->variable);
  out["variable"] = word.key;
  // One number is not what counts where there is a table.
  if (!of.limit->table) out["bound"] = number(of.limit->bound);
  out["table"] = table_json(*of.limit);
  out["unit"] = word.unit;
  for (std::size_t p = 0; p < twin::phase_count; ++p)
    if (const auto phase = static_cast<twin::Phase>(p); of.limit->phases.has(phase))
      out["phases"].push_back(twin::name_of(phase));
  out["source"] = of.limit->source;
  out["status"] = of.limit->status;
  return out;
}

json binding_json(const TaskWindows& task, const TaskStart& start) {
  if (!start.chance.binding) return nullptr;
  const twin::BindingLimit& binding = *start.chance.binding;
  const TaskLimit& limit = task.limits[binding.limit];
  return {{"index", binding.limit},
          {"worker", limit.worker.empty() ? json(nullptr) : json(limit.worker)},
          {"limit", limit.text},
          {"exceeded", binding.is_exceeded},
          {"futures", binding.members},
          {"time", format_utc(*start.binds_at)},
          {"share", number(binding.share)},
          {"bound_then", bound_then_json(task, start)}};
}

json count_json(const FlightCount& count) {
  return {{"flights", count.flights},
          {"probability", number(count.share())},
          {"interval_95", {number(count.low), number(count.high)}}};
}

json twin_json(const std::optional<TwinChance>& twin) {
  if (!twin) return nullptr;
  return {{"probability", number(twin->probability)},
          {"interval_95", {number(twin->interval.low), number(twin->interval.high)}},
          {"flights", twin->flights},
          {"p_done", count_json(twin->p_done)},
          {"p_seen", twin->p_seen ? count_json(*twin->p_seen) : json(nullptr)},
          {"stopped_by", twin->stopped_by.empty() ? json(nullptr) : json(twin->stopped_by)},
          {"duration_s", quantiles_json(twin->duration_s)},
          {"energy_wh", quantiles_json(twin->energy_wh)},
          {"risks", risks_json(twin->risks)}};
}

json start_json(const TaskWindows& task, const TaskStart& start) {
  return {{"start", format_utc(start.start)},
          {"probability", number(start.probability)},
          {"probability_by_futures", number(start.by_futures)},
          {"worth", number(start.worth)},
          {"interval_95", {number(start.interval.low), number(start.interval.high)}},
          {"futures_held", start.chance.held},
          {"futures", task.futures},
          {"threshold", start.chance.by_threshold},
          {"alpha", start.chance.by_alpha ? json(*start.chance.by_alpha) : json(nullptr)},
          {"forbidden", start.forbidden.empty() ? json(nullptr) : json(start.forbidden)},
          {"unforecast", start.unforecast.empty() ? json(nullptr) : json(start.unforecast)},
          {"binding", binding_json(task, start)},
          {"twin", twin_json(start.twin)}};
}

json windows_json(const TaskWindows& task, const std::vector<twin::StartWindow>& windows) {
  json list = json::array();
  for (const twin::StartWindow& window : windows)
    list.push_back({{"from", format_utc(task.starts[window.first].start)},
                    {"to", format_utc(task.starts[window.last].start)},
                    {"starts", window.starts()},
                    {"probability",
                     {{"min", number(window.least)},
                      {"mean", number(window.mean)},
                      {"max", number(window.most)}}},
                    {"best", format_utc(task.starts[window.best].start)},
                    {"threshold_starts", window.by_threshold},
                    {"alpha_starts", task.by_alpha ? json(window.by_alpha) : json(nullptr)}});
  return list;
}

json phases_json(const TaskWindows& task) {
  json list = json::array();
  for (const WorkerPlan& worker : task.workers) {
    double from_s = 0;
    for (const twin::PlannedPhase& phase : worker.plan.phases) {
      list.push_back({{"worker", worker.name},
                      {"phase", twin::name_of(phase.phase)},
                      {"from_min", number(from_s / 60)},
                      {"to_min", number((from_s + phase.duration_s) / 60)}});
      from_s += phase.duration_s;
    }
  }
  return list;
}

json task_json(const TaskWindows& task) {
  json limits = json::array();
  for (const TaskLimit& limit : task.limits) limits.push_back(limit_json(limit));
  json starts = json::array();
  for (const TaskStart& start : task.starts) starts.push_back(start_json(task, start));
  const TaskStart* best = best_of(task);
  json out{{"task", task.id},
           {"name", task.name},
           {"turbines", task.turbines},
           {"verdict", twin::name_of(task.verdict)},
           {"duration_h", number(task.planned_s / 3600)},
           {"contingency_h", number(task.contingency_s / 3600)},
           {"split", task.is_split ? json{{"least_visit_h", number(task.least_visit_s / 3600)}}
                                   : json(nullptr)},
           {"phases", phases_json(task)},
           {"limits", limits},
           {"not_checked", task.not_checked},
           {"assumed", task.assumed},
           {"notes", task.notes},
           {"best", best != nullptr ? json{{"start", format_utc(best->start)}} : json(nullptr)},
           {"windows", windows_json(task, task.windows)},
           {"windows_by_threshold", windows_json(task, task.by_threshold)},
           {"windows_by_alpha", task.by_alpha ? windows_json(task, *task.by_alpha) : json(nullptr)},
           {"no_alpha", task.no_alpha.empty() ? json(nullptr) : json(task.no_alpha)},
           {"past", past_json(task)},
           {"starts", starts}};
  // As the plan of a day reads it.
  if (task.turbines.size() == 1) out["turbine"] = task.turbines.front();
  return out;
}

}  // namespace

json left_out_json(const std::vector<TaskLeftOut>& left_out) {
  json list = json::array();
  for (const TaskLeftOut& one : left_out) list.push_back({{"task", one.task}, {"why", one.why}});
  return list;
}

namespace {

json access_json(const WindowsAnswer& answer) {
  if (answer.vessel == nullptr) return nullptr;
  return {{"vessel", answer.vessel->name},
          {"passage_min", number(60 * hours_of(answer.vessel->passage))},
          {"transfer_min", number(60 * hours_of(answer.vessel->transfer))}};
}

}  // namespace

json windows_json(const WindowsQuestion& question, const WindowsAnswer& answer) {
  const Snapshot& forecast = answer.water.surround.field->snapshot();
  const std::size_t members = question.members > 0 ? question.members : forecast.members;
  json tasks = json::array();
  for (const TaskWindows& task : answer.tasks) tasks.push_back(task_json(task));
  return {
      {"site", answer.site_id},
      {"site_name", answer.site_name},
      {"forecast",
       {{"name", answer.water.forecast_name},
        {"sha256", answer.water.forecast_sha256},
        {"day", format_day(forecast.day)},
        {"issued", format_utc(forecast.issued)},
        {"degraded", forecast.degraded},
        {"hindsight", forecast.hindsight}}},
      {"day", format_day(day_of(answer.from))},
      {"from", format_utc(answer.from)},
      {"to", format_utc(answer.to)},
      {"every_min", number(std::chrono::duration<double, std::ratio<60>>(question.every).count())},
      {"timezone", question.zone ? json(question.zone->name()) : json(nullptr)},
      {"members", members},
      {"members_issued", answer.water.members_issued},
      {"waves", question.waves_as_forecast ? "as forecast in all futures"
                                           : "with the error of the forecast's heights"},
      {"access", access_json(answer)},
      {"rules",
       {{"go", number(question.rule.go)},
        {"marginal", number(question.rule.marginal)},
        {"alpha", question.practice.name()},
        {"alpha_source", question.practice.source()},
        {"alpha_period_from", question.period_from_start ? "start" : "issue"}}},
      {"verdict", twin::name_of(answer.verdict)},
      {"tasks", tasks},
      {"left_out", left_out_json(answer.left_out)},
      {"notes", answer.notes}};
}

}  // namespace slackwater::api
