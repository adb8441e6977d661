#include "fields/wave/sea_sampling.h"

#include <cmath>
#include <limits>

#include "fields/base/check.h"

namespace slackwater {
namespace {

SeaKernels kernels_of(KernelPath path) noexcept {
  switch (path) {
#ifdef SLACKWATER_X86_KERNELS
    case KernelPath::avx2:
      return kernel_avx2::sea_kernels();
    case KernelPath::avx512:
      return kernel_avx512::sea_kernels();
#endif
    default:
      return kernel_baseline::sea_kernels();
  }
}

/// The widest path of this machine, found once.
SeaKernels fastest_kernels() {
  static const SeaKernels kernels = kernels_of(supported_kernel_paths().back());
  return kernels;
}

/// ok, or why the place lies outside before the surface is known. NaN is outside.
SampleStatus status_of(const WavePlace& place) noexcept {
  constexpr double farthest_m = 1.0e6;
  constexpr double longest_s = 1.0e8;
  if (!(std::abs(place.east_m) <= farthest_m && std::abs(place.north_m) <= farthest_m)) {
    return SampleStatus::outside_area;
  }
  return std::abs(place.t_s) <= longest_s ? SampleStatus::ok : SampleStatus::outside_time;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Evaluated {
  SeaKernelSums sums;
  SampleStatus status = SampleStatus::missing;
};

Evaluated evaluate(SeaKernel kernel, const SeaKernelWaves& waves, Stretching stretching,
                   const WavePlace& place) noexcept {
  Evaluated result;
  result.status = status_of(place);
  if (result.status != SampleStatus::ok) {
    result.sums = {nan, nan, {nan, nan, nan}, {nan, nan, nan}, nan};
    return result;
  }
  const bool stretched = stretching == Stretching::wheeler;
  kernel(waves, {place.east_m, place.north_m, place.up_m, place.t_s}, stretched, result.sums);
  const double elevation = result.sums.elevation_m;
  const double top = stretched ? elevation : 0.0;
  if (place.up_m >= -waves.depth_m && place.up_m <= top) return result;
  result.status =
      place.up_m < -waves.depth_m ? SampleStatus::below_bed : SampleStatus::above_surface;
  result.sums = {elevation, nan, {nan, nan, nan}, {nan, nan, nan}, nan};
  return result;
}

WaveMotion motion_of(const Evaluated& at) noexcept {
  const double* const v = at.sums.velocity_m_s;
  return {at.sums.elevation_m, {v[0], v[1], v[2]}, at.status};
}

WaveSample sample_of(const Evaluated& at) noexcept {
  const double* const a = at.sums.acceleration_m_s2;
  return {motion_of(at), {a[0], a[1], a[2]}, at.sums.pressure_pa};
}

void sample_motion_with(const SeaKernels& kernels, const SeaRealisation& sea,
                        std::span<const WavePlace> places, std::span<WaveMotion> out) {
  expects(out.size() == places.size(), "out must hold one value for each place");
  const SeaKernelWaves waves = sea.kernel_waves();
  for (std::size_t i = 0; i < places.size(); ++i) {
    out[i] = motion_of(evaluate(kernels.motion, waves, sea.stretching(), places[i]));
  }
}

void sample_waves_with(const SeaKernels& kernels, const SeaRealisation& sea,
                       std::span<const WavePlace> places, std::span<WaveSample> out) {
  expects(out.size() == places.size(), "out must hold one value for each place");
  const SeaKernelWaves waves = sea.kernel_waves();
  for (std::size_t i = 0; i < places.size(); ++i) {
    out[i] = sample_of(evaluate(kernels.all, waves, sea.stretching(), places[i]));
  }
}

}  // namespace

void sample_elevation(const SeaRealisation& sea, std::span<const WavePlace> places,
                      std::span<double> out) {
  expects(out.size() == places.size(), "out must hold one value for each place");
  const SeaKernel kernel = fastest_kernels().elevation;
  const SeaKernelWaves waves = sea.kernel_waves();
  for (std::size_t i = 0; i < places.size(); ++i) {
    SeaKernelSums sums{.elevation_m = nan};
    const WavePlace& at = places[i];
    if (status_of(at) == SampleStatus::ok) {
      kernel(waves, {at.east_m, at.north_m, 0.0, at.t_s}, true, sums);
    }
    out[i] = sums.elevation_m;
  }
}

void sample_motion(const SeaRealisation& sea, std::span<const WavePlace> places,
                   std::span<WaveMotion> out) {
  sample_motion_with(fastest_kernels(), sea, places, out);
}

void sample_waves(const SeaRealisation& sea, std::span<const WavePlace> places,
                  std::span<WaveSample> out) {
  sample_waves_with(fastest_kernels(), sea, places, out);
}

WaveSample sample_waves(const SeaRealisation& sea, const WavePlace& place) {
  WaveSample sample;
  sample_waves(sea, {&place, 1}, {&sample, 1});
  return sample;
}

void sample_motion_on(KernelPath path, const SeaRealisation& sea, std::span<const WavePlace> places,
                      std::span<WaveMotion> out) {
  sample_motion_with(kernels_of(path), sea, places, out);
}

void sample_waves_on(KernelPath path, const SeaRealisation& sea, std::span<const WavePlace> places,
                     std::span<WaveSample> out) {
  sample_waves_with(kernels_of(path), sea, places, out);
}

}  // namespace slackwater
