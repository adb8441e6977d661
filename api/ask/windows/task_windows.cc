#include "api/ask/windows/task_windows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "api/ask/rehearse/unchecked.h"
#include "api/ask/rehearse/zones.h"
#include "api/ask/windows/relief.h"
#include "api/ask/windows/task_outlook.h"
#include "api/ask/windows/worth.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/agent/conduct.h"
#include "twin/mission/site_work.h"
#include "twin/rehearse/expect_fit.h"

namespace slackwater::api {
namespace {

bool is_unknown(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
}

/// Factors by start, each period rounded up to the hour; empty where practice has none for such
/// limits.
std::vector<double> factors_of(const WindowsQuestion& question, const SharedOutlook& shared,
                               const Outlook& outlook, const twin::Limit& limit,
                               const TaskWindows& task, std::string& why) {
  const UtcTime issued = shared.water->surround.field->snapshot().issued;
  std::vector<double> factors;
  std::map<double, twin::AlphaFactor> known;
  for (std::size_t s = 0; s < outlook.starts.count; ++s) {
    const UtcTime start = outlook.clock.time_of(outlook.starts.step_of(s));
    const double waits_h =
        question.period_from_start ? 0 : std::max(0.0, hours_between(issued, start));
    const UtcTime visits_from = question.period_from_start ? shared.from : issued;
    const double period_h = std::ceil(
        (task.is_split ? hours_between(visits_from, shared.to) : waits_h + task.planned_s / 3600) -
        1e-9);
    if (!known.contains(period_h)) {
      const auto factor = question.practice.at(limit, period_h);
      if (!factor) return {};
      known[period_h] = *factor;
    }
    const twin::AlphaFactor& factor = known[period_h];
    if (!factor.value && why.empty()) why = factor.why;
    factors.push_back(factor.value.value_or(std::nan("")));
  }
  return factors;
}

/// The limits of every worker, at the steps of the phases that they name.
void watch_limits(const WindowsQuestion& question, const SharedOutlook& shared, Outlook& outlook,
                  TaskWindows& out) {
  const double step_s = std::chrono::duration<double>(outlook.clock.step).count();
  std::set<std::string> not_checked;
  for (std::size_t a = 0; a < outlook.ready.agents.size(); ++a) {
    const twin::Agent& agent = outlook.ready.agents[a];
    if (!agent.conduct) continue;
    const std::size_t before = out.limits.size();
    for (const twin::Limit& limit : agent.conduct->plan.limits) {
      out.limits.push_back({agent.name, twin::text_of(limit), limit});
      if (twin::only_a_run_shows(limit.variable))
        not_checked.insert(agent.name + ": " + twin::text_of(limit) + " (only a run shows it)");
    }
    for (twin::LimitAhead& ahead :
         twin::limits_ahead(outlook.ready, a, outlook.clock, shared.members, shared.waves)) {
      const twin::Limit& limit = agent.conduct->plan.limits[ahead.limit];
      twin::PhaseSet phase;
      phase.bits = 0;
      phase.add(ahead.phase);
      twin::WatchedLimit watched;
      watched.limit = before + ahead.limit;
      watched.bound = {limit.is_least ? twin::BoundSide::at_least : twin::BoundSide::at_most,
                       limit.bound};
      watched.may_be_missing = limit.may_be_missing;
      // Half of a level that counts from mean sea level is no half of anything.
      watched.is_gate = limit.variable == twin::LimitVariable::sea_surface_height;
      watched.when = twin::steps_of(out.workers[a].plan, phase, out.contingency_s, step_s);
      if (watched.when.empty()) continue;
      if (out.is_split) watched.when = whole_stay(outlook, out);
      watched.alpha = factors_of(question, shared, outlook, limit, out, out.no_alpha);
      if (limit.may_be_missing &&
          std::any_of(ahead.members.begin(), ahead.members.end(), is_unknown))
        not_checked.insert(agent.name + ": " + twin::text_of(limit));
      outlook.ahead.push_back(std::move(ahead));
      outlook.question.watched.push_back(std::move(watched));
    }
  }
  for (std::size_t i = 0; i < outlook.ahead.size(); ++i)
    for (const std::vector<double>& values : outlook.ahead[i].members)
      outlook.question.watched[i].members.emplace_back(values);
  out.not_checked.assign(not_checked.begin(), not_checked.end());
}

/// Hours that are open to the whole of a task, or shut.
void add_gate(const std::string& text, const twin::StepRanges& open, Outlook& outlook,
              TaskWindows& out) {
  std::vector<double> values(outlook.clock.steps, 0);
  for (const twin::StepRange& range : open)
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(range.begin),
              values.begin() + static_cast<std::ptrdiff_t>(range.end), 1);
  outlook.gates.push_back(std::move(values));
  twin::WatchedLimit watched;
  watched.limit = out.limits.size();
  watched.bound = {twin::BoundSide::at_least, 1};
  watched.is_gate = true;
  watched.when = whole_stay(outlook, out);
  // The values move with the vector that holds them, their place does not.
  watched.members.emplace_back(outlook.gates.back());
  outlook.question.watched.push_back(std::move(watched));
  out.limits.push_back({{}, text, {}});
}

/// Polar days and nights are told.
void note_light(const SharedOutlook& shared, const WindowsQuestion& question, twin::Light light,
                TaskWindows& out) {
  const auto day = twin::light_of(shared.site->point, day_of(shared.from), light, question.zone);
  if (day.kind == twin::DayOfLight::Kind::comes_and_goes) return;
  out.notes.push_back("daylight (" + std::string(twin::name_of(light)) + ") at " +
                      formatted("{:.1f}", shared.site->point.latitude_deg()) +
                      " degrees north on " + format_day(day_of(shared.from)) + ": " +
                      twin::text_of(day, question.zone));
}

void add_gates(const WindowsQuestion& question, const SharedOutlook& shared, const TaskSheet& sheet,
               Outlook& outlook, TaskWindows& out) {
  std::set<twin::Light> lights;
  if (question.light) lights.insert(*question.light);
  if (sheet.daylight) lights.insert(*sheet.daylight);
  outlook.gates.reserve(lights.size() + 1);
  for (const twin::Light light : lights) {
    add_gate("daylight (" + std::string(twin::name_of(light)) + ")",
             twin::light_steps(outlook.clock, shared.site->point, light), outlook, out);
    note_light(shared, question, light, out);
  }
  if (question.shift)
    add_gate("shift " + twin::text_of(*question.shift) + " " +
                 (question.zone ? question.zone->name() : "UTC"),
             twin::steps_at(outlook.clock, *question.shift, question.zone), outlook, out);
}

/// What stops a start of split work from which there is too little time left.
void add_too_little_time(const SharedOutlook& shared, Outlook& outlook, TaskWindows& out) {
  if (!outlook.question.split) return;
  outlook.question.split->limit = out.limits.size();
  out.limits.push_back({{}, "hours enough for the work by " + format_utc(shared.to), {}});
}

/// The chances in order, zones laid over them.
void add_starts(const WindowsQuestion& question, Outlook& outlook, TaskWindows& out) {
  outlook.question.steps = outlook.clock.steps;
  outlook.question.limits = out.limits.size();
  outlook.question.starts = outlook.starts;
  const std::vector<twin::StartChance> chances = twin::start_chances(outlook.question);
  std::map<std::size_t, twin::SuccessInterval> intervals;
  outlook.mission.scenario.duration_s =
      out.is_split ? out.least_visit_s : out.planned_s + out.contingency_s;
  for (std::size_t s = 0; s < chances.size(); ++s) {
    TaskStart start;
    start.start = outlook.clock.time_of(outlook.starts.step_of(s));
    start.chance = chances[s];
    start.forbidden = zone_in_the_way(outlook.mission, start.start);
    if (!start.forbidden.empty()) {
      start.chance.by_threshold = false;
      if (start.chance.by_alpha) start.chance.by_alpha = false;
      start.chance.held = 0;
      start.chance.binding.reset();
      start.probability = 0;
      start.interval = {0, 0};
    } else {
      const std::size_t held = start.chance.held;
      if (!intervals.contains(held))
        intervals[held] = twin::success_interval(held, outlook.question.members);
      start.interval = intervals[held];
      start.probability = twin::next_success(held, outlook.question.members, twin::any_chance);
      start.worth = start.probability;
    }
    if (start.chance.binding) start.binds_at = outlook.clock.time_of(start.chance.binding->step);
    out.starts.push_back(std::move(start));
  }
  const auto windows = [&](auto is_open) {
    std::vector<std::uint8_t> marks;
    std::vector<twin::StartChance> all;
    for (const TaskStart& start : out.starts) {
      marks.push_back(is_open(start.chance) ? 1 : 0);
      all.push_back(start.chance);
    }
    return twin::windows_of(all, marks, outlook.question.members);
  };
  out.windows = windows([&](const auto& chance) {
    return twin::next_success(chance.held, outlook.question.members, twin::any_chance) >=
           question.rule.marginal;
  });
  out.by_threshold = windows([](const auto& chance) { return chance.by_threshold; });
  const bool has_practice = std::any_of(out.starts.begin(), out.starts.end(), [](const auto& one) {
    return one.chance.by_alpha.has_value();
  });
  if (has_practice)
    out.by_alpha = windows([](const auto& chance) { return chance.by_alpha.value_or(false); });
  else if (out.no_alpha.empty())
    out.no_alpha = "the table has no factor for any limit of this task";
  const TaskStart* best = best_of(out);
  out.verdict = twin::verdict_of(best == nullptr ? 0 : best->worth, question.rule);
}

}  // namespace

TaskWindows task_windows(const WindowsQuestion& question, const SharedOutlook& shared,
                         const std::string& task) {
  return with_context("task " + task, [&] {
    TaskWindows out;
    out.id = task;
    const TaskSheet sheet = read_task_sheet(load_task(task, std::filesystem::current_path()),
                                            twin::work_site_of(*shared.site));
    out.name = sheet.name;
    Outlook outlook;
    outlook.mission = laid_out(shared, question, task);
    out.turbines = outlook.mission.expanded.turbines;
    twin::Scenario scenario = outlook.mission.scenario;
    scenario.start = shared.from;
    outlook.ready = twin::set_up(scenario, shared.water->surround);
    twin::expect_fit(outlook.mission.expanded, outlook.ready);
    outlook.question.members = shared.members;
    plan_work(question, sheet, outlook, out);
    lay_grid(question, shared, sheet, outlook, out);
    watch_limits(question, shared, outlook, out);
    add_gates(question, shared, sheet, outlook, out);
    add_too_little_time(shared, outlook, out);
    out.assumed = unchecked_of(outlook.mission.scenario).assumed;
    add_starts(question, outlook, out);
    if (out.verdict != twin::Verdict::go) out.reliefs = reliefs_of(outlook, out);
    return out;
  });
}

}  // namespace slackwater::api
