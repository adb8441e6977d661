#pragma once
#include <span>
#include <string>

#include "api/log/people_over_runs.h"
#include "api/log/people_score.h"

namespace slackwater::api {

/// How people did in a run, in words, a paragraph for each of them; empty: nobody took part.
/// @param run  its title
[[nodiscard]] std::string people_score_text(const std::string& run, const PeopleScore& score);
/// A table with a row for each person; empty: there are none.
[[nodiscard]] std::string people_over_runs_text(std::span<const PersonOverRuns> people);

}  // namespace slackwater::api
