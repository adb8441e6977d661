#pragma once
#include <nlohmann/json_fwd.hpp>

#include "api/ask/rehearse/advice.h"
#include "api/ask/rehearse/mission_file.h"
#include "api/ask/rehearse/rehearsal.h"

namespace slackwater::api {

/// What a rehearsal says to programs: api/docs/rehearse.md has the schema.
[[nodiscard]] nlohmann::json rehearsal_json(const LoadedMission& mission, const RehearsalPlan& plan,
                                            const Rehearsal& rehearsal,
                                            const std::vector<Advice>& advice);

/// The verdict in a sentence: "Go at 06:00: 22 of 24 futures done (75 to 98 %)."
[[nodiscard]] std::string verdict_of(const Rehearsal& rehearsal);
/// Of one start.
[[nodiscard]] std::string verdict_of(const StartOutcome& start);
/// Why the limits and the flights disagree about a start; empty where they do not.
[[nodiscard]] std::string disagreement_of(const StartOutcome& start);

/// {"p10", "p50", "p90"}; null of none.
[[nodiscard]] nlohmann::json quantiles_json(const std::vector<double>& values);

}  // namespace slackwater::api
