#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/ask/run/scenario_run.h"

namespace slackwater::api {

/// How the vehicles of a run fared: a table for people, with what traffic and clearance have to
/// say.
/// @param out  the log that was written; empty: none
void print_run(const ScenarioResult& result, const std::filesystem::path& out);
/// Of how vehicles go with nobody at their controls, a line each, to stderr.
void print_notes(const std::vector<std::string>& notes);
/// The same as the document of `simulate --json` (api/docs/json.md).
[[nodiscard]] nlohmann::json run_json(const ScenarioResult& result, const std::string& scenario,
                                      const ScenarioWater& water, const std::filesystem::path& out);

}  // namespace slackwater::api
