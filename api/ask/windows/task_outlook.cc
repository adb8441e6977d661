#include "api/ask/windows/task_outlook.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "api/ask/windows/vessel_access.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/rehearse/planned_work.h"

namespace slackwater::api {
namespace {

/// The grid is as fine as this or finer.
constexpr Duration longest_step = std::chrono::minutes(10);

/// @param more  beside what each has
LoadedMission mission_of(const WindowsQuestion& question, const std::string& task,
                         const std::vector<std::string>& turbines, YamlValue more,
                         const std::filesystem::path& store_folder) {
  more.put("name", "windows")
      .put("site", question.site)
      .put("tasks", YamlValue::words({task}))
      .put("turbines", YamlValue::words(turbines))
      .put("step_s", 0.05);
  return lay_out_mission(Config::of(more, "its mission"), std::filesystem::current_path(),
                         store_folder, question.assumed);
}

YamlValue waves_of(std::size_t components, bool have_height_errors) {
  return YamlValue()
      .put("components", static_cast<double>(components))
      .put("height_errors", have_height_errors);
}

LoadedMission laid_out_at(const SharedOutlook& outlook, const WindowsQuestion& question,
                          const std::string& task, const std::vector<std::string>& turbines) {
  YamlValue more;
  more.put("duration", "30d").put("seed", 1.0).put("waves", waves_of(8, false));
  LoadedMission mission =
      mission_of(question, task, turbines, std::move(more), outlook.store_folder);
  // It is not flown, and what set_up asks of the forecast is its first minute.
  mission.scenario.duration_s = 60;
  return mission;
}

std::string hours_text(double seconds) { return formatted("{:.1f} h", seconds / 3600); }

/// The grid is as fine as this or finer, and starts fall on it.
Duration step_of(Duration every) {
  Duration::rep parts = std::max<Duration::rep>(1, every / longest_step);
  while (every.count() % parts != 0 || every / parts > longest_step) ++parts;
  return every / parts;
}

std::size_t steps_in(double seconds, Duration step) {
  return static_cast<std::size_t>(
      std::ceil(seconds / std::chrono::duration<double>(step).count() - 1e-6));
}

/// How long before a start the vessel leaves port, and after its end she is home: whole steps. The
/// visits of split work have it in them.
std::size_t way_steps(const SharedOutlook& shared, const TaskWindows& out, Duration step) {
  if (shared.vessel == nullptr || out.is_split) return 0;
  return steps_in(std::chrono::duration<double>(shared.vessel->way()).count(), step);
}

/// How the work of a task may be divided: what of a visit is getting there and back, with the
/// contingency, and what is left of it.
twin::SplitWork split_of(const SharedOutlook& shared, const TaskSheet& sheet, Duration step,
                         TaskWindows& out) {
  double work_s = 0, lost_s = 0;
  for (const WorkerPlan& worker : out.workers) {
    double own_s = 0;
    for (const twin::PlannedPhase& phase : worker.plan.phases)
      if (phase.phase == twin::Phase::work) own_s += phase.duration_s;
    work_s = std::max(work_s, own_s);
    lost_s = std::max(lost_s, worker.plan.duration_s() - own_s + out.contingency_s);
  }
  if (shared.vessel != nullptr)
    lost_s += 2 * std::chrono::duration<double>(shared.vessel->way()).count();
  twin::SplitWork split;
  split.work = std::max<std::size_t>(1, steps_in(work_s, step));
  split.visits.lost = steps_in(lost_s, step);
  split.visits.shortest =
      std::max(steps_in(3600 * sheet.least_visit_h, step), split.visits.lost + 1);
  out.least_visit_s =
      static_cast<double>(split.visits.shortest) * std::chrono::duration<double>(step).count();
  return split;
}

}  // namespace

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
  out.is_split = sheet.is_splittable;
}

void lay_grid(const WindowsQuestion& question, const SharedOutlook& shared, const TaskSheet& sheet,
              Outlook& outlook, TaskWindows& out) {
  const Duration step = step_of(question.every);
  const double step_s = std::chrono::duration<double>(step).count();
  double held_s = out.planned_s + out.contingency_s;
  UtcTime end = shared.water->surround.field->range().to;
  std::string takes =
      "takes " + hours_text(held_s) + " with " + hours_text(out.contingency_s) + " of contingency";
  std::string ends = "the forecast";
  const std::size_t way = way_steps(shared, out, step);
  if (way > 0) takes += ", and " + hours_text(static_cast<double>(way) * step_s) + " home";
  if (out.is_split) {
    outlook.question.split = split_of(shared, sheet, step, out);
    held_s = out.least_visit_s;
    end = shared.to;
    takes = "takes " + hours_text(held_s) + " a visit";
    ends = "the hours that were asked for";
  }
  if (shared.is_one_day && held_s > 86400)
    throw Error(ErrorKind::invalid_input,
                takes +
                    ", which is longer than the day; ask for the hours of several days with "
                    "--from and --to, or for less with --contingency");
  const std::size_t needed = std::max<std::size_t>(steps_in(held_s, step), 1) + way;
  const UtcTime earliest =
      shared.water->surround.field->range().from + step * static_cast<Duration::rep>(way);
  std::size_t fitting = 0, too_early = 0, asked = 0;
  UtcTime first = shared.from;
  for (UtcTime start = shared.from; start < shared.to; start += question.every) {
    if (start < earliest) {
      ++too_early;
      first = start + question.every;
      continue;
    }
    ++asked;
    if (start + step * static_cast<Duration::rep>(needed) <= end) ++fitting;
  }
  if (asked == 0 && too_early > 0)
    throw Error(ErrorKind::invalid_input,
                "found starts from " + format_utc(shared.from) +
                    " on, and the vessel leaves port " +
                    hours_text(static_cast<double>(way) * step_s) +
                    " before a start; the forecast begins at " +
                    format_utc(shared.water->surround.field->range().from) +
                    ": ask for starts from " + format_utc(earliest) + " on with --from and --to");
  if (fitting == 0)
    throw Error(ErrorKind::invalid_input,
                takes + "; begun at " + format_utc(std::max(shared.from, earliest)) +
                    " it ends after " + ends + " (" + format_utc(end) +
                    "); move --from or --to, or take a forecast with a longer --horizon");
  outlook.starts = {way, static_cast<std::size_t>(question.every / step), fitting};
  outlook.clock = {first - step * static_cast<Duration::rep>(way), step,
                   outlook.starts.step_of(fitting - 1) + needed};
  if (outlook.question.split) {
    outlook.clock.steps = static_cast<std::size_t>((shared.to - shared.from) / step);
    outlook.question.split->by_step = outlook.clock.steps;
  }
  if (too_early > 0)
    out.notes.push_back(
        formatted("{} starts before {} are left out: the vessel leaves port {} before a start, and "
                  "the forecast begins at {}",
                  too_early, format_utc(first), hours_text(static_cast<double>(way) * step_s),
                  format_utc(shared.water->surround.field->range().from)));
  if (fitting < asked)
    out.notes.push_back(
        formatted("{} starts after {} are left out: they end after {}", asked - fitting,
                  format_utc(outlook.clock.time_of(outlook.starts.step_of(fitting - 1))), ends));
}

twin::StepRanges whole_stay(const Outlook& outlook, const TaskWindows& out) {
  if (outlook.question.split) return {{0, outlook.question.split->visits.shortest}};
  return {{0, std::max<std::size_t>(
                  1, steps_in(out.planned_s + out.contingency_s, outlook.clock.step))}};
}

LoadedMission mission_to_fly(const WindowsQuestion& question, const TaskWindows& task,
                             std::uint64_t seed, std::size_t wave_components,
                             const std::filesystem::path& store_folder) {
  YamlValue more;
  more.put("duration_s", 60 * std::ceil((task.planned_s + task.contingency_s) / 60))
      .put("seed", static_cast<double>(seed & 0x7fffffff))
      .put("waves", waves_of(wave_components, !question.waves_as_forecast))
      .put("gusts", "dryden");
  return mission_of(question, task.id, task.turbines, std::move(more), store_folder);
}

}  // namespace slackwater::api
