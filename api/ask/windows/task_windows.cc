#include "api/ask/windows/task_windows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "api/ask/rehearse/unchecked.h"
#include "api/ask/rehearse/zones.h"
#include "api/ask/windows/limits_of_task.h"
#include "api/ask/windows/past_outlook.h"
#include "api/ask/windows/relief.h"
#include "api/ask/windows/task_outlook.h"
#include "api/ask/windows/unforecast.h"
#include "api/ask/windows/vessel_access.h"
#include "api/ask/windows/worth.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/agent/conduct.h"
#include "twin/mission/site_work.h"
#include "twin/rehearse/expect_fit.h"

namespace slackwater::api {
namespace {

/// Of what infinitely many futures would say. Many waves beside few waters are no more than these.
twin::SuccessInterval interval_of(std::size_t held, const TaskWindows& task) {
  const double share = static_cast<double>(held) / static_cast<double>(task.futures);
  return twin::success_interval(
      static_cast<std::size_t>(std::lround(share * static_cast<double>(task.independent))),
      task.independent);
}

/// What nobody forecast of any start, told once.
void note_unforecast(TaskWindows& out) {
  std::set<std::string> told;
  for (const TaskStart& start : out.starts)
    if (!start.unforecast.empty() && told.insert(start.unforecast).second)
      out.notes.push_back("from " + format_utc(start.start) +
                          " on nobody forecast what it rests on: " + start.unforecast +
                          "; no such start is a go");
}

/// Whether it begins and ends within the working hours of one day.
bool is_by_day(UtcTime from, UtcTime to, const std::optional<TimeZone>& zone) {
  const auto local = [&](UtcTime time) { return zone ? time + zone->offset_at(time) : time; };
  const UtcTime midnight(day_of(local(from)));
  return local(from) - midnight >= std::chrono::hours(6) &&
         local(to) - midnight <= std::chrono::hours(18);
}

/// Why nobody can be there by then; empty: they can.
std::string left_too_early(const WindowsQuestion& question, const SharedOutlook& shared,
                           const TaskWindows& task, UtcTime start) {
  if (shared.vessel == nullptr || task.is_split || question.is_over) return {};
  const UtcTime leaves = start - shared.vessel->way();
  const UtcTime issued = shared.water->surround.field->snapshot().issued;
  if (leaves >= issued) return {};
  return "the vessel would have left port at " + format_utc(leaves) +
         ", before the forecast was issued";
}

/// Of a limit with a table the bound at the step at which it binds: of the places at which it is
/// watched then, the one where the central forecast takes up most.
std::optional<twin::HeightBound> bound_then(const Outlook& outlook, std::size_t start,
                                            const twin::BindingLimit& binding) {
  std::optional<twin::HeightBound> found;
  double most = -1;
  for (std::size_t i = 0; i < outlook.ahead.size(); ++i) {
    const twin::WatchedLimit& watched = outlook.question.watched[i];
    const std::size_t after = binding.step - (outlook.starts.step_of(start) - watched.before);
    const std::vector<twin::HeightBound>& by_sea = outlook.ahead[i].by_sea;
    if (watched.limit != binding.limit || binding.step >= by_sea.size()) continue;
    const bool counts =
        outlook.question.split ||
        std::any_of(watched.when.begin(), watched.when.end(), [&](const twin::StepRange& when) {
          return when.begin <= after && after < when.end;
        });
    const double share = watched.members.front()[binding.step];
    if (!counts || !(share > most || !found)) continue;
    most = share;
    found = by_sea[binding.step];
  }
  return found;
}

/// The chances in order, zones laid over them.
void add_starts(const WindowsQuestion& question, const SharedOutlook& shared, Outlook& outlook,
                TaskWindows& out) {
  const Snapshot& forecast = shared.water->surround.field->snapshot();
  const std::vector<twin::StartChance> chances = twin::start_chances(outlook.question);
  std::map<std::size_t, twin::SuccessInterval> intervals;
  outlook.mission.scenario.duration_s =
      out.is_split ? out.least_visit_s : out.planned_s + out.contingency_s;
  const Duration stay = std::chrono::round<Duration>(
      std::chrono::duration<double>(outlook.mission.scenario.duration_s));
  const Duration way = shared.vessel == nullptr ? Duration::zero() : shared.vessel->way();
  for (std::size_t s = 0; s < chances.size(); ++s) {
    TaskStart start;
    start.start = outlook.clock.time_of(outlook.starts.step_of(s));
    start.chance = chances[s];
    start.forbidden = zone_in_the_way(outlook.mission, start.start);
    if (start.forbidden.empty())
      start.forbidden = left_too_early(question, shared, out, start.start);
    if (!start.forbidden.empty()) {
      start.chance.by_threshold = false;
      if (start.chance.by_alpha) start.chance.by_alpha = false;
      start.chance.held = 0;
      start.chance.binding.reset();
      start.probability = 0;
      start.interval = {0, 0};
    } else {
      const std::size_t held = start.chance.held;
      if (!intervals.contains(held)) {
        const twin::SuccessInterval said = interval_of(held, out);
        intervals[held] = {out.calibration(said.low), out.calibration(said.high)};
      }
      start.interval = intervals[held];
      start.by_futures = twin::next_success(held, out.futures);
      start.probability = out.calibration(start.by_futures);
      start.unforecast = unforecast(forecast, out, start.start - way, start.start + stay + way);
      if (!start.unforecast.empty()) start.most_worth = most_worth_unforecast(question.rule);
      start.worth = std::min(start.probability, start.most_worth);
    }
    start.is_by_day = is_by_day(start.start, start.start + stay, question.zone);
    if (start.chance.binding) {
      start.binds_at = outlook.clock.time_of(start.chance.binding->step);
      start.bound_then = bound_then(outlook, s, *start.chance.binding);
    }
    out.starts.push_back(std::move(start));
  }
  const auto windows = [&](auto is_open) {
    std::vector<std::uint8_t> marks;
    std::vector<double> probability;
    std::vector<twin::StartChance> all;
    for (const TaskStart& start : out.starts) {
      marks.push_back(is_open(start) ? 1 : 0);
      probability.push_back(start.probability);
      all.push_back(start.chance);
    }
    return twin::windows_of(all, probability, marks);
  };
  out.windows =
      windows([&](const auto& start) { return start.probability >= question.rule.marginal; });
  out.by_threshold = windows([](const auto& start) { return start.chance.by_threshold; });
  const bool has_practice = std::any_of(out.starts.begin(), out.starts.end(), [](const auto& one) {
    return one.chance.by_alpha.has_value();
  });
  if (has_practice)
    out.by_alpha = windows([](const auto& start) { return start.chance.by_alpha.value_or(false); });
  else if (out.no_alpha.empty())
    out.no_alpha = "the table has no factor for any limit of this task";
  note_unforecast(out);
  const TaskStart* best = best_of(out);
  out.verdict = twin::verdict_of(best == nullptr ? 0 : best->worth, question.rule);
}

}  // namespace

TaskWindows task_windows(const WindowsQuestion& question, const SharedOutlook& shared,
                         const std::string& task) {
  return with_context("task " + task, [&] {
    TaskWindows out;
    out.id = task;
    out.rule = question.rule;
    Outlook outlook;
    outlook.mission = laid_out(shared, question, task);
    out.turbines = outlook.mission.expanded.turbines;
    const TaskSheet sheet = read_task_sheet(load_task(task, std::filesystem::current_path()),
                                            twin::work_site_of(*shared.site), out.turbines);
    out.name = sheet.name;
    twin::Scenario scenario = outlook.mission.scenario;
    scenario.start = shared.from;
    twin::Surround surround = shared.water->surround;
    surround.is_only_asked = true;
    outlook.ready = twin::set_up(scenario, surround);
    twin::expect_fit(outlook.mission.expanded, outlook.ready);
    plan_work(question, sheet, outlook, out);
    lay_grid(question, shared, sheet, outlook, out);
    look_back(question, shared, sheet, outlook, out);
    watch(question, shared, sheet, outlook, out);
    out.assumed = unchecked_of(outlook.mission.scenario).assumed;
    add_starts(question, shared, outlook, out);
    if (out.verdict != twin::Verdict::go) out.reliefs = reliefs_of(outlook, out);
    return out;
  });
}

}  // namespace slackwater::api
