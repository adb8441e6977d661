#pragma once
#include "twin/state/mission.h"

namespace slackwater::twin {

/// What a watch for headway remembers. Numbers only.
struct HeadwayState {
  Triple<double> target_m;
  double least_m = 0;      ///< the nearest that it has been to the target
  double least_at_s = -1;  ///< when; below 0: there is no target yet
};

/// Whether a vehicle still gets where it is going: it is lost to water or wind that is faster than
/// it once it has come no nearer for `patience_s`, a fiftieth of the way that it makes through the
/// water in that time being nearer.
///
/// A vehicle on its way to a waypoint is watched for that; one that holds a place for being carried
/// off it, by more than a circling craft strays. Not watched: one that follows a track in time or a
/// published follower, which may circle for ever, and one without power.
struct HeadwayWatch {
  double patience_s = 300;
  double least_gain_m = 0;  ///< in that time
  double arrived_m = 0;     ///< nearer than this it has come, whatever it does there
  double strayed_m = 0;     ///< off a place that is to be held
};
[[nodiscard]] HeadwayWatch headway_watch_of(const Mission& mission, const Autopilot& autopilot);

/// One look. @return whether the vehicle makes no headway
[[nodiscard]] bool has_lost_headway(const HeadwayWatch& watch, const Reference& reference,
                                    const Route& route, const Triple<double>& position_m,
                                    double t_s, HeadwayState& state) noexcept;

}  // namespace slackwater::twin
