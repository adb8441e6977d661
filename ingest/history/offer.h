#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

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
};

/// What a wanted quantity is made of: one column, or two components of a vector whose speed it is.
struct Making {
  std::size_t first = 0;
  std::optional<std::size_t> second{};
};

/// How a wanted quantity comes from what a file offers: by the column's own name, by its standard
/// name, or, `wind_speed` and `sea_water_speed`, from the two components. Nothing where the file
/// has none of these.
/// @throws Error(invalid_input) where two columns are the same quantity
[[nodiscard]] std::optional<Making> making_of(const std::string& wanted,
                                              const std::vector<Offer>& offers,
                                              const Vocabulary& vocabulary);

/// The current standard name where a name is an older or kindred one that means the same; else the
/// name.
[[nodiscard]] std::string current_name(const std::string& name, const Vocabulary& vocabulary);

}  // namespace slackwater::ingest
