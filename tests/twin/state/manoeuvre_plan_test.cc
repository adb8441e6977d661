#include "twin/state/manoeuvre_plan.h"

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/twin/run/manoeuvre_for_tests.h"

namespace slackwater::tests::manoeuvre_plan_test {
namespace {

using constants::degree;

twin::ManoeuvrePlan plan_of(const std::string& model, const std::string& task,
                            const std::string& start = "depth_m: 20") {
  return ready_of(doing(model, task, start)).agents[0].mission.manoeuvres.at(0);
}

TEST(ManoeuvrePlan, PutsTheRudderOverWhereThereIsOne) {
  const twin::ManoeuvrePlan circle =
      plan_of("remus100", "{do: turning_circle, side: port, lasts_s: 60}");
  EXPECT_TRUE(circle.by_rudder);
  EXPECT_TRUE(circle.keeps_depth);
  ASSERT_EQ(circle.legs.size(), 1U);
  EXPECT_EQ(circle.legs[0].helm, -0.237) << "all that there is";
  const twin::ManoeuvrePlan half =
      plan_of("remus100", "{do: pull_out, helm_share: 0.5, turn_s: 10, lasts_s: 20}");
  ASSERT_EQ(half.legs.size(), 2U);
  EXPECT_EQ(half.legs[0].helm, 0.5 * 0.237);
  EXPECT_EQ(half.legs[1].helm, 0);
  EXPECT_EQ(half.lasts_s, 30);
  const twin::ManoeuvrePlan zig_zag = plan_of("lauv", "{do: zig_zag, lasts_s: 60}");
  ASSERT_EQ(zig_zag.legs.size(), 5U);
  EXPECT_NEAR(zig_zag.legs[0].helm, 20 * degree, 1e-15);
  EXPECT_NEAR(zig_zag.legs[1].helm, -20 * degree, 1e-15);
  EXPECT_NEAR(zig_zag.heading_change_rad, 20 * degree, 1e-15);
}

TEST(ManoeuvrePlan, TurnsByThrustersWhatHasNoRudder) {
  const twin::ManoeuvrePlan spiral = plan_of(
      "otter", "{do: spiral, speed_m_s: 1, helms_share: [0.2, 0, -0.2], each_s: 20}", "depth_m: 0");
  EXPECT_FALSE(spiral.by_rudder);
  EXPECT_FALSE(spiral.keeps_depth);
  // A pure couple, of which astern gives less: 0.006445 x 101.74^2 N on arms of 0.395 m.
  EXPECT_NEAR(spiral.most_yaw_n_m, 2 * 0.395 * 0.006445 * 101.74 * 101.74, 1e-6);
  ASSERT_EQ(spiral.legs.size(), 3U);
  EXPECT_EQ(spiral.legs[2].helm, -0.2);
}

TEST(ManoeuvrePlan, OfWhatTheVehicleCannotIsRefusedWithItsLine) {
  struct Case {
    const char* model;
    const char* start;
    const char* task;
    const char* words;
  };
  const char* const deep = "depth_m: 20";
  const char* const afloat = "depth_m: 0";
  for (const Case& c : {
           Case{"remus100", deep, "{do: turning_circle, helm_deg: 20, lasts_s: 9}",
                "helm_deg: found 20, expected -13.58 to 13.58, the limits of the rudder"},
           Case{"remus100", deep, "{do: zig_zag, lasts_s: 9}",
                "helm_deg: found 20, which a zig-zag has by default, expected -13.58"},
           Case{"remus100", deep, "{do: spiral, helms_deg: [5, -14.5], each_s: 9}",
                "helm_deg: found -14.5"},
           Case{"wamv16", afloat, "{do: turning_circle, helm_deg: 10, lasts_s: 9}",
                "helm_deg: found an angle, and the WAM-V 16 has no rudder"},
           Case{"wamv16", afloat, "{do: zig_zag, lasts_s: 9}",
                "helm_share: missing; the WAM-V 16 has no rudder to put to 20 degrees"},
           Case{"otter", afloat, "{do: turning_circle, speed_m_s: 1.5, lasts_s: 9}",
                "helm_share: found 1, expected at most 0.92: beside the thrust of 1.5 m/s"},
           Case{"lauv", deep, "{do: turning_circle, speed_m_s: 30, lasts_s: 9}",
                "speed_m_s: found 30 m/s, expected at most "},
           Case{"remus100", deep, "{do: zig_zag, helm_deg: 5, speed_m_s: 0.2, lasts_s: 9}",
                "speed_m_s: found 0.2 m/s, expected at least 1 m/s"},
           Case{"lauv", deep, "{do: steps, duration_s: 9, table: [{at_s: 0, speed_m_s: 30}]}",
                "speed_m_s: found 30 m/s, expected at most "},
           Case{"remus100", deep, "{do: steps, duration_s: 9, table: [{at_s: 0, depth_m: 150}]}",
                "depth_m: found 150, expected at most 100, the depth that the REMUS 100 is rated "
                "for"},
           Case{"otter", afloat, "{do: steps, duration_s: 9, table: [{at_s: 0, depth_m: 1}]}",
                "depth_m: found 1, and the Otter USV floats; leave it out"},
           Case{"x500", "height_m: 20", "{do: zig_zag, helm_share: 0.1, lasts_s: 9}",
                "do: found zig_zag, and the Holybro X500 flies"},
       }) {
    try {
      (void)ready_of(doing(c.model, c.task, c.start));
      ADD_FAILURE() << c.task << " is not refused";
    } catch (const Error& problem) {
      const std::string& said = problem.message();
      EXPECT_EQ(said.rfind("vehicle it: test.yaml:9: ", 0), 0U) << said;
      EXPECT_NE(said.find(c.words), std::string::npos) << said << "\nhas no: " << c.words;
    }
  }
  EXPECT_THROW(
      (void)ready_of(doing("lauv", "{do: steps, duration_s: 9, table: [{at_s: 0, depth_m: 70}]}")),
      Error)
      << "below the bed";
}

/// A little less than the largest share that is named is taken.
TEST(ManoeuvrePlan, HasRoomForTheShareThatItNames) {
  std::string said;
  try {
    (void)plan_of("wamv16", "{do: turning_circle, speed_m_s: 2, lasts_s: 9}", "depth_m: 0");
  } catch (const Error& problem) {
    said = problem.message();
  }
  const std::size_t at = said.find("at most ");
  ASSERT_NE(at, std::string::npos) << said;
  const std::string share = said.substr(at + 8, 4);
  EXPECT_NO_THROW((void)plan_of(
      "wamv16", "{do: turning_circle, speed_m_s: 2, lasts_s: 9, helm_share: " + share + "}",
      "depth_m: 0"));
}

}  // namespace
}  // namespace slackwater::tests::manoeuvre_plan_test
