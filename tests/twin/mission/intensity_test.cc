#include "twin/mission/intensity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields/base/error.h"
#include "tests/support/error_of.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "twin/mission/work_pattern.h"
#include "twin/scenario/scenario.h"

namespace slackwater::tests::intensity_test {
namespace {

using twin::Intensity;
using twin::PassOrder;

constexpr double pi = 3.141592653589793;
constexpr PassOrder both_orders[] = {PassOrder::as_laid, PassOrder::coarse_to_fine};

struct Pattern {
  const char* name;
  const char* work;
  double touch_m;  ///< nearest that a way may come to the axis of the pile
};

const Pattern patterns[] = {
    {"rings",
     "pattern: rings\nstand_off_m: 2\nfrom: {depth_m: 5}\nto: {depth_m: 33}\nspacing_m: 1.4\n",
     4.9},
    {"verticals",
     "pattern: verticals\nstand_off_m: 2\nfrom: {depth_m: 4}\nto: {above_bed_m: 2}\nbearings: 11\n",
     4.9},
    {"stops",
     "pattern: verticals\nstand_off_m: 2\nfrom: {depth_m: 4}\nto: {above_bed_m: 2}\nbearings: 8\n"
     "stops: 3\nstop_s: 30\n",
     4.9},
    {"blade", "pattern: blade\nblade: 1\nstand_off_m: 10\nrotor_faces_deg: 270\n", 0},
    {"cable",
     "pattern: cable\ncable: A01-A02\nlines: 7\nspacing_m: 4\nat: {above_bed_m: 6}\n"
     "off_ends_m: 80\n",
     70},
    {"bands",
     "pattern: bands\nstand_off_m: 0.8\nfrom: {depth_m: 5}\nto: {depth_m: 7}\nswath_m: 0.4\n"
     "passes: 4\nrate_m2_h: 50\n",
     3.7},
};
void PrintTo(const Pattern& pattern, std::ostream* out) { *out << pattern.name; }

std::vector<twin::WorkLeg> laid(const char* work, const Intensity& intensity) {
  const twin::WorkSite site = small_farm();
  return twin::lay_out(Config::parse(work, "work.yaml"), site, site.turbines[0], intensity);
}

std::vector<twin::Triple<double>> way_of(const std::vector<twin::WorkLeg>& legs) {
  std::vector<twin::Triple<double>> way;
  for (const twin::WorkLeg& leg : legs)
    for (const twin::Waypoint& at : leg.waypoints) way.push_back(at.position_m);
  return way;
}

double length_of_way(const std::vector<twin::WorkLeg>& legs) {
  const auto way = way_of(legs);
  double length_m = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length_m += twin::length_of(way[i] - way[i - 1]);
  return length_m;
}

/// How far round the pile a way leads, at its furthest and at its end, in radians.
struct Wound {
  double most = 0;
  double at_end = 0;
};
Wound wound_of(const std::vector<twin::WorkLeg>& legs) {
  const auto way = way_of(legs);
  Wound wound;
  for (std::size_t i = 1; i < way.size(); ++i) {
    wound.at_end += std::remainder(
        std::atan2(way[i].y, way[i].x) - std::atan2(way[i - 1].y, way[i - 1].x), 2 * pi);
    wound.most = std::max(wound.most, std::abs(wound.at_end));
  }
  return wound;
}

/// Depths of rings, in the order in which they are flown.
std::vector<double> levels_of(const std::vector<twin::WorkLeg>& legs) {
  std::vector<double> down_m;
  for (const twin::WorkLeg& leg : legs) down_m.push_back(leg.waypoints.front().position_m.z);
  return down_m;
}

double largest_gap(std::vector<double> values, double from, double to) {
  values.push_back(from);
  values.push_back(to);
  std::sort(values.begin(), values.end());
  double gap = 0;
  for (std::size_t i = 1; i < values.size(); ++i) gap = std::max(gap, values[i] - values[i - 1]);
  return gap;
}

TEST(Intensity, CoarseToFineComesBackThroughTheGapsThatItLeft) {
  EXPECT_EQ(twin::flown_order(6, PassOrder::coarse_to_fine), (std::vector{0, 2, 4, 5, 3, 1}));
  EXPECT_EQ(twin::flown_order(5, PassOrder::coarse_to_fine), (std::vector{0, 2, 4, 3, 1}));
  EXPECT_EQ(twin::flown_order(4, PassOrder::as_laid), (std::vector{0, 1, 2, 3}));
  for (int passes = 1; passes < 40; ++passes) {
    std::vector<int> flown = twin::flown_order(passes, PassOrder::coarse_to_fine);
    EXPECT_LE(std::abs(flown.back() - flown.front()), 1) << passes;
    std::sort(flown.begin(), flown.end());
    std::vector<int> all(static_cast<std::size_t>(passes));
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(flown, all);
  }
}

TEST(Intensity, FliesTheLeastNumberOfPassesThatIsNoSmallerAShare) {
  for (int passes = 1; passes < 30; ++passes)
    for (int part = 1; part <= passes; ++part) {
      const double density = static_cast<double>(part) / passes;
      EXPECT_EQ(twin::passes_at(passes, density), part);
      EXPECT_EQ(twin::passes_at(passes, density * 0.9 * 0.99),
                std::max(1, static_cast<int>(std::ceil(part * 0.891))));
    }
}

TEST(Intensity, IsReadAndWrittenAndRefused) {
  const auto read = [](const std::string& yaml) {
    const Config config = Config::parse(yaml, "i.yaml");
    const Intensity intensity = twin::read_intensity(config);
    config.expect_all_read();
    return intensity;
  };
  const Intensity half{0.5, PassOrder::coarse_to_fine};
  EXPECT_EQ(twin::read_intensity(Config::of(twin::value_of(half), "i.yaml")), half);
  EXPECT_EQ(read("{}"), Intensity{});
  EXPECT_NE(error_of([&] { (void)read("{density: 0}"); }).find("density"), std::string::npos);
  EXPECT_NE(error_of([&] { (void)read("{density: 1.2}"); }).find("density"), std::string::npos);
  EXPECT_NE(error_of([&] {
              (void)read("{order: random}");
            }).find("found random, expected as_laid or coarse_to_fine"),
            std::string::npos);
  EXPECT_NE(error_of([&] { (void)read("{densty: 1}"); }).find("densty"), std::string::npos);
}

TEST(Intensity, ThinnedByOneIsWhatItWas) {
  const Intensity own{0.8, PassOrder::as_laid};
  EXPECT_EQ(twin::thinned(own, {1, PassOrder::coarse_to_fine}), own);
  EXPECT_EQ(twin::thinned(own, {0.5, PassOrder::coarse_to_fine}),
            (Intensity{0.4, PassOrder::coarse_to_fine}));
}

class Thinned : public testing::TestWithParam<Pattern> {};

TEST_P(Thinned, TheWayGetsNoLongerAsTheDensityFalls) {
  for (const PassOrder order : both_orders) {
    double before = length_of_way(laid(GetParam().work, {1, order}));
    const double whole = before;
    for (int percent = 99; percent > 0; --percent) {
      const double length = length_of_way(laid(GetParam().work, {0.01 * percent, order}));
      EXPECT_LE(length, before + 1e-6) << percent << " % " << twin::name_of(order);
      EXPECT_GE(length, 0.01 * percent * whole * 0.5) << percent << " %";
      before = length;
    }
    EXPECT_LT(before, 0.55 * whole) << "nothing was left out";
  }
}

TEST_P(Thinned, KeepsClearOfThePileInEitherOrder) {
  for (const PassOrder order : both_orders)
    for (int percent = 5; percent <= 100; percent += 5) {
      const auto way = way_of(laid(GetParam().work, {0.01 * percent, order}));
      for (std::size_t i = 1; i < way.size(); ++i) {
        // Nearest to the axis on the straight way between.
        const double n = way[i].x - way[i - 1].x, e = way[i].y - way[i - 1].y;
        const double square = n * n + e * e;
        const double along =
            square > 0 ? std::clamp(-(n * way[i - 1].x + e * way[i - 1].y) / square, 0.0, 1.0) : 0;
        EXPECT_GE(std::hypot(way[i - 1].x + along * n, way[i - 1].y + along * e),
                  GetParam().touch_m)
            << percent << " % " << twin::name_of(order);
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Patterns, Thinned, testing::ValuesIn(patterns),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Thinned, NoLineWinds) {
  for (const std::size_t pattern : {0U, 1U, 2U, 5U})
    for (const PassOrder order : both_orders)
      for (int percent = 3; percent <= 100; percent += 1) {
        const Wound wound = wound_of(laid(patterns[pattern].work, {0.01 * percent, order}));
        EXPECT_NEAR(wound.at_end, 0, 1e-6) << patterns[pattern].name << " " << percent;
        EXPECT_LE(wound.most, 2 * pi + 1e-6) << patterns[pattern].name << " " << percent;
      }
}

TEST(Thinned, RingsReachFromTheFirstLevelToTheLastAtAnyDensity) {
  for (const PassOrder order : both_orders)
    for (const double density : {1.0, 0.76, 0.5, 0.2, 0.01}) {
      std::vector<double> down_m = levels_of(laid(patterns[0].work, {density, order}));
      EXPECT_EQ(down_m.size() % 2, 0U);
      EXPECT_EQ(down_m.front(), 5);
      std::sort(down_m.begin(), down_m.end());
      EXPECT_EQ(down_m.back(), 33);
      down_m.erase(std::unique(down_m.begin(), down_m.end()), down_m.end());
      // Twenty-one levels and as far apart everywhere.
      const double wanted = density == 1 ? 21 : 2 * std::ceil(std::ceil(21 * density - 1e-6) / 2);
      EXPECT_EQ(static_cast<double>(down_m.size()), wanted) << density;
      EXPECT_NEAR(largest_gap(down_m, 5, 33), 28 / (wanted - 1), 1e-9);
    }
}

TEST(Thinned, WhoTurnsHomeHalfWayLeavesNoHoleIfHeWentCoarseToFine) {
  const auto gap_half_way = [](PassOrder order) {
    std::vector<double> down_m = levels_of(laid(patterns[0].work, {1, order}));
    down_m.resize(down_m.size() / 2);
    return largest_gap(down_m, 5, 33);
  };
  EXPECT_NEAR(gap_half_way(PassOrder::coarse_to_fine), 2 * 1.4, 1e-9);
  EXPECT_NEAR(gap_half_way(PassOrder::as_laid), 10 * 1.4, 1e-9);
}

TEST(Thinned, CableLinesKeepTheirWidthAndOneAloneIsInTheMiddle) {
  const auto off = [](double density) {
    // On the first leg of the cable, to the right of its way.
    const double n = 60 / std::hypot(60, 350), e = 350 / std::hypot(60, 350);
    std::vector<double> right_m;
    for (const auto& at : way_of(laid(patterns[4].work, {density, PassOrder::as_laid})))
      if (std::hypot(at.x, at.y) < 100) right_m.push_back(-e * at.x + n * at.y);
    std::sort(right_m.begin(), right_m.end());
    return right_m;
  };
  EXPECT_EQ(off(1).size(), 7U);
  const std::vector<double> three = off(0.4);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_NEAR(three[0], -12, 1e-6);
  EXPECT_NEAR(three[1], 0, 1e-6);
  EXPECT_NEAR(three[2], 12, 1e-6);
  ASSERT_EQ(off(0.1).size(), 1U);
  EXPECT_NEAR(off(0.1)[0], 0, 1e-6);
}

TEST(Thinned, ABladeAtHalfIsSeenFromItsEdgesAndNoWayLeadsThroughIt) {
  for (const PassOrder order : both_orders)
    for (const double density : {1.0, 0.75, 0.5}) {
      const auto way = way_of(laid(patterns[3].work, {density, order}));
      // The blade stands up 5 m west of the axis.
      for (std::size_t i = 1; i < way.size(); ++i)
        for (int part = 0; part <= 20; ++part) {
          const auto at = way[i - 1] + (0.05 * part) * (way[i] - way[i - 1]);
          EXPECT_GT(std::hypot(at.x, at.y + 5), 6) << density << " " << twin::name_of(order);
        }
    }
  const auto half = way_of(laid(patterns[3].work, {0.5, PassOrder::as_laid}));
  ASSERT_EQ(half.size(), 5U);
  EXPECT_NEAR(half[0].x, -10, 1e-9);
  EXPECT_NEAR(half[4].x, 10, 1e-9);
}

TEST(Thinned, PatternsWithoutPassesStayAsTheyAre) {
  const twin::WorkSite site = small_farm();
  for (const auto& [work, turbine] :
       {std::pair{"pattern: landing\ngap_m: 3\nbow_m: 12\nstay: 15min\n", 0},
        {"pattern: circles\nradii_m: [50, 80]\nat: {depth_m: 0}\n", 0},
        {"pattern: square\ndistance_m: 50\nat: {depth_m: 0}\nleg_m: 10\nlegs: 6\n", 0},
        {"pattern: mooring\nmooring: M1\nstand_off_m: 2\n", 2}}) {
    const Config config = Config::parse(work, "work.yaml");
    const auto& at = site.turbines[static_cast<std::size_t>(turbine)];
    EXPECT_EQ(length_of_way(twin::lay_out(config, site, at)),
              length_of_way(twin::lay_out(config, site, at, {0.1, PassOrder::coarse_to_fine})));
  }
}

/// Metres of work of the first vehicle of a mission.
double work_of(const std::string& agents, const Intensity& thinned_by) {
  const Config config = Config::parse(
      "name: test\nseed: 7\nduration: 3h\nstep_s: 0.05\nwater: {made_up: {depth_m: 35}}\ntasks: "
      "[cp_anode]\nturbines: [A01]\n" +
          agents,
      "mission.yaml");
  twin::MissionParts parts = small_farm_parts();
  parts.thinned_by = thinned_by;
  const twin::ExpandedMission out = twin::expand_mission(config, parts);
  config.expect_all_read();
  const twin::Scenario scenario = out.scenario;
  std::vector<twin::WorkLeg> legs;
  for (const twin::ScenarioTask& task : scenario.vehicles[0].tasks)
    if (task.phase == twin::Phase::work && !task.waypoints.empty())
      legs.push_back({task.waypoints, 0});
  return length_of_way(legs);
}

TEST(Thinned, AMissionSaysItByRoleAndItsCallerThinsThat) {
  const double whole = work_of("", {});
  const std::string role = "inspector";
  const double half = work_of("agents: {" + role + ": {intensity: {density: 0.5}}}\n", {});
  EXPECT_LT(half, 0.6 * whole);
  EXPECT_EQ(work_of("", {0.5, PassOrder::as_laid}), half);
  EXPECT_LT(
      work_of("agents: {" + role + ": {intensity: {density: 0.5}}}\n", {0.5, PassOrder::as_laid}),
      0.6 * half);
  EXPECT_NE(error_of([&] {
              (void)work_of("agents: {" + role + ": {intensity: {density: 2}}}\n", {});
            }).find("mission.yaml:"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::intensity_test
