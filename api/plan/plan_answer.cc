#include "api/plan/plan_answer.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "api/plan/branch_and_cut.h"
#include "api/plan/left_jobs.h"
#include "api/plan/plan_rules.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

std::string utc(const PlanProblem& problem, Minute minute) {
  return format_utc(problem.begin + std::chrono::minutes(minute));
}

std::vector<std::string> names_of(const PlanProblem& problem,
                                  const std::vector<std::size_t>& vehicles) {
  std::vector<std::string> names;
  for (const std::size_t k : vehicles) names.push_back(problem.vehicles[k].id);
  return names;
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

/// As wide as the widest of them.
struct Width {
  std::size_t most = 0;
  void hold(const std::string& text) { most = std::max(most, text.size()); }
  std::string operator()(std::string text) const {
    text.resize(std::max(text.size(), most), ' ');
    return text;
  }
};

std::string table_text(const PlanProblem& problem, const Plan& plan) {
  std::vector<std::array<std::string, 6>> rows{
      {"time", "chance", "job", "vessel", "crew", "vehicles"}};
  for (const Assignment& one : plan.assignments)
    rows.push_back({clock_text(problem, begin_of(problem, one)) + "-" +
                        clock_text(problem, end_of(problem, one)),
                    chance_text(start_of(problem, one).probability), problem.jobs[one.job].id,
                    problem.vessels[one.vessel].id, problem.crews[one.crew].id,
                    joined(names_of(problem, one.vehicles), ", ")});
  std::array<Width, 6> widths;
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i].hold(row[i]);
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += widths[i](row[i]) + "  ";
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string ways_text(const PlanProblem& problem, const Plan& plan, std::size_t v) {
  const std::vector<VesselWay> ways = ways_of_vessel(problem, plan.assignments, v);
  if (ways.empty()) return {};
  std::string text = problem.vessels[v].id + ": ";
  for (std::size_t i = 0; i < ways.size(); ++i)
    text += (i == 0 ? "" : "; ") + problem.places[ways[i].from] + " " +
            clock_text(problem, ways[i].leaves) + " to " + problem.places[ways[i].to] + " " +
            clock_text(problem, ways[i].arrives);
  return text + "\n";
}

std::string charges_text(const PlanProblem& problem, const Plan& plan) {
  std::string text;
  for (std::size_t i = 0; i < plan.charges.size();) {
    const Charge& charge = plan.charges[i];
    std::size_t packs = 0;
    for (; i < plan.charges.size() && plan.charges[i] == charge; ++i) ++packs;
    const PlanBattery& battery = problem.batteries[charge.battery];
    const Minute begin = problem.minute_of(charge.slot);
    text += formatted("{}: {} on {} from {} to {}\n", battery.id,
                      packs == 1 ? "a pack charges" : formatted("{} packs charge", packs),
                      problem.chargers[charge.charger].id, clock_text(problem, begin),
                      clock_text(problem, begin + battery.charge_min));
  }
  return text;
}

}  // namespace

std::string worth_text(const PlanProblem& problem, const Plan& plan) {
  double all = 0;
  for (const PlanJob& job : problem.jobs) all += job.priority;
  std::string text =
      formatted("{} of {} jobs planned, worth {:.2f} of {:g} (priority x probability)",
                plan.assignments.size(), problem.jobs.size(), plan.value, all);
  if (plan.is_proven) return text + "; no plan is worth more.";
  return text + formatted(
                    "; stopped at the time limit: no plan is worth more than {:.2f}, {:.1f} % "
                    "above this one.",
                    plan.bound, 100 * plan.gap());
}

std::vector<VesselWay> ways_of_vessel(const PlanProblem& problem,
                                      const std::vector<Assignment>& assignments,
                                      std::size_t vessel) {
  std::vector<VesselWay> ways;
  const PlanVessel& v = problem.vessels[vessel];
  std::optional<std::size_t> at;
  Minute free = 0;
  for (const Assignment& one : assignments) {  // by time
    if (one.vessel != vessel) continue;
    const std::size_t place = problem.jobs[one.job].place;
    const Minute begin = begin_of(problem, one);
    if (!at && v.port) {
      ways.push_back({*v.port, place, begin - v.way_min[*v.port][place], begin});
    } else if (at && *at != place) {
      ways.push_back({*at, place, free, free + v.way_min[*at][place]});
      free = 0;
    }
    at = place;
    free = std::max(free, end_of(problem, one));
  }
  if (at && v.port) ways.push_back({*at, *v.port, free, free + v.way_min[*at][*v.port]});
  return ways;
}

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

std::string plan_text(const PlanProblem& problem, const PlanAnswer& answer) {
  const Plan& plan = answer.plan;
  std::string text =
      formatted("{}, {}, {}, by the clocks of {}", answer.name, answer.site,
                format_day(day_of(problem.begin)), problem.zone ? problem.zone->name() : "UTC");
  text += problem.least_probability > 0
              ? "; no start of less than " + chance_text(problem.least_probability) + ".\n"
              : std::string(".\n");
  text += worth_text(problem, plan) + "\n";
  if (!plan.assignments.empty()) text += "\n" + table_text(problem, plan) + "\n";
  for (std::size_t v = 0; v < problem.vessels.size(); ++v) text += ways_text(problem, plan, v);
  text += charges_text(problem, plan);
  if (!plan.left.empty()) text += "\nleft:\n";
  for (const LeftJob& left : plan.left)
    text += "  " + problem.jobs[left.job].id + ": " + left.why + "\n";
  if (!answer.is_compared) return text;
  text += "\nsince the earlier plan:\n";
  std::size_t kept = 0;
  for (const PlanChange& change : answer.changes) {
    kept += change.kind == PlanChange::Kind::kept ? 1 : 0;
    if (change.kind != PlanChange::Kind::kept)
      text += formatted("  {} {}", change.job, name_of(change.kind)) +
              (change.why.empty() ? "" : ", " + change.why) + "\n";
  }
  return text + formatted("  {} as before\n", kept);
}

}  // namespace slackwater::api
