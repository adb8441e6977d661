#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/ask/rehearse/rehearsal.h"
#include "twin/surface/cleaning_outcome.h"

// What vehicles that clean have cleaned, for people and as JSON.

namespace slackwater::api {

/// "9.2 of 9.4 m2 clean (97 %, asked for 95 %), 0.94 m3 of growth off, 0.01 m3 left, 1 pass
/// needed".
[[nodiscard]] std::string cleaning_text(const twin::CleaningOutcome& cleaning);
/// One vehicle's; depths positive down.
[[nodiscard]] nlohmann::json cleaning_json(const twin::CleaningOutcome& cleaning);
/// P10, P50 and P90 of a vehicle over the flights of a start; null: it does not clean.
[[nodiscard]] nlohmann::json cleaning_json(const StartOutcome& start, std::size_t vehicle);
/// "cleaner: 97 % of 9.4 m2 clean (P10 95 %, P90 98 %)", one for each that cleans.
[[nodiscard]] std::vector<std::string> cleaning_texts(const StartOutcome& start);

/// "9.2 of 9.4 m2 (97 %)".
[[nodiscard]] std::string cleaned_text(const twin::CleaningOutcome& cleaning);

}  // namespace slackwater::api
