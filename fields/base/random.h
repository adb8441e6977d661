#pragma once
#include <cstdint>
#include <string_view>

namespace slackwater {

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
