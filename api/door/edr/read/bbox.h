#pragma once
#include <optional>
#include <string_view>

#include "api/door/edr/read/geometry.h"
#include "api/door/edr/read/vertical.h"

namespace slackwater::api::edr {

struct BoundingBox {
  Box box;
  std::optional<LevelRange> levels;
};

/// Reads `bbox`: west,south,east,north in degrees, or with vertical limits as third and sixth:
/// west,south,low,east,north,high. West greater than east: the box crosses the antimeridian (or, by
/// longitudes from 0 to 360, Greenwich); one of the two is then given by the name, 360 away,
/// that makes west the lesser. Longitudes in [-180, 360], latitudes in [-90, 90]. Throws
/// Error(usage) for anything else.
[[nodiscard]] BoundingBox parse_bbox(std::string_view text);

}  // namespace slackwater::api::edr
