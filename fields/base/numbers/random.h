#pragma once
#include <cstdint>
#include <string_view>

namespace slackwater {

/// How far the state of SplitMix64 goes on with each number: 2^64 over the golden ratio.
inline constexpr std::uint64_t split_mix_step = 0x9E3779B97F4A7C15U;

/// The next number of a SplitMix64 (Steele, Lea and Flood 2014) in this state, which any number
/// can be: neighbours give numbers that have nothing to do with each other.
[[nodiscard]] constexpr std::uint64_t split_mix_64(std::uint64_t state) noexcept {
  std::uint64_t z = state + split_mix_step;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/// A seeded stream of random numbers, the same on every machine and compiler.
///
/// Generator: xoshiro256** (Blackman & Vigna 2018), seeded by SplitMix64 from (run seed, stream
/// name), so that adding a stream never disturbs another. Normals by the polar method, not
/// std::normal_distribution, whose bits differ between libraries.
class Rng {
 public:
  Rng(std::uint64_t run_seed, std::string_view stream_name);
  [[nodiscard]] std::uint64_t bits() noexcept;
  /// Uniform in [0, 1).
  [[nodiscard]] double uniform() noexcept;
  [[nodiscard]] double uniform(double low, double high) noexcept {
    return low + (high - low) * uniform();
  }
  /// Standard normal.
  [[nodiscard]] double normal() noexcept;

  /// Names each member to a visitor, for what stores a stream and takes it up again.
  template <typename Self, typename Visit>
  static void for_each_member(Self& self, Visit&& visit) {
    auto& [state, spare, has_spare] = self;
    visit("state", state);
    visit("spare", spare);
    visit("has_spare", has_spare);
  }

 private:
  std::uint64_t state_[4]{};
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace slackwater
