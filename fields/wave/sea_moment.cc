#include "fields/wave/sea_moment.h"

#include <array>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/wave/sea_moment_kernel.h"

namespace slackwater {
namespace {

SeaMomentKernel kernel_of(KernelPath path) noexcept {
  switch (path) {
#ifdef SLACKWATER_X86_KERNELS
    case KernelPath::avx2:
      return kernel_avx2::sea_moment_kernel();
    case KernelPath::avx512:
      return kernel_avx512::sea_moment_kernel();
#endif
    default:
      return kernel_baseline::sea_moment_kernel();
  }
}

using constants::nan;

MomentSample without_value(SampleStatus status, double elevation_m, double rise_m_s) noexcept {
  return {{elevation_m, {nan, nan, nan}, status}, {nan, nan, nan}, rise_m_s};
}

/// ok, or why it is outside before the surface is known.
SampleStatus status_of(const MomentPlace& first, const MomentPlace& place, double t_s) noexcept {
  constexpr double farthest_m = 1.0e6;  // as in sea_sampling.cc
  constexpr double longest_s = 1.0e8;
  const bool is_near = std::abs(first.east_m) <= farthest_m &&
                       std::abs(first.north_m) <= farthest_m &&
                       std::abs(place.east_m - first.east_m) <= moment_reach_m &&
                       std::abs(place.north_m - first.north_m) <= moment_reach_m;
  if (!is_near) return SampleStatus::outside_area;
  return std::abs(t_s) <= longest_s ? SampleStatus::ok : SampleStatus::outside_time;
}

MomentSample judged(const SeaMomentSums& sums, double up_m, double depth_m,
                    bool stretched) noexcept {
  const double top_m = stretched ? static_cast<double>(sums.elevation_m) : 0.0;
  if (!(up_m <= top_m))
    return without_value(SampleStatus::above_surface, sums.elevation_m, sums.rise_m_s);
  if (up_m < -depth_m)
    return without_value(SampleStatus::below_bed, sums.elevation_m, sums.rise_m_s);
  const float* const v = sums.velocity_m_s;
  const float* const a = sums.acceleration_m_s2;
  return {
      {sums.elevation_m, {v[0], v[1], v[2]}, SampleStatus::ok}, {a[0], a[1], a[2]}, sums.rise_m_s};
}

void sample_with(SeaMomentKernel kernel, const SeaRealisation& sea, double t_s,
                 std::span<const MomentPlace> places, std::span<MomentSample> out) {
  expects(places.size() <= most_in_moment, "a moment has at most 32 places");
  expects(out.size() == places.size(), "out must hold one value for each place");
  std::array<SeaMomentPlace, most_in_moment> asked;
  std::array<std::size_t, most_in_moment> index{};
  std::array<SeaMomentSums, most_in_moment> sums;
  std::size_t count = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const SampleStatus status = status_of(places[0], places[i], t_s);
    if (status != SampleStatus::ok) {
      out[i] = without_value(status, nan, nan);
      continue;
    }
    asked[count] = {static_cast<float>(places[i].east_m - places[0].east_m),
                    static_cast<float>(places[i].north_m - places[0].north_m),
                    static_cast<float>(places[i].up_m),
                    static_cast<float>(places[i].velocity_m_s[0]),
                    static_cast<float>(places[i].velocity_m_s[1]),
                    static_cast<float>(places[i].velocity_m_s[2])};
    index[count++] = i;
  }
  if (count == 0) return;
  const bool stretched = sea.stretching() == Stretching::wheeler;
  kernel(sea.kernel_waves(), {places[0].east_m, places[0].north_m, 0, t_s, sea.course().at(t_s)},
         stretched, asked.data(), count, sums.data());
  for (std::size_t n = 0; n < count; ++n)
    out[index[n]] = judged(sums[n], places[index[n]].up_m, sea.water().depth_m, stretched);
}

}  // namespace

void sample_moment(const SeaRealisation& sea, double t_s, std::span<const MomentPlace> places,
                   std::span<MomentSample> out) {
  static const SeaMomentKernel kernel = kernel_of(supported_kernel_paths().back());
  sample_with(kernel, sea, t_s, places, out);
}

void sample_moment_on(KernelPath path, const SeaRealisation& sea, double t_s,
                      std::span<const MomentPlace> places, std::span<MomentSample> out) {
  sample_with(kernel_of(path), sea, t_s, places, out);
}

}  // namespace slackwater
