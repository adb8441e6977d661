#include "api/ask/windows/fly_windows.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "api/ask/rehearse/advice.h"
#include "api/ask/rehearse/rehearsal.h"
#include "api/ask/rehearse/risks.h"
#include "api/ask/rehearse/seen_in_calm.h"
#include "api/ask/rehearse/zones.h"
#include "api/ask/windows/task_windows.h"
#include "api/ask/windows/worth.h"
#include "fields/base/error.h"
#include "twin/run/set_up.h"

namespace slackwater::api {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t wave_components = 32;

/// The starts of a task that are worth flying, some time apart.
std::vector<std::size_t> starts_to_fly(const TaskWindows& task, Duration every) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < task.starts.size(); ++i) {
    const TaskStart& start = task.starts[i];
    if (start.chance.held == 0 || !start.forbidden.empty()) continue;
    if (!out.empty() && start.start - task.starts[out.back()].start < every) continue;
    out.push_back(i);
  }
  return out;
}

TwinChance chance_of(const StartOutcome& flown, const std::vector<twin::Consequence>& harms) {
  TwinChance out;
  out.probability = flown.success.share();
  out.interval = {flown.success.low, flown.success.high};
  out.p_done = flown.done;
  out.p_seen = flown.seen;
  out.flights = flown.flights.size();
  out.done = flown_start(flown, out.flights).done;
  const std::size_t stopped = flown.done.of - flown.done.flights;
  if (flown.seen && flown.seen->of - flown.seen->flights > stopped)
    out.stopped_by = "not seen: " + flown.unseen_by.front().cause;
  else if (!flown.stopped_by.empty())
    out.stopped_by = flown.stopped_by.front().cause;
  for (const twin::Flight& flight : flown.flights) {
    if (flight.is_done) out.duration_s.push_back(flight.ended_s);
    double energy_j = 0;
    for (const twin::VehicleAccount& vehicle : flight.vehicles)
      energy_j += vehicle.on_mission.drawn_j;
    out.energy_wh.push_back(energy_j / 3600);
  }
  out.risks = risks_of(flown, harms);
  return out;
}

/// The start that is worth most of those that were flown, done otherwise: in nine futures, with
/// which flights begin to count (worth.h). Where all of them were done there is nothing to gain.
std::optional<FlownAdvice> advice_of(const LoadedMission& mission, const RehearsalPlan& plan,
                                     const TaskWindows& task) {
  constexpr std::size_t futures = 9;
  const TaskStart* best = best_flown(task);
  if (best == nullptr) return std::nullopt;
  FlownStart flown{best->start, best->twin->done};
  if (flown.done.size() > futures) flown.done.resize(futures);
  if (std::find(flown.done.begin(), flown.done.end(), 0) == flown.done.end()) return std::nullopt;
  return FlownAdvice{best->start, advice_for(mission, plan, flown)};
}

/// @return why it is left out, of one that cannot see what it asks for; empty: it was flown
std::string fly_task(const WindowsQuestion& question, const FlyWindows& settings,
                     double most_wall_s, const std::filesystem::path& store_folder,
                     WindowsAnswer& answer, TaskWindows& task) {
  const std::vector<std::size_t> starts = starts_to_fly(task, settings.every);
  if (starts.empty()) return "";
  const Field& field = *answer.water.surround.field;
  LoadedMission mission =
      mission_to_fly(question, task, field.snapshot().seed, wave_components, store_folder);
  if (std::string why = unseen_in_calm(mission); !why.empty()) {
    if (!question.may_leave_out) throw Error(ErrorKind::invalid_input, task.id + ": " + why);
    return why;
  }
  mission.water = answer.water;
  RehearsalPlan plan;
  for (const std::size_t i : starts) plan.starts.push_back(task.starts[i].start);
  plan.members = question.members > 0 ? question.members : field.snapshot().members;
  plan.narrow_enough = settings.narrow_enough;
  const double for_advice_s = settings.with_advice ? 0.25 * most_wall_s : 0;
  plan.most_wall_s = most_wall_s - for_advice_s;
  plan.threads = question.threads;
  plan.forbidden = [&](UtcTime start) { return zone_in_the_way(mission, start); };
  plan.flights.workers = mission.expanded.workers;
  plan.flights.sample_every_s = mission.scenario.duration_s;
  const Rehearsal flown = rehearse(mission.scenario, answer.water.surround, plan);
  for (std::size_t i = 0; i < starts.size(); ++i)
    task.starts[starts[i]].twin = chance_of(flown.starts[i], mission.consequences);
  weigh_by_flights(task, settings.every);
  task.verdict = twin::verdict_of(best_of(task)->worth, question.rule);
  if (!settings.with_advice || task.verdict == twin::Verdict::go) return "";
  plan.most_wall_s = for_advice_s;
  task.advice = advice_of(mission, plan, task);
  return "";
}

/// Takes out the tasks that were refused, each with its reason.
void leave_out(const WindowsQuestion& question, const std::vector<std::string>& refused,
               WindowsAnswer& answer) {
  std::vector<TaskWindows> kept;
  for (std::size_t i = 0; i < refused.size(); ++i) {
    if (refused[i].empty())
      kept.push_back(std::move(answer.tasks[i]));
    else
      answer.left_out.push_back({answer.tasks[i].id, refused[i]});
  }
  if (kept.size() < refused.size()) answer.verdict = twin::Verdict::no_go;
  answer.tasks = std::move(kept);
  if (answer.tasks.empty() && !refused.empty() && !question.may_leave_all_out)
    throw Error(ErrorKind::invalid_input, answer.left_out.back().why);
}

}  // namespace

void fly_windows(const WindowsQuestion& question, const FlyWindows& settings,
                 const std::filesystem::path& store_folder, WindowsAnswer& answer,
                 const std::function<void(double)>& on_progress) {
  const Clock::time_point began = Clock::now();
  std::vector<std::size_t> to_fly;
  for (const TaskWindows& task : answer.tasks)
    to_fly.push_back(starts_to_fly(task, settings.every).size());
  std::vector<std::string> refused(answer.tasks.size());
  std::size_t left = std::accumulate(to_fly.begin(), to_fly.end(), std::size_t{0});
  for (std::size_t i = 0; i < answer.tasks.size(); ++i) {
    const double left_s =
        settings.most_wall_s - std::chrono::duration<double>(Clock::now() - began).count();
    const double share_s = std::max(left_s, 1.0) * static_cast<double>(to_fly[i]) /
                           static_cast<double>(std::max<std::size_t>(left, 1));
    left -= to_fly[i];
    // One task that cannot succeed does not stop the answer about the others.
    refused[i] = fly_task(question, settings, share_s, store_folder, answer, answer.tasks[i]);
    if (refused[i].empty()) answer.verdict = std::max(answer.verdict, answer.tasks[i].verdict);
    if (on_progress)
      on_progress(static_cast<double>(i + 1) / static_cast<double>(answer.tasks.size()));
  }
  leave_out(question, refused, answer);
}

}  // namespace slackwater::api
