#include "api/windows/task_windows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "api/rehearse/rehearsal_json.h"
#include "api/rehearse/zones.h"
#include "api/windows/task_sheet.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/mission/site_work.h"
#include "twin/rehearse/expect_fit.h"
#include "twin/rehearse/limit_ahead.h"
#include "twin/rehearse/planned_work.h"
#include "twin/simulate/conduct.h"

namespace slackwater::api {
namespace {

/// The grid is as fine as this or finer.
constexpr auto longest_step = std::chrono::minutes(10);

std::string yaml_list(const std::vector<std::string>& values) {
  std::vector<std::string> quoted;
  for (const std::string& value : values) quoted.push_back(quoted_yaml(value));
  return "[" + joined(quoted, ", ") + "]";
}

/// @param more  of its YAML
LoadedMission mission_of(const WindowsQuestion& question, const std::string& task,
                         const std::vector<std::string>& turbines, const std::string& more,
                         const std::filesystem::path& store_folder) {
  const std::string yaml = "name: windows\nsite: " + quoted_yaml(question.site) +
                           "\ntasks: " + yaml_list({task}) + "\nturbines: " + yaml_list(turbines) +
                           "\nstep_s: 0.05\n" + more;
  return lay_out_mission(Config::parse(yaml, "its mission"), std::filesystem::current_path(),
                         "its mission", store_folder, question.assumed);
}

LoadedMission laid_out_at(const SharedOutlook& outlook, const WindowsQuestion& question,
                          const std::string& task, const std::vector<std::string>& turbines) {
  LoadedMission mission =
      mission_of(question, task, turbines, "duration: 30d\nseed: 1\nwaves: {components: 8}\n",
                 outlook.store_folder);
  // It is not flown, and what set_up asks of the forecast is its first minute.
  mission.scenario.duration_s = 60;
  return mission;
}

/// At the turbines that were asked for, else at the first at which there is such work.
LoadedMission laid_out(const SharedOutlook& outlook, const WindowsQuestion& question,
                       const std::string& task) {
  if (!question.turbines.empty() || outlook.site->turbines.empty())
    return laid_out_at(outlook, question, task, question.turbines);
  std::optional<Error> first;
  for (const TurbinePlace& turbine : outlook.site->turbines) {
    try {
      return laid_out_at(outlook, question, task, {turbine.id});
    } catch (const Error& problem) {
      if (!first) first = problem;
    }
  }
  throw Error(*first);
}

/// Everything of one task that the chances are worked out from.
struct Outlook {
  LoadedMission mission;
  twin::ReadyRun ready;
  StepClock clock;
  twin::StartSteps starts;
  twin::StartQuestion question;
  std::vector<twin::LimitAhead> ahead;
  std::vector<std::vector<double>> gates;
};

double hours_of(double seconds) { return seconds / 3600; }

std::string hours_text(double seconds) { return formatted("{:.1f} h", hours_of(seconds)); }

/// Phases, planned time and contingency of every worker.
void plan_work(const WindowsQuestion& question, const TaskSheet& sheet, const Outlook& outlook,
               TaskWindows& out) {
  for (std::size_t i = 0; i < outlook.ready.agents.size(); ++i) {
    const twin::Agent& agent = outlook.ready.agents[i];
    out.workers.push_back(
        {agent.name,
         twin::plan_of(outlook.ready.states[i].vehicle.body.position_m, agent.mission)});
  }
  out.planned_s = 3600 * sheet.planned_h(out.turbines.size()).value_or(0);
  for (const WorkerPlan& worker : out.workers)
    out.planned_s = std::max(out.planned_s, worker.plan.duration_s());
  for (WorkerPlan& worker : out.workers)
    worker.plan = twin::stretched(std::move(worker.plan), out.planned_s);
  out.contingency_s = question.contingency
                          ? std::chrono::duration<double>(*question.contingency).count()
                          : 3600 * sheet.contingency_h();
}

/// The grid of the starts, as many as the forecast holds from beginning to end.
void lay_grid(const WindowsQuestion& question, const SharedOutlook& shared, Outlook& outlook,
              TaskWindows& out) {
  const double needed_s = out.planned_s + out.contingency_s;
  const std::string takes = "takes " + hours_text(needed_s) + " with " +
                            hours_text(out.contingency_s) + " of contingency";
  if (shared.is_one_day && needed_s > 86400)
    throw Error(ErrorKind::invalid_input,
                takes +
                    ", which is longer than the day; ask for the hours of several days with "
                    "--from and --to, or for less with --contingency");
  const auto parts =
      std::max<Duration::rep>(1, (question.every.count() + Duration(longest_step).count() - 1) /
                                     Duration(longest_step).count());
  const Duration step = question.every / parts;
  const double step_s = std::chrono::duration<double>(step).count();
  const auto needed = static_cast<std::size_t>(std::ceil(needed_s / step_s - 1e-6));
  const UtcTime end = shared.water->surround.field->range().to;
  std::size_t fitting = 0, asked = 0;
  for (UtcTime start = shared.from; start < shared.to; start += question.every) {
    ++asked;
    if (start + step * static_cast<Duration::rep>(needed) <= end) ++fitting;
  }
  if (fitting == 0)
    throw Error(ErrorKind::invalid_input,
                takes + "; begun at " + format_utc(shared.from) +
                    " it ends after the forecast, "
                    "which ends at " +
                    format_utc(end) + "; move --from, or take a forecast with a longer --horizon");
  outlook.starts = {0, static_cast<std::size_t>(parts), fitting};
  outlook.clock = {shared.from, step,
                   outlook.starts.step_of(fitting - 1) + std::max<std::size_t>(needed, 1)};
  if (fitting < asked)
    out.notes.push_back(
        formatted("{} starts after {} are left out: they end after the forecast", asked - fitting,
                  format_utc(outlook.clock.time_of(outlook.starts.step_of(fitting - 1)))));
}

LimitText text_of_limit(const std::string& worker, const twin::Limit& limit) {
  LimitText text;
  text.worker = worker;
  text.text = twin::text_of(limit);
  for (std::size_t p = 0; p < twin::phase_count; ++p)
    if (const auto phase = static_cast<twin::Phase>(p); limit.phases.has(phase))
      text.phases.emplace_back(twin::name_of(phase));
  const twin::LimitWord& word = twin::word_of(limit.variable);
  text.bound = limit.bound;
  text.unit = word.unit;
  text.variable = word.key;
  text.source = limit.source;
  text.status = limit.status;
  return text;
}

bool is_unknown(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
}

/// Factors by start, each period rounded up to the hour; empty where practice has none for such
/// limits.
std::vector<double> factors_of(const WindowsQuestion& question, const Outlook& outlook,
                               UtcTime issued, const twin::Limit& limit, const TaskWindows& task,
                               std::string& why) {
  std::vector<double> factors;
  std::map<double, twin::AlphaFactor> known;
  for (std::size_t s = 0; s < outlook.starts.count; ++s) {
    const UtcTime start = outlook.clock.time_of(outlook.starts.step_of(s));
    const double waits_h =
        question.period_from_start ? 0 : std::max(0.0, hours_between(issued, start));
    const double period_h = std::ceil(waits_h + hours_of(task.planned_s) - 1e-9);
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
  const UtcTime issued = shared.water->surround.field->snapshot().issued;
  std::set<std::string> not_checked;
  for (std::size_t a = 0; a < outlook.ready.agents.size(); ++a) {
    const twin::Agent& agent = outlook.ready.agents[a];
    if (!agent.conduct) continue;
    const std::size_t before = out.limits.size();
    for (const twin::Limit& limit : agent.conduct->plan.limits) {
      out.limits.push_back(text_of_limit(agent.name, limit));
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
      watched.when = twin::steps_of(out.workers[a].plan, phase, out.contingency_s, step_s);
      if (watched.when.empty()) continue;
      watched.alpha = factors_of(question, outlook, issued, limit, out, out.no_alpha);
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
  const double step_s = std::chrono::duration<double>(outlook.clock.step).count();
  watched.when = {{0, static_cast<std::size_t>(
                          std::ceil((out.planned_s + out.contingency_s) / step_s - 1e-6))}};
  // The values move with the vector that holds them, their place does not.
  watched.members.emplace_back(outlook.gates.back());
  outlook.question.watched.push_back(std::move(watched));
  LimitText limit;
  limit.text = text;
  out.limits.push_back(std::move(limit));
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

/// The chances in order, zones laid over them.
void add_starts(const WindowsQuestion& question, Outlook& outlook, TaskWindows& out) {
  outlook.question.steps = outlook.clock.steps;
  outlook.question.limits = out.limits.size();
  outlook.question.starts = outlook.starts;
  const std::vector<twin::StartChance> chances = twin::start_chances(outlook.question);
  std::map<std::size_t, twin::SuccessInterval> intervals;
  outlook.mission.scenario.duration_s = out.planned_s + out.contingency_s;
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
      start.probability = twin::next_success(held, outlook.question.members);
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
    return twin::next_success(chance.held, outlook.question.members) >= question.rule.marginal;
  });
  out.by_threshold = windows([](const auto& chance) { return chance.by_threshold; });
  const bool has_practice = std::any_of(out.starts.begin(), out.starts.end(), [](const auto& one) {
    return one.chance.by_alpha.has_value();
  });
  if (has_practice)
    out.by_alpha = windows([](const auto& chance) { return chance.by_alpha.value_or(false); });
  else if (out.no_alpha.empty())
    out.no_alpha = "it has no factor for any of the limits";
  const TaskStart* best = best_of(out);
  out.verdict = twin::verdict_of(best == nullptr ? 0 : best->probability, question.rule);
}

}  // namespace

LoadedMission mission_to_fly(const WindowsQuestion& question, const TaskWindows& task,
                             std::uint64_t seed, std::size_t wave_components,
                             const std::filesystem::path& store_folder) {
  const double minutes = std::ceil((task.planned_s + task.contingency_s) / 60);
  return mission_of(question, task.id, task.turbines,
                    formatted("duration: {:.0f}min\nseed: {}\nwaves: {{components: {}}}\ngusts: "
                              "dryden\n",
                              minutes, seed & 0x7fffffff, wave_components),
                    store_folder);
}

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
    lay_grid(question, shared, outlook, out);
    watch_limits(question, shared, outlook, out);
    add_gates(question, shared, sheet, outlook, out);
    out.assumed = unchecked_of(outlook.mission.scenario).assumed;
    add_starts(question, outlook, out);
    return out;
  });
}

}  // namespace slackwater::api
