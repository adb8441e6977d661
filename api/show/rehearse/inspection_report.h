#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/ask/rehearse/rehearsal.h"

namespace slackwater::api {

// An inspection in words and as JSON.

/// "1210 of 1480 m2 covered (82 %): A01/monopile by the ROV camera 82 %; 4 found, 1 missed, 0 false
/// alarms". The missed are those of the made-up truth.
[[nodiscard]] std::string inspection_text(const twin::InspectionOutcome& outcome);
[[nodiscard]] nlohmann::json inspection_json(const twin::InspectionOutcome& outcome);

/// The same of a vehicle over the flights of a start: P10, P50 and P90. Null: it inspects nothing.
[[nodiscard]] nlohmann::json inspection_json(const StartOutcome& start, std::size_t vehicle);
/// A line a vehicle that inspects.
[[nodiscard]] std::vector<std::string> inspection_texts(const StartOutcome& start);

/// "1210 of 1480 m2 covered (82 %)".
[[nodiscard]] std::string covered_text(const twin::InspectionOutcome& outcome);

}  // namespace slackwater::api
