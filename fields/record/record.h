#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/interpolate/column.h"
#include "fields/record/piece.h"

namespace slackwater {

/// One stored piece seen at one place.
template <typename T>
struct PieceColumn {
  const Origin* origin = nullptr;  ///< owned by the pieces, which outlive the record
  Column<T> column;
  double distance_m = 0;  ///< of a point series from the place asked about; 0 for grids
  /// The height above the sea that a wind was brought to 10 m from; nothing where it is stated at
  /// 10 m, or not brought anywhere.
  std::optional<double> from_height_m{};
};

/// Everything the store holds of one quantity at one place, not yet chosen from.
template <typename T>
struct Record {
  std::vector<PieceColumn<T>> pieces;
  bool on_land = false;  ///< a product covers the place and says that it is dry there
};

using VectorRecord = Record<Horizontal>;
using ScalarRecord = Record<double>;

/// How far a point series speaks for the water, or the air, around it: currents 10 km (within which
/// `calibration/fuse` knows what distance costs), winds 50 km (over open sea they change over the
/// scale of weather), everything else 5 km.
[[nodiscard]] double series_reach_m(const std::string& standard_name) noexcept;

/// What the pieces hold at a point: grids interpolated, point series within reach as they are.
[[nodiscard]] VectorRecord record_at(const std::vector<VectorPiece>& pieces, const GeoPoint& point);
[[nodiscard]] ScalarRecord record_at(const std::vector<ScalarPiece>& pieces, const GeoPoint& point);

}  // namespace slackwater
