#pragma once
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "fields/base/constants.h"

namespace slackwater::tests {

/// Numbers, words and choices of a seed. Angles are degrees times pi/180, as a reader makes them.
class RandomValues {
 protected:
  explicit RandomValues(std::uint64_t seed) : random_(seed) {}

  static constexpr double degree = constants::degree;

  double number(double low, double high) {
    // Round ones and odd ones.
    const double value = std::uniform_real_distribution<double>(low, high)(random_);
    const double round = std::round(value);
    return chance(0.3) && round >= low && round <= high ? round : value;
  }
  std::size_t count(std::size_t low, std::size_t high) {
    return std::uniform_int_distribution<std::size_t>(low, high)(random_);
  }
  bool chance(double share) { return std::bernoulli_distribution(share)(random_); }
  template <typename Value>
  Value pick(const std::vector<Value>& values) {
    return values[count(0, values.size() - 1)];
  }
  double angle(double low_deg = -360, double high_deg = 360) {
    return number(low_deg, high_deg) * degree;
  }
  std::string name() {
    std::string text;
    for (std::size_t i = count(1, 5); i > 0; --i)
      text += pick<std::string>({"a", "B", "7",  "\"", "'", ": ",   " #",  "\n",
                                 "{", "]", ", ", "ä",  "-", "null", "0.5", "\\",
                                 "%", "&", "*",  "!",  "|", ">",    "~",   "\t"});
    return text;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace slackwater::tests
