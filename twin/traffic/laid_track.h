#pragma once
#include <span>

#include "twin/traffic/track.h"

namespace slackwater::twin {

/// A track made up by hand: from one place to the next by straight ways at a constant speed over
/// ground, from `begin_s` on. One place alone: at anchor there until `end_s`. Reports are laid
/// close enough together that no rule sees a gap.
/// @param speed_m_s  > 0, but for a vessel at anchor
/// @throws ContractViolation without a place
[[nodiscard]] Track laid_track(std::span<const Triple<double>> places, double speed_m_s,
                               double begin_s, double end_s);

}  // namespace slackwater::twin
