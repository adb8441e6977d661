#include "fields/record/nearest_wind.h"

#include <algorithm>
#include <cmath>

#include "fields/interpolate/stencil.h"

namespace slackwater {
namespace {

/// Degrees: distances closer than the rounding of a place in radians are equal.
constexpr double same_deg = 1e-9;

/// Index of the value nearest to `wanted`; of two equally near the first, or the last.
std::size_t nearest(const std::vector<double>& axis, double wanted, bool last_of_equals) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < axis.size(); ++i) {
    const double gain = std::abs(axis[best] - wanted) - std::abs(axis[i] - wanted);
    if (gain > same_deg || (last_of_equals && gain > -same_deg)) best = i;
  }
  return best;
}

bool written_south_to_north(const Origin& origin) { return origin.product_id.starts_with("WIND_"); }

/// The cell's series in the shape of the interpolated column; nothing where the cell is masked.
std::optional<VectorColumn> column_of_cell(const VectorPiece& piece, const VectorColumn& shape,
                                           const GeoPoint& point) {
  const Grid& grid = piece.east.grid;
  const std::size_t row =
      nearest(grid.latitude_deg, point.latitude_deg(), !written_south_to_north(piece.origin));
  const std::size_t column = nearest(grid.longitude_deg, longitude_on_axis_deg(grid, point), false);
  VectorColumn cell = shape;
  bool any = false;
  for (std::size_t t = 0; t < cell.times(); ++t) {
    for (std::size_t k = 0; k < cell.levels(); ++k) {
      const std::size_t from = grid.offset(t, k, row, column);
      const std::size_t to = cell.offset(t, k);
      const Horizontal value(static_cast<double>(piece.east.values[from]),
                             static_cast<double>(piece.north.values[from]));
      const bool there = !std::isnan(value.real()) && !std::isnan(value.imag());
      cell.value[to] = there ? value : Horizontal{};
      cell.status[to] = there ? SampleStatus::ok : SampleStatus::missing;
      any = any || there;
    }
  }
  if (!any) return std::nullopt;
  return cell;
}

}  // namespace

VectorRecord nearest_wind(const VectorRecord& wind, const std::vector<VectorPiece>& pieces,
                          const GeoPoint& point) {
  VectorRecord record = wind;
  for (PieceColumn<Horizontal>& part : record.pieces) {
    if (part.origin->is_point_series) continue;
    const auto piece = std::find_if(pieces.begin(), pieces.end(),
                                    [&](const VectorPiece& p) { return &p.origin == part.origin; });
    if (piece == pieces.end()) continue;
    if (auto cell = column_of_cell(*piece, part.column, point)) part.column = std::move(*cell);
  }
  return record;
}

}  // namespace slackwater
