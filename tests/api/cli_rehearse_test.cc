// `slackwater rehearse` and `score`: a stranger's task at a stranger's farm, in made-up water and
// in the members of an issued forecast.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ingest/cf/trajectory_file.h"
#include "tests/support/farm_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_rehearse_test {
namespace {

using nlohmann::json;

const std::string peek = "id: peek\nname: A peek at a pile\n" + eye_yaml + R"(    launch_s: 10
    conduct:
      limits:
        - {current_speed_m_s: 0.9, phases: [work], source: nobody, status: estimate}
        - {least_visibility_m: 500, if_missing: not_checked}
)" + eyes_work_yaml;

class RehearseCommand : public testing::Test {
 protected:
  void SetUp() override {
    write("peek.yaml", peek);
    write("farm.yaml", "id: farm\nlatitude_deg: 48.9\nlongitude_deg: -3.1\n" + pile_yaml +
                           "turbines: [{id: T1, latitude_deg: 48.9, longitude_deg: -3.1}]\n"
                           "areas:\n  - {id: terns, kind: exclusion, reason: breeding terns, "
                           "months: [4, 7], polygon: [{latitude_deg: 48.9001, longitude_deg: "
                           "-3.102}, {latitude_deg: 48.902, longitude_deg: -3.102}, {latitude_deg: "
                           "48.902, longitude_deg: -3.098}, {latitude_deg: 48.9001, longitude_deg: "
                           "-3.098}]}\n");
    write("mission.yaml", mission());
  }
  /// A mission in the forecast of a day, which is issued for it.
  void write_issued() {
    made_.ingest_days(parse_day("2025-03-01"), 3);
    write("issued_farm.yaml", farm_at_the_site(made_));
    ASSERT_EQ(
        made_.run({"forecast", "--site", path("issued_farm.yaml"), "--at", "2025-03-04T05:00:00Z"})
            .exit_code,
        0);
    const std::string yaml =
        "name: peek\nseed: 3\nsite: issued_farm.yaml\ntasks: [peek.yaml]\nturbines: "
        "[T1]\nduration: "
        "20min\nstep_s: 0.05\nwaves: {components: 8}\nagents: {eye: {limits: [{current_speed_m_s: "
        "3}]}}\n";
    write("issued.yaml", yaml);
  }
  static std::string mission(const std::string& start = "2025-03-10T06:00:00Z") {
    return "name: peek\nseed: 3\nsite: farm.yaml\ntasks: [peek.yaml]\nturbines: [T1]\nstart: " +
           start +
           "\nduration: 20min\nstep_s: 0.05\nwater: {made_up: {depth_m: 30, current: [{depth_m: 0, "
           "east_m_s: 0.2, north_m_s: 0}], wind: {speed_m_s: 5, from_deg: 270}}}\nwaves: "
           "{components: 8, partitions: [{significant_height_m: 0.4, peak_period_s: 5, from_deg: "
           "270}]}\n";
  }
  std::string write(const std::string& name, const std::string& text) const {
    return made_.write(name, text);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return made_.path(name); }
  StoreForTests made_;
};

TEST_F(RehearseCommand, FliesAStrangersTaskInSeveralFuturesAndSaysHowItWent) {
  const ProgramResult run =
      made_.run({"rehearse", path("mission.yaml"), "--members", "3", "--out", path("all.nc"),
                 "--html", path("page.html"), "--scenario", path("laid_out.yaml"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json out = json::parse(run.out);
  ASSERT_EQ(out.at("starts").size(), 1U);
  const json& start = out.at("starts")[0];
  EXPECT_EQ(start.at("done"), 3) << start.dump(1);
  EXPECT_EQ(start.at("flights"), 3);
  EXPECT_LT(start.at("interval_95")[0].get<double>(), 0.5);
  EXPECT_EQ(start.at("interval_95")[1], 1.0);
  EXPECT_TRUE(start.at("by_the_limits").at("allows").get<bool>());
  EXPECT_TRUE(start.at("disagreement").is_null());
  ASSERT_EQ(out.at("not_checked").size(), 1U);
  EXPECT_NE(out.at("not_checked")[0].get<std::string>().find("visibility"), std::string::npos);
  const ingest::TrajectoryFile all = ingest::read_trajectories(path("all.nc"));
  EXPECT_EQ(all.names.size(), 3U);
  EXPECT_NE(read_bytes(path("page.html")).find("done in 3 of 3 futures"), std::string::npos);
  // What it was laid out as runs by itself.
  EXPECT_EQ(made_.run({"simulate", path("laid_out.yaml")}).exit_code, 0);
}

TEST_F(RehearseCommand, SaysHowNearEachCameOverTheFlightsAndTheLogOfOneSaysTheSameOfIt) {
  const ProgramResult run =
      made_.run({"rehearse", path("mission.yaml"), "--members", "1", "--log", path("one.nc"),
                 "--log-member", "0", "--assume", "visibility_m=2000", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json eye = json::parse(run.out).at("starts")[0].at("vehicles")[0];
  const json& pile = eye.at("closest_m").at("structure");
  const json score =
      json::parse(made_.run({"score", path("one.nc"), "--json"}).out).at("runs")[0].at("vehicles");
  // The task keeps 3 m from the pile.
  EXPECT_NEAR(pile.at("p50").get<double>(), 3, 1);
  EXPECT_NEAR(pile.at("p50").get<double>(), score[0].at("closest_structure_m").get<double>(), 1e-4);
  EXPECT_EQ(pile.at("p10"), pile.at("p90")) << "of one flight";
  EXPECT_TRUE(eye.at("closest_m").at("vehicle").is_null()) << "it is alone";
  EXPECT_TRUE(eye.at("flights_with_clearance_alarms").is_null()) << "it does not keep clear";
  // Nearer than it promises, in every flight.
  write("clear.yaml", mission() + "clearance: {structure_m: 20}\n");
  const ProgramResult clear = made_.run({"rehearse", path("clear.yaml"), "--members", "2",
                                         "--assume", "visibility_m=2000", "--json"});
  ASSERT_EQ(clear.exit_code, 0) << clear.err;
  EXPECT_EQ(
      json::parse(clear.out).at("starts")[0].at("vehicles")[0].at("flights_with_clearance_alarms"),
      2);
}

TEST_F(RehearseCommand, SaysWhatWouldChangeTheAnswerAndHowBadItIs) {
  // What is left of its battery is a little too little.
  write("mission.yaml", mission() + "agents: {eye: {state_of_charge: 0.23}}\n");
  write(
      "peek.yaml",
      peek +
          "risks: [{cause: energy, people: 1, environment: 1, asset: 4, schedule: 2, cost: 2}]\n");
  const ProgramResult run = made_.run({"rehearse", path("mission.yaml"), "--members", "2",
                                       "--advice", "--json", "--html", path("page.html")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json out = json::parse(run.out);
  const json& risk = out.at("starts")[0].at("risks")[0];
  EXPECT_EQ(risk.at("cause"), "energy");
  EXPECT_EQ(risk.at("befell"), 2);
  EXPECT_EQ(risk.at("level_at_worst"), "high");
  EXPECT_EQ(risk.at("consequence").at("asset"), 4);
  const json& advice = out.at("advice");
  ASSERT_GE(advice.size(), 4U);
  EXPECT_EQ(advice[0].at("what"), "with another battery beside each");
  EXPECT_EQ(advice[0].at("done_as_is"), 0);
  EXPECT_EQ(advice[0].at("gained"), 2);
  // An hour later there is no water.
  EXPECT_TRUE(advice.back().contains("impossible")) << advice.dump(1);
  const std::string page = read_bytes(path("page.html"));
  EXPECT_NE(page.find("What would change the answer"), std::string::npos);
  EXPECT_NE(page.find("asset 4 of 5"), std::string::npos);
}

TEST_F(RehearseCommand, TheLogOfAFlightReplaysAndIsScored) {
  const ProgramResult run =
      made_.run({"rehearse", path("mission.yaml"), "--members", "2", "--log", path("one.nc"),
                 "--log-member", "1", "--assume", "visibility_m=2000", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(json::parse(run.out).at("not_checked").size(), 0U);
  EXPECT_EQ(json::parse(run.out).at("assumed")[0], "visibility 2000 m");
  EXPECT_EQ(made_.run({"replay", path("one.nc")}).exit_code, 0);
  const ProgramResult scored = made_.run({"score", path("one.nc"), path("one.nc"), "--json"});
  ASSERT_EQ(scored.exit_code, 0) << scored.err;
  const json cards = json::parse(scored.out);
  const json& eye = cards.at("runs")[0].at("vehicles")[0];
  EXPECT_TRUE(eye.at("done").get<bool>());
  EXPECT_EQ(eye.at("interventions"), 0);
  EXPECT_GT(eye.at("closest_structure_m").get<double>(), 1.5);
  EXPECT_GT(eye.at("energy_per_metre_j").get<double>(), 10);
  EXPECT_EQ(cards.at("vehicles")[0].at("runs"), 2);
  EXPECT_EQ(cards.at("vehicles")[0].at("time_s").at("deviation"), 0.0);
  // The flight of the rehearsal and its log end at the same time.
  const json flight = json::parse(run.out).at("starts")[0].at("members")[1];
  EXPECT_NEAR(flight.at("ended_s").get<double>(), eye.at("time_s").get<double>(), 1e-6);
}

TEST_F(RehearseCommand, FliesInTheMembersOfAnIssuedForecastAndLeavesTheStoreAsItWas) {
  write_issued();
  const auto before = made_.digests();
  const ProgramResult run =
      made_.run({"rehearse", path("issued.yaml"), "--members", "2", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(made_.digests(), before);
  const json out = json::parse(run.out);
  EXPECT_EQ(out.at("forecast_sha256").get<std::string>().size(), 64U);
  ASSERT_EQ(out.at("starts").size(), 1U);
  EXPECT_EQ(out.at("starts")[0].at("flights"), 2);
  const ProgramResult again =
      made_.run({"rehearse", path("issued.yaml"), "--members", "2", "--threads", "1", "--json"});
  json first = out, second = json::parse(again.out);
  for (json* one : {&first, &second}) {
    one->erase("wall_s");
    one->erase("first_answer_s");
  }
  EXPECT_EQ(first, second) << "whatever the number of threads";
}

TEST_F(RehearseCommand, DrawsFurtherMembersThanWereIssuedAndTheLogOfOneReplays) {
  write_issued();
  const auto before = made_.digests();
  const ProgramResult issued =
      made_.run({"rehearse", path("issued.yaml"), "--members", "2", "--json"});
  const ProgramResult run = made_.run({"rehearse", path("issued.yaml"), "--members", "26", "--log",
                                       path("25.nc"), "--log-member", "25", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json out = json::parse(run.out);
  EXPECT_EQ(out.at("members"), 26);
  EXPECT_EQ(out.at("members_issued"), 25);
  const json flights = out.at("starts")[0].at("members");
  const json first = json::parse(issued.out).at("starts")[0].at("members");
  ASSERT_EQ(flights.size(), 26U);
  EXPECT_EQ(flights[0], first[0]) << "those issued are what they were";
  EXPECT_EQ(flights[1], first[1]);
  EXPECT_NE(flights[25].at("ended_s"), flights[24].at("ended_s"));
  const ProgramResult replayed = made_.run({"replay", path("25.nc")});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_EQ(made_.digests(), before);
}

/// The share of a limit that the waves take up, over the flights: the limit is on nothing else.
TEST_F(RehearseCommand, WavesErrInTheMembersUnlessTheyAreTakenAsForecastAndBothReplay) {
  write_issued();
  std::string yaml = read_bytes(path("issued.yaml"));
  const std::string limit = "current_speed_m_s: 3";
  yaml.replace(yaml.find(limit), limit.size(), "significant_wave_height_m: 20");
  write("issued.yaml", yaml);
  for (const std::string& waves : {std::string("error"), std::string("forecast")}) {
    const bool errs = waves == "error";
    const std::string log = path(waves + ".nc"), scenario = path(waves + ".yaml");
    std::vector<std::string> words{
        "rehearse", path("issued.yaml"), "--members", "5",     "--log", log, "--log-member",
        "3",        "--scenario",        scenario,    "--json"};
    // Errors are the default.
    if (!errs) words.insert(words.end(), {"--waves", waves});
    const ProgramResult run = made_.run(words);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const json share = json::parse(run.out).at("starts")[0].at("vehicles")[0].at("most_of_a_limit");
    EXPECT_GT(share.at("p50").get<double>(), 0) << "there are waves";
    EXPECT_EQ(share.at("p10") != share.at("p90"), errs) << share;
    const std::string told = errs ? "height_errors: true" : "height_errors: false";
    EXPECT_NE(read_bytes(scenario).find(told), std::string::npos);
    EXPECT_NE(ingest::read_trajectories(log).attribute("scenario").find(told), std::string::npos);
    const ProgramResult replayed = made_.run({"replay", log});
    EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  }
}

TEST_F(RehearseCommand, RefusesALogOfAFlightThatIsNotFlownBeforeItFlies) {
  const ProgramResult member = made_.run({"rehearse", path("mission.yaml"), "--members", "2",
                                          "--log", path("one.nc"), "--log-member", "2"});
  EXPECT_EQ(member.exit_code, 2);
  EXPECT_NE(member.err.find("expected 0 to 1"), std::string::npos) << member.err;
  const ProgramResult start = made_.run({"rehearse", path("mission.yaml"), "--log", path("one.nc"),
                                         "--log-start", "2025-03-10T07:00:00Z"});
  EXPECT_EQ(start.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(path("one.nc")));
}

TEST_F(RehearseCommand, KeepsOutOfZonesWhileTheyAreInForce) {
  const ProgramResult march = made_.run({"rehearse", path("mission.yaml")});
  EXPECT_EQ(march.exit_code, 0) << march.err;
  const ProgramResult may = made_.run(
      {"rehearse", write("may.yaml", mission("2025-05-10T06:00:00Z")), "--html", path("may.html")});
  EXPECT_EQ(may.exit_code, 3);
  EXPECT_NE(may.err.find("eye: starts in zone terns (breeding terns)"), std::string::npos)
      << may.err;
  EXPECT_FALSE(std::filesystem::exists(path("may.html")));
}

TEST_F(RehearseCommand, BelowAboveAndAroundOneTurbineAtOnceInOneRun) {
  const std::string three = (source_folder() / "data/missions/three_at_one_pile.yaml").string();
  const ProgramResult run = made_.run({"rehearse", three, "--log", path("three.nc"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json out = json::parse(run.out);
  EXPECT_EQ(out.at("starts")[0].at("done"), 1) << out.at("starts")[0].dump(1);
  const ingest::TrajectoryFile log = ingest::read_trajectories(path("three.nc"));
  EXPECT_EQ(log.names, (std::vector<std::string>{"inspector", "climber", "watch"}));
  EXPECT_NE(log.attribute("track_deviation").find("watch followed 200000001"), std::string::npos);
  const json scores = json::parse(made_.run({"score", path("three.nc"), "--json"}).out)
                          .at("runs")[0]
                          .at("vehicles");
  ASSERT_EQ(scores.size(), 3U);
  for (const json& score : scores) {
    EXPECT_GT(score.at("closest_structure_m").get<double>(), 0.5) << score.dump(1);
    EXPECT_GT(score.at("closest_vehicle_m").get<double>(), 3) << score.dump(1);
  }
  EXPECT_GT(scores[2].at("closest_structure_m").get<double>(), 50);
}

struct Bad {
  const char* what;
  const char* instead;
  int exit_code;
  const char* says;
};

TEST_F(RehearseCommand, RefusesWhatCannotBeFlownBeforeTheFirstStep) {
  const Bad missions[] = {
      {"tasks: [peek.yaml]", "tasks: [peak]", 4, "scour_survey"},
      {"tasks: [peek.yaml]", "taks: [peek.yaml]", 3, "tasks"},
      {"turbines: [T1]", "turbines: [T9]", 3, "the site has T1"},
      {"site: farm.yaml", "site: nowhere", 4, "nowhere"},
      {"seed: 3", "seed: 3\nagents: {eye: {model: lrauv_tethys}}", 3, "expected rov"},
      {"seed: 3", "seed: 3\nagents: {eye: {limits: [{visibility_m: 4}]}}", 3, "--assume"},
      {"seed: 3", "seed: 3\nagents: {eye: {behaviour: {do: dance}}}", 3, "dance"},
      {"seed: 3",
       "seed: 3\nagents: {eye: {trees: {a: {tree: b}, b: {tree: a}}, behaviour: {tree: a}}}", 3,
       "back to itself"},
      {"seed: 3",
       "seed: 3\nvehicles: [{name: dog, model: bluerov2_heavy, start: {north_m: 40, east_m: 0, "
       "depth_m: 5}, tether: {top: {north_m: 40, east_m: 0, depth_m: 0}, length_m: 30}, conduct: "
       "{}, "
       "carrier: {name: eye, forward_m: 0}}]",
       3, "from whose deck the line hangs"},
      {"seed: 3", "seed: 3\nassume: {current_speed_m_s: 1}", 3, "cannot be assumed"},
  };
  for (const Bad& bad : missions) {
    std::string yaml = mission();
    yaml.replace(yaml.find(bad.what), std::string(bad.what).size(), bad.instead);
    const ProgramResult run =
        made_.run({"rehearse", write("bad.yaml", yaml), "--out", path("bad.nc")});
    EXPECT_EQ(run.exit_code, bad.exit_code) << bad.instead << "\n" << run.err;
    EXPECT_NE(run.err.find(bad.says), std::string::npos) << bad.instead << "\n-> " << run.err;
    EXPECT_FALSE(std::filesystem::exists(path("bad.nc"))) << bad.instead;
  }
  const Bad tasks[] = {
      {"needs: [camera]", "needs: [gnss]", 3, "has no gnss"},
      {"    work:\n", "    play:\n", 3, "work"},
      {"pattern: verticals", "pattern: spirals", 3, "spirals"},
      {"to: {depth_m: 9}", "to: {below_hub_m: 9}", 3, "above the sea"},
      {"bearings: 2", "bearings: 60, stops: 100, stop_s: 600", 3, "shorten the work"},
      {"distance_m: 12, depth_m: 3", "distance_m: 12", 3, "depth_m"},
      {"distance_m: 12, depth_m: 3}",
       "distance_m: 12, depth_m: 3}\n    tether: {top: {distance_m: 13, depth_m: 0}, length_m: 12}",
       3, "start it nearer"},
      {"agents:", "agents: []\nagentz:", 3, "agent"},
  };
  for (const Bad& bad : tasks) {
    std::string yaml = peek;
    yaml.replace(yaml.find(bad.what), std::string(bad.what).size(), bad.instead);
    write("peek.yaml", yaml);
    const ProgramResult run =
        made_.run({"rehearse", path("mission.yaml"), "--out", path("bad.nc")});
    EXPECT_EQ(run.exit_code, bad.exit_code) << bad.instead << "\n" << run.err;
    EXPECT_NE(run.err.find(bad.says), std::string::npos) << bad.instead << "\n-> " << run.err;
    EXPECT_FALSE(std::filesystem::exists(path("bad.nc"))) << bad.instead;
  }
}

}  // namespace
}  // namespace slackwater::tests::cli_rehearse_test
