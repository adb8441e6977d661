#pragma once
#include <span>
#include <vector>

#include "fields/base/time.h"
#include "fields/current/kernel_dispatch.h"
#include "fields/grid/status.h"
#include "fields/wave/sea_kernel.h"
#include "fields/wave/wave_component.h"

namespace slackwater {

/// How the linear velocity, which ends at still water, is brought to the moving surface.
enum class Stretching {
  /// z -> h (z - eta)/(h + eta): what holds at still water holds at the surface (Wheeler 1970).
  wheeler,
  /// As it stands, the water ending at z = 0: for comparison with the exact linear field.
  none,
};

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

/// A sea of sinusoids over water of one depth and current; immutable, shared by any threads.
///
///   eta = sum a cos(theta),  theta = k . x - omega t + epsilon
///   (u, v) = sum a sigma cosh k(z+h)/sinh kh cos(theta) k/|k|,  w = sum a sigma sinh k(z+h)/sinh kh
///   sin(theta),  p = sum rho g a cosh k(z+h)/cosh kh cos(theta)
///
/// Source: Airy (1845); Dean & Dalrymple (1991), ch. 3; with a current Peregrine (1976).
class SeaRealisation {
 public:
  /// Throws ContractViolation for a depth that is not positive, a wave without length or with a
  /// value that is not finite, and more than 1 024 waves. No waves: a calm sea.
  SeaRealisation(std::vector<WaveComponent> waves, const WaveWater& water, UtcTime epoch,
                 Stretching stretching = Stretching::wheeler);

  /// By ascending wavenumber.
  [[nodiscard]] const std::vector<WaveComponent>& waves() const noexcept { return waves_; }
  [[nodiscard]] const WaveWater& water() const noexcept { return water_; }
  [[nodiscard]] UtcTime epoch() const noexcept { return epoch_; }
  [[nodiscard]] Stretching stretching() const noexcept { return stretching_; }
  /// Variance of the surface, sum a^2/2: exact over an endless record, m2.
  [[nodiscard]] double variance_m2() const noexcept;
  [[nodiscard]] double significant_height_m() const noexcept;  ///< 4 sqrt(variance)
  /// The arrays of the kernel; they live as long as this.
  [[nodiscard]] SeaKernelWaves kernel_waves() const noexcept;

 private:
  std::vector<WaveComponent> waves_;
  WaveWater water_;
  UtcTime epoch_;
  Stretching stretching_;
  std::size_t padded_ = 0;      ///< waves, up to a multiple of 8 by waves of no height
  std::vector<double> packed_;  ///< the arrays of SeaKernelWaves, one after the other
};

/// A sea from partitions, or from a measured spectrum, and a seed: `components_of` put to use.
/// Throws as that does.
[[nodiscard]] SeaRealisation realise(const PartitionedSea& sea, const WaveWater& water,
                                     std::uint64_t run_seed, UtcTime epoch,
                                     const ComponentChoice& choice = {});
[[nodiscard]] SeaRealisation realise(const DirectionalSpectrum& spectrum, const WaveWater& water,
                                     std::uint64_t run_seed, UtcTime epoch,
                                     const ComponentChoice& choice = {
                                         .frame = FrequencyFrame::absolute});

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

/// The same on one path, which this machine must support (`supported_kernel_paths`).
void sample_motion_on(KernelPath path, const SeaRealisation& sea, std::span<const WavePlace> places,
                      std::span<WaveMotion> out);
void sample_waves_on(KernelPath path, const SeaRealisation& sea, std::span<const WavePlace> places,
                     std::span<WaveSample> out);

}  // namespace slackwater
