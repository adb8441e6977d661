// "Left its depth": what a run says of a vehicle that is not where it was to be, beyond what its
// scenario bears.
#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/twin/run/manoeuvre_for_tests.h"

namespace slackwater::twin::left_depth_test {
namespace {

TEST(LeftDepth, IsSaidOfWhatWasThereAndWentAndNotOfWhatIsOnItsWay) {
  Milestones on_its_way;  // from 10 m to 30 m
  for (int t = 0; t < 50; ++t) note_depth(on_its_way, 1, 30, 10 + std::min(0.5 * t, 20.0), t);
  EXPECT_TRUE(std::isnan(on_its_way.left_depth_s));
  Milestones leaves = on_its_way;
  note_depth(leaves, 1, 30, 30.9, 50);
  EXPECT_TRUE(std::isnan(leaves.left_depth_s));
  note_depth(leaves, 1, 30, 31.1, 51);
  EXPECT_EQ(leaves.left_depth_s, 51);
  note_depth(leaves, 1, 30, 40, 52);
  EXPECT_EQ(leaves.left_depth_s, 51) << "when it did first";
  Milestones turns_back;  // sent to 30 m, and back to 20 m before it was there
  note_depth(turns_back, 2, 20, 20, 0);
  for (int t = 1; t < 8; ++t) note_depth(turns_back, 2, 30, 20 + t, t);
  for (int t = 8; t < 15; ++t) note_depth(turns_back, 2, 20, 27 - (t - 7), t);
  EXPECT_TRUE(std::isnan(turns_back.left_depth_s));
  note_depth(turns_back, 2, 20, 23, 16);
  EXPECT_EQ(turns_back.left_depth_s, 16) << "it had come back";
  Milestones sloping;  // a leg that goes down as it does
  for (int t = 0; t < 100; ++t) note_depth(sloping, 1, 10 + 0.3 * t, 10.5 + 0.3 * t, t);
  EXPECT_TRUE(std::isnan(sloping.left_depth_s));
  Milestones unkept;  // nobody keeps any: where it was
  for (int t = 0; t < 10; ++t) note_depth(unkept, 1, Milestones::never, 10 + 0.3 * t, t);
  EXPECT_EQ(unkept.left_depth_s, 4);
}

VehicleAccount account_of_run(const std::string& tasks, const std::string& model, double lasts_s,
                              const std::string& bound) {
  const auto run = tests::lone_run(
      "name: test\nseed: 7\nduration: 60min\nstep_s: 0.05\nlog_every_s: 1\n"
      "water: {made_up: {depth_m: 60}}\nvehicles:\n  - {name: it, model: " +
      model + ", " + bound + "start: {north_m: 0, east_m: 0, depth_m: 20}, tasks: [" + tasks +
      "]}\n");
  tests::go_on(*run, lasts_s);
  return account_of({run->agents(), run->states(), {}, run->time_s()}, 0);
}

/// A REMUS is light: with its fins amidships and its propeller still it rises.
TEST(LeftDepth, AnAuvThatNobodySteersRisesAndItIsSaid) {
  const std::string still =
      "{do: actuators, duration_s: 200, table: [{at_s: 0, propeller_rpm: 0}]}";
  const VehicleAccount said = account_of_run(still, "remus100", 200, "depth_bound_m: 2, ");
  ASSERT_TRUE(time_of(said.fate, Fate::left_depth).has_value());
  EXPECT_GT(*time_of(said.fate, Fate::left_depth), 5);
  EXPECT_NE(said.fate_text(parse_utc("2025-06-02T06:00:00Z")).find("left its depth at 06:0"),
            std::string::npos);
  EXPECT_TRUE(account_of_run(still, "remus100", 200, "").fate.empty()) << "nobody asks";
}

TEST(LeftDepth, DivesAndHoldsLeaveNone) {
  for (const char* tasks :
       {"{do: steps, duration_s: 300, table: [{at_s: 60, depth_m: 30}, {at_s: 200, depth_m: 15}]}",
        "{do: route, waypoints: [{north_m: 300, east_m: 0, depth_m: 30}]}"}) {
    const VehicleAccount account = account_of_run(tasks, "remus100", 400, "depth_bound_m: 2, ");
    EXPECT_FALSE(time_of(account.fate, Fate::left_depth)) << tasks;
  }
}

TEST(LeftDepth, IsRefusedOfWhatFloats) {
  try {
    (void)account_of_run("{do: hold}", "otter", 1, "depth_bound_m: 1, ");
    ADD_FAILURE() << "taken";
  } catch (const Error& problem) {
    EXPECT_NE(problem.message().find("keeps no depth; leave it out"), std::string::npos)
        << problem.message();
  }
}

}  // namespace
}  // namespace slackwater::twin::left_depth_test
