#include "api/ask/plan/plan_change.h"

#include <algorithm>
#include <map>
#include <optional>

#include "api/ask/plan/left_jobs.h"
#include "api/ask/plan/plan_rules.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// Chances that are told as the same are the same.
constexpr double as_good = 0.005;

template <typename Things>
std::optional<std::size_t> index_of(const Things& things, const std::string& id) {
  for (std::size_t i = 0; i < things.size(); ++i)
    if (things[i].id == id) return i;
  return std::nullopt;
}

/// The earlier assignment among the things of the new problem; or what of it is gone.
std::optional<Assignment> as_before(const PlanProblem& problem, std::size_t job,
                                    const EarlierPlan::Job& was, std::string& gone) {
  const std::vector<JobStart>& starts = problem.jobs[job].starts;
  const auto start = std::find_if(starts.begin(), starts.end(), [&](const JobStart& one) {
    return problem.begin + std::chrono::minutes(problem.minute_of(one.slot)) == was.start;
  });
  Assignment before{job, static_cast<std::size_t>(start - starts.begin()), 0, 0, {}};
  const auto vessel = index_of(problem.vessels, was.vessel);
  const auto crew = index_of(problem.crews, was.crew);
  if (!vessel) gone = was.vessel;
  if (!crew) gone = was.crew;
  for (const std::string& id : was.vehicles) {
    const auto vehicle = index_of(problem.vehicles, id);
    if (!vehicle)
      gone = id;
    else
      before.vehicles.push_back(*vehicle);
  }
  if (!gone.empty() || start == starts.end()) return std::nullopt;
  before.vessel = *vessel;
  before.crew = *crew;
  return before;
}

/// Why a job is not done as before.
struct Obstacle {
  std::string why;  ///< empty: it still could be
  std::optional<std::size_t>
      makes_room_for{};  ///< the job that it makes room for, where that is why
};

Obstacle obstacle(const PlanProblem& problem, const Plan& plan, std::size_t job,
                  const EarlierPlan::Job& was) {
  const Minute minute = static_cast<Minute>(
      std::chrono::duration_cast<std::chrono::minutes>(was.start - problem.begin).count());
  const std::string at = clock_text(problem, minute);
  std::string gone;
  const std::optional<Assignment> before = as_before(problem, job, was, gone);
  if (!gone.empty()) return {gone + " is no longer there"};
  if (!before) {
    const std::string& why = problem.jobs[job].without_starts;
    return {"there is no start at " + at + " any more" + (why.empty() ? "" : ": " + why)};
  }
  const double now = start_of(problem, *before).probability;
  if (now < was.probability - as_good)
    return {"the chance of " + at + " fell from " + chance_text(was.probability) + " to " +
            chance_text(now)};
  if (!has_chance(problem, start_of(problem, *before)))
    return {at + " has " + chance_text(now) + ", less than the plan now requires"};
  if (breach_of(problem, *before))
    return {"the team that was planned cannot do it at " + at +
            " any more: its hours, skills or packs have changed"};
  const std::vector<std::size_t> kits = kits_of(problem);
  for (const Assignment& other : plan.assignments) {
    if (other.job == job) continue;
    if (const auto breach = breach_between(problem, kits, other, *before))
      return {"makes room: " + taken_text(problem, *breach, other), other.job};
  }
  return {};
}

/// The jobs that make room for each other in a circle through this one, itself first; empty where
/// there is no such circle.
/// @param room_for  by job, what it makes room for
std::vector<std::size_t> circle_of(const std::map<std::size_t, std::size_t>& room_for,
                                   std::size_t job) {
  std::vector<std::size_t> circle{job};
  for (auto next = room_for.find(job); next != room_for.end(); next = room_for.find(next->second)) {
    if (next->second == job) return circle;
    if (std::find(circle.begin(), circle.end(), next->second) != circle.end()) return {};
    circle.push_back(next->second);
  }
  return {};
}

/// Who does it.
std::string team_text(const PlanProblem& problem, const Assignment& one) {
  std::vector<std::string> who{problem.vessels[one.vessel].id, problem.crews[one.crew].id};
  for (const std::size_t k : one.vehicles) who.push_back(problem.vehicles[k].id);
  return joined(who, ", ");
}

std::string team_text(const EarlierPlan::Job& was) {
  std::vector<std::string> who{was.vessel, was.crew};
  who.insert(who.end(), was.vehicles.begin(), was.vehicles.end());
  return joined(who, ", ");
}

/// What a change of places is for.
std::string places_text(const PlanProblem& problem, const std::vector<std::size_t>& circle) {
  std::vector<std::string> others;
  for (std::size_t i = 1; i < circle.size(); ++i) others.push_back(problem.jobs[circle[i]].id);
  return "changes places with " + joined(others, " and ");
}

/// @param circle  of `circle_of`
PlanChange change_of(const PlanProblem& problem, const Assignment& now, const EarlierPlan::Job& was,
                     const Obstacle& in_the_way, const std::vector<std::size_t>& circle) {
  PlanChange change{was.id, PlanChange::Kind::kept, {}};
  const UtcTime start = problem.begin + std::chrono::minutes(begin_of(problem, now));
  const bool has_moved = start != was.start;
  const bool is_other_team = team_text(problem, now) != team_text(was);
  if (!has_moved && !is_other_team) return change;
  change.kind = has_moved ? PlanChange::Kind::moved : PlanChange::Kind::handed_over;
  const auto minute = [&](UtcTime time) {
    return clock_text(problem,
                      static_cast<Minute>((time - problem.begin) / std::chrono::minutes(1)));
  };
  std::string what = has_moved ? "from " + minute(was.start) + " to " + minute(start) + " (" +
                                     chance_text(start_of(problem, now).probability) + ")"
                               : "from " + team_text(was) + " to " + team_text(problem, now);
  if (has_moved && is_other_team) what += ", now by " + team_text(problem, now);
  // In a circle each would be the other's reason.
  std::string why = circle.empty() ? in_the_way.why : std::string();
  if (why.empty() && start_of(problem, now).probability > was.probability + as_good)
    why = "its chance is better now: " + chance_text(start_of(problem, now).probability) +
          " against " + chance_text(was.probability);
  if (why.empty()) why = "the day as a whole is worth as much or more";
  if (!circle.empty()) why = places_text(problem, circle) + ": " + why;
  change.why = what + ": " + why;
  return change;
}

}  // namespace

std::string_view name_of(PlanChange::Kind kind) noexcept {
  switch (kind) {
    case PlanChange::Kind::kept:
      return "kept";
    case PlanChange::Kind::moved:
      return "moved";
    case PlanChange::Kind::handed_over:
      return "handed over";
    case PlanChange::Kind::dropped:
      return "dropped";
    case PlanChange::Kind::added:
      return "added";
    case PlanChange::Kind::no_longer_asked:
      return "no longer asked for";
  }
  return "kept";
}

std::vector<PlanChange> changes_since(const EarlierPlan& earlier, const PlanProblem& problem,
                                      const Plan& plan, const std::string& site) {
  if (earlier.site != site)
    throw Error(ErrorKind::invalid_input,
                earlier.name + ": found the plan of " + earlier.site + ", expected one of " + site);
  if (earlier.day != day_of(problem.begin))
    throw Error(ErrorKind::invalid_input, earlier.name + ": found the plan of " +
                                              format_day(earlier.day) + ", expected one of " +
                                              format_day(day_of(problem.begin)) +
                                              "; only plans of the same day can be compared");
  const auto of_job = [&](std::size_t j) {
    return std::find_if(plan.assignments.begin(), plan.assignments.end(),
                        [&](const Assignment& one) { return one.job == j; });
  };
  std::map<std::size_t, Obstacle> obstacles;
  std::map<std::size_t, std::size_t> room_for;
  for (std::size_t j = 0; j < problem.jobs.size(); ++j) {
    const auto was = index_of(earlier.jobs, problem.jobs[j].id);
    if (!was) continue;
    obstacles[j] = obstacle(problem, plan, j, earlier.jobs[*was]);
    if (obstacles[j].makes_room_for && of_job(j) != plan.assignments.end())
      room_for[j] = *obstacles[j].makes_room_for;
  }
  std::vector<PlanChange> changes;
  for (std::size_t j = 0; j < problem.jobs.size(); ++j) {
    const std::string& id = problem.jobs[j].id;
    const auto was = index_of(earlier.jobs, id);
    const auto now = of_job(j);
    const auto left = std::find_if(plan.left.begin(), plan.left.end(),
                                   [&](const LeftJob& one) { return one.job == j; });
    if (now != plan.assignments.end() && was) {
      changes.push_back(
          change_of(problem, *now, earlier.jobs[*was], obstacles[j], circle_of(room_for, j)));
    } else if (now != plan.assignments.end()) {
      const auto was_left = index_of(earlier.left, id);
      changes.push_back(
          {id, PlanChange::Kind::added,
           "at " + clock_text(problem, begin_of(problem, *now)) + " (" +
               chance_text(start_of(problem, *now).probability) + "): " +
               (was_left ? "it was left out before, because " + earlier.left[*was_left].why
                         : "it was not asked for before")});
    } else if (was) {
      const std::string& why = obstacles[j].why;
      changes.push_back({id, PlanChange::Kind::dropped,
                         (why.empty() ? "" : why + "; ") +
                             (left != plan.left.end() ? left->why : std::string())});
    }
  }
  for (const EarlierPlan::Job& was : earlier.jobs)
    if (!index_of(problem.jobs, was.id))
      changes.push_back(
          {was.id, PlanChange::Kind::no_longer_asked, "it is no longer in the plan's file"});
  return changes;
}

}  // namespace slackwater::api
