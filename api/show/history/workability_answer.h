#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/ask/history/workability.h"

namespace slackwater::api {

/// For programs: api/docs/json.md has the schema.
[[nodiscard]] nlohmann::json workability_json(const History& history,
                                              const WorkabilityQuestion& question,
                                              const WorkabilityAnswer& answer,
                                              const ingest::Vocabulary& vocabulary);
/// For people: the answer in two sentences, then a table by month and year.
[[nodiscard]] std::string workability_text(const History& history,
                                           const WorkabilityQuestion& question,
                                           const WorkabilityAnswer& answer);

/// "113952 steps of 1 h from 2002-01-01T00:00:00Z to 2015-01-01T00:00:00Z, 24 of them missing in 2
/// gaps, the longest 20 h from ...: they count as not accessible".
[[nodiscard]] std::string extent_text(const StepClock& clock, const twin::StepRanges& missing);

/// The gaps of a history: `{count, longest_h, longest_from}`.
[[nodiscard]] nlohmann::json gaps_json(const StepClock& clock, const twin::StepRanges& missing);

/// NaN of nothing.
[[nodiscard]] double share_of(std::size_t part, std::size_t of) noexcept;
/// "Europe/Berlin"; "UTC" where nobody named one.
[[nodiscard]] std::string zone_text(const std::optional<TimeZone>& zone);

}  // namespace slackwater::api
