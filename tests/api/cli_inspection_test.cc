// `inspection` in `rehearse`, `simulate`, `replay` and `score`: what comes out, in a checkpoint, on
// pages and as files; and what is flown again.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/show/coverage/view.h"
#include "tests/support/contains.h"
#include "tests/support/farm_for_tests.h"

namespace slackwater::tests::cli_inspection_test {
namespace {

using nlohmann::json;

/// One ring at 10 m of depth about four metres of a pile: it sees a band of them.
const std::string film = R"(id: film
name: Film a pile
)" + eye_yaml + R"(    conduct: {clear_m: 1}
    inspection:
      surfaces: [{kind: monopile, from: {depth_m: 8}, to: {depth_m: 12}}]
      looks:
        - {instrument: rov_camera, kinds: [monopile], detail_mm: 40, incidence_deg: 70,
           seen_at: 0.3}
      water: {visibility_m: 10}
      defects: [{kind: corrosion, count: 8}]
      detection: [rgb_corrosion]
    work:
      - {pattern: rings, stand_off_m: 2, from: {depth_m: 9}, to: {depth_m: 9}, spacing_m: 1}
)";
const std::string mission =
    "name: film\nseed: 3\nsite: farm.yaml\ntasks: [film.yaml]\nturbines: [T1]\nstart: "
    "2025-03-10T06:00:00Z\nduration: 10min\nstep_s: 0.05\nwater: {made_up: {depth_m: 30, current: "
    "[{depth_m: 0, east_m_s: 0.05, north_m_s: 0}]}}\nwaves: {from: calm}\n";

class InspectionCommand : public testing::Test {
 protected:
  void SetUp() override {
    (void)made_.write("film.yaml", film);
    (void)made_.write("farm.yaml", farm_yaml());
    (void)made_.write("mission.yaml", mission);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return made_.path(name); }
  /// Lays the mission out as laid_out.yaml.
  void lay_out() {
    ASSERT_EQ(made_.run({"rehearse", path("mission.yaml"), "--scenario", path("laid_out.yaml")})
                  .exit_code,
              0);
  }
  StoreForTests made_;
};

TEST_F(InspectionCommand, TellsWhatWasCoveredOverTheFuturesAndInOneRun) {
  const ProgramResult run =
      made_.run({"rehearse", path("mission.yaml"), "--members", "3", "--scenario",
                 path("laid_out.yaml"), "--html", path("page.html"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json start = json::parse(run.out).at("starts")[0];
  const json inspection = start.at("vehicles")[0].at("inspection");
  EXPECT_NEAR(inspection.at("surfaces")[0].at("area_m2").get<double>(), 3.14159 * 5 * 4, 0.3);
  const double p50 = inspection.at("share").at("p50");
  EXPECT_GT(p50, 0.3);
  EXPECT_LT(p50, 0.7);
  EXPECT_EQ(start.at("done"), 3) << start.dump(1);
  const std::string page = read_bytes(path("page.html"));
  EXPECT_NE(page.find("m2 covered (P10"), std::string::npos);
  EXPECT_NE(page.find("What is covered, over all futures"), std::string::npos);
  EXPECT_NE(page.find("Covered against current or wind"), std::string::npos);

  const ProgramResult one = made_.run({"simulate", path("laid_out.yaml"), "--out", path("one.nc"),
                                       "--findings", path("found.csv"), "--truth", "--json"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  const json own = json::parse(one.out).at("vehicles")[0].at("inspection");
  // With more rays and smaller patches: within half a patch of 0.2 m at both edges of the one band
  // that is seen of 4 m.
  EXPECT_NEAR(own.at("share").get<double>(), p50, 0.05);
  EXPECT_EQ(own.at("defects").at("planted"), 8);
  // The log has the same, and so have those who read it.
  const auto coverage = api::coverage_in(ingest::read_trajectories(path("one.nc")));
  ASSERT_EQ(coverage.size(), 1U);
  EXPECT_NEAR(coverage[0].covered_m2 / coverage[0].area_m2, own.at("share").get<double>(), 1e-4);
  EXPECT_EQ(coverage[0].findings.size(),
            8U + own.at("defects").at("false_alarms").get<std::size_t>());
  const ProgramResult score = made_.run({"score", path("one.nc"), "--json"});
  ASSERT_EQ(score.exit_code, 0) << score.err;
  const json card = json::parse(score.out).at("runs")[0].at("vehicles")[0];
  EXPECT_NEAR(card.at("coverage").get<double>(), own.at("share").get<double>(), 1e-4);
  EXPECT_EQ(card.at("findings").at("found"), own.at("defects").at("found"));
  EXPECT_EQ(made_.run({"replay", path("one.nc"), "--html", path("one.html")}).exit_code, 0);
  EXPECT_NE(read_bytes(path("one.html")).find("What was seen"), std::string::npos);
}

TEST_F(InspectionCommand, IsPartOfACheckpoint) {
  lay_out();
  expect_in_a_checkpoint(made_, "1min");
}

TEST_F(InspectionCommand, WhatIsLeftIsFlownAgain) {
  lay_out();
  const ProgramResult first = made_.run({"simulate", path("laid_out.yaml"), "--out",
                                         path("first.nc"), "--resurvey", path("again.yaml")});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.out.find("another look from "), std::string::npos) << first.out;
  const ProgramResult again =
      made_.run({"simulate", path("again.yaml"), "--out", path("again.nc")});
  ASSERT_EQ(again.exit_code, 0) << again.err << read_bytes(path("again.yaml"));
  const auto before = api::coverage_in(ingest::read_trajectories(path("first.nc")));
  const auto after = api::coverage_in(ingest::read_trajectories(path("again.nc")));
  // Patches are as large where the way is other: both together, by the place of each.
  double left_m2 = 0, seen_again_m2 = 0;
  for (const api::CoveragePatch& patch : before[0].patches) {
    if (patch.state == api::PatchState::covered) continue;
    left_m2 += patch.area_m2;
    const api::CoveragePatch* same = after[0].nearest_patch(patch.centre_m);
    if (same != nullptr && same->state == api::PatchState::covered) seen_again_m2 += patch.area_m2;
  }
  ASSERT_GT(left_m2, 10);
  EXPECT_GT(seen_again_m2, 0.8 * left_m2);
}

/// The same task where more is asked than its one ring shows.
std::string asking(const std::string& share) {
  std::string yaml = film;
  return yaml.replace(yaml.find("seen_at: 0.3"), 12, share);
}

TEST_F(InspectionCommand, ATaskThatCannotSeeWhatItAsksForIsRefused) {
  for (const char* share : {"seen_at: 0.9", "done_at: 0.9"}) {  // its name of before
    (void)made_.write("film.yaml", asking(share));
    const ProgramResult run = made_.run({"rehearse", path("mission.yaml")});
    EXPECT_EQ(run.exit_code, 3) << run.out;
    for (const char* words :
         {"mission.yaml: eye: flown in dead calm its Camera of a small ROV covers ",
          " % of T1/monopile, expected at least 90 % (seen_at of its look): ", "; lay the path "})
      EXPECT_TRUE(contains(run.err, words)) << run.err;
  }
  (void)made_.write("film.yaml", asking("seen_at: 0.3, done_at: 0.3"));
  EXPECT_TRUE(contains(made_.run({"rehearse", path("mission.yaml")}).err, "keep seen_at"));
}

TEST_F(InspectionCommand, DoneIsNotSeen) {
  // Thinned on purpose it is flown, and tells both.
  (void)made_.write("film.yaml", asking("seen_at: 0.9"));
  (void)made_.write("mission.yaml", mission + "agents: {eye: {intensity: {density: 0.5}}}\n");
  const ProgramResult run = made_.run({"rehearse", path("mission.yaml"), "--members", "2", "--html",
                                       path("page.html"), "--out", path("all.nc"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json start = json::parse(run.out).at("starts")[0];
  EXPECT_EQ(start.at("done"), 2);
  EXPECT_EQ(start.at("p_done").at("probability"), 1.0);
  EXPECT_EQ(start.at("p_done").at("interval_95")[1], 1.0);
  EXPECT_EQ(start.at("seen"), 0);
  EXPECT_EQ(start.at("p_seen").at("probability"), 0.0);
  EXPECT_EQ(start.at("p_seen").at("interval_95")[0], 0.0);
  // A success is both.
  EXPECT_EQ(start.at("succeeded"), 0);
  EXPECT_EQ(start.at("probability"), 0.0);
  EXPECT_TRUE(start.at("stopped_by").empty());
  const std::string why = "less than 90 % covered by the Camera of a small ROV (eye)";
  EXPECT_EQ(start.at("unseen_by")[0].at("cause"), why);
  EXPECT_EQ(start.at("unseen_by")[0].at("flights"), 2);
  EXPECT_TRUE(start.at("members")[0].at("done").get<bool>());
  EXPECT_FALSE(start.at("members")[0].at("seen").get<bool>());
  EXPECT_EQ(start.at("members")[0].at("unseen_by"), why);
  EXPECT_EQ(start.at("vehicles")[0].at("seen"), 0);
  for (const json& risk : start.at("risks"))
    EXPECT_EQ(risk.at("befell"), risk.at("cause") == "unseen" ? 2 : 0) << risk.dump(1);
  const std::string verdict = start.at("verdict");
  EXPECT_TRUE(contains(verdict, "done in 2 of 2 futures but seen in only 0 of 2")) << verdict;
  EXPECT_TRUE(contains(verdict, "not seen: " + why + " (2 of 2)")) << verdict;
  const std::string page = read_bytes(path("page.html"));
  EXPECT_TRUE(contains(page, "No-go."));
  EXPECT_TRUE(contains(page, "P(seen)"));
  EXPECT_TRUE(contains(page, "seen as asked in 0 of 2"));
  const ingest::TrajectoryFile all = ingest::read_trajectories(path("all.nc"));
  const ingest::TrajectoryTable* flights = all.find_table("flight");
  ASSERT_NE(flights, nullptr);
  EXPECT_EQ(*flights->column("done"), (std::vector<double>{1, 1}));
  EXPECT_EQ(*flights->column("seen"), (std::vector<double>{0, 0}));
  const ProgramResult text = made_.run({"rehearse", path("mission.yaml"), "--members", "2"});
  EXPECT_TRUE(contains(text.out, "2/2")) << text.out;
  EXPECT_TRUE(contains(text.out, "0/2")) << text.out;
  EXPECT_TRUE(contains(text.out, "not seen: " + why)) << text.out;
}

TEST_F(InspectionCommand, RefusesWhatCannotBeInspectedBeforeTheFirstStep) {
  const BadTask all[] = {{"stand_off_m: 2", "stand_off_m: 30", "go nearer, or take"},
                         {"{visibility_m: 10}", "{turbidity_ntu: 10}", "turbidity"},
                         {"kind: corrosion", "kind: chain_wear", "it needs one of: mooring_line"},
                         {"[rgb_corrosion]", "[rgb_corosion]", "rgb_corrosion"},
                         {"surfaces: [{kind: monopile, from: {depth_m: 8}, to: {depth_m: 12}}]",
                          "surfaces: []", "at least one surface"}};
  expect_refused(made_, "film.yaml", film, all);
}

}  // namespace
}  // namespace slackwater::tests::cli_inspection_test
