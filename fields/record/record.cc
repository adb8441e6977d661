#include "fields/record/record.h"

#include <algorithm>

#include "fields/interpolate/column_of_field.h"

namespace slackwater {
namespace {

constexpr double current_reach_m = 10000.0;
constexpr double wind_reach_m = 50000.0;
constexpr double other_reach_m = 5000.0;

GeoPoint place_of(const Grid& grid) {
  return GeoPoint::from_degrees(grid.latitude_deg.front(), grid.longitude_deg.front());
}

struct Place {
  GeoPoint point;
  double distance_m = 0;
};

/// A series answers at its own place wherever within reach it is asked; a grid answers where it is
/// asked.
std::optional<Place> where_to_ask(const Origin& origin, const GriddedField& field,
                                  const GeoPoint& point) {
  if (!origin.is_point_series) return Place{point, 0};
  const GeoPoint mooring = place_of(field.grid);
  const double distance = distance_m(mooring, point);
  if (distance > series_reach_m(field.standard_name)) return std::nullopt;
  return Place{mooring, distance};
}

template <typename T>
bool anything(const Column<T>& column) {
  return std::any_of(column.status.begin(), column.status.end(),
                     [](SampleStatus s) { return has_value(s); });
}

template <typename T, typename Piece, typename FieldOf, typename ColumnOf>
Record<T> record_of(const std::vector<Piece>& pieces, const GeoPoint& point, FieldOf field_of,
                    ColumnOf column_of_piece) {
  Record<T> record;
  for (const Piece& piece : pieces) {
    const auto place = where_to_ask(piece.origin, field_of(piece), point);
    if (!place) continue;
    Column<T> column = column_of_piece(piece, place->point);
    if (anything(column)) {
      record.pieces.push_back({&piece.origin, std::move(column), place->distance_m});
    } else if (column.status.front() == SampleStatus::land) {
      record.on_land = true;
    }
  }
  return record;
}

}  // namespace

VectorRecord record_at(const std::vector<VectorPiece>& pieces, const GeoPoint& point) {
  return record_of<Horizontal>(
      pieces, point, [](const VectorPiece& piece) -> const GriddedField& { return piece.east; },
      [](const VectorPiece& piece, const GeoPoint& place) {
        return column_of(piece.east, piece.north, place, piece.origin.status);
      });
}

ScalarRecord record_at(const std::vector<ScalarPiece>& pieces, const GeoPoint& point) {
  return record_of<double>(
      pieces, point, [](const ScalarPiece& piece) -> const GriddedField& { return piece.field; },
      [](const ScalarPiece& piece, const GeoPoint& place) {
        return column_of(piece.field, place, piece.origin.status);
      });
}

double series_reach_m(const std::string& standard_name) noexcept {
  if (standard_name.ends_with("ward_sea_water_velocity")) return current_reach_m;
  if (standard_name.ends_with("ward_wind")) return wind_reach_m;
  return other_reach_m;
}

}  // namespace slackwater
