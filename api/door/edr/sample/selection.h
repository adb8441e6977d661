#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "api/door/edr/read/query_string.h"
#include "api/door/edr/sample/collection.h"
#include "api/issued/issued_fields.h"

namespace slackwater::api::edr {

/// Of one forecast, the parameters that a query wants: what all queries have in common once it is
/// known which forecast answers.
struct Selection {
  const Collection* collection = nullptr;
  std::shared_ptr<const Field> field;
  std::vector<std::size_t> parameters;  ///< indices into parameters_of
  Answer answer;                        ///< with all but its coverages and the notes about them
};

/// @throws Error(usage) for a parameter name that the collection does not have; Error(not_found)
/// where the forecast offers nothing of the collection (`is_offered_by`)
[[nodiscard]] Selection select(const Collection& collection, const IssuedForecast& forecast,
                               std::shared_ptr<const Field> field, const QueryString& query);

/// The times of `datetime`: all stamps where it is absent; the instant itself, between stamps too;
/// the stamps of an interval, or its ends cut to the forecast where no stamp lies in it.
/// @throws Error(not_found), with the valid range, where the forecast has none of it
[[nodiscard]] std::vector<UtcTime> times_of(const Selection& selection, const QueryString& query);

/// The vertical positions of `z`: as listed, or the levels of a range (its ends where no
/// level lies in it). Where `z` is absent the native levels, for currents those above
/// `bed_m`. One NaN without a vertical.
/// @throws Error(usage) for z where there is no vertical; Error(not_found) outside the range
[[nodiscard]] std::vector<double> verticals_of(const Selection& selection, const QueryString& query,
                                               double bed_m);

/// The vertical positions of a `z` that is there: as listed, or of `all` those within a range (its
/// ends, cut to [low, high], where none lies in it).
/// @param held  "depth 0 to 35 m", and @param holder  "this forecast": what a refusal says
/// @throws Error(not_found) outside [low, high]
[[nodiscard]] std::vector<double> levels_asked(std::string_view z, double low, double high,
                                               std::vector<double> all, std::string_view holder,
                                               const std::string& held);

/// Why values are missing, one sentence a reason, with the valid range.
[[nodiscard]] std::vector<std::string> notes_of(const Absences& absences, const Field& field);

/// Refuses query parameters that are not among `known`.
/// @throws Error(usage) that names the nearest known one
void expect_known(const QueryString& query, std::span<const std::string_view> known);

}  // namespace slackwater::api::edr
