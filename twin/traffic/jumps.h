#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "twin/traffic/track.h"

namespace slackwater::twin {

/// What no vessel does between two reports: to be further apart than `allowance_m + most_speed_m_s
/// * time`.
struct JumpRule {
  /// 102.2 kn, the fastest that a report can tell (ITU-R M.1371-5, table 48).
  double most_speed_m_s = 52.6;
  /// For clocks that differ by a second or two and for the noise of a bad fix.
  double allowance_m = 100;
};

/// Two good reports that do not belong to one way: two craft under one number, or a receiver that
/// was moved.
struct Jump {
  double from_s = 0;
  double to_s = 0;
  double distance_m = 0;
};

/// Reports that belong together.
struct SteadyPieces {
  std::vector<std::vector<TrackPoint>> pieces;
  std::vector<Jump> jumps;  ///< one fewer than pieces
  std::size_t strays = 0;   ///< single reports elsewhere, left out
};

/// Cuts reports at jumps. A report from which the way goes on where it was before is a stray one,
/// and so is a piece of a single report beside others.
/// @param points  times strictly ascending
[[nodiscard]] SteadyPieces cut_at_jumps(std::span<const TrackPoint> points,
                                        const JumpRule& rule = {});

}  // namespace slackwater::twin
