#include "twin/render/stage/told_from_noise.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

std::vector<double> told_from_noise(const LightFrame& light, const LightFrame& bare,
                                    const TruthFrame& truth, const ImageSensor& sensor, double gain,
                                    std::size_t marks) {
  const double most_e = sensor.full_well_e / std::max(1.0, gain);
  const double read_e2 = sensor.read_noise_e * sensor.read_noise_e;
  const auto electrons = [&](float one) {
    return std::min(most_e, electrons_of(one, sensor, gain));
  };
  std::vector<double> told(marks, 0.0);
  for (std::size_t pixel = 0; pixel < truth.defect.size(); ++pixel) {
    if (truth.defect[pixel] == 0) continue;
    for (std::size_t k = 0; k < light.light[pixel].size(); ++k) {
      const double without = electrons(bare.light[pixel][k]);
      const double signal = electrons(light.light[pixel][k]) - without;
      told[truth.defect[pixel] - 1U] += signal * signal / (without + read_e2);
    }
  }
  for (double& one : told) one = std::sqrt(one);
  return told;
}

}  // namespace slackwater::twin
