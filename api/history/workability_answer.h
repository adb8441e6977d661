#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "api/history/history.h"
#include "twin/risk/calendar.h"
#include "twin/risk/daylight.h"
#include "twin/risk/workability.h"

namespace slackwater::api {

/// What is asked of a history.
struct WorkabilityQuestion {
  std::vector<SeriesLimit> limits;
  Duration duration{};
  Duration contingency{0};
  std::optional<twin::DayHours> start_hours;
  std::optional<twin::Light> daylight;  ///< it is all done in this light; needs a place
  std::optional<TimeZone> zone;         ///< of the hours, months and years; absent: UTC
};

/// Its answer.
struct WorkabilityAnswer {
  LimitedHistory limited;
  twin::Workability workability;
  std::size_t light_steps = 0;     ///< of the daylight that was asked for
  std::vector<std::string> notes;  ///< what a reader should know beside the history's
};

/// @throws Error(usage) for daylight nowhere; Error(invalid_input) for a task longer than the
///         history
[[nodiscard]] WorkabilityAnswer answer_of(const History& history,
                                          const WorkabilityQuestion& question,
                                          const ingest::Vocabulary& vocabulary);

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

/// The steps of a history that are light at its place.
/// @param notes  polar nights and days are told there
/// @throws Error(usage) where nobody said where it is
[[nodiscard]] twin::StepRanges light_at(const History& history, twin::Light light,
                                        std::vector<std::string>& notes);

/// The gaps of a history: `{count, longest_h, longest_from}`.
[[nodiscard]] nlohmann::json gaps_json(const StepClock& clock, const twin::StepRanges& missing);

}  // namespace slackwater::api
