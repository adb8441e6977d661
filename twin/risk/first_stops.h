#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "twin/risk/start_chances.h"

namespace slackwater::twin {

inline constexpr std::uint32_t never_stopped = std::numeric_limits<std::uint32_t>::max();
inline constexpr std::uint16_t no_limit = std::numeric_limits<std::uint16_t>::max();

/// The first thing that stops each start, of one member.
struct FirstStops {
  std::vector<std::uint32_t> step;   ///< of the grid; `never_stopped`
  std::vector<std::uint16_t> limit;  ///< `no_limit`
};

/// By member. What is the same in all is worked out once.
[[nodiscard]] std::vector<FirstStops> first_stops(const StartQuestion& question);
/// Of the central member of split work, limits taken in by their factors (those of the first
/// start).
[[nodiscard]] FirstStops central_stops_with_alpha(const StartQuestion& question);

}  // namespace slackwater::twin
