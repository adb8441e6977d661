#include "twin/sensor/noise.h"

#include "fields/base/numbers/random.h"

namespace slackwater::twin {

NoiseStream::NoiseStream(std::uint64_t run_seed, std::string_view name)
    : key_(Rng(run_seed, name).bits()) {}

double NoiseStream::uniform() noexcept {
  const std::uint64_t bits = split_mix_64(key_ + drawn_ * split_mix_step);
  ++drawn_;
  return static_cast<double>(bits >> 11U) * 0x1.0p-53;
}

double NoiseStream::normal() noexcept {
  for (;;) {
    const double x = 2 * uniform() - 1;
    const double y = 2 * uniform() - 1;
    const double s = x * x + y * y;
    // The second of the pair is dropped: a stream holds nothing back between draws.
    if (s < 1 && s > 0) return x * std::sqrt(-2 * std::log(s) / s);
  }
}

Triple<double> NoiseStream::normals() noexcept {
  const double x = normal();
  const double y = normal();
  return {x, y, normal()};
}

double later(const GaussMarkov& model, double now, double dt_s, NoiseStream& noise) noexcept {
  const double kept = std::exp(-dt_s / model.correlation_time_s);
  return kept * now + model.sd * std::sqrt(1 - kept * kept) * noise.normal();
}

double rounded_to(double value, double resolution) noexcept {
  return resolution > 0 ? resolution * std::nearbyint(value / resolution) : value;
}

}  // namespace slackwater::twin
