#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "api/ask/plan/plan.h"

namespace slackwater::api {

/// A plan as it was printed by `slackwater plan --json`, as far as another is held against it.
struct EarlierPlan {
  struct Job {
    std::string id;
    UtcTime start{};
    double probability = 0;
    std::string vessel;
    std::string crew;
    std::vector<std::string> vehicles;
  };
  struct Left {
    std::string id;
    std::string why;
  };
  std::string name;  ///< of the file
  std::string site;
  UtcDay day{};
  std::vector<Job> jobs;
  std::vector<Left> left;
};

/// What became of a job since an earlier plan.
struct PlanChange {
  enum class Kind { kept, moved, handed_over, dropped, added, no_longer_asked };
  std::string job;
  Kind kind = Kind::kept;
  std::string why;  ///< in words; empty of what was kept
  bool operator==(const PlanChange&) const = default;
};
/// "kept", "moved", "handed over", "dropped", "added", "no longer asked for".
[[nodiscard]] std::string_view name_of(PlanChange::Kind kind) noexcept;

/// What changed and why: each job of the new problem, then those that it no longer has. Why it did
/// is found by holding the old start and team against the new chances, hours and plan.
/// @throws Error(invalid_input) for a plan of another site or day
[[nodiscard]] std::vector<PlanChange> changes_since(const EarlierPlan& earlier,
                                                    const PlanProblem& problem, const Plan& plan,
                                                    const std::string& site);

}  // namespace slackwater::api
