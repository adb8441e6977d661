#pragma once
#include <cstdint>
#include <vector>

#include "fields/base/time.h"
#include "fields/wave/height_course.h"
#include "fields/wave/sea_components.h"
#include "fields/wave/sea_kernel.h"

namespace slackwater {

/// How the linear velocity, which ends at still water, is brought to the moving surface.
enum class Stretching {
  /// z -> h (z - eta)/(h + eta): what holds at still water holds at the surface (Wheeler 1970).
  wheeler,
  /// As it stands, the water ending at z = 0: for comparison with the exact linear field.
  none,
};

/// A sea of sinusoids over water of one depth and current; immutable, shared by any threads.
///
///   eta = sum a cos(theta),  theta = k . x - omega t + epsilon
///   (u, v) = sum a sigma cosh k(z+h)/sinh kh cos(theta) k/|k|,
///   w = sum a sigma sinh k(z+h)/sinh kh sin(theta),
///   p = sum rho g a cosh k(z+h)/cosh kh cos(theta)
///
/// A sea that follows a course of its height has all of these times r(t): the same waves, higher or
/// lower (height_course.h); stretching is to the surface as it then is.
///
/// Source: Airy (1845); Dean & Dalrymple (1991), ch. 3; with a current Peregrine (1976).
class SeaRealisation {
 public:
  /// Throws ContractViolation for a depth that is not positive, a wave without length or with a
  /// value that is not finite, and more than 1 024 waves. No waves: a calm sea.
  SeaRealisation(std::vector<WaveComponent> waves, const WaveWater& water, UtcTime epoch,
                 Stretching stretching = Stretching::wheeler);
  /// The same waves, whose height follows a course. @param course  of the seconds since the epoch
  [[nodiscard]] SeaRealisation following(HeightCourse course) const;

  /// By ascending wavenumber.
  [[nodiscard]] const std::vector<WaveComponent>& waves() const noexcept { return waves_; }
  [[nodiscard]] const WaveWater& water() const noexcept { return water_; }
  [[nodiscard]] UtcTime epoch() const noexcept { return epoch_; }
  [[nodiscard]] Stretching stretching() const noexcept { return stretching_; }
  [[nodiscard]] const HeightCourse& course() const noexcept { return course_; }
  /// Variance of the surface, sum a^2/2: exact over an endless record, m2; where r(t) is 1.
  [[nodiscard]] double variance_m2() const noexcept;
  [[nodiscard]] double significant_height_m() const noexcept;  ///< 4 sqrt(variance)
  /// The arrays of the kernel; they live as long as this.
  [[nodiscard]] SeaKernelWaves kernel_waves() const noexcept;

 private:
  std::vector<WaveComponent> waves_;
  WaveWater water_;
  UtcTime epoch_;
  Stretching stretching_;
  HeightCourse course_;
  std::size_t padded_ = 0;      ///< waves, up to a multiple of 8 by waves of no height
  std::vector<double> packed_;  ///< the arrays of SeaKernelWaves, one after the other
};

/// A sea from partitions and a seed: `components_of` put to use. Throws as that does.
[[nodiscard]] SeaRealisation realise(const PartitionedSea& sea, const WaveWater& water,
                                     std::uint64_t run_seed, UtcTime epoch,
                                     const ComponentChoice& choice = {});
}  // namespace slackwater
