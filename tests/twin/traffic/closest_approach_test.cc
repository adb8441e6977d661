#include "twin/traffic/closest_approach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::tests::closest_approach_test {
namespace {

using namespace twin;

double distance_after(const MovingPoint& a, const MovingPoint& b, double t_s) {
  const Triple<double> p =
      (b.position_m + t_s * b.velocity_m_s) - (a.position_m + t_s * a.velocity_m_s);
  return std::hypot(p.x, p.y);
}

/// The least over all times, by trying them, then again around the best, ten times finer each time.
ClosestApproach by_trying(const MovingPoint& a, const MovingPoint& b) {
  double best = 0, step_s = 10;
  double from = 0, to = 20'000;
  for (int round = 0; round < 9; ++round) {
    for (double t = from; t <= to; t += step_s) {
      if (distance_after(a, b, t) < distance_after(a, b, best)) best = t;
    }
    from = std::max(0.0, best - step_s);
    to = best + step_s;
    step_s /= 10;
  }
  return {best, distance_after(a, b, best), best > 0};
}

MovingPoint random_point(Rng& rng) {
  return {{rng.uniform(-5000, 5000), rng.uniform(-5000, 5000), rng.uniform(-9, 9)},
          {rng.uniform(-10, 10), rng.uniform(-10, 10), rng.uniform(-1, 1)}};
}

TEST(ClosestApproach, IsWhatTryingAllTimesFinds) {
  Rng rng(3, "tests/closest_approach");
  int closing = 0;
  for (int round = 0; round < 500; ++round) {
    const MovingPoint a = random_point(rng);
    const MovingPoint b = random_point(rng);
    const ClosestApproach formula = closest_approach(a, b);
    const ClosestApproach tried = by_trying(a, b);
    if (formula.time_s > 19'000) continue;
    // A square has a flat bottom: near the least the distance tells the time to the root of its
    // rounding.
    EXPECT_NEAR(formula.distance_m, tried.distance_m, 1e-6) << round;
    EXPECT_NEAR(formula.time_s, tried.time_s, 1e-2) << round;
    closing += formula.is_closing ? 1 : 0;
  }
  EXPECT_GT(closing, 150);
  EXPECT_LT(closing, 350);
}

TEST(ClosestApproach, ATextbookCrossing) {
  // Own ship north at 5 m/s, the other 1000 m east of the point 1000 m ahead, west at 5 m/s: both
  // are there after 200 s.
  const ClosestApproach approach =
      closest_approach({{0, 0, 0}, {5, 0, 0}}, {{1000, 1000, 0}, {0, -5, 0}});
  EXPECT_NEAR(approach.time_s, 200, 1e-12);
  EXPECT_NEAR(approach.distance_m, 0, 1e-12);
  EXPECT_TRUE(approach.is_closing);
}

TEST(ClosestApproach, AbreastAtOneSpeedItIsNow) {
  const Triple<double> velocity{3, 4, 0};
  const ClosestApproach approach = closest_approach({{0, 0, 0}, velocity}, {{30, 40, 0}, velocity});
  EXPECT_EQ(approach.time_s, 0);
  EXPECT_DOUBLE_EQ(approach.distance_m, 50);
  EXPECT_FALSE(approach.is_closing);
  const ClosestApproach nearly =
      closest_approach({{0, 0, 0}, velocity}, {{30, 40, 0}, {3, 4 - 1e-9, 0}});
  EXPECT_EQ(nearly.time_s, 0) << "not ten thousand years";
}

TEST(ClosestApproach, OvertakingOnAParallelCourseKeepsTheDistanceAcross) {
  const ClosestApproach approach =
      closest_approach({{0, 0, 0}, {8, 0, 0}}, {{600, 70, 0}, {5, 0, 0}});
  EXPECT_NEAR(approach.time_s, 200, 1e-12);
  EXPECT_NEAR(approach.distance_m, 70, 1e-12);
}

TEST(ClosestApproach, PartingItIsNow) {
  const ClosestApproach approach =
      closest_approach({{0, 0, 0}, {-5, 0, 0}}, {{100, 0, 0}, {5, 0, 0}});
  EXPECT_EQ(approach.time_s, 0);
  EXPECT_EQ(approach.distance_m, 100);
  EXPECT_FALSE(approach.is_closing);
  EXPECT_EQ(closest_approach({{1, 2, 0}, {3, 0, 0}}, {{1, 2, 0}, {0, 3, 0}}).distance_m, 0)
      << "in one place";
}

TEST(ClosestApproach, DoesNotCareWhoseItIsNorWhereNorHowFastTheWaterCarriesBoth) {
  Rng rng(4, "tests/closest_approach");
  for (int round = 0; round < 500; ++round) {
    MovingPoint a = random_point(rng);
    MovingPoint b = random_point(rng);
    const ClosestApproach seen = closest_approach(a, b);
    const ClosestApproach other = closest_approach(b, a);
    EXPECT_NEAR(other.time_s, seen.time_s, 1e-9 * (1 + seen.time_s));
    EXPECT_NEAR(other.distance_m, seen.distance_m, 1e-8);
    const Triple<double> shift{700, -300, 0}, drift{0.5, -1.5, 0};
    for (MovingPoint* point : {&a, &b}) {
      point->position_m = point->position_m + shift;
      point->velocity_m_s = point->velocity_m_s + drift;
    }
    EXPECT_NEAR(closest_approach(a, b).time_s, seen.time_s, 1e-7 * (1 + seen.time_s));
    EXPECT_NEAR(closest_approach(a, b).distance_m, seen.distance_m, 1e-7);
  }
}

TEST(ClosestOfAllTimes, HeadOnCrossingOvertakingAtRestAndParallelAreAsOnPaper) {
  struct Case {
    const char* what;
    MovingPoint other;
    double time_s, distance_m;
    bool is_closing;
  };
  const MovingPoint own{{0, 0, 0}, {4, 0, 0}};  // north at 4 m/s
  for (const Case& paper : {
           Case{"head-on, 100 m to starboard", {{1000, 100, 0}, {-6, 0, 0}}, 100, 100, true},
           Case{"crossing: both at (400, 0)", {{400, 300, 0}, {0, -3, 0}}, 100, 0, true},
           Case{"overtaking at 60 m", {{-300, 60, 0}, {7, 0, 0}}, 100, 60, true},
           Case{"it lies at rest ahead", {{800, -50, 0}, {0, 0, 0}}, 200, 50, true},
           Case{"parallel, the same speed", {{30, 40, 0}, {4, 0, 0}}, 0, 50, false},
           Case{"passed 50 s ago at 80 m", {{-500, 80, 0}, {-6, 0, 0}}, -50, 80, false},
           Case{"in the same place, parting", {{0, 0, 0}, {0, 5, 0}}, 0, 0, false},
       }) {
    const ClosestApproach found = closest_of_all_times(own, paper.other);
    EXPECT_NEAR(found.time_s, paper.time_s, 1e-12) << paper.what;
    EXPECT_NEAR(found.distance_m, paper.distance_m, 1e-12) << paper.what;
    EXPECT_EQ(found.is_closing, paper.is_closing) << paper.what;
  }
}

TEST(ClosestOfAllTimes, NoTimeIsNearerAndTimeRunsBothWays) {
  Rng rng(5, "tests/closest_of_all_times");
  for (int round = 0; round < 500; ++round) {
    const MovingPoint a = random_point(rng), b = random_point(rng);
    const ClosestApproach found = closest_of_all_times(a, b);
    EXPECT_NEAR(distance_after(a, b, found.time_s), found.distance_m, 1e-7);
    for (const double step_s : {-1000.0, -1.0, 1.0, 1000.0})
      EXPECT_GE(distance_after(a, b, found.time_s + step_s), found.distance_m - 1e-7) << round;
    MovingPoint back_a = a, back_b = b;
    for (MovingPoint* point : {&back_a, &back_b}) point->velocity_m_s = -1.0 * point->velocity_m_s;
    EXPECT_NEAR(closest_of_all_times(back_a, back_b).time_s, -found.time_s, 1e-9) << round;
    const ClosestApproach to_come = closest_approach(a, b);
    EXPECT_EQ(to_come.time_s, std::max(0.0, found.time_s)) << "what is over is now";
  }
}

}  // namespace
}  // namespace slackwater::tests::closest_approach_test
