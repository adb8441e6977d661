#include "fields/wave/sea_realisation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater {
namespace {

using constants::pi;

constexpr std::size_t kernel_arrays = 12;
constexpr std::size_t kernel_lanes = 8;

bool is_sound(const WaveComponent& wave) {
  return std::isfinite(wave.amplitude_m) && std::isfinite(wave.intrinsic_rad_s) &&
         std::isfinite(wave.absolute_rad_s) && std::isfinite(wave.phase_rad) &&
         std::abs(wave.wavenumber_rad_m) > 0 && std::isfinite(std::abs(wave.wavenumber_rad_m));
}

/// e^(-2kh), 0 where it would be so small that quotients of it lose digits as subnormals.
double reflection_of(double kh) {
  const double reflection = std::exp(-2.0 * kh);
  return reflection < 1e-290 ? 0.0 : reflection;
}

/// The twelve values of a wave in the order of `SeaKernelWaves`.
void pack(const WaveComponent& wave, double depth_m, double* first, std::size_t stride) {
  const double k = std::abs(wave.wavenumber_rad_m);
  const double b = reflection_of(k * depth_m);
  // 1 - B by expm1, for long waves in shallow water.
  const double speed = wave.amplitude_m * wave.intrinsic_rad_s / -std::expm1(-2.0 * k * depth_m);
  const double values[kernel_arrays] = {
      wave.wavenumber_rad_m.real() / (2.0 * pi),
      wave.wavenumber_rad_m.imag() / (2.0 * pi),
      wave.absolute_rad_s / (2.0 * pi),
      wave.phase_rad / (2.0 * pi),
      wave.amplitude_m,
      k * std::numbers::log2e,
      b,
      speed * wave.wavenumber_rad_m.real() / k,
      speed * wave.wavenumber_rad_m.imag() / k,
      speed,
      wave.intrinsic_rad_s,
      constants::sea_water_density_kg_m3 * constants::gravity_m_s2 * wave.amplitude_m / (1.0 + b)};
  for (std::size_t i = 0; i < kernel_arrays; ++i) first[i * stride] = values[i];
}

}  // namespace

SeaRealisation::SeaRealisation(std::vector<WaveComponent> waves, const WaveWater& water,
                               UtcTime epoch, Stretching stretching)
    : waves_(std::move(waves)), water_(water), epoch_(epoch), stretching_(stretching) {
  expects(water_.depth_m > 0 && std::isfinite(water_.depth_m), "the water depth must be positive");
  expects(waves_.size() <= most_kernel_waves, "a sea has at most 1024 waves");
  expects(std::all_of(waves_.begin(), waves_.end(), is_sound),
          "a wave has finite values and a wavenumber above 0");
  // The kernel stops at the first wave that does not reach down to a place.
  std::sort(waves_.begin(), waves_.end(), [](const WaveComponent& a, const WaveComponent& b) {
    return std::pair(std::norm(a.wavenumber_rad_m), a.phase_rad) <
           std::pair(std::norm(b.wavenumber_rad_m), b.phase_rad);
  });
  padded_ = (waves_.size() + kernel_lanes - 1) / kernel_lanes * kernel_lanes;
  packed_.assign(kernel_arrays * padded_, 0.0);
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    pack(waves_[i], water_.depth_m, packed_.data() + i, padded_);
  }
}

SeaRealisation SeaRealisation::following(HeightCourse course) const {
  SeaRealisation sea = *this;
  sea.course_ = std::move(course);
  return sea;
}

double SeaRealisation::variance_m2() const noexcept {
  double sum = 0;
  for (const WaveComponent& wave : waves_) sum += 0.5 * wave.amplitude_m * wave.amplitude_m;
  return sum;
}

double SeaRealisation::significant_height_m() const noexcept {
  return 4.0 * std::sqrt(variance_m2());
}

SeaKernelWaves SeaRealisation::kernel_waves() const noexcept {
  const double* const p = packed_.data();
  const std::size_t n = padded_;
  return {n,         water_.depth_m, p,         p + n,     p + 2 * n, p + 3 * n,  p + 4 * n,
          p + 5 * n, p + 6 * n,      p + 7 * n, p + 8 * n, p + 9 * n, p + 10 * n, p + 11 * n};
}

SeaRealisation realise(const PartitionedSea& sea, const WaveWater& water, std::uint64_t run_seed,
                       UtcTime epoch, const ComponentChoice& choice) {
  return {components_of(sea, water, run_seed, choice).waves, water, epoch};
}

}  // namespace slackwater
