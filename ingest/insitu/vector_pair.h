#pragma once
#include <optional>
#include <string_view>

#include "ingest/insitu/series_values.h"

namespace slackwater::ingest {

/// Two standard names that make a vector, a speed and its direction.
struct VectorPair {
  std::string_view speed;
  std::string_view direction;
  bool from;  ///< the direction is where it comes from (wind), else where it goes to (current)
  std::string_view eastward;
  std::string_view northward;
};

/// The pair whose speed has this standard name and whose direction has that one; null if they make
/// none.
[[nodiscard]] const VectorPair* vector_pair_of(std::string_view speed,
                                               std::string_view direction) noexcept;
/// Whether a standard name is the speed, or the direction, of any pair.
[[nodiscard]] bool is_vector_speed(std::string_view standard_name) noexcept;
[[nodiscard]] bool is_vector_direction(std::string_view standard_name) noexcept;

/// Eastward and northward components of a speed (m s-1) and a direction (degrees clockwise from
/// true north). A speed of 0 needs no direction. The status of a component is the worse of the two;
/// where one of them has no value, neither component has.
struct Components {
  SeriesValues east;
  SeriesValues north;
};
[[nodiscard]] Components components_of(const VectorPair& pair, const SeriesValues& speed,
                                       const SeriesValues& direction);

}  // namespace slackwater::ingest
