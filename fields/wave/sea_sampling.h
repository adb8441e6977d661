#pragma once
#include <span>

#include "fields/current/kernel_dispatch.h"
#include "fields/grid/status.h"
#include "fields/wave/sea_realisation.h"

namespace slackwater {

/// A place in the sea: metres in ENU about the realisation's origin, up from still water, seconds
/// since its epoch. Far away (|east|, |north| > 1000 km, |t| > 3 years) is outside.
struct WavePlace {
  double east_m = 0;
  double north_m = 0;
  double up_m = 0;
  double t_s = 0;
};

/// The sea at a place. Numbers hold where `has_value(status)`; else they are NaN, but for the
/// elevation, which holds above the surface and below the bed too.
struct WaveMotion {
  double elevation_m = 0;       ///< eta, of the surface over this point
  double velocity_m_s[3] = {};  ///< orbital, ENU, without the current
  SampleStatus status =
      SampleStatus::missing;  ///< ok, above_surface, below_bed, outside_area/_time
};
struct WaveSample {
  WaveMotion motion;
  /// Du/Dt = du/dt + U . grad u of the orbital velocity, ENU: what a body that moves with the
  /// current feels, and the force of the pressure, -grad p/rho. Without a current it is du/dt.
  double acceleration_m_s2[3] = {};
  double pressure_pa = 0;  ///< dynamic: what the waves add to the hydrostatic pressure below z = 0
};

/// The sea at many places. No allocation, no lock; the same bits on every instruction set, whatever
/// the batch. Errors of the arithmetic: 2e-11 in sin and cos, 6e-11 in the decay with depth, and
/// the rounding of the phase, 2^-52 of the turns since the epoch (1e-10 turns after 100 days).
/// `out` has the length of `places`, else a contract violation.
void sample_elevation(const SeaRealisation& sea, std::span<const WavePlace> places,
                      std::span<double> out);  ///< NaN where the place is outside; `up_m` unused
void sample_motion(const SeaRealisation& sea, std::span<const WavePlace> places,
                   std::span<WaveMotion> out);
void sample_waves(const SeaRealisation& sea, std::span<const WavePlace> places,
                  std::span<WaveSample> out);
[[nodiscard]] WaveSample sample_waves(const SeaRealisation& sea, const WavePlace& place);

/// Places in a row, each a step further than the one before it, all at one time.
struct WaveRow {
  WavePlace first;
  double east_step_m = 0;
  double north_step_m = 0;
  double up_step_m = 0;
};
inline constexpr std::size_t most_in_row = 16;

/// The sea along a row, a tenth quicker than place by place: the phases of a place are those of the
/// one before it, turned on. Their error, 2e-11, grows as much again with each place. `out` has one
/// value for each of at most `most_in_row` places, else a contract violation.
void sample_row(const SeaRealisation& sea, const WaveRow& row, std::span<WaveSample> out);
void sample_row_on(KernelPath path, const SeaRealisation& sea, const WaveRow& row,
                   std::span<WaveSample> out);

/// The same on one path, which this machine must support (`supported_kernel_paths`).
void sample_motion_on(KernelPath path, const SeaRealisation& sea, std::span<const WavePlace> places,
                      std::span<WaveMotion> out);
void sample_waves_on(KernelPath path, const SeaRealisation& sea, std::span<const WavePlace> places,
                     std::span<WaveSample> out);

}  // namespace slackwater
