#include "twin/chance/rank_rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "fields/base/numbers/random.h"

namespace slackwater::tests::rank_rule_test {
namespace {

TEST(RankRule, AsksOneMoreThanTheShareOfTheMembersAlone) {
  EXPECT_EQ(twin::rank_needed(9, 0.9), 9U);
  EXPECT_EQ(twin::rank_needed(19, 0.9), 18U);
  EXPECT_EQ(twin::rank_needed(24, 0.9), 23U);
  EXPECT_EQ(twin::rank_needed(99, 0.9), 90U);
  EXPECT_EQ(twin::rank_needed(1, 0.5), 1U);
  EXPECT_GT(twin::rank_needed(8, 0.9), 8U);
  EXPECT_EQ(twin::members_needed(0.9), 9U);
  EXPECT_EQ(twin::members_needed(0.5), 1U);
  EXPECT_EQ(twin::members_needed(0.95), 19U);
}

/// How often the truth bears the most demanding plan that `rank` of the members bear, where all are
/// drawn alike.
template <typename Draw>
double borne(std::size_t members, std::size_t rank, int rounds, const Draw& draw) {
  Rng random(4, "rank_rule");
  int held = 0;
  std::vector<double> bears(members);
  for (int round = 0; round < rounds; ++round) {
    const double shift = random.normal();  // a day, the same for all
    for (double& one : bears) one = draw(shift + random.normal());
    std::sort(bears.begin(), bears.end(), std::greater<>());
    held += draw(shift + random.normal()) >= bears[rank - 1] ? 1 : 0;
  }
  return static_cast<double>(held) / rounds;
}

TEST(RankRule, TheTruthBearsWhatItAllowsAsOftenAsItSays) {
  constexpr int rounds = 40000;
  for (const std::size_t members : {9U, 14U, 19U, 24U}) {
    const std::size_t rank = twin::rank_needed(members, 0.9);
    const double p = static_cast<double>(rank) / static_cast<double>(members + 1);
    ASSERT_GE(p, 0.9 - 1e-12);
    const double error = std::sqrt(p * (1 - p) / rounds);
    EXPECT_NEAR(borne(members, rank, rounds, [](double x) { return x; }), p, 4 * error) << members;
    // On a ladder of few rungs many are equal: it holds no less often.
    EXPECT_GT(borne(members, rank, rounds, [](double x) { return std::floor(x); }), p - 4 * error);
  }
  // Nine tenths of the members alone are too few.
  EXPECT_LT(borne(10, 9, rounds, [](double x) { return x; }), 0.84);
}

}  // namespace
}  // namespace slackwater::tests::rank_rule_test
