#pragma once
#include "fields/interpolate/column.h"

namespace slackwater {

/// The column of a horizontal vector at a point, from its two components on one grid.
///
/// Bilinear over the wet cells around the point: a cell that is masked at a level at every time
/// carries no weight there, and the other weights are scaled up to one, so a masked value is never
/// averaged in. A value that is missing only at some times makes the column missing at those times.
/// Where no cell around is wet the status says land (dry at the top level) or below_bed (wet
/// above). A point series keeps its own statuses. `source` is filled with `status_of_file` for
/// every time.
[[nodiscard]] VectorColumn column_of(const GriddedField& east, const GriddedField& north,
                                     const GeoPoint& point, DataStatus status_of_file);

/// The same for a scalar. A direction (unit "degree") is interpolated through unit vectors, never
/// as a number.
[[nodiscard]] ScalarColumn column_of(const GriddedField& field, const GeoPoint& point,
                                     DataStatus status_of_file);

}  // namespace slackwater
