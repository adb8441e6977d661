#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fields/record/history_series.h"
#include "ingest/copernicus/vocabulary.h"

namespace slackwater::ingest {

/// What the user says of one column of a table, or of one variable of a NetCDF file.
struct NamedColumn {
  std::string column;
  std::string standard_name;  ///< CF
  std::string unit;           ///< empty: the canonical one, or what the file states
};
/// Reads "NAME=STANDARD_NAME" or "NAME=STANDARD_NAME:UNIT". @throws Error(usage)
[[nodiscard]] NamedColumn parse_named_column(const std::string& text);

/// A column or variable of a file, as the quantity it is.
struct Offer {
  std::string name;
  std::string standard_name;  ///< CF, the current one of several that mean the same
  std::string unit;           ///< empty: nobody says
  bool is_named = false;      ///< the user says that it is this quantity
};

/// What is made of the two components of a vector.
enum class VectorPart { speed, from_direction, to_direction };

/// What a wanted quantity is made of: one column, or the two components of a vector, east and
/// north.
struct Making {
  std::size_t first = 0;
  std::optional<std::size_t> second{};
  VectorPart part = VectorPart::speed;  ///< of two
  std::string standard_name{};          ///< of what is made of two
};

/// The speed of a vector, or its direction in degrees clockwise from north, [0, 360): NaN of a
/// vector of no length.
[[nodiscard]] double part_of(VectorPart part, double east, double north) noexcept;

/// Makes of the series of an eastward component what is wanted of both.
/// @throws Error(invalid_input) where times or units of the two differ
void make_of_components(HistorySeries& east, const HistorySeries& north, const Making& making);

/// Whether the values of a quantity are directions, between which nothing is interpolated.
[[nodiscard]] bool is_direction(const std::string& standard_name);

/// How a wanted quantity comes from what a file offers: by the column's own name, by its standard
/// name, or, speeds and directions of wind and current, from the two components. Nothing where the
/// file has none of these. Of several of one standard name the one that the user names is meant.
/// @throws Error(invalid_input) where two columns are the same quantity, and where one component is
///         named and the other is not
[[nodiscard]] std::optional<Making> making_of(const std::string& wanted,
                                              const std::vector<Offer>& offers,
                                              const Vocabulary& vocabulary);

/// In words, where of a wanted speed and its direction one is a column and the other made of
/// components: they may be of different heights.
[[nodiscard]] std::vector<std::string> made_apart(const std::vector<std::string>& wanted,
                                                  const std::vector<Offer>& offers,
                                                  const Vocabulary& vocabulary);

/// The current standard name where a name is an older or kindred one that means the same; else the
/// name.
[[nodiscard]] std::string current_name(const std::string& name, const Vocabulary& vocabulary);

}  // namespace slackwater::ingest
