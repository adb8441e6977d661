// `slackwater simulate` with manoeuvres: figures in the summary and as JSON, absent ones with why;
// the log replays, and a run that is taken up in the middle of them has its bytes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fields/base/encode/sha256.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_manoeuvre_test {
namespace {

using nlohmann::json;

const std::string zig_zag = (source_folder() / "data/scenarios/zig_zag.yaml").string();

/// An Otter in still water for 70 s; the task is in its eighth line.
std::string usv_that_does(const StoreForTests& made, const std::string& task) {
  return made.write("usv.yaml",
                    "name: usv\nseed: 1\nduration_s: 70\nstep_s: 0.05\nlog_every_s: 0.1\n"
                    "water: {made_up: {depth_m: 20}}\nvehicles:\n"
                    "  - {name: usv, tasks: [" +
                        task +
                        "],\n"
                        "     model: otter, start: {north_m: 0, east_m: 0, depth_m: 0}}\n");
}

TEST(ManoeuvreCommand, TellsTheFiguresOfTheBundledZigZag) {
  const StoreForTests made;
  const ProgramResult run = made.run(
      {"simulate", zig_zag, "--out", made.path("run.nc"), "--html", made.path("run.html")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(
      run.out.find("auv: zig-zag (task 1): to starboard by 10 degrees of rudder: overshoots "),
      std::string::npos)
      << run.out;
  EXPECT_NE(read_bytes(made.path("run.html")).find("zig-zag (task 1)"), std::string::npos);
  const ProgramResult as_json = made.run({"simulate", zig_zag, "--json"});
  const json vehicle = json::parse(as_json.out).at("vehicles").at(0);
  const json manoeuvre = vehicle.at("manoeuvres").at(0);
  EXPECT_EQ(manoeuvre.at("kind"), "zig_zag");
  EXPECT_EQ(manoeuvre.at("executed_s"), 60);
  EXPECT_EQ(manoeuvre.at("over"), true);
  EXPECT_EQ(manoeuvre.at("approach").at("steady"), true);
  EXPECT_EQ(manoeuvre.at("helms").size(), 5U);
  EXPECT_EQ(manoeuvre.at("helms").at(1).at("helm_deg"), -10);
  EXPECT_EQ(manoeuvre.at("figures").at("overshoots_deg").size(), 4U);
  EXPECT_GT(manoeuvre.at("figures").at("period_s").get<double>(), 1);
  EXPECT_TRUE(manoeuvre.at("absent").empty());
  EXPECT_EQ(made.run({"replay", made.path("run.nc")}).exit_code, 0);
}

TEST(ManoeuvreCommand, SaysWhyAFigureIsAbsent) {
  const StoreForTests made;
  const std::string scenario =
      usv_that_does(made, "{do: turning_circle, helm_share: 0.3, speed_m_s: 1.2, lasts_s: 60}");
  const ProgramResult run = made.run({"simulate", scenario});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("0.3 of the thrusters' yaw moment"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("no tactical diameter, no half turn, no three quarters turn, no full "
                         "turn: the run ended at "),
            std::string::npos)
      << run.out;
  const json manoeuvre = json::parse(made.run({"simulate", scenario, "--json"}).out)
                             .at("vehicles")
                             .at(0)
                             .at("manoeuvres")
                             .at(0);
  EXPECT_TRUE(manoeuvre.at("figures").at("tactical_diameter_m").is_null());
  EXPECT_EQ(manoeuvre.at("over"), false);
  EXPECT_EQ(manoeuvre.at("absent").back().at("figure"), "steady");
}

TEST(ManoeuvreCommand, GoesOnFromACheckpointInItsMiddleToTheSameBytes) {
  const StoreForTests made;
  // Ten seconds after the first helm.
  const std::string zig_zag = usv_that_does(
      made, "{do: zig_zag, helm_share: 0.3, speed_m_s: 1.2, approach_s: 50, lasts_s: 20}");
  const ProgramResult whole =
      made.run({"simulate", zig_zag, "--out", made.path("run.nc"), "--checkpoint",
                made.path("at.checkpoint"), "--checkpoint-at", "1min"});
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const ProgramResult on = made.run({"simulate", zig_zag, "--out", made.path("again.nc"),
                                     "--restore", made.path("at.checkpoint")});
  ASSERT_EQ(on.exit_code, 0) << on.err;
  EXPECT_EQ(sha256_of_file(made.path("run.nc")), sha256_of_file(made.path("again.nc")));
}

TEST(ManoeuvreCommand, RefusesWhatTheVehicleCannotWithItsLine) {
  const StoreForTests made;
  const std::string scenario = usv_that_does(made, "{do: zig_zag, helm_deg: 20, lasts_s: 60}");
  const ProgramResult run = made.run({"simulate", scenario});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("usv.yaml:8: helm_deg: found an angle, and the Otter USV has no rudder"),
            std::string::npos)
      << run.err;
}

}  // namespace
}  // namespace slackwater::tests::cli_manoeuvre_test
