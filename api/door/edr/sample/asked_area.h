#pragma once
#include <functional>
#include <vector>

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

/// What two boxes share, as the first counts longitudes; west > east for nothing. Where both ends
/// of a wide area lie in the first box, its longitudes stay as asked. Of a whole turn that is asked
/// what the area has, in one piece.
[[nodiscard]] Box shared(const Box& asked, const Box& area) noexcept;

/// Places of a grid.
struct Axes {
  std::vector<double> longitude_deg;
  std::vector<double> latitude_deg;
};

/// Evenly from one to the other, both included; the middle where it is one.
[[nodiscard]] std::vector<double> even_axis(double low, double high, std::size_t count);

/// A place inside a shape that holds none of what is asked for: its middle, or any of a fine grid
/// over it.
[[nodiscard]] Axes some_place_in(const Box& box,
                                 const std::function<bool(double, double)>& is_inside);

}  // namespace slackwater::api::edr
