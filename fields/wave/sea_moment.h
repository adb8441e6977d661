#pragma once
#include <span>

#include "fields/wave/sea_sampling.h"

namespace slackwater {

/// A place in the sea at a given moment: metres in ENU about the realisation's origin, up from
/// still water; and how it moves, ENU over ground.
struct MomentPlace {
  double east_m = 0;
  double north_m = 0;
  double up_m = 0;
  double velocity_m_s[3] = {};
};

/// The sea there. Numbers hold where `has_value(status)`; else they are NaN, but for the elevation,
/// which holds above the surface and below the bed too.
struct MomentSample {
  WaveMotion motion;
  /// By how much the orbital velocity changes for one who moves so, ENU: du/dt at a place at rest,
  /// and for one that goes with the sea's current Du/Dt of `WaveSample`, but for what the moving
  /// surface stretches meanwhile.
  double acceleration_m_s2[3] = {};
  double rise_m_s = 0;  ///< of the elevation for one who moves so; holds where that does
};

/// The most places of one call, and how far from the first of them the others may lie: beyond, the
/// phases of short waves would lose digits.
inline constexpr std::size_t most_in_moment = 32;
inline constexpr double moment_reach_m = 2000;

/// The sea at places near each other, all at one moment, twice as quick as `sample_waves`: the
/// phases of the first place are made in double precision, the rest is done in single.
///
/// Differs from `sample_waves` by less than 5e-5 of the sum of the waves' amplitudes (or of their
/// velocities at the surface), from rounding and from waves left out where they have less than 6e-5
/// of their motion at the surface. Wheeler's stretching as the sea has it. No allocation, no lock;
/// the same bits on every instruction set. `out` has the length of `places`, at most
/// `most_in_moment`, else a contract violation; a place too far from the first is outside_area.
void sample_moment(const SeaRealisation& sea, double t_s, std::span<const MomentPlace> places,
                   std::span<MomentSample> out);
/// The same on one path, which this machine must support.
void sample_moment_on(KernelPath path, const SeaRealisation& sea, double t_s,
                      std::span<const MomentPlace> places, std::span<MomentSample> out);

}  // namespace slackwater
