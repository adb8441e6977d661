#pragma once
#include "twin/environment/carried_water.h"

namespace slackwater::twin {

/// How the water and the tether of a vehicle are stepped where not each tremble is asked for but
/// the figures of a mission: tension, place, energy, time. The vehicle itself, its thrusters,
/// battery and autopilot keep their step.
///
/// A tether is stepped through drag and tension by implicit formulas (tether_dynamics.h), which
/// bear some steps of a vehicle at once (long_step.h), and holds its pull meanwhile. Against the
/// full step mean tension, bow and energy stay within 2 % over the range of small ROVs at a
/// foundation (tests/bench/rehearse_bench.cc has the table), at a tenth of the time.
struct CoarsePlan {
  double look_s = 0;  ///< from one look at the water to the next, a whole number of pulls
  double pull_s = 0;  ///< of a step of the tether, a whole number of steps of the vehicle
  double late_s = 0;  ///< half a step: within it a time has come
};

/// Numbers only: they are copied into a checkpoint and back.
struct CoarseState {
  CarriedWater water;
  Triple<double> pull_n;    ///< of the tether on the vehicle, NED
  double pulled_to_s = -1;  ///< below 0: not yet
};

}  // namespace slackwater::twin
