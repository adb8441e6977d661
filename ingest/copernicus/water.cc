#include "ingest/copernicus/water.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "fields/base/turn.h"
#include "fields/geo/polygon.h"

namespace slackwater::ingest {
namespace {

Water read_water(const Config& config, const std::string& name) {
  Water water;
  water.name = name;
  const std::vector<double> numbers = config.numbers(name, {-180.0, 360.0});
  if (numbers.size() % 2 != 0)
    config.refuse(name, formatted("found {} numbers, expected pairs: longitude and latitude of "
                                  "each corner",
                                  numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    if (std::abs(numbers[i + 1]) > 90)
      config.refuse(name, formatted("found latitude {}, expected -90 to 90; a corner is longitude, "
                                    "then latitude",
                                    numbers[i + 1]));
    water.corners.push_back(GeoPoint::from_degrees(numbers[i + 1], numbers[i]));
  }
  if (const auto flaw = flaw_of_polygon(degrees_about_first(water.corners)))
    config.refuse(name, *flaw);
  return water;
}

}  // namespace

bool Water::contains(const GeoPoint& point) const {
  const double east_deg = short_way_deg(point.longitude_deg() - corners.front().longitude_deg());
  return is_inside(degrees_about_first(corners), {east_deg, point.latitude_deg()});
}

BoundingBox Water::box() const {
  const std::vector<Horizontal> plane = degrees_about_first(corners);
  const auto [west, east] = std::minmax_element(
      plane.begin(), plane.end(), [](Horizontal a, Horizontal b) { return a.real() < b.real(); });
  const auto [south, north] = std::minmax_element(
      plane.begin(), plane.end(), [](Horizontal a, Horizontal b) { return a.imag() < b.imag(); });
  const double first_deg = corners.front().longitude_deg();
  return BoundingBox::from_degrees(first_deg + west->real(), south->imag(),
                                   first_deg + east->real(), north->imag());
}

std::vector<Water> read_waters(const Config& product) {
  std::vector<Water> waters;
  if (const auto named = product.optional_child("waters"))
    for (const std::string& name : named->keys()) waters.push_back(read_water(*named, name));
  return waters;
}

}  // namespace slackwater::ingest
