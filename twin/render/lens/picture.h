#pragma once
#include <cstdint>
#include <vector>

namespace slackwater::twin {

struct LightFrame;

/// What becomes of light in a camera.
struct ImageSensor {
  double full_well_e = 10000;  ///< electrons of the brightest that it tells apart
  double read_noise_e = 5;     ///< standard deviation
  /// How many times the light of a usual place in enough light fills the well. Where there is less
  /// than enough light the gain is raised, until the picture's mean is `mean_level`, by up to
  /// `most_gain`: of electrons as well as of noise. Where there is more, it is exposed for less.
  double full_light = 9;
  double mean_level = 0.18;
  double most_gain = 16;
};

/// What a camera saw: three bytes a pixel (red, green, blue), rows from the top, from the left.
struct Picture {
  int wide = 0;
  int high = 0;
  std::vector<std::uint8_t> rgb;
  double gain = 1;  ///< that it was exposed with; 1 where nobody says

  [[nodiscard]] const std::uint8_t* at(int column, int row) const noexcept {
    return rgb.data() + 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(wide) +
                             static_cast<std::size_t>(column));
  }
};

/// Electrons of a light, before noise, as a picture of this gain is exposed: e below.
[[nodiscard]] inline double electrons_of(double light, const ImageSensor& sensor,
                                         double gain) noexcept {
  return (gain < 1 ? gain : 1) * light / sensor.full_light * sensor.full_well_e;
}

/// Light becomes electrons, e = light / full_light * full well, with shot noise of e^(1/2) and read
/// noise, both normal; times the gain; held at the full well; written by the transfer of sRGB (IEC
/// 61966-2-1). The noise of a pixel and colour rests on (seed, pixel, colour) alone: twelve even
/// 16-bit numbers, whose sum is normal enough (kurtosis -0.1) and has the same bits everywhere.
[[nodiscard]] Picture developed(const LightFrame& light, const ImageSensor& sensor,
                                std::uint64_t seed, int threads);

}  // namespace slackwater::twin
