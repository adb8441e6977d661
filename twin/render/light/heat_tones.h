#pragma once
#include <cstdint>
#include <vector>

#include "twin/render/light/infrared_frame.h"

namespace slackwater::twin {

/// What an infrared camera shows people: a byte a pixel, black at the coldest hundredth of what it
/// tells, white at the warmest, so that a cold sky leaves the rest its tones; at least 0.1 K from
/// one to the other.
[[nodiscard]] std::vector<std::uint8_t> heat_tones(const InfraredFrame& heat);

}  // namespace slackwater::twin
