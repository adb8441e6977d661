#pragma once
#include <cstddef>
#include <span>

#include "twin/traffic/track.h"

namespace slackwater::twin {

/// Where the follower was.
struct FollowedPoint {
  double t_s = 0;
  Triple<double> position_m;
};

/// Of a signed distance over all samples.
struct DistanceStatistics {
  double mean_m = 0;
  double rms_m = 0;
  double most_m = 0;  ///< the largest magnitude
};

/// How far a follower was from the way of a track, and from its time table.
struct Deviation {
  std::size_t samples = 0;
  std::size_t unknown = 0;  ///< samples at times of which the track says nothing: not counted
  /// From the nearest place of the way, positive to its right: was the way kept?
  DistanceStatistics across;
  /// From where the track is to that place, along the way, positive ahead: was the time kept?
  DistanceStatistics along;
  /// From where the track is: how far altogether, and how many samples were nearer than the radius
  /// asked for.
  DistanceStatistics apart;
  std::size_t within = 0;
};

/// Compares in the plane. The way is the track's curve cut into pieces of at most a second; the
/// first and last piece reach on, so that a follower that has not yet come to the start is behind
/// it, not beside it. Where the way comes near itself, the nearest place is looked for near where
/// the track is: within four times the distance from there and 20 m along the way, at most
/// `window_m`. A track that never moves has no side: the distance is across, and positive.
/// @param within_m  radius for `within`
/// @throws ContractViolation for a track without points
[[nodiscard]] Deviation deviation_from(const Track& track, const TrackRule& rule,
                                       std::span<const FollowedPoint> followed,
                                       double window_m = 500, double within_m = 10);

}  // namespace slackwater::twin
