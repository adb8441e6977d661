#include "fields/base/numbers/random.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

namespace slackwater::random_test {
namespace {

TEST(SplitMix64, GivesTheNumbersOfItsAuthors) {
  // From the state 1234567, as Rosetta Code lists them for the C of Vigna (2015).
  std::uint64_t state = 1234567;
  for (const std::uint64_t expected :
       {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U,
        16408922859458223821U}) {
    EXPECT_EQ(split_mix_64(state), expected);
    state += split_mix_step;
  }
}

TEST(SplitMix64, OneBitOfTheStateTurnsHalfOfTheNumber) {
  int turned = 0;
  for (std::uint64_t state = 0; state < 1000; ++state)
    for (int bit = 0; bit < 64; ++bit)
      turned += std::popcount(split_mix_64(state) ^ split_mix_64(state ^ (1ULL << bit)));
  EXPECT_NEAR(turned / 64000.0, 32.0, 0.1);
}

}  // namespace
}  // namespace slackwater::random_test
