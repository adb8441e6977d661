#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "api/ask/plan/plan_problem.h"

namespace slackwater::api {

/// A job that is done: when, and by whom.
struct Assignment {
  std::size_t job = 0;
  std::size_t start = 0;  ///< index into the job's starts
  std::size_t vessel = 0;
  std::size_t crew = 0;
  std::vector<std::size_t> vehicles;  ///< one for each that the job takes
  bool operator==(const Assignment&) const = default;
};

/// A pack that begins to charge.
struct Charge {
  std::size_t battery = 0;
  std::size_t charger = 0;
  std::size_t slot = 0;
  bool operator==(const Charge&) const = default;
};

/// A job that is left, and why, in words.
struct LeftJob {
  std::size_t job = 0;
  std::string why;
  bool operator==(const LeftJob&) const = default;
};

/// What to do when.
struct Plan {
  std::vector<Assignment> assignments;  ///< by time, then by job
  std::vector<Charge> charges;          ///< by time
  std::vector<LeftJob> left;            ///< in the order of the jobs
  double value = 0;                     ///< sum of priority x probability
  double bound = 0;                     ///< no plan is worth more
  bool is_proven = false;               ///< no plan is worth more than this one

  /// (bound - value) / value; 0 of a proven one.
  [[nodiscard]] double gap() const noexcept;
};

[[nodiscard]] inline const JobStart& start_of(const PlanProblem& problem,
                                              const Assignment& assignment) {
  return problem.jobs[assignment.job].starts[assignment.start];
}
/// When it begins and when all that it takes is free again (a vehicle after its swap).
[[nodiscard]] inline Minute begin_of(const PlanProblem& problem, const Assignment& assignment) {
  return problem.minute_of(start_of(problem, assignment).slot);
}
[[nodiscard]] inline Minute end_of(const PlanProblem& problem, const Assignment& assignment) {
  return begin_of(problem, assignment) + start_of(problem, assignment).hold_min;
}
[[nodiscard]] double value_of(const PlanProblem& problem,
                              const std::vector<Assignment>& assignments);
/// By time, then by job.
void sort_by_time(const PlanProblem& problem, std::vector<Assignment>& assignments);

}  // namespace slackwater::api
