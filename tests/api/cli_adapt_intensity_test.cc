// `slackwater rehearse --adapt-intensity`: how closely a mission can look and keep its reserve.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/farm_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_adapt_intensity_test {
namespace {

using nlohmann::json;

class AdaptIntensityCommand : public testing::Test {
 protected:
  void SetUp() override {
    made_.write("rings.yaml", "id: rings\nname: Rings about a pile\n" + eye_yaml +
                                  "    launch_s: 10\n    recovery_s: 10\n    conduct:\n"
                                  "      limits: [{current_speed_m_s: 1.2}]\n"
                                  "    work:\n      - {pattern: rings, stand_off_m: 2, from: "
                                  "{depth_m: 4}, to: {depth_m: 14}, spacing_m: 2}\n");
    made_.write("farm.yaml", "id: farm\nlatitude_deg: 48.9\nlongitude_deg: -3.1\n" + pile_yaml +
                                 "turbines: [{id: T1, latitude_deg: 48.9, longitude_deg: -3.1}]\n");
  }
  /// @param charge  with which it begins; it has to come home with 0.2
  std::string write_mission(double charge) {
    return made_.write(
        "mission.yaml",
        "name: \"rings: 1\"\nseed: 3\nsite: farm.yaml\ntasks: [rings.yaml]\nturbines: [T1]\nstart: "
        "2025-03-10T06:00:00Z\nduration: 40min\nstep_s: 0.05\nwater: {made_up: {depth_m: 30, "
        "current: [{depth_m: 0, east_m_s: 0.5, north_m_s: 0}], wind: {speed_m_s: 5, from_deg: "
        "270}}}\nwaves: {from: calm}\nagents: {eye: {state_of_charge: " +
            std::to_string(charge) + "}}\n");
  }
  StoreForTests made_;
};

TEST_F(AdaptIntensityCommand, WritesAMissionThatKeepsTheReserveWhereTheFixedOneDoesNot) {
  const std::string mission = write_mission(0.30);
  const ProgramResult run = made_.run({"rehearse", mission, "--members", "9", "--adapt-intensity",
                                       "--adapted", made_.path("adapted.yaml"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json out = json::parse(run.out);
  EXPECT_EQ(out.at("starts")[0].at("done"), 0) << "the fixed plan";
  const json& intensity = out.at("intensity");
  EXPECT_EQ(intensity.at("needed"), 9);
  const double chosen = intensity.at("chosen").get<double>();
  EXPECT_LT(chosen, 1) << intensity.dump(1);
  const json& fixed = intensity.at("tried")[0];
  EXPECT_EQ(fixed.at("density"), 1.0);
  EXPECT_EQ(fixed.at("called_home"), 9);
  EXPECT_LT(fixed.at("coverage").at("p90").get<double>(), 1);
  // What was written flies as it stands, and does what was said of it.
  const ProgramResult flown =
      made_.run({"rehearse", made_.path("adapted.yaml"), "--members", "9", "--json"});
  ASSERT_EQ(flown.exit_code, 0) << flown.err << read_bytes(made_.path("adapted.yaml"));
  const json start = json::parse(flown.out).at("starts")[0];
  EXPECT_EQ(start.at("done"), 9);
  for (const json& one : intensity.at("tried"))
    if (one.at("density") == chosen) {
      EXPECT_EQ(one.at("duration_s"), start.at("duration_s"));
    }
  EXPECT_TRUE(json::parse(flown.out).at("intensity").is_null()) << "nobody asked";
  // For people.
  const ProgramResult told =
      made_.run({"rehearse", mission, "--members", "9", "--adapt-intensity"});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_NE(told.out.find("the reserve kept in 9 of 9 futures"), std::string::npos) << told.out;
  EXPECT_NE(told.out.find(intensity.at("reason").get<std::string>()), std::string::npos);
}

TEST_F(AdaptIntensityCommand, WritesNothingWhereNoDensityKeepsTheReserve) {
  const ProgramResult run = made_.run({"rehearse", write_mission(0.205), "--members", "9",
                                       "--adapted", made_.path("adapted.yaml"), "--json"});
  EXPECT_EQ(run.exit_code, 12) << run.err;
  EXPECT_NE(run.err.find("not written, no density keeps the reserve: do not fly"),
            std::string::npos)
      << run.err;
  EXPECT_FALSE(std::filesystem::exists(made_.path("adapted.yaml")));
  EXPECT_TRUE(json::parse(run.out).at("intensity").at("chosen").is_null());
}

TEST_F(AdaptIntensityCommand, RefusesTooFewFuturesAndAPlaceWhereTheMissionsFilesAreNot) {
  const std::string mission = write_mission(0.9);
  const ProgramResult few = made_.run({"rehearse", mission, "--members", "8", "--adapt-intensity"});
  EXPECT_EQ(few.exit_code, 2);
  EXPECT_NE(few.err.find("found 8 futures, expected 9 at the least"), std::string::npos) << few.err;
  std::filesystem::create_directory(made_.path("elsewhere"));
  const ProgramResult away = made_.run(
      {"rehearse", mission, "--members", "9", "--adapted", made_.path("elsewhere/adapted.yaml")});
  EXPECT_EQ(away.exit_code, 2);
  EXPECT_NE(away.err.find("expected a file beside"), std::string::npos) << away.err;
}

}  // namespace
}  // namespace slackwater::tests::cli_adapt_intensity_test
