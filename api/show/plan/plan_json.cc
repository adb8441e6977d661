#include "api/show/plan/plan_json.h"

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "api/ask/plan/branch_and_cut.h"
#include "api/ask/plan/plan_rules.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

std::string utc(const PlanProblem& problem, Minute minute) {
  return format_utc(problem.begin + std::chrono::minutes(minute));
}

json packs_json(const PlanProblem& problem, const Assignment& one) {
  std::map<std::size_t, std::size_t> packs;
  for (const std::size_t k : one.vehicles)
    if (const auto b = problem.vehicles[k].battery)
      packs[*b] += packs_for(problem.batteries[*b], start_of(problem, one));
  json list = json::array();
  for (const auto& [b, count] : packs)
    list.push_back({{"battery", problem.batteries[b].id}, {"count", count}});
  return list;
}

json job_json(const PlanProblem& problem, const Assignment& one) {
  const PlanJob& job = problem.jobs[one.job];
  return {{"job", job.id},
          {"task", job.task},
          {"turbine", problem.places[job.place]},
          {"priority", job.priority},
          {"start", utc(problem, begin_of(problem, one))},
          {"end", utc(problem, end_of(problem, one))},
          {"contingency_h", job.contingency_min / 60.0},
          {"drop_off_min", job.drop_off_min == 0 ? json(nullptr) : json(job.drop_off_min)},
          {"probability", start_of(problem, one).probability},
          {"vessel", problem.vessels[one.vessel].id},
          {"crew", problem.crews[one.crew].id},
          {"vehicles", names_of(problem, one.vehicles)},
          {"packs", packs_json(problem, one)}};
}

json vessel_json(const PlanProblem& problem, const Plan& plan, std::size_t v) {
  std::set<std::string> crews;
  for (const Assignment& one : plan.assignments)
    if (one.vessel == v) crews.insert(problem.crews[one.crew].id);
  json ways = json::array();
  for (const VesselWay& way : ways_of_vessel(problem, plan.assignments, v))
    ways.push_back({{"from", problem.places[way.from]},
                    {"to", problem.places[way.to]},
                    {"leaves", utc(problem, way.leaves)},
                    {"arrives", utc(problem, way.arrives)}});
  return {{"vessel", problem.vessels[v].id}, {"crews", crews}, {"ways", ways}};
}

}  // namespace

json plan_json(const PlanProblem& problem, const PlanAnswer& answer) {
  const Plan& plan = answer.plan;
  json document = {
      {"schema", "plan/1"},
      {"plan", answer.name},
      {"site", answer.site},
      {"day", format_day(day_of(problem.begin))},
      {"time_zone", problem.zone ? problem.zone->name() : "UTC"},
      {"grid_min", problem.slot_min},
      {"least_probability",
       problem.least_probability > 0 ? json(problem.least_probability) : json(nullptr)},
      {"value", plan.value},
      {"bound", plan.bound},
      {"gap", plan.gap()},
      {"proven", plan.is_proven},
      {"time_limit_s", answer.time_limit_s},
      {"solver", solver_name()},
      {"jobs", json::array()},
      {"left", json::array()},
      {"vessels", json::array()},
      {"charges", json::array()}};
  for (const Assignment& one : plan.assignments) document["jobs"].push_back(job_json(problem, one));
  for (const LeftJob& one : plan.left) {
    const PlanJob& job = problem.jobs[one.job];
    document["left"].push_back({{"job", job.id},
                                {"task", job.task},
                                {"turbine", problem.places[job.place]},
                                {"priority", job.priority},
                                {"why", one.why}});
  }
  for (std::size_t v = 0; v < problem.vessels.size(); ++v)
    document["vessels"].push_back(vessel_json(problem, plan, v));
  for (const Charge& charge : plan.charges) {
    const Minute begin = problem.minute_of(charge.slot);
    const PlanBattery& battery = problem.batteries[charge.battery];
    document["charges"].push_back({{"battery", battery.id},
                                   {"charger", problem.chargers[charge.charger].id},
                                   {"start", utc(problem, begin)},
                                   {"end", utc(problem, begin + battery.charge_min)}});
  }
  if (!answer.is_compared) return document;
  document["changes"] = json::array();
  for (const PlanChange& change : answer.changes)
    document["changes"].push_back(
        {{"job", change.job}, {"change", name_of(change.kind)}, {"why", change.why}});
  return document;
}

}  // namespace slackwater::api
