#pragma once
#include <span>

#include "fields/current/tide.h"

namespace slackwater::calibration {

/// The harmonic tide of a level, by the rules of currents (`fit_tide`): which constituents a record
/// of this length shows, which are inferred, which are dropped. A real series is a current along
/// one axis; its mean stays with the fit. Nothing is left out as inertial motion, which no level
/// has.
/// @param value_m  used where the status has a value
[[nodiscard]] TideFit fit_level_tide(std::span<const TimeCell> time,
                                     std::span<const double> value_m,
                                     std::span<const SampleStatus> status);

/// Mean and tide of a level, m, at an instant or over a mean's interval.
[[nodiscard]] double level_over(const TideFit& fit, const TimeCell& cell) noexcept;

}  // namespace slackwater::calibration
