#pragma once
#include <cstdint>

#include "fields/base/numbers/random.h"

namespace slackwater::twin {

/// Random numbers by the place that they are for, so that no order of work matters. A key is mixed
/// from a seed and such numbers by `noise_key`.
[[nodiscard]] constexpr std::uint64_t noise_key(std::uint64_t seed, std::uint64_t a,
                                                std::uint64_t b = 0) noexcept {
  return split_mix_64(split_mix_64(seed ^ (a * split_mix_step)) ^ (b * split_mix_step));
}
/// Even in [0, 1).
[[nodiscard]] constexpr double even_at(std::uint64_t key) noexcept {
  return static_cast<double>(split_mix_64(key) >> 11U) * 0x1p-53;
}
/// Standard normal, nearly: the sum of twelve even 16-bit numbers (kurtosis -0.1; none beyond 6).
/// The same bits on every machine.
[[nodiscard]] constexpr double normal_at(std::uint64_t key) noexcept {
  std::uint64_t sum = 0;
  for (std::uint64_t word = 0; word < 3; ++word) {
    const std::uint64_t bits = split_mix_64(key + word * split_mix_step);
    sum += (bits & 0xFFFFU) + ((bits >> 16U) & 0xFFFFU) + ((bits >> 32U) & 0xFFFFU) + (bits >> 48U);
  }
  return (static_cast<double>(sum) + 6 - 6 * 65536.0) / 65536;
}

}  // namespace slackwater::twin
