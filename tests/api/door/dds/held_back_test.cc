// How long messages were held back on their way, by clocks that do not agree.
#include "api/door/dds/held_back.h"

#include <gtest/gtest.h>

namespace slackwater::tests::held_back_test {
namespace {

TEST(HeldBack, IsWhatADelayHasAboveTheLeast) {
  dds::HeldBack held;
  constexpr double off_s = 7200;  // the writer's clock is two hours ahead
  for (int i = 0; i < 20; ++i) EXPECT_NEAR(held.look(off_s + 0.1 * i, 0.1 * i + 0.002), 0, 1e-9);
  // The link is down for three seconds, then all comes at once.
  for (int i = 20; i < 50; ++i)
    EXPECT_NEAR(held.look(off_s + 0.1 * i, 5.002), 5 - 0.1 * i, 1e-9) << i;
  EXPECT_NEAR(held.look(off_s + 5.1, 5.102), 0, 1e-9);
}

TEST(HeldBack, ALinkThatIsSlowForAMinuteIsSlow) {
  dds::HeldBack held;
  for (double t_s = 0; t_s < 40; t_s += 0.5) (void)held.look(t_s, t_s);
  EXPECT_NEAR(held.look(40, 42), 2, 1e-9);
  EXPECT_NEAR(held.look(55, 57), 2, 1e-9);
}

TEST(HeldBack, AClockThatIsSetIsForgivenWithinAMinute) {
  for (const double set_by_s : {-10'800.0, -5.0, 5.0, 10'800.0}) {
    dds::HeldBack held;
    double t_s = 0;
    for (; t_s < 100; t_s += 0.5) EXPECT_EQ(held.look(t_s, t_s), 0);
    double last_wrong_s = t_s;
    for (; t_s < 300; t_s += 0.5)
      if (held.look(t_s + set_by_s, t_s) > 1) last_wrong_s = t_s;
    EXPECT_LE(last_wrong_s, 160.5) << set_by_s;
  }
}

TEST(HeldBack, AClockThatGoesAHundredMillionthsWrongStaysFresh) {
  dds::HeldBack held;
  for (double t_s = 0; t_s < 86'400; t_s += 1)
    ASSERT_LT(held.look(t_s * (1 - 1e-4), t_s), 0.01) << t_s;
}

TEST(HeldBack, TheFirstAfterALongSilenceIsFresh) {
  dds::HeldBack held;
  (void)held.look(0, 0);
  EXPECT_EQ(held.look(3600 - 4, 3600), 0);
}

}  // namespace
}  // namespace slackwater::tests::held_back_test
