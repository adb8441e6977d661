#pragma once
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "fields/geo/geo_point.h"

namespace slackwater::ingest {

/// A stretch of sea in which a product has water. Its corners may lie on land: the polygon parts
/// one sea from another, it does not draw the coast. Less than 180 degrees wide.
struct Water {
  std::string name;
  std::vector<GeoPoint> corners;  ///< in order, the last joined to the first

  [[nodiscard]] bool contains(const GeoPoint& point) const;
  /// The smallest box round the corners.
  [[nodiscard]] BoundingBox box() const;
};

/// `waters` of a descriptor, each a name and its corners, longitude before latitude:
///
///     waters:
///       marmara: [26.2, 39.95,  27.2, 39.85,  30.05, 40.2,  29.4, 41.15]
///
/// @throws Error(invalid_input) for a corner without latitude, a latitude beyond a pole, fewer than
///         three corners, one twice running, sides that cross
[[nodiscard]] std::vector<Water> read_waters(const Config& product);

}  // namespace slackwater::ingest
