#pragma once
#include <functional>

#include "api/door/edr/read/geometry.h"

namespace slackwater::api::edr {

/// A region of the earth's surface that a query asks about. `is_inside` is asked of places in `box`
/// alone, their longitudes as the box counts them.
struct AskedArea {
  Box box;
  std::function<bool(double longitude_deg, double latitude_deg)> is_inside;
  std::size_t vertices = 1;  ///< what one call of `is_inside` costs
};

/// All of a box.
[[nodiscard]] AskedArea shape_of(const Box& box);
/// POLYGON or MULTIPOLYGON.
[[nodiscard]] AskedArea shape_of(Geometry polygons);
/// What lies within a distance of a place.
[[nodiscard]] AskedArea circle(double longitude_deg, double latitude_deg, double radius_m);

/// The longitude as the box counts it.
[[nodiscard]] double in_box(double longitude_deg, const Box& box) noexcept;

/// What two boxes share, with the second moved by whole turns to where they share most;
/// west > east for nothing.
[[nodiscard]] Box shared(const Box& asked, const Box& area) noexcept;

}  // namespace slackwater::api::edr
