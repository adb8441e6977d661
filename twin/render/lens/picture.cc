#include "twin/render/lens/picture.h"

#include <algorithm>
#include <cmath>

#include "fields/base/parallel.h"
#include "twin/render/light/counted_noise.h"
#include "twin/render/light/light_frame.h"

namespace slackwater::twin {
namespace {

/// sRGB's numbers of linear values in equal steps.
const std::vector<std::uint8_t>& transfer() {
  static const std::vector<std::uint8_t> table = [] {
    constexpr std::size_t steps = 1U << 14U;
    std::vector<std::uint8_t> made(steps + 1);
    for (std::size_t i = 0; i <= steps; ++i) {
      const double x = static_cast<double>(i) / steps;
      const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
      made[i] = static_cast<std::uint8_t>(std::lround(255 * y));
    }
    return made;
  }();
  return table;
}

double mean_of(const LightFrame& frame, double most) {
  double sum = 0;
  for (const auto& light : frame.light)
    for (const float one : light) sum += std::min<double>(one, most);
  return frame.light.empty() ? 0 : sum / (3 * static_cast<double>(frame.light.size()));
}

}  // namespace

Picture developed(const LightFrame& light, const ImageSensor& sensor, std::uint64_t seed,
                  int threads) {
  Picture picture;
  picture.wide = light.wide;
  picture.high = light.high;
  picture.rgb.resize(3 * light.light.size());
  const double mean = mean_of(light, sensor.full_light) / sensor.full_light;
  picture.gain =
      std::clamp(mean > 0 ? sensor.mean_level / mean : 1.0, 1 / sensor.most_gain, sensor.most_gain);
  const double amplified = std::max(1.0, picture.gain);
  const auto& table = transfer();
  const double steps = static_cast<double>(table.size() - 1);
  const auto row = 3 * static_cast<std::size_t>(light.wide);
  for_all(static_cast<std::size_t>(light.high), threads, [&](std::size_t j) {
    for (std::size_t at = j * row; at < (j + 1) * row; ++at) {
      const double electrons = electrons_of(light.light[at / 3][at % 3], sensor, picture.gain);
      const double sd = std::sqrt(electrons + sensor.read_noise_e * sensor.read_noise_e);
      const double noisy = electrons + sd * normal_at(noise_key(seed, at));
      const double value = std::clamp(amplified * noisy / sensor.full_well_e, 0.0, 1.0);
      picture.rgb[at] = table[static_cast<std::size_t>(std::lround(value * steps))];
    }
  });
  return picture;
}

}  // namespace slackwater::twin
