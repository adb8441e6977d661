#pragma once
#include <span>

#include "fields/service/snapshot.h"

namespace slackwater {

/// Where the water of a forecast ends: one rule for the issued file and for everything that samples
/// it.
///
///   down to the product's deepest wet level            its values
///   a little deeper (`depth_tolerance_m`, short of
///   the next level, which the product has dry)         the deepest value holds: ok
///   from there to the bed                              the deepest value, status `carried`
///   below the bed of the column                        nothing: `below_bed`
///
/// The bed is the column's (`water_depth_m`: of the site, the bathymetry, a station), whatever the
/// product's own. A product whose cell is shallower than the site says nothing of the water between
/// its bed and the site's; the last that it knows is carried there and marked, because a current
/// that is not known must not read as calm.

/// Beds that are interpolated differ from equal ones by rounding; nobody knows them to a
/// micrometre.
inline constexpr double same_depth_m = 1e-6;

/// By how much two statements of a depth may differ and mean the same: 20 %, at least 5 m. Cells of
/// a model are that uneven (1.5 km of shelf), and so are its levels.
[[nodiscard]] double depth_tolerance_m(double depth_m) noexcept;

/// Down to which depth values of the column are not `carried`; infinite where it has none at all.
/// @param depth_m  of the snapshot's levels, ascending
[[nodiscard]] double known_to_m(const ForecastColumn& column,
                                std::span<const double> depth_m) noexcept;

/// Brings the levels of a column under the rule: below the bed nothing, above it no gap. Members
/// go with the central forecast. Doing it again changes nothing.
void keep_to_bed(ForecastColumn& column, std::span<const double> depth_m);

}  // namespace slackwater
