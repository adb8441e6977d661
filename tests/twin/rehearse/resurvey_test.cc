// What is flown again: who, from where, for how long, and in a text that comes back.
#include "twin/rehearse/resurvey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "tests/twin/rehearse/pile_survey.h"
#include "twin/scenario/read_scenario.h"

namespace slackwater::tests::resurvey_test {
namespace {

using twin::Phase;
using twin::Triple;

class ResurveyOf : public testing::Test {
 protected:
  ResurveyOf() {
    const twin::ScenarioVehicle& eye = scenario_.vehicles.at(0);
    std::vector<twin::Waypoint> way;
    for (const twin::ScenarioTask& task : eye.tasks)
      if (task.phase == Phase::work)
        way.insert(way.end(), task.waypoints.begin(), task.waypoints.end());
    inspection_ = twin::ready_inspection(eye.name, eye.conduct.value().inspection.value(), way,
                                         source_folder() / "data", 200);
    for (const twin::ScenarioStructure& structure : scenario_.structures)
      structures_.push_back(twin::shape_of(structure));
    const auto& pile = std::get<twin::MonopileSizes>(inspection_->plan.surfaces.at(0).sizes);
    axis_m_ = {pile.upright.north_m, pile.upright.east_m, 0};
    radius_m_ = pile.radius_m;
  }

  using Where = std::function<bool(const twin::Patch&)>;
  static bool everywhere(const twin::Patch&) { return true; }
  static bool in_the_south(const twin::Patch& patch) { return patch.normal.x < 0; }
  static bool nowhere(const twin::Patch&) { return false; }

  /// At the end of a flight that covered the pile there, and else saw it so.
  [[nodiscard]] twin::InspectionState after(const Where& is_covered,
                                            const twin::BestLook& else_seen = {}) const {
    twin::BestLook good;
    good.detail_m = 0.001F;
    good.incidence_cosine = 1;
    good.looks = 1;
    twin::InspectionState state = twin::begin_inspection(*inspection_, 1);
    const auto& patches = inspection_->surfaces.at(0).patches;
    for (std::size_t p = 0; p < patches.size(); ++p)
      state.best.at(0).at(p) = is_covered(patches[p]) ? good : else_seen;
    return state;
  }
  [[nodiscard]] twin::Resurvey again_after(const twin::InspectionState& state) const {
    const twin::Inspected one{0, *inspection_, state};
    return twin::resurvey_of(scenario_, structures_, {&one, 1});
  }
  /// Where the routes of its work end.
  [[nodiscard]] static std::vector<Triple<double>> stands_of(const twin::ScenarioVehicle& vehicle) {
    std::vector<Triple<double>> stands_m;
    for (const twin::ScenarioTask& task : vehicle.tasks)
      if (task.phase != Phase::return_home && !task.waypoints.empty())
        stands_m.push_back(task.waypoints.back().position_m);
    return stands_m;
  }

  twin::Scenario scenario_ = pile_survey(1, 0.9)({});
  std::shared_ptr<const twin::Inspection> inspection_;
  std::vector<twin::Structure> structures_;
  Triple<double> axis_m_;
  double radius_m_ = 0;
};

TEST_F(ResurveyOf, WhatIsCoveredIsNotFlownAgain) {
  const twin::Resurvey again = again_after(after(everywhere));
  EXPECT_FALSE(again.scenario);
  EXPECT_TRUE(again.words.empty());
}

TEST_F(ResurveyOf, OnlyThoseThatLeftSomethingFlyAgain) {
  for (const char* name : {"second", "third"})
    scenario_.vehicles.emplace_back(scenario_.vehicles.front()).name = name;
  const twin::InspectionState all = after(everywhere), half = after(in_the_south);
  const std::vector<twin::Inspected> inspected{
      {0, *inspection_, all}, {1, *inspection_, half}, {2, *inspection_, all}};
  const twin::Resurvey again = twin::resurvey_of(scenario_, structures_, inspected);
  ASSERT_EQ(again.scenario.value().vehicles.size(), 1U);
  EXPECT_EQ(again.scenario->vehicles[0].name, "second");
  ASSERT_EQ(again.words.size(), 1U);
  EXPECT_TRUE(again.words[0].starts_with("second: ")) << again.words[0];
}

TEST_F(ResurveyOf, NineTenthsOfWhatIsLeftIsLookedAtSquarelyEnoughAndNothingElseIs) {
  const auto again = again_after(after(in_the_south));
  const auto stands_m = stands_of(again.scenario.value().vehicles.at(0));
  ASSERT_FALSE(stands_m.empty());
  for (const Triple<double>& stand_m : stands_m) EXPECT_GT(stand_m.x, axis_m_.x);
  const double reach_m = inspection_->instruments.at(0).most_range_m;
  const double least_cosine = std::cos(inspection_->plan.lines.at(0).most_incidence_rad);
  double left_m2 = 0, looked_at_m2 = 0;
  for (const twin::Patch& patch : inspection_->surfaces.at(0).patches) {
    if (in_the_south(patch)) continue;
    left_m2 += patch.area_m2;
    for (const Triple<double>& stand_m : stands_m) {
      const Triple<double> way = stand_m - patch.centre_m;
      const double range_m = twin::length_of(way);
      if (range_m > reach_m || twin::dot(way, patch.normal) < least_cosine * range_m) continue;
      looked_at_m2 += patch.area_m2;
      break;
    }
  }
  // Half of the mantle, of which the words tell too.
  EXPECT_NEAR(left_m2, constants::pi * radius_m_ * 24, 0.05 * left_m2);
  EXPECT_GT(looked_at_m2, 0.9 * left_m2);
  EXPECT_TRUE(
      contains(again.words.at(0), formatted(": {:.0f} m2 are not covered, 0 of them seen too "
                                            "poorly; another look from {} places",
                                            left_m2, stands_m.size())))
      << again.words[0];
}

TEST_F(ResurveyOf, LegsKeepOffThePile) {
  const auto again = again_after(after(nowhere));
  const twin::ScenarioVehicle& eye = again.scenario.value().vehicles.at(0);
  const double clear_m = eye.conduct.value().clear_m;
  EXPECT_GT(clear_m, 0.5);
  Triple<double> at_m = eye.start_m;
  std::size_t legs = 0;
  for (const twin::ScenarioTask& task : eye.tasks)
    for (const twin::Waypoint& to : task.waypoints) {
      for (int i = 0; i <= 20; ++i) {
        const Triple<double> here_m = at_m + (i / 20.0) * (to.position_m - at_m);
        // A micrometre for what is rounded.
        EXPECT_GT(std::hypot(here_m.x - axis_m_.x, here_m.y - axis_m_.y),
                  radius_m_ + clear_m - 1e-5);
      }
      at_m = to.position_m;
      ++legs;
    }
  EXPECT_GT(legs, 20U);
  EXPECT_LT(twin::length_of(at_m - eye.start_m), 1e-5) << "it ends where it began";
}

TEST_F(ResurveyOf, LaunchAndRecoveryAreAsTheyWereAndItComesHomeBetween) {
  const auto again = again_after(after(in_the_south));
  const twin::ScenarioVehicle &was = scenario_.vehicles[0], &is = again.scenario->vehicles.at(0);
  EXPECT_EQ(is.start_m, was.start_m);
  EXPECT_EQ(is.conduct, was.conduct);
  EXPECT_EQ(was.tasks.front().phase, Phase::launch);
  EXPECT_EQ(was.tasks.back().phase, Phase::recovery);
  EXPECT_EQ(is.tasks.front(), was.tasks.front());
  EXPECT_EQ(is.tasks.back(), was.tasks.back());
  EXPECT_EQ(is.tasks.at(1).phase, Phase::transit);
  EXPECT_EQ(is.tasks.at(is.tasks.size() - 2).phase, Phase::return_home);
  for (std::size_t i = 2; i + 2 < is.tasks.size(); ++i) EXPECT_EQ(is.tasks[i].phase, Phase::work);
}

TEST_F(ResurveyOf, LastsAsLongAsItDidOrHalfAsLongAgainAsTheWayTakes) {
  const auto state = after(nowhere);
  EXPECT_EQ(again_after(after(in_the_south)).scenario.value().duration_s, scenario_.duration_s);
  scenario_.duration_s = 61;
  const auto again = again_after(state);
  const twin::ScenarioVehicle& eye = again.scenario.value().vehicles.at(0);
  double takes_s = 20;  // launch and recovery
  Triple<double> at_m = eye.start_m;
  for (const twin::ScenarioTask& task : eye.tasks) {
    if (task.phase == Phase::return_home) break;
    for (const twin::Waypoint& to : task.waypoints) {
      EXPECT_EQ(to.speed_m_s, 0.4);
      takes_s += twin::length_of(to.position_m - at_m) / to.speed_m_s;
      at_m = to.position_m;
    }
  }
  EXPECT_EQ(again.scenario->duration_s, 60 * std::ceil(1.5 * takes_s / 60));
  EXPECT_TRUE(contains(again.words.at(0), formatted(" takes about {:.0f} min", takes_s / 60)))
      << again.words[0];
}

TEST_F(ResurveyOf, WhatWasSmearedIsFlownAtHalfTheSpeedAndNearer) {
  twin::BestLook smeared;
  smeared.detail_m = 0.1F;  // twice what is asked for
  smeared.incidence_cosine = 1;
  smeared.ground_sampling_m = 0.01F;
  smeared.blur_m = 0.09F;
  smeared.looks = 1;
  const auto farther = again_after(after(in_the_south));
  const auto again = again_after(after(in_the_south, smeared));
  EXPECT_TRUE(again.words.at(0).ends_with(", at half the speed")) << again.words[0];
  EXPECT_FALSE(contains(again.words[0], ", 0 of them seen too poorly")) << again.words[0];
  const twin::ScenarioVehicle& eye = again.scenario.value().vehicles.at(0);
  EXPECT_EQ(eye.tasks.at(1).waypoints.back().speed_m_s, 0.2);
  const auto off_m = [&](const twin::Resurvey& resurvey) {
    const auto stands_m = stands_of(resurvey.scenario.value().vehicles.at(0));
    double sum_m = 0;
    for (const Triple<double>& at_m : stands_m)
      sum_m += std::hypot(at_m.x - axis_m_.x, at_m.y - axis_m_.y) - radius_m_;
    return sum_m / static_cast<double>(stands_m.size());
  };
  EXPECT_NEAR(off_m(again), 0.5 * off_m(farther), 0.1);
}

TEST_F(ResurveyOf, WhateverItsNamesTheTextComesBackAsTheScenario) {
  for (const char* name :
       {"a: b", "- x", "\"", "'", "# no", "{", "]", "null", "0.5", "ä\n\t", "\\"}) {
    twin::Scenario& was = scenario_;
    was.name = was.vehicles[0].name = name;
    was.vehicles[0].conduct->inspection->surfaces[0].name = name;
    const auto again = again_after(after(in_the_south));
    ASSERT_TRUE(again.scenario) << name;
    EXPECT_EQ(again.scenario->name, std::string(name) + ", flown again");
    twin::Scenario read = twin::parse_scenario(again.scenario->yaml, "again.yaml");
    EXPECT_TRUE(read == *again.scenario) << again.scenario->yaml;
  }
}

}  // namespace
}  // namespace slackwater::tests::resurvey_test
