// `cleaning` in `rehearse` and `simulate`: what comes out, in a checkpoint, and what is refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ingest/cf/trajectory_file.h"
#include "tests/support/farm_for_tests.h"

namespace slackwater::tests::cli_cleaning_test {
namespace {

using nlohmann::json;

/// Two rings at 0.28 m/s, half a metre of pile between them.
const std::string scrub = R"(id: scrub
name: Scrub a pile
agents:
  - role: cleaner
    kinds: [rov]
    needs: [camera]
    model: bluerov2_heavy
    start: {distance_m: 6, depth_m: 5}
    conduct:
      cleaning:
        from: {depth_m: 4.9}
        to: {depth_m: 5.4}
        band_m: 0.25
        done_at: 0.9
        growth: {source: test, status: estimate, density_kg_m3: 1000,
                 by_depth: [{thickness_mm: 40}]}
        tool: {swath_m: 0.4, reach_m: 1.2, rate_m2_h: 500, source: test, status: estimate}
    work:
      - {pattern: bands, stand_off_m: 0.8, from: {depth_m: 5}, to: {depth_m: 5.3}, swath_m: 0.4,
         overlap_m: 0.1, rate_m2_h: 400}
)";

const std::string mission =
    "name: scrub\nseed: 3\nsite: farm.yaml\ntasks: [scrub.yaml]\nturbines: [T1]\nstart: "
    "2025-03-10T06:00:00Z\nduration: 8min\nstep_s: 0.05\nwater: {made_up: {depth_m: 30, current: "
    "[{depth_m: 0, east_m_s: 0.05, north_m_s: 0}]}}\nwaves: {from: calm}\n";

class CleaningCommand : public testing::Test {
 protected:
  void SetUp() override {
    (void)made_.write("scrub.yaml", scrub);
    (void)made_.write("farm.yaml", farm_yaml());
    (void)made_.write("mission.yaml", mission);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return made_.path(name); }
  StoreForTests made_;
};

TEST_F(CleaningCommand, RehearseTellsWhatIsCleanOverTheFuturesAndSimulateOfOne) {
  const ProgramResult run =
      made_.run({"rehearse", path("mission.yaml"), "--members", "3", "--scenario",
                 path("laid_out.yaml"), "--html", path("page.html"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json start = json::parse(run.out).at("starts")[0];
  EXPECT_EQ(start.at("done"), 3) << start.dump(1);
  const json cleaning = start.at("vehicles")[0].at("cleaning");
  const double area_m2 = 3.141592653589793 * 5 * 0.5;
  // Printed with five digits.
  EXPECT_NEAR(cleaning.at("area_m2").get<double>(), area_m2, 1e-5 * area_m2);
  EXPECT_EQ(cleaning.at("done_at"), 0.9);
  EXPECT_EQ(cleaning.at("passes_needed"), 1);
  EXPECT_GE(cleaning.at("share").at("p10").get<double>(), 0.9);
  EXPECT_LE(cleaning.at("share").at("p50"), cleaning.at("share").at("p90"));
  ASSERT_EQ(cleaning.at("by_depth").size(), 2U);
  EXPECT_NEAR(cleaning.at("by_depth")[1].at("from_depth_m").get<double>(), 5.15, 1e-9);
  EXPECT_GE(start.at("members")[2].at("cleaned_share").at("cleaner").get<double>(), 0.9);
  EXPECT_NE(read_bytes(path("page.html")).find("m2 clean (P10"), std::string::npos);

  const ProgramResult one =
      made_.run({"simulate", path("laid_out.yaml"), "--out", path("one.nc"), "--json"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  const json own = json::parse(one.out).at("vehicles")[0].at("cleaning");
  EXPECT_TRUE(own.at("done").get<bool>());
  const double removed_m3 = own.at("growth_removed_m3"), left_m3 = own.at("growth_left_m3");
  EXPECT_NEAR(removed_m3 + left_m3, 0.04 * area_m2, 2e-4 * 0.04 * area_m2);
  EXPECT_NEAR(own.at("growth_removed_kg").get<double>(), 1000 * removed_m3, 0.2 * removed_m3);
  // The log has the same, and the page of the log.
  const ingest::TrajectoryFile log = ingest::read_trajectories(path("one.nc"));
  const ingest::TrajectoryTable* table = log.find_table("cleaning");
  ASSERT_NE(table, nullptr);
  ASSERT_EQ(table->rows(), 2U);
  const auto* cleaned = table->column("cleaned_area");
  ASSERT_NE(cleaned, nullptr);
  EXPECT_NEAR((*cleaned)[0] + (*cleaned)[1], own.at("cleaned_m2").get<double>(), 1e-5 * area_m2);
  EXPECT_EQ(made_.run({"replay", path("one.nc"), "--html", path("one.html")}).exit_code, 0);
  EXPECT_NE(read_bytes(path("one.html")).find("Cleaned"), std::string::npos);
  const ProgramResult said = made_.run({"simulate", path("laid_out.yaml")});
  EXPECT_NE(said.out.find("m2 clean ("), std::string::npos) << said.out;
}

TEST_F(CleaningCommand, IsPartOfACheckpoint) {
  ASSERT_EQ(
      made_.run({"rehearse", path("mission.yaml"), "--scenario", path("laid_out.yaml")}).exit_code,
      0);
  expect_in_a_checkpoint(made_, "2min");
}

TEST_F(CleaningCommand, AFlightThatLeavesTooMuchIsNotDone) {
  // The rings lie too far apart.
  std::string yaml = scrub;
  yaml.replace(yaml.find("to: {depth_m: 5.3}, swath"), 25, "to: {depth_m: 5}, swath");
  (void)made_.write("scrub.yaml", yaml);
  const ProgramResult run = made_.run({"rehearse", path("mission.yaml"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json start = json::parse(run.out).at("starts")[0];
  EXPECT_EQ(start.at("done"), 0);
  EXPECT_EQ(start.at("stopped_by")[0].at("cause"),
            "less than 90 % of the surface is clean (cleaner)");
}

TEST_F(CleaningCommand, RefusesWhatCannotBeCleanedBeforeTheFirstStep) {
  const BadTask all[] = {{"tool: {swath_m: 0.4", "tool: {swath_m: 0", "expected a value from 0.05"},
                         {"to: {depth_m: 5.4}", "to: {depth_m: 31}", "the foundation from"},
                         {"thickness_mm: 40", "thickness: 40", "has no unit; say thickness_mm"},
                         {"reach_m: 1.2", "reach_m: 0.3", "the tool reaches 0.3 m"}};
  expect_refused(made_, "scrub.yaml", scrub, all);
}

}  // namespace
}  // namespace slackwater::tests::cli_cleaning_test
