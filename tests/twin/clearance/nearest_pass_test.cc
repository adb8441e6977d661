#include "twin/clearance/nearest_pass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::twin::nearest_pass_test {
namespace {

Triple<double> any(Rng& rng, double within_m) {
  return {rng.uniform(-within_m, within_m), rng.uniform(-within_m, within_m),
          rng.uniform(-within_m, within_m)};
}

TEST(LeastBetween, IsWhatTryingAllOfTheWayFinds) {
  int inside = 0;
  for (int seed = 0; seed < 300; ++seed) {
    Rng rng(7, "least between/" + std::to_string(seed));
    const Triple<double> before = any(rng, 5), after = seed % 9 == 0 ? before : any(rng, 5);
    const LeastOnWay least = least_between(before, after);
    double tried_m = 1e9;
    for (int i = 0; i <= 2000; ++i)
      tried_m = std::min(tried_m, length_of(before + (i / 2000.0) * (after - before)));
    EXPECT_LE(least.distance_m, tried_m + 1e-12) << seed;
    EXPECT_GE(least.distance_m, tried_m - 0.5 * length_of(after - before) / 2000) << seed;
    EXPECT_NEAR(length_of(before + least.share * (after - before)), least.distance_m, 1e-12);
    inside += least.share > 0 && least.share < 1 ? 1 : 0;
  }
  EXPECT_GT(inside, 50);
}

TEST(LeastBetween, AtTheEndIsTheDistanceThereToTheLastBit) {
  // A run taken up at that barrier sees the end alone.
  for (int seed = 0; seed < 300; ++seed) {
    Rng rng(7, "end/" + std::to_string(seed));
    const Triple<double> after = any(rng, 50), before = (1 + rng.uniform(0.001, 3)) * after;
    EXPECT_EQ(least_between(before, after).distance_m, length_of(after)) << seed;
    EXPECT_EQ(least_between(after, after).distance_m, length_of(after)) << seed;
  }
}

TEST(LeastToAPiece, IsWhatTryingAllOfBothFinds) {
  for (int seed = 0; seed < 200; ++seed) {
    Rng rng(7, "least to a piece/" + std::to_string(seed));
    const Triple<double> from = any(rng, 5), a = any(rng, 5);
    Triple<double> to = any(rng, 5), b = any(rng, 5);
    // Points, and parallels, are among them.
    if (seed % 5 == 0) to = from;
    if (seed % 7 == 0) b = a;
    if (seed % 11 == 0) b = a + 0.7 * (to - from);
    const LeastOnWay least = least_to_piece(from, to, a, b);
    constexpr int tries = 120;
    double tried_m = 1e9, at_share_m = 1e9;
    for (int j = 0; j <= tries; ++j) {
      const Triple<double> on_piece = a + (double(j) / tries) * (b - a);
      at_share_m = std::min(at_share_m, length_of(from + least.share * (to - from) - on_piece));
      for (int i = 0; i <= tries; ++i)
        tried_m = std::min(tried_m, length_of(from + (double(i) / tries) * (to - from) - on_piece));
    }
    const double between_tries_m = 0.5 * (length_of(to - from) + length_of(b - a)) / tries;
    EXPECT_LE(least.distance_m, tried_m + 1e-12) << seed;
    EXPECT_GE(least.distance_m, tried_m - between_tries_m) << seed;
    EXPECT_NEAR(at_share_m, least.distance_m, between_tries_m) << seed;
  }
}

TEST(ANearestPass, IsTheFirstOfEqualOnes) {
  NearestPass pass;
  EXPECT_FALSE(pass.is_any());
  pass.take(5, 1, 3);
  pass.take(5, 2, 4);
  pass.take(7, 3, 5);
  EXPECT_EQ(pass, (NearestPass{5, 1, 3}));
  pass.take(4, 4, 0);
  EXPECT_EQ(pass, (NearestPass{4, 4, 0}));
  EXPECT_TRUE(pass.is_any());
}

}  // namespace
}  // namespace slackwater::twin::nearest_pass_test
