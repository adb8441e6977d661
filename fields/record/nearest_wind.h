#pragma once
#include <vector>

#include "fields/record/record.h"

namespace slackwater {

/// The wind of the cell nearest to a point, for the baseline `reference-slab`, whose recipe takes
/// that cell where the forecast itself interpolates: nearest latitude and nearest longitude, each
/// by itself. Of two equally near the first in the order of the product's file counts: the western
/// one, and the southern one in Copernicus Marine's wind (written south to north), the northern one
/// in any other (weather centres write north to south); the store does not keep a file's own order.
///
/// @param wind    the record at the point; decides which products answer, and is itself the answer
///                for moored instruments and where the nearest cell has no value at all
/// @param pieces  the pieces that the record was made from
[[nodiscard]] VectorRecord nearest_wind(const VectorRecord& wind,
                                        const std::vector<VectorPiece>& pieces,
                                        const GeoPoint& point);

}  // namespace slackwater
