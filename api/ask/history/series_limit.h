#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/record/history_series.h"
#include "ingest/copernicus/vocabulary.h"
#include "twin/mission/height_table.h"
#include "twin/risk/bound.h"

namespace slackwater::api {

/// A limit on a series, as a user writes it.
struct SeriesLimit {
  std::string text;      ///< "sea_surface_wave_significant_height<=1.5"
  std::string variable;  ///< a CF standard name, or a column's
  twin::Bound bound;     ///< in the unit
  std::string unit;      ///< empty: the canonical one of the variable, else that of the series
  /// Of a height of waves: bounds that go by the sea (sea_limit.h); `bound` is the least of them.
  std::optional<twin::HeightTable> table{};
  bool operator==(const SeriesLimit&) const = default;
};

/// Reads "NAME<=VALUE UNIT", with <=, <, >= or >, the unit perhaps left out.
/// @throws Error(invalid_input) for anything else, and for values that are not finite
[[nodiscard]] SeriesLimit parse_series_limit(const std::string& text);

/// Refuses limits that nothing can hold: below the least or above the greatest believable value of
/// a quantity that we know, and two that contradict each other.
/// @throws Error(invalid_input) that says why; also for a unit that is not one of the quantity
/// @return limits that can never be exceeded, in words
std::vector<std::string> expect_possible(const std::vector<SeriesLimit>& limits,
                                         const ingest::Vocabulary& vocabulary);

/// The limit in the unit of a series, ready to be held against its values.
///
/// The bound is converted, not the values, and rounded to twelve digits: 0.57 m is 57 cm and not
/// 56.99999999999999. Against values in single precision it is rounded to single precision.
/// @throws Error(invalid_input) where the units do not convert
[[nodiscard]] twin::Bound bound_on(const SeriesLimit& limit, const HistorySeries& series,
                                   const ingest::Vocabulary& vocabulary);

/// The unit in which a limit is meant.
[[nodiscard]] std::string unit_of(const SeriesLimit& limit, const HistorySeries& series,
                                  const ingest::Vocabulary& vocabulary);

}  // namespace slackwater::api
