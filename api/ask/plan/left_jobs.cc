#include "api/ask/plan/left_jobs.h"

#include <algorithm>
#include <optional>

#include "api/ask/plan/candidates.h"
#include "api/ask/plan/charging.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// A way to do a job that a plan leaves no room for, and what takes the room.
struct Hindrance {
  Assignment wanted;
  std::vector<std::pair<Breach, std::size_t>> by;  ///< each with an assignment of the plan
  std::optional<Breach> of_all;                    ///< room aboard, or packs
};

Hindrance hindrance_of(const PlanProblem& problem, const std::vector<std::size_t>& kits,
                       const Plan& plan, const Assignment& wanted) {
  Hindrance hindrance{wanted, {}, std::nullopt};
  for (std::size_t i = 0; i < plan.assignments.size(); ++i)
    if (const auto breach = breach_between(problem, kits, plan.assignments[i], wanted))
      hindrance.by.emplace_back(*breach, i);
  if (!hindrance.by.empty()) return hindrance;
  std::vector<Assignment> all = plan.assignments;
  all.push_back(wanted);
  hindrance.of_all = breach_of_room(problem, all);
  if (!hindrance.of_all)
    hindrance.of_all = breach_of_packs(problem, all, earliest_charges(problem, all));
  return hindrance;
}

std::string in_all_text(const PlanProblem& problem, const Breach& breach) {
  if (breach.rule == Rule::crowded)
    return problem.vessels[breach.resource].id + " has no room for another crew";
  if (breach.rule == Rule::charger)
    return "the chargers of " + problem.batteries[breach.resource].id + " are in use";
  return "no pack of " + problem.batteries[breach.resource].id + " is charged by then";
}

/// Less is in the way of it; then it has the better chance.
bool is_nearer(const PlanProblem& problem, const Hindrance& a, const Hindrance& b) {
  if (a.by.size() != b.by.size()) return a.by.size() < b.by.size();
  return start_of(problem, a.wanted).probability > start_of(problem, b.wanted).probability;
}

std::string hindrance_text(const PlanProblem& problem, const Plan& plan,
                           const std::vector<Assignment>& candidates) {
  const std::vector<std::size_t> kits = kits_of(problem);
  std::optional<Hindrance> nearest;
  for (const Assignment& wanted : candidates) {
    Hindrance here = hindrance_of(problem, kits, plan, wanted);
    if (!nearest || is_nearer(problem, here, *nearest)) nearest = std::move(here);
  }
  std::vector<std::string> why;
  for (const auto& [breach, i] : nearest->by) {
    std::string text = taken_text(problem, breach, plan.assignments[i]);
    if (std::find(why.begin(), why.end(), text) == why.end()) why.push_back(std::move(text));
  }
  if (nearest->of_all) why.push_back(in_all_text(problem, *nearest->of_all));
  if (nearest->by.size() > 2) {
    why.clear();
    for (const auto& [breach, i] : nearest->by)
      why.push_back(problem.jobs[plan.assignments[i].job].id);
    return "its best place, " + clock_text(problem, begin_of(problem, nearest->wanted)) + " (" +
           chance_text(start_of(problem, nearest->wanted).probability) + "), would push out " +
           joined(why, ", ");
  }
  return "at " + clock_text(problem, begin_of(problem, nearest->wanted)) + " (" +
         chance_text(start_of(problem, nearest->wanted).probability) + ") " +
         (why.empty() ? "it would fit, but the search ran out of time" : joined(why, ", and "));
}

const JobStart& best_start(const PlanJob& job) {
  return *std::max_element(
      job.starts.begin(), job.starts.end(),
      [](const JobStart& a, const JobStart& b) { return a.probability < b.probability; });
}

/// Where no way to do it breaks no rule by itself.
std::string alone_text(const PlanProblem& problem, std::size_t j) {
  const PlanJob& job = problem.jobs[j];
  const JobStart& best = best_start(job);
  if (!has_chance(problem, best)) {
    const std::string found =
        "the best is " + chance_text(best.probability) + " at " +
        clock_text(problem, problem.minute_of(best.slot)) +
        (job.without_starts.empty() ? std::string() : "; " + job.without_starts);
    return problem.least_probability > 0
               ? "no start reaches " + chance_text(problem.least_probability) + ": " + found
               : "no start has a chance" +
                     (job.without_starts.empty() ? std::string() : "; " + job.without_starts);
  }
  Minute first = problem.minute_of(problem.slots), last = 0;
  std::optional<Breach> breach;
  for (std::size_t s = 0; s < job.starts.size(); ++s) {
    if (!has_chance(problem, job.starts[s])) continue;
    first = std::min(first, problem.minute_of(job.starts[s].slot));
    last = std::max(last, problem.minute_of(job.starts[s].slot));
    for (Assignment team : teams_of(problem, j)) {
      team.start = s;
      if (!breach) breach = breach_of(problem, team);
    }
  }
  if (!breach) return "no team that can do it is available";
  if (breach->rule == Rule::packs_of_one)
    return formatted("it takes {} packs of {}, and there are {}",
                     packs_for(problem.batteries[breach->resource], best),
                     problem.batteries[breach->resource].id,
                     problem.batteries[breach->resource].count);
  const std::string when = first == last ? "its only start, " + clock_text(problem, first) + ","
                                         : "its starts, " + clock_text(problem, first) + " to " +
                                               clock_text(problem, last) + ",";
  return when +
         " with the way out and home do not fit the working hours of any team that can do it" +
         (job.without_starts.empty() ? std::string() : "; " + job.without_starts);
}

}  // namespace

std::string clock_text(const PlanProblem& problem, Minute minute) {
  const UtcTime time = problem.begin + std::chrono::minutes(minute);
  return format_utc(time + (problem.zone ? problem.zone->offset_at(time) : std::chrono::minutes(0)))
      .substr(11, 5);
}

std::string chance_text(double probability) {
  const double percent = 100 * probability;
  // As whole numbers, but never "100 %" or "0 %" for what is not.
  if (percent > 99 && percent < 100) return formatted("{:.1f} %", std::min(percent, 99.9));
  if (percent > 0 && percent < 1) return formatted("{:.1f} %", std::max(percent, 0.1));
  return formatted("{:.0f} %", percent);
}

std::string taken_text(const PlanProblem& problem, const Breach& breach, const Assignment& by) {
  const PlanJob& job = problem.jobs[by.job];
  const std::string& place = problem.places[job.place];
  const std::string hours = "from " + clock_text(problem, begin_of(problem, by)) + " to " +
                            clock_text(problem, end_of(problem, by));
  switch (breach.rule) {
    case Rule::vehicle_twice:
      return problem.vehicles[breach.resource].id + " is at " + place + " " + hours + " (" +
             job.id + ")";
    case Rule::crew_twice:
      return problem.crews[breach.resource].id + " are at " + place + " " + hours + " (" + job.id +
             ")";
    case Rule::vessel_twice:
      return problem.vessels[breach.resource].id + " is at " + place + " " + hours + " (" + job.id +
             ")";
    case Rule::place_aboard:
      return "the teams that can do it are on " + problem.vessels[by.vessel].id + " (" + job.id +
             ")";
    case Rule::crew_hours:
      return problem.vessels[by.vessel].id + " keeps to the shift of " +
             problem.crews[breach.resource].id;
    default:
      return job.id + " is in the way";
  }
}

std::vector<LeftJob> left_jobs(const PlanProblem& problem, const Plan& plan) {
  std::vector<LeftJob> left;
  for (std::size_t j = 0; j < problem.jobs.size(); ++j) {
    const bool is_done = std::any_of(plan.assignments.begin(), plan.assignments.end(),
                                     [&](const Assignment& one) { return one.job == j; });
    if (is_done) continue;
    if (problem.jobs[j].starts.empty()) {
      const std::string& why = problem.jobs[j].without_starts;
      left.push_back({j, why.empty() ? "the windows have no start for it" : why});
      continue;
    }
    const std::vector<Assignment> candidates = candidates_of(problem, j);
    left.push_back({j, candidates.empty() ? alone_text(problem, j)
                                          : hindrance_text(problem, plan, candidates)});
  }
  return left;
}

}  // namespace slackwater::api
