#include "api/show/rehearse/run_page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/log/account_log.h"
#include "api/show/rehearse/account_text.h"
#include "fields/base/error.h"

namespace slackwater::tests::run_page_test {
namespace {

using namespace api;
using nlohmann::json;

constexpr const char* yaml = R"(name: past a pile
seed: 1
duration: 1min
water: {made_up: {depth_m: 40}}
structures:
  - {name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6,
     top_height_m: 20, bottom_depth_m: 40}
  - {name: barge, kind: box, north_m: 60, east_m: 0, north_size_m: 20, east_size_m: 8,
     top_height_m: 2, bottom_depth_m: 10}
vehicles:
  - name: rov
    model: bluerov2_heavy
    start: {north_m: 4, east_m: -10, depth_m: 5}
    tether: {top: {north_m: 0, east_m: -20, depth_m: 0}, length_m: 60}
    tasks: [{do: route, waypoints: [{north_m: 4, east_m: 10, depth_m: 5}]}, {do: hold}]
  - {name: auv, model: lrauv_tethys, start: {north_m: 30, east_m: 0, depth_m: 5},
     tasks: [{do: hold}]}
)";

/// Three rows: the ROV passes 1 m from the pile between the first two, takes its second task, and
/// halts at the third; the AUV stays 30 m north.
ingest::TrajectoryFile log_of(const std::string& scenario = yaml) {
  ingest::TrajectoryFile log;
  log.names = {"rov", "auv"};
  log.epoch = parse_utc("2025-03-10T06:00:00Z");
  log.t_s = {0, 20, 40};
  const auto add = [&](const char* name, std::vector<double> values, const char* long_name = "") {
    log.variables.push_back({name, "", "", long_name, 1, std::move(values)});
  };
  add("x", {-10, 10, 12, 0, 0, 0});
  add("y", {4, 4, 4, 30, 30, 30});
  add("z", {-5, -5, -5, -5, -5, -5});
  add("roll", {0, -0.5, 0.1, 0, 0, 0});
  add("across_track", {0, 0.25, -1.5, 0, 0, 0});
  add("below_track", {0, 2.5, 0, 0, 0, 0});
  add("state_of_charge", {1, 0.9, 0.8, 1, 1, 1});
  add("energy_delivered", {0, 1800, 3600, 0, 0, 0});
  add("bus_voltage", {16, 14.5, 15, 0, 0, 0});
  add("battery_off", {0, 0, 1, 0, 0, 0});
  add("task", {0, 1, 1, 0, 0, 0});
  add("halt", {0, 0, 6, 0, 0, 0}, "0 goes on, 1 diverged, 6 struck");
  log.attributes = {{"title", "past <a> pile"}, {"scenario", scenario}};
  return log;
}

twin::RunAccount account_of(const ingest::TrajectoryFile& log) {
  const auto scenario = scenario_of(log);
  return account_in(log, scenario ? &*scenario : nullptr);
}

std::string of(const twin::RunAccount& account, std::size_t vehicle, const std::string& what) {
  for (const auto& [name, value] : margins_of(account.vehicles.at(vehicle), account.start))
    if (name == what) return value;
  return "";
}

TEST(AccountText, SaysHowItEndedAndTheMarginsWithTheirTimes) {
  const twin::RunAccount account = account_of(log_of());
  ASSERT_EQ(account.vehicles.size(), 2U);
  EXPECT_EQ(verdict_text(account.vehicles[0], account.start),
            "Battery cut off at its least voltage at 06:00:40Z \u2192 struck a structure (pile) at "
            "06:00:40Z; 1 of 2 tasks done.");
  EXPECT_EQ(account.vehicles[0].halt, twin::Halt::struck);
  EXPECT_EQ(of(account, 0, "Battery left"), "80.0 %");
  EXPECT_EQ(of(account, 0, "Energy used"), "1.0 Wh");
  EXPECT_EQ(of(account, 0, "Least voltage"), "14.5 V");
  EXPECT_EQ(of(account, 0, "Farthest off the track"), "1.50 m at 06:00:40 UTC");
  EXPECT_EQ(of(account, 0, "Farthest off the depth"), "2.50 m at 06:00:20 UTC");
  EXPECT_EQ(of(account, 0, "Largest roll"), "29° at 06:00:20 UTC");
  EXPECT_EQ(verdict_text(account.vehicles[1], account.start), "Ran to the end; 0 of 1 task done.");
  EXPECT_EQ(of(account, 1, "Battery left"), "") << "nothing was drawn from it";
}

TEST(AccountText, TheClosestApproachIsThatOfTheWayNotOfTheRows) {
  const twin::RunAccount account = account_of(log_of());
  EXPECT_EQ(of(account, 0, "Closest to a structure"), "1.0 m, pile at 06:00:20 UTC");
  EXPECT_EQ(of(account, 1, "Closest to a structure"), "20.0 m, barge at 06:00:00 UTC")
      << "its side is at 50 m north";
  EXPECT_EQ(of(account, 1, "Closest to another vehicle"), "27.9 m, rov at 06:00:00 UTC");
}

TEST(AccountText, EventsAreTasksCutOffsAndHaltsByTime) {
  const ingest::TrajectoryFile log = log_of();
  const auto events = event_lines(log, account_of(log));
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].what, "task 2 begins");
  EXPECT_EQ(events[0].t_s, 20);
  EXPECT_EQ(events[1].what, "battery cut off");
  EXPECT_EQ(events[2].what, "struck a structure");
}

TEST(AccountLog, AHaltThatThisVersionDoesNotKnowIsRefusedWithItsNumber) {
  ingest::TrajectoryFile log = log_of();
  for (auto& variable : log.variables)
    if (variable.name == "halt") variable.values[2] = 9;
  try {
    (void)account_of(log);
    ADD_FAILURE() << "was read";
  } catch (const Error& e) {
    EXPECT_NE(e.message().find("has 9 as halt, expected 0 to 8"), std::string::npos) << e.message();
  }
}

TEST(AccountLog, TablesThatDoNotFitAreRefused) {
  const auto refused = [](auto&& change) {
    ingest::TrajectoryFile log = log_of();
    ingest::TrajectoryTable mission;
    mission.name = "mission";
    mission.columns = {{"vehicle", "1", "", {1}}, {"time", "s", "", {5}}};
    mission.texts = {{"kind", "", {"phase_began"}}, {"cause", "", {"none"}}, {"text", "", {"w"}}};
    change(mission);
    log.tables.push_back(mission);
    try {
      (void)account_of(log);
    } catch (const Error& e) {
      return e.message();
    }
    return std::string();
  };
  EXPECT_EQ(refused([](auto&) {}), "");
  EXPECT_NE(refused([](auto& t) {
              t.columns[0].values[0] = 2;
            }).find("vehicle 2, expected a number below 2"),
            std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.columns[0].values[0] = -1; }).find("expected a count"),
            std::string::npos);
  EXPECT_NE(
      refused([](auto& t) { t.texts[0].values[0] = "flew_away"; }).find("'flew_away' as kind"),
      std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.texts.pop_back(); }).find("no column text"), std::string::npos);
}

TEST(RunPage, HoldsThePlanTheStructuresTheTetherAndTheEvents) {
  const std::string html = run_page_html(log_of(), "/* library */");
  const std::string open = "id=\"report-data\">";
  const std::size_t from = html.find(open) + open.size();
  const json data = json::parse(html.substr(from, html.find("</script>", from) - from));
  EXPECT_EQ(data["epoch"], 1741586400000);
  EXPECT_EQ(data["plan"][0]["x"], (json{-10, 10}));
  EXPECT_EQ(data["plan"][0]["y"], (json{4, 4}));
  EXPECT_EQ(data["plan"][0]["tether"], (json{-20, 0}));
  EXPECT_TRUE(data["plan"][1]["tether"].is_null());
  ASSERT_EQ(data["structures"].size(), 2U);
  EXPECT_EQ(data["structures"][0]["width"], 6);
  EXPECT_FALSE(data["structures"][1]["round"].get<bool>());
  EXPECT_EQ(data["events"].size(), 3U);
  EXPECT_EQ(html.find("past <a>"), std::string::npos);
  EXPECT_NE(html.find("Closest to a structure"), std::string::npos);
  EXPECT_NE(html.find("2025-03-10T06:00:40Z"), std::string::npos) << "the table of events";
}

TEST(RunPage, ALogWithoutTimesIsAnErrorAndNoCrash) {
  ingest::TrajectoryFile log = log_of();
  log.t_s.clear();
  EXPECT_THROW((void)run_page_html(log, ""), Error);
}

TEST(RunPage, WithoutAScenarioOrThePlotsItStillSaysHowItCameOut) {
  const std::string html = run_page_html(log_of("not: a scenario"), "");
  EXPECT_NE(html.find("struck a structure at 06:00:40Z."), std::string::npos);
  EXPECT_NE(html.find("no scenario that this version reads"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::run_page_test
