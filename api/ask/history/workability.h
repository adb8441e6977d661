#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/ask/history/history.h"
#include "twin/risk/workability/calendar.h"
#include "twin/risk/workability/daylight.h"
#include "twin/risk/workability/workability.h"

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

/// The steps of a history that are light at its place.
/// @param notes  polar nights and days are told there
/// @throws Error(usage) where nobody said where it is
[[nodiscard]] twin::StepRanges light_at(const History& history, twin::Light light,
                                        std::vector<std::string>& notes);

/// The longest of some stretches, the first of them; null where there is none.
[[nodiscard]] const twin::StepRange* longest_of(const twin::StepRanges& ranges);

}  // namespace slackwater::api
