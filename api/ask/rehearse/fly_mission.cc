#include "api/ask/rehearse/fly_mission.h"

#include <algorithm>

#include "api/ask/rehearse/seen_in_calm.h"
#include "api/ask/rehearse/zones.h"
#include "fields/base/error.h"
#include "twin/rehearse/expect_fit.h"

namespace slackwater::api {

RehearsalPlan rehearsal_plan(LoadedMission& mission, std::vector<UtcTime> starts,
                             std::size_t members, int threads,
                             const std::filesystem::path& store_folder) {
  RehearsalPlan plan;
  plan.threads = threads;
  plan.starts = std::move(starts);
  if (plan.starts.empty())
    plan.starts.push_back(
        mission.scenario.start.value_or(mission.water.surround.field->range().from));
  plan.members = std::max<std::size_t>(mission.water.members_issued, 1);
  if (members > 0) {
    hold_members(mission.water, members, store_folder, threads);
    plan.members = members;
  }
  plan.flights.workers = mission.expanded.workers;
  // A page draws some hundreds of places of a way.
  plan.flights.sample_every_s = std::clamp(mission.scenario.duration_s / 240, 5.0, 60.0);
  plan.forbidden = [&mission](UtcTime start) { return zone_in_the_way(mission, start); };
  return plan;
}

Rehearsal fly_mission(const LoadedMission& mission, const RehearsalPlan& plan,
                      const std::function<void(double, const Rehearsal&)>& on_progress) {
  twin::Scenario first = mission.scenario;
  first.start = plan.starts.front();
  twin::expect_fit(mission.expanded, twin::set_up(first, mission.water.surround));
  expect_seen_in_calm(mission);
  Rehearsal rehearsal = rehearse(mission.scenario, mission.water.surround, plan, on_progress);
  if (std::all_of(rehearsal.starts.begin(), rehearsal.starts.end(),
                  [](const StartOutcome& start) { return !start.forbidden.empty(); }))
    throw Error(ErrorKind::invalid_input,
                rehearsal.starts.front().forbidden + "; move the start, or the work");
  return rehearsal;
}

}  // namespace slackwater::api
