#include "twin/surface/cleaning.h"

#include <gtest/gtest.h>

#include <numeric>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/twin/surface/cleaning_for_tests.h"

namespace slackwater::tests::cleaning_test {
namespace {

using twin::Cleaning;
using twin::CleaningOutcome;
using twin::CleaningState;

constexpr double pi = constants::pi;

std::int64_t left_nm(const CleaningState& state, std::size_t patch = 0) {
  const auto& growth = state.patches[patch].growth_nm;
  return std::accumulate(growth.begin(), growth.end(), std::int64_t{0});
}

TEST(Cleaning, ParallelPassesCleanTheirSwathsLessTheOverlap) {
  // From far before the patch to far behind it, so that its ends do not count.
  struct Case {
    double spacing_m;
    int passes;
    double cell_m;
  };
  // Where the cells do not fit the swath they have to be small: the edge lies within one of them.
  for (const Case& c : {Case{0.4, 3, 0.1}, Case{0.3, 4, 0.1}, Case{0.25, 5, 0.02},
                        Case{0.31, 3, 0.0043}, Case{0.4, 1, 0.0033}}) {
    const Cleaning cleaning = ready_for(cleaning_plan(cleaning_yaml(
        "removal_mm_m2_h: 6000", formatted("bearings_deg: [60, 70]\ncell_m: {}\n", c.cell_m))));
    CleaningState state = twin::begin_cleaning(cleaning);
    for (int i = 0; i < c.passes; ++i) pass(cleaning, 2, 5, 5 + c.spacing_m * i, 0.04, 0.05, state);
    const CleaningOutcome out = cleaning_outcome(cleaning, state);
    const double length_m = 3 * pi / 18;
    const double wanted_m2 = length_m * (0.4 * c.passes - (0.4 - c.spacing_m) * (c.passes - 1));
    EXPECT_NEAR(out.cleaned_m2, wanted_m2, 0.01 * wanted_m2) << c.spacing_m << " " << c.cell_m;
    EXPECT_NEAR(out.area_m2, length_m * 4, 1e-9);
    EXPECT_NEAR(out.removed_m3, 0.1 * wanted_m2, 0.01 * 0.1 * wanted_m2);
  }
}

TEST(Cleaning, WhatIsLeftBehindAPassIsWhatTheToolHadNoTimeFor) {
  // h - Q/(w v), pass by pass; and as many passes as were foretold lay the face bare, not one
  // fewer.
  for (const double speed_m_s : {0.04, 0.06, 0.1, 0.35}) {
    const Cleaning cleaning =
        ready_for(cleaning_plan(cleaning_yaml("removal_mm_m2_h: 6000", "bearings_deg: [45, 75]\n")),
                  speed_m_s);
    const double takes_mm = 6000.0 / 3600 / (0.4 * speed_m_s);
    EXPECT_EQ(cleaning.passes, static_cast<std::size_t>(std::ceil(100 / takes_mm - 1e-9)))
        << speed_m_s;
    CleaningState state = twin::begin_cleaning(cleaning);
    for (std::size_t p = 1; p <= cleaning.passes; ++p) {
      pass(cleaning, 1, 5.5, 6, speed_m_s, 0.05, state);
      const double wanted_mm = std::max(0.0, 100 - static_cast<double>(p) * takes_mm);
      const twin::CylinderPatch& patch = cleaning.patches[0];
      for (std::size_t r = 0; r < patch.rows; ++r) {
        const double down_m = 4 + (static_cast<double>(r) + 0.5) * patch.row_m();
        const double left_mm =
            1e-6 * static_cast<double>(state.patches[0].growth_nm[r * patch.columns]);
        EXPECT_NEAR(left_mm, std::abs(down_m - 6) < 0.2 ? wanted_mm : 100, 1e-3) << down_m;
      }
      const bool is_bare = cleaning_outcome(cleaning, state).cleaned_m2 > 0;
      EXPECT_EQ(is_bare, p == cleaning.passes) << speed_m_s << " pass " << p;
    }
  }
}

TEST(Cleaning, TakesTheInverseOfItsRateForAnArea) {
  // 60 m2/h: a square metre in a minute, whatever grows on it.
  for (const char* thickness : {"20", "100", "180"}) {
    std::string yaml = cleaning_yaml("rate_m2_h: 60", "bearings_deg: [45, 75]\n");
    yaml.replace(yaml.find("100}]"), 3, thickness);
    const auto cleaned = [&](double speed_m_s) {
      const Cleaning cleaning = ready_for(cleaning_plan(yaml), speed_m_s);
      CleaningState state = twin::begin_cleaning(cleaning);
      pass(cleaning, 1, 5.5, 6, speed_m_s, 0.05, state);
      return cleaning_outcome(cleaning, state).cleaned_m2;
    };
    const double just_m_s = 60.0 / 3600 / 0.4;
    EXPECT_NEAR(cleaned(0.999 * just_m_s), 0.4 * 3 * pi / 6, 1e-9) << thickness;
    EXPECT_EQ(cleaned(1.001 * just_m_s), 0) << thickness;
  }
  const Cleaning cleaning = ready_for(cleaning_plan(cleaning_yaml("rate_m2_h: 60")));
  CleaningState state = twin::begin_cleaning(cleaning);
  // A metre and a half at the speed of the rate, and the time that it worked.
  pass(cleaning, 1, 2.5, 6, 60.0 / 3600 / 0.4, 0.05, state);
  EXPECT_NEAR(state.worked_s / (0.4 * 1.5), 60, 1e-6);
}

TEST(Cleaning, WhatIsTakenOffAndWhatIsLeftAreWhatThereWasExactly) {
  Rng rng(11, "cleaning");
  for (int trial = 0; trial < 20; ++trial) {
    const bool by_area = rng.uniform() < 0.5;
    const Cleaning cleaning = ready_for(cleaning_plan(
        cleaning_yaml(formatted("{}: {:.3f}", by_area ? "rate_m2_h" : "removal_mm_m2_h",
                                by_area ? rng.uniform(10, 500) : rng.uniform(500, 50000)),
                      formatted("cell_m: {:.3f}\n", rng.uniform(0.02, 0.4)))));
    CleaningState state = twin::begin_cleaning(cleaning);
    const std::int64_t grew_nm = left_nm(state);
    double along_m = 2, down_m = 6;
    for (int i = 0; i < 3000; ++i) {
      along_m += rng.uniform(-0.1, 0.12);
      down_m = std::clamp(down_m + rng.uniform(-0.1, 0.1), 3.0, 9.0);
      clean(cleaning, rng.uniform() < 0.95, beside_pile(along_m, down_m, rng.uniform(0.5, 1.1)),
            rng.uniform(0.01, 0.5), state);
    }
    EXPECT_EQ(state.patches[0].removed_nm + left_nm(state), grew_nm);
    EXPECT_GT(state.patches[0].removed_nm, 0);
    const CleaningOutcome out = cleaning_outcome(cleaning, state);
    const double all_m3 = 0.1 * 6 * pi * 4;
    EXPECT_NEAR(out.removed_m3 + out.left_m3, all_m3, 1e-9 * all_m3);
    double cleaned_m2 = 0, removed_m3 = 0;
    for (const CleaningOutcome::Band& band : out.bands) {
      cleaned_m2 += band.cleaned_m2;
      removed_m3 += band.removed_m3;
    }
    EXPECT_NEAR(cleaned_m2, out.cleaned_m2, 1e-9);
    EXPECT_NEAR(removed_m3, out.removed_m3, 1e-9);
    EXPECT_EQ(out.bands.size(), 4U);
  }
}

TEST(Cleaning, IsTheSameHoweverOftenOneLooks) {
  const Cleaning cleaning = ready_for(cleaning_plan(cleaning_yaml()));
  std::vector<CleaningState> states;
  for (const double dt_s : {0.01, 0.05, 1.0, 7.0}) {
    CleaningState& state = states.emplace_back(twin::begin_cleaning(cleaning));
    pass(cleaning, 2, 4, 6.03, 0.06, dt_s, state);
    const auto& growth = state.patches[0].growth_nm;
    for (std::size_t i = 0; i < growth.size(); ++i)
      EXPECT_NEAR(static_cast<double>(growth[i]),
                  static_cast<double>(states[0].patches[0].growth_nm[i]), 3000)
          << dt_s;  // a nanometre a look
  }
}

TEST(Cleaning, TakesNothingFromAfarOrWhileItDoesNotWork) {
  const Cleaning cleaning = ready_for(cleaning_plan(cleaning_yaml()));
  CleaningState state = twin::begin_cleaning(cleaning);
  for (int i = 0; i < 100; ++i) clean(cleaning, true, beside_pile(0.01 * i, 6, 1.001), 1, state);
  for (int i = 0; i < 100; ++i) clean(cleaning, false, beside_pile(0.01 * i, 6), 1, state);
  for (int i = 0; i < 100; ++i) clean(cleaning, true, beside_pile(0.01 * i, 3.7), 1, state);
  EXPECT_EQ(state.patches[0].removed_nm, 0);
  EXPECT_EQ(state.worked_s, 0);
  // Away and back again: what lies between is not swept.
  clean(cleaning, true, beside_pile(1, 6), 1, state);
  clean(cleaning, true, beside_pile(2, 6, 3), 1, state);
  clean(cleaning, true, beside_pile(3, 6), 1, state);
  EXPECT_EQ(state.patches[0].removed_nm, 0);
  clean(cleaning, true, beside_pile(3, 6, 0.999), 1, state);
  EXPECT_GT(state.patches[0].removed_nm, 0);
}

TEST(Cleaning, GoesOverTheSeamAsOverAnyOtherPlace) {
  const auto removed_nm = [](double from_m, const std::string& bearings) {
    const Cleaning cleaning = ready_for(
        cleaning_plan(cleaning_yaml("removal_mm_m2_h: 6000", "bearings_deg: " + bearings + "\n")));
    CleaningState state = twin::begin_cleaning(cleaning);
    // At places of the same kind within their cells.
    const double column_m = cleaning.patches[0].column_m();
    pass(cleaning, from_m * column_m, (from_m + 20) * column_m, 6, 0.05, 0.3, state);
    return state.patches[0].removed_nm;
  };
  EXPECT_NEAR(static_cast<double>(removed_nm(-10, "[0, 360]")),
              static_cast<double>(removed_nm(40, "[0, 360]")), 1e5);
  // A patch over north is entered from outside on both its sides.
  EXPECT_EQ(removed_nm(-30, "[0, 90]"), 0);
  EXPECT_GT(removed_nm(-10, "[0, 90]"), 0);
  EXPECT_NEAR(static_cast<double>(removed_nm(-10, "[-90, 90]")),
              static_cast<double>(removed_nm(-10, "[270, 450]")), 1e5);
}

TEST(Cleaning, CountsWhatMayStayAsClean) {
  const auto share = [](const std::string& more) {
    const Cleaning cleaning =
        ready_for(cleaning_plan(cleaning_yaml("removal_mm_m2_h: 6000", more)), 0.044);
    CleaningState state = twin::begin_cleaning(cleaning);
    // 94.7 of 100 mm.
    for (int i = 0; i < 10; ++i) pass(cleaning, 0, 6 * pi, 4.2 + 0.4 * i, 0.044, 0.5, state);
    return cleaning_outcome(cleaning, state).share();
  };
  // Not about the seam, where each pass begins and ends.
  EXPECT_LT(share("bearings_deg: [20, 340]\n"), 1e-9);
  EXPECT_NEAR(share("bearings_deg: [20, 340]\nclean_below_mm: 6\n"), 1, 1e-9);
}

TEST(MarineGrowth, IsThatOfItsLayer) {
  const Config config = Config::parse(
      "source: s\nstatus: estimate\nup_to_height_m: 2\nby_depth: [{down_to_depth_m: 40, "
      "thickness_mm: 100}, {thickness_mm: 50}]\n",
      "growth.yaml");
  const twin::MarineGrowth growth = twin::read_marine_growth(config);
  EXPECT_EQ(growth.thickness_mm_at(-2.1), 0);
  EXPECT_EQ(growth.thickness_mm_at(-1.9), 100);
  EXPECT_EQ(growth.thickness_mm_at(39.9), 100);
  EXPECT_EQ(growth.thickness_mm_at(40.1), 50);
  EXPECT_EQ(growth.thickness_mm_at(4000), 50);
  EXPECT_EQ(growth.density_kg_m3, 0);
}

struct Bad {
  const char* what;
  const char* instead;
  const char* says;
};

TEST(Cleaning, RefusesWhatCannotBeWithOneSentence) {
  const Bad all[] = {
      {"swath_m: 0.4", "swath_m: 0", "expected a value from 0.05"},
      {"swath_m: 0.4", "swath_m: 5", "take a narrower"},
      {"reach_m: 1", "reach_m: 0.5", "its work stays 0.80 m off"},
      {"removal_mm_m2_h: 6000", "power_w: 6000", "give one of removal_mm_m2_h"},
      {"removal_mm_m2_h: 6000", "removal_mm_m2_h: 6000, rate_m2_h: 3", "give one of"},
      {"thickness_mm: 100", "thickness: 100", "has no unit; say thickness_mm"},
      {"thickness_mm: 100", "thickness_mm: 0", "found no growth to take off"},
      {"thickness_mm: 100", "down_to_depth_m: 3, thickness_mm: 100", "found no growth to take off"},
      {"to: {depth_m: 8}", "to: {depth_m: 36}", "the foundation from -20 to 35 m"},
      {"from: {depth_m: 4}", "from: {height_m: 21}", "the foundation from -20 to 35 m"},
      {"from: {depth_m: 4}", "from: {depth_m: 7}", "does not reach the patch"},
      {"from: {depth_m: 4}", "from: {depth_m: 9}", "is not below from"},
      {"from: {depth_m: 4}", "from: {depth: 4}", "give one of depth_m and height_m"},
      {"source: test, status: estimate, density", "density", "source"},
      {"to: {", "bearings_deg: [350, 10]\nto: {", "write [350, 370]"},
      {"to: {", "bearings_deg: [10]\nto: {", "expected two"},
      {"to: {", "cell_m: 0.5\nto: {", "wider than the tool's"},
      {"to: {", "swath_m: 0.4\nto: {", "swath_m"},
  };
  for (const Bad& bad : all) {
    std::string yaml = cleaning_yaml();
    yaml.replace(yaml.find(bad.what), std::string(bad.what).size(), bad.instead);
    try {
      (void)ready_for(cleaning_plan(yaml));
      ADD_FAILURE() << bad.instead << ": no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      EXPECT_NE(std::string(error.what()).find(bad.says), std::string::npos)
          << bad.instead << "\n-> " << error.what();
    }
  }
}

}  // namespace
}  // namespace slackwater::tests::cleaning_test
