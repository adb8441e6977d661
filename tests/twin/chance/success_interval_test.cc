#include "twin/chance/success_interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::tests::success_interval_test {
namespace {

using twin::success_interval;
using twin::SuccessInterval;

TEST(SuccessInterval, KnowsNothingOfNothing) {
  const SuccessInterval all = success_interval(0, 0);
  EXPECT_EQ(all.low, 0);
  EXPECT_EQ(all.high, 1);
}

TEST(SuccessInterval, IsTheMirrorImageForFailures) {
  for (const std::size_t n : {1U, 7U, 24U, 100U})
    for (std::size_t s = 0; s <= n; ++s) {
      const SuccessInterval a = success_interval(s, n), b = success_interval(n - s, n);
      EXPECT_NEAR(a.low, 1 - b.high, 1e-12);
      EXPECT_LE(a.low, static_cast<double>(s) / static_cast<double>(n));
      EXPECT_GE(a.high, static_cast<double>(s) / static_cast<double>(n));
    }
}

TEST(SuccessInterval, OfSuccessesAloneIsThatOfTheClosedForm) {
  // B(1 + n, 1) = 1/(n + 1), so p^n = (1 - level)/(n + 1).
  for (const std::size_t n : {1U, 5U, 24U, 200U}) {
    const SuccessInterval all = success_interval(n, n);
    EXPECT_EQ(all.high, 1);
    EXPECT_NEAR(all.low, std::pow(0.05 / static_cast<double>(n + 1), 1 / static_cast<double>(n)),
                1e-12);
  }
}

/// One start flown until its interval is narrower than `width`, or 200 times.
struct Stopped {
  std::size_t flown = 0;
  SuccessInterval interval;
};
template <typename Interval>
Stopped flown_until(double p, double width, Rng& rng, Interval&& interval_of) {
  Stopped out;
  std::size_t successes = 0;
  while (out.flown < 200) {
    for (int i = 0; i < 4; ++i) successes += rng.uniform() < p ? 1 : 0;
    out.flown += 4;
    const SuccessInterval now = interval_of(successes, out.flown);
    out.interval = {std::max(out.interval.low, now.low), std::min(out.interval.high, now.high)};
    if (out.interval.high - out.interval.low < width) break;
  }
  return out;
}

TEST(SuccessInterval, HoldsItsLevelOverAThousandRunsThatStopWhenTheyLike) {
  Rng rng(11, "sequential");
  for (const double p : {0.0, 0.02, 0.3, 0.5, 0.9, 0.97, 1.0}) {
    constexpr int runs = 1000;
    int held = 0;
    double flown = 0;
    for (int i = 0; i < runs; ++i) {
      const Stopped end = flown_until(
          p, 0.3, rng, [](std::size_t s, std::size_t n) { return success_interval(s, n); });
      held += end.interval.low <= p && p <= end.interval.high ? 1 : 0;
      flown += static_cast<double>(end.flown) / runs;
    }
    // 95 % less three standard deviations of the count.
    EXPECT_GE(held, 950 - 3 * std::sqrt(1000 * 0.05 * 0.95)) << p;
    EXPECT_LT(flown, 200) << p;
    // Certain outcomes need few flights.
    if (p == 0 || p == 1) {
      EXPECT_LE(flown, 24);
    }
  }
}

TEST(SuccessInterval, WhereOneForAFixedNumberDoesNot) {
  // Wald's with its customary 1.96, looked at after every four flights, all looks intersected.
  Rng rng(12, "sequential");
  int held = 0;
  for (int i = 0; i < 1000; ++i) {
    const Stopped end = flown_until(0.5, 0.01, rng, [](std::size_t s, std::size_t n) {
      const double share = static_cast<double>(s) / static_cast<double>(n);
      const double off = 1.96 * std::sqrt(share * (1 - share) / static_cast<double>(n));
      return SuccessInterval{share - off, share + off};
    });
    held += end.interval.low <= 0.5 && 0.5 <= end.interval.high ? 1 : 0;
  }
  EXPECT_LT(held, 850);
}

}  // namespace
}  // namespace slackwater::tests::success_interval_test
