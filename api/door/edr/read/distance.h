#pragma once
#include <span>
#include <string_view>

namespace slackwater::api::edr {

/// The distance units that we offer (`within_units`, `width_units`, `height_units` of collections).
[[nodiscard]] std::span<const std::string_view> distance_units() noexcept;

/// Metres of a distance and its unit, e.g. of `within=10&within-units=km`. Units: m, km, mi
/// (1609.344 m), nmi or NM (1852 m), ft (0.3048 m), yd (0.9144 m), their English names in singular
/// and plural, in either case. Throws Error(usage), naming the two parameters, for a distance that
/// is not greater than 0 or is beyond the globe's half circumference, and for other units.
[[nodiscard]] double parse_distance_m(std::string_view parameter, std::string_view value,
                                      std::string_view units_parameter, std::string_view units);

}  // namespace slackwater::api::edr
