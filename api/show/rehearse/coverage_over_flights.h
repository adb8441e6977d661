#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/ask/rehearse/rehearsal.h"
#include "api/show/coverage/view.h"

// What the futures of a start leave of an inspection: where it is covered whatever comes, and what
// the current or the wind that was felt has to do with it.

namespace slackwater::api {

/// From this share of the futures on a patch counts as covered, below one less this as not.
inline constexpr double sure_share = 0.9;

/// Each surface under each instrument of a vehicle. A patch's state is how many of the futures
/// cover it: nearly all of them, some, hardly any; `words` say so. Without marks: of findings each
/// future has its own.
/// @param what  the inspection that all flights share; null: none
[[nodiscard]] std::vector<InspectionCoverage> coverage_over_flights(const StartOutcome& start,
                                                                    std::size_t vehicle,
                                                                    const twin::Inspection* what);

/// The pictures of all vehicles of a start. Empty where none inspects.
[[nodiscard]] std::string rehearsed_coverage_html(const StartOutcome& start,
                                                  const twin::InspectionShelf& inspections);

/// `{"in": "current" | "wind", "points": [[m/s, %, member], ...]}`, a point a future: the mean at
/// work of the current felt, or of the wind by one that works in the air; null where it never was
/// at work; and the share of all surfaces that was covered. Null: the vehicle inspects nothing.
[[nodiscard]] nlohmann::json covered_against_flow_json(const StartOutcome& start,
                                                       std::size_t vehicle);

}  // namespace slackwater::api
