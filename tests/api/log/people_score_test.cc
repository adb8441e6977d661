// How people did, by logs of live sessions that are written here by hand.
#include "api/log/people_score.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/log/action_tables.h"
#include "api/log/command_tables.h"
#include "api/log/people_over_runs.h"
#include "api/log/person_source.h"
#include "api/show/people/people_score_json.h"
#include "api/show/people/people_score_text.h"
#include "tests/support/contains.h"

namespace slackwater::tests::people_score_test {
namespace {

using namespace api;
using store::SessionAction;

constexpr double step_s = 0.1;
const UtcTime begun = parse_utc("2026-05-01T06:00:00Z");

/// A seat that does things at one pace: a second of the wall is one of the run.
struct Hand {
  unsigned seat = 1;
  std::string name = "Ann";
  std::string role = "operator";

  [[nodiscard]] SessionAction does(double at_s, const std::string& what,
                                   const std::string& before = "", const std::string& after = "",
                                   const std::string& vehicle = "rov") const {
    SessionAction row;
    row.at = begun + std::chrono::milliseconds(static_cast<std::int64_t>(1000 * at_s));
    row.time_s = at_s;
    row.step = static_cast<std::uint64_t>(at_s / step_s);
    row.seat = seat;
    row.who = name;
    row.role = role;
    row.what = what;
    row.vehicle = vehicle;
    row.before = before;
    row.after = after;
    return row;
  }
  /// A word about its seat.
  [[nodiscard]] SessionAction is(double at_s, const std::string& what) const {
    return does(at_s, what, "", "", "");
  }
  [[nodiscard]] SessionAction refused(double at_s, const std::string& what,
                                      const std::string& reason, std::uint64_t count = 1) const {
    SessionAction row = does(at_s, what);
    row.is_taken = false;
    row.reason = reason;
    row.count = count;
    return row;
  }
  [[nodiscard]] SessionAction ends(double at_s, std::uint64_t count) const {
    SessionAction row = does(at_s, "stick_end");
    row.count = count;
    return row;
  }
  /// What the run took of it.
  [[nodiscard]] twin::Command commands(double at_s, twin::CommandWhat what) const {
    twin::Command command;
    command.step = static_cast<std::uint64_t>(at_s / step_s + 0.5) + 2;
    command.what = std::move(what);
    command.source = source_of_person(seat, name);
    command.received_s = at_s;
    return command;
  }
};

const Hand ann{}, bob{2, "Bob"}, sue{3, "Sue", "supervisor"};

const std::string plan =
    "name: test\nseed: 7\nduration: 1min\nstep_s: 0.1\nlog_every_s: 10\n"
    "water: {made_up: {depth_m: 60}}\n"
    "structures:\n  - {name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6, "
    "top_height_m: "
    "20, bottom_depth_m: 60}\n"
    "vehicles:\n  - {name: rov, model: bluerov2_heavy, start: {north_m: 20, east_m: 0, depth_m: "
    "10}, tasks: [{do: hold}], conduct: {autonomy: shared, envelope: {stand_off_m: 4, fence_m: "
    "13}, reserve: {share: 0.2}}}\n";

/// A minute of two vehicles at 10 s: `rov` off a pile of 3 m radius, and `aux` that no plan knows.
struct Log {
  explicit Log(std::vector<SessionAction> actions, std::vector<twin::Command> commands = {}) {
    file.names = {"rov", "aux"};
    file.epoch = begun;
    file.t_s = {0, 10, 20, 30, 40, 50, 60};
    // Off the pile, m: 25, 4.5, 3, 4.2, 3.5, 5.5, 17; from home: 8, 12.5, 14, 12.8, 13.5, 11.5, 0.
    const std::vector<double> north{28, 7.5, 6, 7.2, 6.5, 8.5, 20};
    const std::vector<double> charge{1, 1, 1, 1, 0.1, 0.1, 0.1};
    const auto add = [&](const char* name, std::vector<double> of) {
      of.resize(2 * file.t_s.size());
      file.variables.push_back({name, "", "", "", 1, std::move(of)});
    };
    add("x", std::vector<double>(7, 0));
    add("y", north);
    add("z", std::vector<double>(7, -10));
    add("state_of_charge", charge);
    for (std::size_t i = 0; i < actions.size(); ++i) actions[i].number = i + 1;
    for (auto& table : action_tables(actions)) file.tables.push_back(std::move(table));
    for (auto& table : command_tables(commands, {}, step_s)) file.tables.push_back(table);
    account.ran_s = 60;
    account.vehicles.resize(2);
    account.vehicles[0].name = "rov";
    account.vehicles[0].makeup.has_battery = true;
    account.vehicles[1].name = "aux";
  }
  [[nodiscard]] PeopleScore scored() const { return people_score_of(file, account, &scenario); }

  ingest::TrajectoryFile file;
  twin::RunAccount account;
  twin::Scenario scenario = twin::parse_scenario(plan, "plan.yaml");
};

const HelmScore& helm_of(const PeopleScore& score, unsigned seat,
                         const std::string& vehicle = "rov") {
  for (const PersonScore& person : score.people)
    for (const HelmScore& helm : person.helms)
      if (person.seat == seat && helm.vehicle == vehicle) return helm;
  throw std::runtime_error("no such helm");
}

/// Ann has the helm from 5 s to 25 s, Bob then to 45 s, Sue from there on.
Log in_turn() {
  return Log(
      {ann.is(0, "join"), bob.is(1, "join"), sue.is(2, "join"), ann.does(5, "ask", "free", "held"),
       ann.does(6.5, "stick", "held", "velocity"), ann.ends(9, 10),
       ann.refused(10, "stick", "stale"), ann.refused(11, "stick_end", "stale", 4),
       ann.refused(12, "home", "not_finite"), bob.does(20, "ask", "held", "requested"),
       bob.does(21, "ask", "requested", "requested"), ann.does(25, "grant", "requested", "held"),
       bob.does(28, "waypoints", "held", "1 waypoints"),
       sue.does(45, "take_back", "held", "held by the supervisor: near")},
      {ann.commands(6.5, twin::SetVelocity{}), ann.commands(6.6, twin::SetVelocity{}),
       bob.commands(28, twin::Reroute{}), bob.commands(30, twin::HoldHere{true}),
       sue.commands(45, twin::HoldHere{})});
}

TEST(PeopleScore, TellsHowEachHadTheHelmAndWhatForOfTwoInTurn) {
  const PeopleScore score = in_turn().scored();
  ASSERT_EQ(score.people.size(), 3U);
  EXPECT_EQ(score.people[2].role, "supervisor");
  const HelmScore &anns = helm_of(score, 1), &bobs = helm_of(score, 2), &sues = helm_of(score, 3);
  EXPECT_EQ(anns.asked_to_had_s, std::vector<double>{0}) << "it was free";
  EXPECT_EQ(bobs.asked_to_had_s, std::vector<double>{5}) << "from the first time that it asked";
  EXPECT_TRUE(sues.asked_to_had_s.empty());
  EXPECT_EQ(sues.taken_over, 1U);
  EXPECT_EQ(anns.had_to_command_s, std::vector<double>{1.5});
  EXPECT_EQ(bobs.had_to_command_s, std::vector<double>{3});
  EXPECT_TRUE(sues.had_to_command_s.empty()) << "it came with a command";
  EXPECT_EQ(sues.turns_without_command, 0U);
  EXPECT_DOUBLE_EQ(anns.at_helm_s, 20);
  EXPECT_DOUBLE_EQ(bobs.at_helm_s, 20);
  EXPECT_DOUBLE_EQ(sues.at_helm_s, 15) << "to the end of the run";
  ASSERT_TRUE(sues.hold_in_force_s);
  ASSERT_EQ(sues.hold_in_force_s->size(), 1U);
  EXPECT_NEAR(sues.hold_in_force_s->front(), 2 * step_s, 1e-9);
}

TEST(PeopleScore, CountsCommandsAndRefusalsByReason) {
  const PeopleScore score = in_turn().scored();
  const HelmScore& anns = helm_of(score, 1);
  EXPECT_EQ(anns.commands, 10U) << "the sticks by their end, not one more";
  EXPECT_EQ(anns.refused, 5U);
  EXPECT_EQ(anns.refused_for,
            (std::map<std::string, std::uint64_t>{{"not_finite", 1}, {"stale", 4}}));
  EXPECT_DOUBLE_EQ(*commands_per_minute(anns), 30);
  EXPECT_DOUBLE_EQ(*refused_share(anns), 1.0 / 3);
  EXPECT_EQ(helm_of(score, 3).commands, 1U);
}

TEST(PeopleScore, CountsWhoTookAVehicleOffItsMissionOrOffAnothersHelm) {
  Log log = in_turn();
  twin::Command away = ann.commands(1, twin::SetVelocity{});
  away.agent = 1;
  away.source = "dds 01.0f";
  twin::Command back = away;
  back.what = twin::Resume{};
  std::erase_if(log.file.tables, [](const auto& table) { return table.name != "action"; });
  for (auto& table : command_tables(
           std::vector<twin::Command>{
               away, away, back, away, ann.commands(6.5, twin::SetVelocity{}),
               bob.commands(28, twin::Reroute{}), sue.commands(45, twin::HoldHere{})},
           {}, step_s))
    log.file.tables.push_back(table);
  const PeopleScore score = log.scored();
  EXPECT_EQ(score.by_role.at("agent").off_mission, 2U) << "once more after it was given back";
  EXPECT_EQ(score.by_role.at("operator").off_mission, 1U);
  EXPECT_EQ(helm_of(score, 1).off_mission, 1U);
  EXPECT_EQ(helm_of(score, 2).off_mission, 0U) << "it was off it already";
  EXPECT_EQ(score.by_role.at("operator").off_helm, 0U) << "it was granted";
  EXPECT_EQ(score.by_role.at("supervisor").off_helm, 1U);
  EXPECT_EQ(score.by_role.at("supervisor").off_mission, 0U);
}

TEST(PeopleScore, CountsLimitsUnderTheHandThatWasAtTheHelm) {
  const PeopleScore score = in_turn().scored();
  ASSERT_TRUE(helm_of(score, 1).at_limits);
  const AtLimits anns = *helm_of(score, 1).at_limits, bobs = *helm_of(score, 2).at_limits,
                 sues = *helm_of(score, 3).at_limits;
  EXPECT_DOUBLE_EQ(*anns.stand_off_m, 4);
  EXPECT_NEAR(*anns.nearest_structure_m, 3, 1e-12);
  EXPECT_EQ(anns.stand_off_breaches, 1U);
  EXPECT_DOUBLE_EQ(anns.inside_stand_off_s, 5) << "from 20 s until it granted the helm";
  EXPECT_DOUBLE_EQ(anns.near_stand_off_s, 10);
  EXPECT_EQ(anns.fence_breaches, 1U);
  EXPECT_DOUBLE_EQ(anns.outside_fence_s, 5);
  EXPECT_DOUBLE_EQ(anns.near_fence_s, 10);
  EXPECT_DOUBLE_EQ(anns.below_reserve_s, 0);
  EXPECT_EQ(bobs.stand_off_breaches, 1U) << "what it took over is no breach of its own";
  EXPECT_DOUBLE_EQ(bobs.inside_stand_off_s, 5 + 5);
  EXPECT_DOUBLE_EQ(bobs.near_stand_off_s, 10);
  EXPECT_DOUBLE_EQ(bobs.below_reserve_s, 5);
  EXPECT_EQ(sues.stand_off_breaches, 0U);
  EXPECT_DOUBLE_EQ(sues.inside_stand_off_s, 5);
  EXPECT_DOUBLE_EQ(sues.near_stand_off_s, 0) << "5.5 m is more than a quarter beyond 4 m";
  EXPECT_DOUBLE_EQ(sues.near_fence_s, 10) << "11.5 m of 13 m";
  EXPECT_NEAR(*sues.nearest_structure_m, 3.5, 1e-12);
  EXPECT_DOUBLE_EQ(sues.below_reserve_s, 15);
}

TEST(PeopleScore, AStopForGoodIsOfWhoWasAtTheHelmThen) {
  Log log = in_turn();
  log.account.vehicles[0].halt = twin::Halt::struck;
  log.account.vehicles[0].halted_at_s = 30;
  log.account.vehicles[0].mission = {
      {22, twin::ConductEventKind::hold_began, twin::Cause::limit, "holds", {}},
      {23, twin::ConductEventKind::hold_began, twin::Cause::link, "holds", {}}};
  const PeopleScore score = log.scored();
  EXPECT_EQ(helm_of(score, 1).at_limits->stopped_by, "");
  EXPECT_EQ(helm_of(score, 1).at_limits->limits_broken, 1U);
  EXPECT_EQ(helm_of(score, 2).at_limits->stopped_by, "struck");
  EXPECT_EQ(helm_of(score, 2).at_limits->limits_broken, 0U);
}

// Cut off from 20 s to 35 s; gone at 50 s; back in a seat of its own at 55 s.
TEST(PeopleScore, WhoIsCutOffIsNotAtTheHelmAndWhoSitsDownAgainIsOnePerson) {
  const Hand again{4, "Ann"};
  const Log log({ann.is(0, "join"), ann.does(10, "ask", "free", "held"), ann.is(20, "cut_off"),
                 ann.does(21, "link lost: holds", "", "lost"), ann.is(35, "come_back"),
                 ann.is(50, "leave"), again.is(52, "join"), again.does(55, "ask", "free", "held")});
  const PeopleScore score = log.scored();
  const HelmScore& first = helm_of(score, 1);
  EXPECT_DOUBLE_EQ(first.at_helm_s, 10 + 15);
  EXPECT_EQ(first.turns, 1U);
  EXPECT_EQ(first.turns_without_command, 1U);
  EXPECT_EQ(first.links_lost, 1U);
  EXPECT_EQ(*commands_per_minute(first), 0) << "it was there, and told it nothing";
  EXPECT_FALSE(refused_share(first)) << "of nothing there is no share";
  EXPECT_DOUBLE_EQ(helm_of(score, 4).at_helm_s, 5);
  const auto over = people_over_runs(std::vector{score});
  ASSERT_EQ(over.size(), 1U);
  EXPECT_EQ(over[0].runs, 1U);
  EXPECT_EQ(over[0].at_helm_s, std::vector<double>{30});
  EXPECT_EQ(over[0].asked_to_had_s, (std::vector<double>{0, 0}));
}

TEST(PeopleScore, ALostHelmIsGotAfterTheCountdownAndIsAnothers) {
  const Log log({ann.is(0, "join"), bob.is(0, "join"), ann.does(10, "ask", "free", "held"),
                 ann.is(20, "cut_off"), bob.does(22, "ask", "lost", "requested"),
                 bob.does(32, "helm got", "", "held"), ann.is(50, "leave"),
                 bob.does(55, "lease over", "", "free")});
  const PeopleScore score = log.scored();
  EXPECT_DOUBLE_EQ(helm_of(score, 1).at_helm_s, 10);
  EXPECT_EQ(helm_of(score, 2).asked_to_had_s, std::vector<double>{10});
  EXPECT_EQ(helm_of(score, 2).off_helm, 1U);
  EXPECT_DOUBLE_EQ(helm_of(score, 2).at_helm_s, 23);
}

SessionAction attends(const Hand& hand, double at_s, const std::string& on, const std::string& by) {
  SessionAction row = hand.does(at_s, "attend", "", on, "");
  row.why = by;
  return row;
}

// Each object until the next one; not while it was off, cut off, or after the seat was left.
TEST(PeopleScore, AttentionIsAddedUpFromRowToRow) {
  const Log log({ann.is(0, "join"), bob.is(0, "join"), attends(ann, 5, "rov", "pointer"),
                 attends(ann, 15, "COASTER", "head"), attends(ann, 17, "rov", "head"),
                 attends(ann, 20, "", "off"), attends(ann, 30, "", "head"), ann.is(32, "cut_off"),
                 ann.is(40, "come_back"), attends(ann, 41, "pile", "head"), ann.is(45, "leave"),
                 bob.is(50, "leave")});
  const PeopleScore score = log.scored();
  ASSERT_EQ(score.people.size(), 2U);
  EXPECT_FALSE(score.people[1].attention);
  ASSERT_TRUE(score.people[0].attention);
  EXPECT_DOUBLE_EQ(score.people[0].attention->kept_s, 10 + 2 + 3 + 2 + 4);
  EXPECT_EQ(score.people[0].attention->on_s,
            (std::map<std::string, double>{{"rov", 13}, {"COASTER", 2}, {"", 2}, {"pile", 4}}));
  EXPECT_TRUE(contains(people_score_text("run", score),
                       "looked at, kept for 0.3 min: rov 62 %, pile 19 %, COASTER 10 %, nothing "
                       "with a name 10 %"));
  const nlohmann::json json = people_score_json(score);
  EXPECT_TRUE(json["seats"][1]["attention"].is_null());
  EXPECT_EQ(json["seats"][0]["attention"]["kept_s"], 21);
  EXPECT_TRUE(json["seats"][0]["attention"]["on"][0]["name"].is_null()) << "nothing with a name";
}

// A reload takes the seat up at another station, before the first one is seen to be cut off.
TEST(PeopleScore, AttentionEndsWhereTheSeatIsTakenUpElsewhere) {
  const Log log({ann.is(0, "join"), attends(ann, 5, "rov", "pointer"), ann.is(15, "come_back"),
                 bob.is(25, "join")});
  EXPECT_DOUBLE_EQ(log.scored().people[0].attention->kept_s, 10);
}

TEST(PeopleScore, AttentionThatIsOpenAtTheEndCountsToTheLastRow) {
  const Log log({ann.is(0, "join"), attends(ann, 5, "rov", "pointer"), bob.is(25, "join")});
  EXPECT_DOUBLE_EQ(log.scored().people[0].attention->on_s.at("rov"), 20);
}

// What is given back goes to whoever asks for it: nothing is taken from anybody.
TEST(PeopleScore, AHelmThatIsGivenBackIsHadAndNotTaken) {
  const Log log({ann.does(10, "ask", "free", "held"), bob.does(22, "ask", "held", "requested"),
                 ann.does(25, "give_back", "requested", "requested"),
                 bob.does(25.5, "helm got", "", "held"), ann.does(40, "ask", "held", "requested"),
                 bob.is(41, "leave"), ann.does(41.5, "helm got", "", "held")});
  const PeopleScore score = log.scored();
  EXPECT_EQ(helm_of(score, 2).asked_to_had_s, std::vector<double>{3.5});
  EXPECT_EQ(helm_of(score, 2).asked_in_vain, 0U);
  EXPECT_EQ(helm_of(score, 2).off_helm, 0U);
  EXPECT_DOUBLE_EQ(helm_of(score, 2).at_helm_s, 15.5);
  EXPECT_EQ(helm_of(score, 1).asked_to_had_s, (std::vector<double>{0, 1.5}));
  EXPECT_EQ(helm_of(score, 1).off_helm, 0U);
}

// A take-back whose hold is refused has taken the helm all the same.
TEST(PeopleScore, WhoeverIsObeyedHasTheHelm) {
  const Log log({ann.does(1, "ask", "free", "held"),
                 sue.refused(10, "take_back", "vehicle_not_free"), sue.does(12, "home", "held")});
  const PeopleScore score = log.scored();
  EXPECT_DOUBLE_EQ(helm_of(score, 1).at_helm_s, 11);
  EXPECT_DOUBLE_EQ(helm_of(score, 3).at_helm_s, 48);
  EXPECT_EQ(helm_of(score, 3).taken_over, 1U);
}

TEST(PeopleScore, AskingInVainIsCountedAndIsNoLatency) {
  const Log log(
      {ann.is(0, "join"), bob.is(0, "join"), ann.does(1, "ask", "free", "held"),
       bob.does(2, "ask", "held", "requested"), ann.does(4, "deny", "requested", "held"),
       bob.does(5, "ask", "held", "requested"), bob.does(15, "request lapsed", "", "held"),
       bob.does(20, "ask", "held", "requested"), bob.does(21, "give_back", "requested", "held"),
       bob.refused(25, "ask", "unauthorised"), bob.does(58, "ask", "held", "requested")});
  const HelmScore bobs = helm_of(log.scored(), 2);
  EXPECT_EQ(bobs.asked_in_vain, 5U) << "denied, lapsed, withdrawn, refused, run over";
  EXPECT_TRUE(bobs.asked_to_had_s.empty());
  EXPECT_EQ(bobs.turns, 0U);
  EXPECT_FALSE(commands_per_minute(bobs));
  EXPECT_EQ(bobs.refused, 0U) << "a helm that is asked for is no command";
}

TEST(PeopleScore, WhatALogDoesNotTellIsNotZero) {
  Log log = in_turn();
  const PeopleScore score = people_score_of(log.file, log.account, nullptr);
  EXPECT_FALSE(helm_of(score, 1).at_limits);
  EXPECT_TRUE(contains(people_score_text("test", score), "limits: not known"));
  const nlohmann::json json = people_score_json(score);
  EXPECT_TRUE(json["seats"][0]["vehicles"][0]["at_limits"].is_null());
  EXPECT_TRUE(json["seats"][0]["vehicles"][0]["hold_in_force_run_s"].is_null());
  std::erase_if(log.file.tables, [](const auto& table) { return table.name != "action"; });
  EXPECT_FALSE(helm_of(log.scored(), 3).hold_in_force_s) << "a hold without its command";
  log.scenario.vehicles[0].conduct->envelope = {};
  const AtLimits at = *helm_of(log.scored(), 1).at_limits;
  EXPECT_FALSE(at.stand_off_m);
  EXPECT_FALSE(at.fence_m);
  EXPECT_TRUE(
      people_score_json(log.scored())["seats"][0]["vehicles"][0]["at_limits"]["stand_off_breaches"]
          .is_null());
  // A clock that is set back makes no latency.
  std::vector<SessionAction> rows{ann.does(1, "ask", "free", "held"), ann.does(9, "home")};
  rows[1].at = begun;
  EXPECT_TRUE(helm_of(Log(rows).scored(), 1).had_to_command_s.empty());
  EXPECT_EQ(helm_of(Log(rows).scored(), 1).turns_without_command, 0U);
}

TEST(PeopleScore, SaysNothingWhereNobodyTookPart) {
  const PeopleScore score = Log({}, {ann.commands(6, twin::HoldHere{})}).scored();
  EXPECT_TRUE(score.people.empty());
  EXPECT_EQ(people_score_text("test", score), "");
  EXPECT_TRUE(people_score_json(score).is_null());
  EXPECT_EQ(people_over_runs_text(people_over_runs(std::vector{score, score})), "");
}

TEST(PeopleScore, ReadsAsItIsMeant) {
  const std::string text = people_score_text("test", in_turn().scored());
  for (const char* const words :
       {"People of test (limits by positions 10 s apart: what is between two is not seen)",
        "Ann, operator, seat 1", "rov: at the helm once for 0.3 min of the run, 33 % of it",
        "asked once, had it after 5.0 s; first command 3.0 s after it had the helm",
        "asked once, had it at once; first command 1.5 s after it had the helm",
        "1 command taken, 3.0 a minute at the helm\n",
        "10 commands taken, 30.0 a minute at the helm; 5 refused (33.3 %): 1 not_finite, 4 stale; "
        "took it off its own mission once",
        "took it over once by HOLD or take-back; its holds were in force at most 0.20 s of "
        "the run after they came in",
        "nearest structure 3.0 m; nearer than its stand-off of 4 m once, 5.0 s in all, 10.0 s "
        "within a quarter beyond it; outside its fence of 13 m once, 5.0 s in all",
        "by supervisors: off its own mission never, off another's helm once"})
    EXPECT_TRUE(contains(text, words)) << text;
}

TEST(PeopleScore, ComparesPeopleOverRuns) {
  const PeopleScore first = in_turn().scored();
  const PeopleScore second =
      Log({bob.does(0, "ask", "free", "held"), bob.does(2, "home")}).scored();
  const auto over = people_over_runs(std::vector{first, second});
  ASSERT_EQ(over.size(), 3U);
  const PersonOverRuns& bobs = over[1];
  EXPECT_EQ(bobs.name, "Bob");
  EXPECT_EQ(bobs.runs, 2U);
  EXPECT_EQ(bobs.asked_to_had_s, (std::vector<double>{5, 0}));
  EXPECT_EQ(bobs.at_helm_s, (std::vector<double>{20, 60}));
  EXPECT_EQ(bobs.commands_per_minute, (std::vector<double>{3, 1}));
  EXPECT_EQ(bobs.breaches, (std::vector<double>{1 + 1, 2 + 2}));
  EXPECT_EQ(over[0].runs, 1U);
  const nlohmann::json json = people_over_runs_json(over);
  EXPECT_EQ(json[1]["asked_to_had_s"]["median"], 2.5);
  EXPECT_EQ(json[1]["asked_to_had_s"]["most"], 5);
  EXPECT_EQ(json[1]["at_helm_run_s"]["mean"], 40);
  EXPECT_TRUE(json[2]["asked_to_had_s"].is_null());
  const std::string text = people_over_runs_text(over);
  EXPECT_TRUE(contains(text, "Bob")) << text;
  EXPECT_TRUE(contains(text, "0.7 (0.5)")) << text;
}

}  // namespace
}  // namespace slackwater::tests::people_score_test
