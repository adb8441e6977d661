#include "api/show/plan/plan_text.h"

#include <algorithm>
#include <array>

#include "api/ask/plan/left_jobs.h"
#include "api/ask/plan/plan_rules.h"
#include "fields/base/text.h"
#include "twin/risk/start_windows.h"

namespace slackwater::api {
namespace {

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
                    chance_and_verdict(start_of(problem, one).probability),
                    problem.jobs[one.job].id, problem.vessels[one.vessel].id,
                    problem.crews[one.crew].id, joined(names_of(problem, one.vehicles), ", ")});
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
  return text +
         formatted("; {:.1f} h at sea\n", (ways.back().arrives - ways.front().leaves) / 60.0);
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

std::string chance_and_verdict(double probability) {
  const twin::Verdict verdict = twin::verdict_of(probability, {});
  if (verdict == twin::Verdict::go) return chance_text(probability);
  return chance_text(probability) + ", " + std::string(twin::name_of(verdict));
}

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

std::string plan_text(const PlanProblem& problem, const PlanAnswer& answer) {
  const Plan& plan = answer.plan;
  std::string text =
      formatted("{}, {}, {}, times of {}", answer.name, answer.site,
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
