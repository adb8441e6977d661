#include "fields/base/numbers/random.h"

#include <bit>
#include <cmath>

namespace slackwater {

Rng::Rng(std::uint64_t run_seed, std::string_view stream_name) {
  // FNV-1a of the name, mixed with the seed, expanded by SplitMix64.
  std::uint64_t mix = 14695981039346656037ULL;
  for (const char c : stream_name) {
    mix = (mix ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  mix ^= run_seed * split_mix_step;
  for (std::uint64_t& word : state_) {
    word = split_mix_64(mix);
    mix += split_mix_step;
  }
}

std::uint64_t Rng::bits() noexcept {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t shifted = state_[1] << 17U;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Rng::uniform() noexcept { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }

double Rng::normal() noexcept {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double x = 0;
  double y = 0;
  double s = 0;
  do {
    x = uniform(-1, 1);
    y = uniform(-1, 1);
    s = x * x + y * y;
  } while (s >= 1.0 || s == 0.0);
  const double scale = std::sqrt(-2.0 * std::log(s) / s);
  spare_ = y * scale;
  has_spare_ = true;
  return x * scale;
}

}  // namespace slackwater
