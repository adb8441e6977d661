#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "tests/published/profile_level.h"

// What joins the dots of a profile, for rivals of the fitted one. All hold the outermost value
// beyond the outermost level: continuing a polynomial there would be no fair rival.

namespace slackwater::tests {

enum class Joined { linear, spline, pchip };
inline constexpr Joined all_joined[] = {Joined::linear, Joined::spline, Joined::pchip};
[[nodiscard]] std::string_view name_of(Joined how) noexcept;

/// The current at a depth by piecewise lines, by the natural cubic spline, or by monotone cubic
/// Hermite pieces (Fritsch and Carlson 1980, SIAM J. Numer. Anal. 17, 238, with the harmonic mean
/// of Fritsch and Butland 1984, SIAM J. Sci. Stat. Comput. 5, 300), component by component.
/// @param levels  by increasing depth, at least two
[[nodiscard]] Horizontal joined_at(std::span<const calibration::ProfileLevel> levels, Joined how,
                                   double depth_m);

}  // namespace slackwater::tests
