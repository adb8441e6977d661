#include "fields/wave/sea_sampling.h"

#include <array>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

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
const SeaKernels& fastest_kernels() {
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

using constants::nan;

struct Evaluated {
  SeaKernelSums sums;
  SampleStatus status = SampleStatus::missing;
};

/// Numbers where there is water; else why there is none, and the elevation of the surface over the
/// place.
void judge(const SeaKernelWaves& waves, bool stretched, double up_m, Evaluated& result) noexcept {
  const double elevation = result.sums.elevation_m;
  const double top = stretched ? elevation : 0.0;
  if (up_m >= -waves.depth_m && up_m <= top) {
    result.status = SampleStatus::ok;
    return;
  }
  result.status = up_m < -waves.depth_m ? SampleStatus::below_bed : SampleStatus::above_surface;
  result.sums = {elevation, nan, {nan, nan, nan}, {nan, nan, nan}, nan};
}

Evaluated outside(SampleStatus status) noexcept {
  return {{nan, nan, {nan, nan, nan}, {nan, nan, nan}, nan}, status};
}

SeaKernelPlace place_of(const SeaRealisation& sea, const WavePlace& at) noexcept {
  return {at.east_m, at.north_m, at.up_m, at.t_s, sea.course().at(at.t_s)};
}

Evaluated evaluate(SeaKernel kernel, const SeaRealisation& sea, const SeaKernelWaves& waves,
                   bool stretched, const WavePlace& place) noexcept {
  const SampleStatus status = status_of(place);
  if (status != SampleStatus::ok) return outside(status);
  Evaluated result;
  kernel(waves, place_of(sea, place), stretched, result.sums);
  judge(waves, stretched, place.up_m, result);
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
  const bool stretched = sea.stretching() == Stretching::wheeler;
  for (std::size_t i = 0; i < places.size(); ++i) {
    out[i] = motion_of(evaluate(kernels.motion, sea, waves, stretched, places[i]));
  }
}

void sample_waves_with(const SeaKernels& kernels, const SeaRealisation& sea,
                       std::span<const WavePlace> places, std::span<WaveSample> out) {
  expects(out.size() == places.size(), "out must hold one value for each place");
  const SeaKernelWaves waves = sea.kernel_waves();
  const bool stretched = sea.stretching() == Stretching::wheeler;
  for (std::size_t i = 0; i < places.size(); ++i) {
    out[i] = sample_of(evaluate(kernels.all, sea, waves, stretched, places[i]));
  }
}

void sample_row_with(const SeaKernels& kernels, const SeaRealisation& sea, const WaveRow& row,
                     std::span<WaveSample> out) {
  expects(out.size() <= most_in_row, "a row has at most 16 places");
  if (out.empty()) return;
  const auto further = static_cast<double>(out.size() - 1);
  const WavePlace last{row.first.east_m + further * row.east_step_m,
                       row.first.north_m + further * row.north_step_m, 0, row.first.t_s};
  for (const SampleStatus status : {status_of(row.first), status_of(last)}) {
    if (status == SampleStatus::ok) continue;
    for (WaveSample& sample : out) sample = sample_of(outside(status));
    return;
  }
  const SeaKernelWaves waves = sea.kernel_waves();
  const bool stretched = sea.stretching() == Stretching::wheeler;
  std::array<SeaKernelSums, most_in_row> sums;
  kernels.row(waves, place_of(sea, row.first),
              {row.east_step_m, row.north_step_m, row.up_step_m, 0, 1}, out.size(), stretched,
              sums.data());
  for (std::size_t j = 0; j < out.size(); ++j) {
    Evaluated result{sums[j], SampleStatus::missing};
    judge(waves, stretched, row.first.up_m + static_cast<double>(j) * row.up_step_m, result);
    out[j] = sample_of(result);
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
      kernel(waves, place_of(sea, at), true, sums);
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
  return sample_of(evaluate(fastest_kernels().all, sea, sea.kernel_waves(),
                            sea.stretching() == Stretching::wheeler, place));
}

void sample_row(const SeaRealisation& sea, const WaveRow& row, std::span<WaveSample> out) {
  sample_row_with(fastest_kernels(), sea, row, out);
}

void sample_row_on(KernelPath path, const SeaRealisation& sea, const WaveRow& row,
                   std::span<WaveSample> out) {
  sample_row_with(kernels_of(path), sea, row, out);
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
