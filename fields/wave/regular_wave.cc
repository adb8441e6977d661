#include "fields/wave/regular_wave.h"

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/service/snapshot.h"
#include "fields/wave/dispersion.h"
#include "fields/wave/sea_realisation.h"

namespace slackwater {
namespace {

constexpr double most_steepness = 0.142;

double frequency_rad_s(double period_s) { return 2 * constants::pi / period_s; }

/// The shortest period whose wave of this height stands; infinite where the water is too shallow
/// for any.
double least_period_s(double height_m, double water_depth_m) {
  double low_s = 0.01, high_s = 1;
  while (breaking_height_m(high_s, water_depth_m) < height_m) {
    high_s *= 2;
    if (high_s > 1e4) return HUGE_VAL;
  }
  for (int i = 0; i < 60; ++i) {
    const double middle_s = 0.5 * (low_s + high_s);
    (breaking_height_m(middle_s, water_depth_m) < height_m ? low_s : high_s) = middle_s;
  }
  return high_s;
}

}  // namespace

double breaking_height_m(double period_s, double water_depth_m) {
  const double k = wavenumber_rad_m(frequency_rad_s(period_s), water_depth_m);
  return most_steepness * std::tanh(k * water_depth_m) * 2 * constants::pi / k;
}

SeaState state_of(const RegularWave& wave) noexcept {
  return {std::sqrt(2.0) * wave.height_m, wave.period_s, wave.from_direction_deg};
}

std::string why_it_breaks(const RegularWave& wave, double water_depth_m) {
  const double most_m = breaking_height_m(wave.period_s, water_depth_m);
  if (wave.height_m <= most_m) return {};
  const double k = wavenumber_rad_m(frequency_rad_s(wave.period_s), water_depth_m);
  const double longer_s = least_period_s(wave.height_m, water_depth_m);
  return formatted(
             "found H {:.4g} m with T {:.4g} s, a steepness H/L of {:.3f} in {:.4g} m "
             "of water; such a wave breaks, the limit is 0.142 tanh(kh) = {:.3f} (Miche "
             "1944); lower H to {:.4g} m or less",
             wave.height_m, wave.period_s, wave.height_m * k / (2 * constants::pi), water_depth_m,
             most_steepness * std::tanh(k * water_depth_m), std::floor(most_m * 1000) / 1000) +
         (std::isinf(longer_s)
              ? std::string("; no longer one of that height stands there")
              : formatted(", or lengthen T to {:.4g} s or more", std::ceil(longer_s * 100) / 100));
}

SeaRealisation realise(const RegularWave& wave, const WaveWater& water, UtcTime epoch) {
  if (const std::string why = why_it_breaks(wave, water.depth_m); !why.empty())
    throw Error(ErrorKind::invalid_input, "a regular wave: " + why);
  const auto component =
      wave_component(0.5 * wave.height_m, frequency_rad_s(wave.period_s), FrequencyFrame::intrinsic,
                     wave.from_direction_deg, 0, water);
  return {{component.value()}, water, epoch};
}

}  // namespace slackwater
