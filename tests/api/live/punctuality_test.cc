// When steps begin, beside when they are due.
#include "api/live/punctuality.h"

#include <gtest/gtest.h>

namespace slackwater::tests {
namespace {

using namespace std::chrono_literals;
using live::Punctuality;

const Punctuality::WallClock::time_point noon{1000h};

TEST(Punctuality, CountsStepsThatBeginMoreThanTenMillisecondsLate) {
  Punctuality punctuality(2, 0.1);  // a step is due every 50 ms
  punctuality.begin(3, noon);       // a run taken up begins somewhere
  punctuality.begin(4, noon + 50ms);
  punctuality.begin(5, noon + 109ms);
  punctuality.begin(6, noon + 161ms);  // 11 ms
  punctuality.begin(7, noon + 232ms);  // 32 ms
  punctuality.begin(8, noon + 251ms);  // caught up
  EXPECT_EQ(punctuality.steps(), 6U);
  EXPECT_EQ(punctuality.late_steps(), 2U);
  EXPECT_NEAR(punctuality.worst_s(), 0.032, 1e-9);
  EXPECT_EQ(punctuality.text(),
            "6 steps, 2 of them (33.3 %) began more than 10 ms late, the worst by 32.0 ms");
}

TEST(Punctuality, APauseIsNoLateness) {
  Punctuality punctuality(1, 0.1);
  punctuality.begin(0, noon);
  punctuality.begin(1, noon + 100ms);
  punctuality.begin(2, noon + 60s);
  punctuality.begin(3, noon + 60s + 105ms);
  EXPECT_EQ(punctuality.late_steps(), 0U);
  EXPECT_EQ(punctuality.pauses(), 1U);
  EXPECT_NEAR(punctuality.worst_s(), 0.005, 1e-9);
}

TEST(Punctuality, AsFastAsItGoesNothingIsLate) {
  Punctuality punctuality(0, 0.1);
  for (int i = 0; i < 5; ++i) punctuality.begin(static_cast<std::uint64_t>(i), noon + i * 700ms);
  EXPECT_EQ(punctuality.late_steps(), 0U);
  EXPECT_EQ(punctuality.text(), "as fast as the machine can");
}

}  // namespace
}  // namespace slackwater::tests
