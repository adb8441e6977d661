#pragma once
#include <vector>

#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// The white noise of an instrument's samples, from its own highest frequencies: standard deviation
/// of one component, m/s, per level.
///
///   d4 = x(i-2) - 4 x(i-1) + 6 x(i) - 4 x(i+1) + x(i+2),   Var d4 = 70 sigma^2,
///   sigma^2 = median |d4|^2 / (2 ln 2) / 70
///
/// The fourth difference leaves (2 sin(w dt/2))^4 of a motion of frequency w: of M2 sampled hourly
/// 6 %, which passes for a noise of 5 mm/s for each m/s of tide; sampled every ten minutes nothing.
/// The median does not see spikes. What changes from sample to sample in the water itself counts as
/// noise, and rightly: a product cannot know it.
///
/// 0 where it cannot be told: samples rarer than `rarest_sampling` (tide would pass for noise), or
/// fewer than twenty runs of five samples one usual step apart.
[[nodiscard]] std::vector<double> instrument_noise(const VectorColumn& observed);

inline constexpr Duration rarest_sampling = std::chrono::minutes(65);

}  // namespace slackwater::calibration
