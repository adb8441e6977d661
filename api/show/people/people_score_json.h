#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "api/log/people_over_runs.h"
#include "api/log/people_score.h"

namespace slackwater::api {

/// How people did in a run, as `score --json` has it (api/docs/json.md); null: nobody took part.
[[nodiscard]] nlohmann::json people_score_json(const PeopleScore& score);
/// The same over runs, by person.
[[nodiscard]] nlohmann::json people_over_runs_json(std::span<const PersonOverRuns> people);

}  // namespace slackwater::api
