#pragma once
#include <cmath>
#include <cstdint>
#include <string_view>

#include "twin/body/spatial.h"

namespace slackwater::twin {

/// A stream of random numbers that is two words: a key, made of the run's seed and the stream's
/// name (for one sensor of one vehicle), and how many numbers have been drawn. Which other streams
/// are drawn from, and in which order, does not matter to it; copying the words is a checkpoint.
///
/// Generator: SplitMix64 (Steele, Lea and Flood 2014): a mix of key + n x golden ratio.
class NoiseStream {
 public:
  NoiseStream() = default;
  NoiseStream(std::uint64_t run_seed, std::string_view name);

  /// Uniform in [0, 1).
  [[nodiscard]] double uniform() noexcept;
  /// Standard normal, by the polar method (Marsaglia and Bray 1964).
  [[nodiscard]] double normal() noexcept;
  [[nodiscard]] Triple<double> normals() noexcept;
  [[nodiscard]] std::uint64_t drawn() const noexcept { return drawn_; }
  friend bool operator==(const NoiseStream&, const NoiseStream&) = default;

  /// Names each member to a visitor, for what stores a stream and takes it up again.
  template <typename Self, typename Visit>
  static void for_each_member(Self& self, Visit&& visit) {
    auto& [key, drawn] = self;
    visit("key", key);
    visit("drawn", drawn);
  }

 private:
  std::uint64_t key_ = 0;
  std::uint64_t drawn_ = 0;
};

/// First-order Gauss-Markov noise: x' = -x/tau + white, with a standard deviation that lasts. Its
/// autocorrelation is sd^2 exp(-t/tau). Source: Gelb, Applied Optimal Estimation (1974), 2.4 and
/// 3.8.
struct GaussMarkov {
  double sd = 0;
  double correlation_time_s = 1;
};

/// The noise `dt_s` later; exact for any step. A start from `sd` times a standard normal is
/// stationary.
[[nodiscard]] double later(const GaussMarkov& model, double now, double dt_s,
                           NoiseStream& noise) noexcept;

/// The nearest multiple of `resolution`, or the value itself for a resolution of 0.
[[nodiscard]] double rounded_to(double value, double resolution) noexcept;

}  // namespace slackwater::twin
