#pragma once
#include <span>
#include <string>
#include <vector>

#include "api/log/people_score.h"

namespace slackwater::api {

/// One person over the vehicles of a run, or over runs. What a run does not tell is not in the
/// lists that have a value for each run.
struct PersonOverRuns {
  std::string name;
  std::string role;
  std::size_t runs = 0;
  std::vector<double> asked_to_had_s;    ///< all of them
  std::size_t asked_in_vain = 0;         ///< in all
  std::vector<double> had_to_command_s;  ///< all of them
  // Of each run.
  std::vector<double> at_helm_s;
  std::vector<double> share_of_run;  ///< at a helm; of two vehicles at once above 1
  std::vector<double> commands_per_minute;
  std::vector<double> refused_share;
  std::vector<double> off_mission;
  std::vector<double> off_helm;
  std::vector<double> breaches;      ///< of stand-off and fence
  std::vector<double> near_limit_s;  ///< likewise
};

/// By name and role: whoever sits down twice is one person. In the order of names.
[[nodiscard]] std::vector<PersonOverRuns> people_over_runs(std::span<const PeopleScore> runs);

/// Nothing: they were not at it.
[[nodiscard]] std::optional<double> commands_per_minute(const HelmScore& helm) noexcept;
/// Nothing: there were none.
[[nodiscard]] std::optional<double> refused_share(const HelmScore& helm) noexcept;

}  // namespace slackwater::api
