// The pattern `mooring`: on which sides of its line it leads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "twin/mission/work_pattern.h"

namespace slackwater::tests::mooring_sides_test {
namespace {

using twin::WorkLeg;

std::vector<WorkLeg> laid_out(const std::string& more) {
  const twin::WorkSite site = small_farm();
  return twin::lay_out(
      Config::parse("pattern: mooring\nmooring: M1\nstand_off_m: 2\n" + more, "work.yaml"), site,
      site.turbines.back());
}

/// M1 leads north at 0 m east: how far east of it a place is.
double aside_m(const twin::Waypoint& at) { return at.position_m.y; }

TEST(MooringSides, OneLeadsBackAsItCame) {
  for (const char* one : {"", "sides: 1\n"}) {
    std::vector<WorkLeg> legs = laid_out(one);
    ASSERT_EQ(legs.size(), 2U);
    std::reverse(legs[1].waypoints.begin(), legs[1].waypoints.end());
    EXPECT_EQ(legs[0].waypoints, legs[1].waypoints);
  }
}

TEST(MooringSides, TwoLeadBackOnTheOtherOverTheLine) {
  const std::vector<WorkLeg> legs = laid_out("share: 0.5\nsides: 2\n");
  ASSERT_EQ(legs.size(), 2U);
  const auto& out = legs[0].waypoints;
  const auto& back = legs[1].waypoints;
  ASSERT_EQ(back.size(), out.size() + 1);
  // Over the line at its far end, where it lies 14 + 0.5 (33 - 14) m deep.
  EXPECT_NEAR(aside_m(back[0]), 0, 1e-9);
  EXPECT_NEAR(back[0].position_m.z, 14 + 0.5 * 19 - 2, 1e-9);
  const double side = aside_m(out[0]);
  EXPECT_NEAR(std::abs(side), 2, 1e-9);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const twin::Waypoint& mirrored = back[back.size() - 1 - i];
    EXPECT_NEAR(aside_m(out[i]), side, 1e-9);
    EXPECT_NEAR(aside_m(mirrored), -side, 1e-9);
    EXPECT_NEAR(mirrored.position_m.x, out[i].position_m.x, 1e-9);
    EXPECT_NEAR(mirrored.position_m.z, out[i].position_m.z, 1e-9);
  }
}

TEST(MooringSides, ThereAreTwo) { EXPECT_THROW((void)laid_out("sides: 3\n"), Error); }

}  // namespace
}  // namespace slackwater::tests::mooring_sides_test
