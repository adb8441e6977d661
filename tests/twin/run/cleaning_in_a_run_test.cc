#include "fields/base/error.h"
#include "fields/base/text.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/conduct.h"
#include "twin/surface/cleaning_outcome.h"

namespace slackwater::tests::cleaning_in_a_run_test {
namespace {

using twin::CleaningOutcome;

/// An ROV that cleans the north side of a pile of 6 m on three levels, on straight ways 0.4 to
/// 0.8 m off the face, at 5 to 6 cm/s along it: 0.1 m of overlap, from 19 degrees before the patch
/// to 19 behind it, where it turns.
std::string rov_that_cleans(const std::string& conduct = "", const std::string& name = "rov") {
  std::string tasks;
  for (int level = 0; level < 3; ++level) {
    const bool is_back = level % 2 == 1;
    std::string points;
    for (int i = 0; i <= 1; ++i) {
      const double bearing = (-5 + 55 * (is_back ? 1 - i : i)) * constants::pi / 180;
      points += formatted(
          "{}{{north_m: {:.6f}, east_m: {:.6f}, depth_m: {:.2f}, speed_m_s: 0.0633}}",
          i > 0 ? ", " : "", 3.8 * std::cos(bearing), 3.8 * std::sin(bearing), 10 + 0.3 * level);
    }
    tasks +=
        formatted("{}{{do: route, phase: work, waypoints: [{}]}}", level > 0 ? ", " : "", points);
  }
  return formatted(
             "  - {{name: {}, model: bluerov2_heavy, start: {{north_m: 3.7855, east_m: -0.3312, "
             "depth_m: "
             "10, "
             "heading_deg: 90}}, conduct: {{cleaning: {{bearings_deg: [14, 31], from: {{depth_m: "
             "9.5}}, "
             "to: {{depth_m: 11.1}}, cell_m: 0.02, growth: {{source: test, status: estimate, "
             "by_depth: "
             "[{{thickness_mm: 100}}]}}, tool: {{swath_m: 0.4, reach_m: 1, removal_mm_m2_h: 9000, "
             "source: test, status: estimate}}}}{}}}, ",
             name, conduct) +
         "tasks: [" + tasks + "]}\n";
}

std::string water_of(double current_m_s) {
  return formatted(
      "name: test\nseed: 7\nduration: 30min\nstep_s: 0.05\nlog_every_s: 1\nwater: {{made_up: "
      "{{depth_m: 40, current: [{{depth_m: 0, east_m_s: 0, north_m_s: {}}}]}}}}\nwaves: {{from: "
      "calm}}\nstructures:\n  - {{name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: "
      "6, top_height_m: 20, bottom_depth_m: 40}}\nvehicles:\n",
      current_m_s);
}

std::unique_ptr<twin::Run> run_of(const std::string& yaml, std::size_t threads = 1,
                                  bool is_batch = true) {
  return begun(ready_of(yaml), 0.05, threads, is_batch);
}

CleaningOutcome outcome_of(twin::Run& run, std::size_t i = 0) {
  return twin::cleaning_outcome(*run.agents()[i].conduct->cleaning,
                                run.states()[i].conduct.cleaning);
}

CleaningOutcome flown(const std::string& yaml) {
  const auto run = run_of(yaml);
  while (run->time_s() < 900 && !run->all_ended()) run->step();
  EXPECT_TRUE(run->all_ended());
  return outcome_of(*run);
}

TEST(CleaningInARun, InStillWaterIsTheAreaOfItsPasses) {
  const CleaningOutcome out = flown(water_of(0) + rov_that_cleans());
  // Three swaths less two overlaps, as wide as the patch is within the way.
  const double wanted_m2 = 3 * (31 - 14) * constants::pi / 180 * (3 * 0.4 - 2 * 0.1);
  EXPECT_NEAR(out.cleaned_m2, wanted_m2, 0.01 * wanted_m2);
  EXPECT_NEAR(out.removed_m3 + out.left_m3, 0.1 * out.area_m2, 1e-9);
  EXPECT_EQ(out.passes_needed, 1U);
  EXPECT_FALSE(out.is_done());  // the patch is higher than that
}

TEST(CleaningInARun, FallsInACurrentThatKeepsTheVehicleOffTheFace) {
  // From the south: the north side lies in the lee, and the water takes the vehicle away from it.
  std::vector<double> shares;
  for (const double current_m_s : {0.0, 0.6, 1.6})
    shares.push_back(flown(water_of(current_m_s) + rov_that_cleans()).share());
  EXPECT_LE(shares[1], shares[0] + 0.01);
  EXPECT_LT(shares[2], 0.5 * shares[0]);
}

TEST(CleaningInARun, TakesNothingWhileItHoldsAndGoesOnWhereItLeft) {
  const std::string water = water_of(0);
  const CleaningOutcome straight = flown(water + rov_that_cleans(", autonomy: shared"));
  const auto run = run_of(
      water + rov_that_cleans(", autonomy: shared, holding: {overlap_m: 0.3}, faults: [{fault: "
                              "lost_link, at_s: 30, for_s: 40}]"));
  while (run->time_s() < 31.01) run->step();
  ASSERT_EQ(run->states()[0].conduct.doing, twin::Doing::hold);
  const double at_hold_m3 = outcome_of(*run).removed_m3;
  EXPECT_GT(at_hold_m3, 0);
  while (run->time_s() < 69.99) run->step();
  EXPECT_EQ(outcome_of(*run).removed_m3, at_hold_m3);
  while (run->time_s() < 900 && !run->all_ended()) run->step();
  EXPECT_NEAR(outcome_of(*run).cleaned_m2, straight.cleaned_m2, 0.01 * straight.cleaned_m2);
}

TEST(CleaningInARun, IsTheSameToTheBitHoweverItIsSteppedAndTakenUp) {
  std::string yaml = water_of(0.4);
  for (int i = 0; i < 9; ++i)
    yaml +=
        rov_that_cleans(", autonomy: shared, pilot: {wander_m: 0.05}", "rov" + std::to_string(i));
  const auto state_after = [&](twin::Run& run, int steps) {
    for (int i = 0; i < steps; ++i) run.step();
    std::vector<twin::CleaningState> all;
    for (const twin::AgentState& state : run.states()) all.push_back(state.conduct.cleaning);
    return all;
  };
  const auto first = run_of(yaml), threads = run_of(yaml, 2), single = run_of(yaml, 1, false),
             before = run_of(yaml), after = run_of(yaml);
  const auto wanted = state_after(*first, 1200);
  (void)state_after(*before, 500);
  after->restore(before->checkpoint());
  const std::pair<const char*, std::vector<twin::CleaningState>> others[] = {
      {"two threads", state_after(*threads, 1200)},
      {"one by one", state_after(*single, 1200)},
      {"taken up", state_after(*after, 700)}};
  for (const auto& [what, states] : others)
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(states[i].patches[0].growth_nm, wanted[i].patches[0].growth_nm) << what << i;
      EXPECT_EQ(states[i].along_m, wanted[i].along_m) << what << i;
      EXPECT_GT(wanted[i].patches[0].removed_nm, 0);
    }
}

TEST(CleaningInARun, SaysWhichVehicleCannotCleanWhatItIsTo) {
  std::string yaml = water_of(0) + rov_that_cleans();
  yaml.replace(yaml.find("to: {depth_m: 11.1}"), 19, "to: {depth_m: 41}");
  try {
    (void)ready_of(yaml);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("rov"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("the foundation from -20 to 40 m"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace slackwater::tests::cleaning_in_a_run_test
