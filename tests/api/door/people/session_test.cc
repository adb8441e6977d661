// Several people in one run, by scripted stations at raw sockets: who may do what is decided by the
// server, and a run with people in it is made again to the last bit.
#include "api/door/people/session.h"

#include <gtest/gtest.h>

#include "api/log/action_tables.h"
#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/asked_number.h"
#include "tests/support/contains.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::session_test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using people::Role;

const std::string two_rovs = calm_head(0.05) +
                             "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 0, east_m: "
                             "0, depth_m: 10}, tasks: [{do: hold}]}\n"
                             "  - {name: rov 2, model: bluerov2_heavy, start: {north_m: 30, "
                             "east_m: 0, depth_m: 10}, tasks: [{do: hold}]}\n";

/// An operator, a supervisor and a spectator, seated.
struct Session : testing::Test {
  twin::CommandArbiter* arbiter = nullptr;  ///< as another door has it
  SessionUnderWay run{two_rovs,
                      {1, people::TokenBook::drawn(UtcTime::max()),
                       [this](const api::RunInHand& hand) { arbiter = &hand.arbiter; }}};
  StationClient ann{run, run.token(Role::drives)};
  StationClient bob{run, run.token(Role::drives)};
  StationClient sue{run, run.token(Role::supervises)};
  StationClient guest{run, run.token(Role::looks_on)};
  json anns = ann.hello("Ann"), bobs = bob.hello("Bob");
  json sues = sue.hello("Sue"), guests = guest.hello("Gus");

  [[nodiscard]] static json ask(int vehicle) { return {{"do", "ask"}, {"vehicle", vehicle}}; }
  static std::function<bool(const json&)> helm(int vehicle, const std::string& state) {
    return [=](const json& helm) { return helm["vehicle"] == vehicle && helm["state"] == state; };
  }
  static std::function<bool(const json&)> mode(int vehicle, const std::string& mode) {
    return [=](const json& helm) { return helm["vehicle"] == vehicle && helm["mode"] == mode; };
  }
  json stick(StationClient& who, int vehicle, double surge) {
    return who.asks(who.command("stick", vehicle, {{"velocity", {surge, 0, 0, 0}}}));
  }
};

TEST_F(Session, ShowsEverybodyTheRunItsVehiclesAndWhoIsThere) {
  EXPECT_EQ(guests["role"], "spectator");
  ASSERT_EQ(guests["vehicles"].size(), 2U);
  EXPECT_EQ(guests["vehicles"][0]["name"], "rov 1");
  EXPECT_EQ(guests["seats"].size(), 4U);
  EXPECT_EQ(guests["run"]["state"], "running");
  guest.listen(300ms);
  ASSERT_GE(guest.frames.size(), 1U);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(guest.frames[0].data());
  flatbuffers::Verifier verifier(bytes, guest.frames[0].size());
  ASSERT_TRUE(slackwater::session::VerifyFrameBuffer(verifier));
  const auto* frame = slackwater::session::GetFrame(bytes);
  EXPECT_TRUE(frame->is_whole());
  ASSERT_EQ(frame->poses()->size(), 2U);
  EXPECT_NEAR(frame->poses()->Get(1)->north_m(), 30, 0.5);
  EXPECT_NEAR(frame->poses()->Get(1)->up_m(), -10, 0.5);
  EXPECT_NEAR(frame->poses()->Get(1)->bed_m(), 50, 0.6);
}

TEST_F(Session, LetsOneDriveAndTheOthersNot) {
  expect_refused(stick(ann, 0, 0.3), "unauthorised", "ask for it first");
  expect_taken(ann.asks(ask(0)));
  expect_taken(stick(ann, 0, 0.3));
  EXPECT_FALSE(guest.told("helm", mode(0, "velocity")).is_null()) << "all see it";
  expect_refused(stick(bob, 0, 0.3), "unauthorised", "seat 1 has the helm");
  expect_refused(guest.asks(ask(0)), "unauthorised", "ask needs the role of operator");
  expect_refused(bob.asks({{"do", "pause"}}), "unauthorised", "role of supervisor");
  expect_refused(guest.asks({{"do", "say"}, {"text", "hello"}}), "unauthorised", "operator");
  expect_taken(bob.asks({{"do", "say"}, {"text", "hello"}}));
  expect_refused(bob.asks({{"do", "say"}, {"text", "\x1b[2Jhello"}}), "unreadable", "control");
  // Two operators, two vehicles.
  expect_taken(bob.asks(ask(1)));
  expect_taken(stick(bob, 1, 0.2));
}

TEST_F(Session, HandsAHelmOverByRequestAndGrant) {
  expect_taken(ann.asks(ask(0)));
  expect_taken(bob.asks(ask(0)));
  const json requested = ann.told("helm", helm(0, "requested"));
  ASSERT_FALSE(requested.is_null());
  EXPECT_EQ(requested["asker"], 2);
  // Less what it took to arrive and to be read.
  EXPECT_NEAR(requested["until"].get<double>() - static_cast<double>(ann.clock()), 10'000, 1'000);
  expect_taken(ann.asks({{"do", "grant"}, {"vehicle", 0}}));
  expect_taken(stick(bob, 0, 0.2));
  expect_refused(stick(ann, 0, 0.2), "unauthorised", "seat 2 has the helm");
}

// HOLD works without the helm, and no stick goes on past it.
TEST_F(Session, TheSupervisorHoldsAndTakesBackWhoeverDrives) {
  expect_taken(ann.asks(ask(0)));
  expect_taken(stick(ann, 0, 0.3));
  expect_taken(sue.asks(sue.command("hold", 0)));
  expect_refused(stick(ann, 0, 0.3), "unauthorised", "seat 3 has the helm");
  EXPECT_FALSE(guest.told("helm", mode(0, "hold")).is_null());
  expect_refused(bob.asks(bob.command("hold", 0)), "unauthorised", "seat 3");
  expect_taken(sue.asks({{"do", "give_back"}, {"vehicle", 0}}));
  expect_taken(ann.asks(ask(0)));
  expect_refused(sue.asks({{"do", "take_back"}, {"vehicle", 0}}), "unreadable", "reason");
  expect_taken(sue.asks({{"do", "take_back"}, {"vehicle", 0}, {"reason", "vessel comes"}}));
  const json row =
      guest.told("action", [](const json& action) { return action["what"] == "take_back"; });
  ASSERT_FALSE(row.is_null());
  EXPECT_TRUE(contains(row["after"].get<std::string>(), "vessel comes"));
}

// Whatever no person drives; what a person drives is taken back with a reason first.
TEST_F(Session, TheSupervisorDirectsWhatNobodyDrives) {
  const json there{{"places", {{{"east_m", 3}, {"north_m", 0}, {"up_m", -8}, {"speed_m_s", 0}}}}};
  expect_refused(bob.asks(bob.command("waypoints", 0, there)), "unauthorised", "ask for it first");
  expect_taken(sue.asks(sue.command("waypoints", 0, there)));
  EXPECT_FALSE(guest.told("helm", mode(0, "waypoints")).is_null());
  expect_refused(stick(ann, 0, 0.3), "unauthorised", "seat 3 has the helm");
  expect_taken(ann.asks(ask(1)));
  expect_refused(sue.asks(sue.command("home", 1)), "unauthorised", "seat 1 has the helm");
  expect_taken(sue.asks({{"do", "take_back"}, {"vehicle", 1}, {"reason", "storm"}}));
  expect_taken(sue.asks(sue.command("home", 1)));
}

TEST_F(Session, OnlySupervisorsPauseStepAndSpawn) {
  expect_taken(sue.asks({{"do", "pause"}}));
  const json paused = guest.told("run", [](const json& run) { return run["state"] == "paused"; });
  ASSERT_FALSE(paused.is_null());
  EXPECT_EQ(paused["by"], "Sue");
  const json stepped = sue.asks({{"do", "step"}, {"steps", 40}});
  expect_taken(stepped);
  // All of them are seen, and not the first alone.
  std::uint64_t seen = 0;
  for (int i = 0; i < 40 && seen < stepped["step"]; ++i) {
    sue.listen(50ms);
    if (sue.frames.empty()) continue;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(sue.frames.back().data());
    seen = slackwater::session::GetFrame(bytes)->step();
  }
  EXPECT_EQ(seen, stepped["step"]);
  expect_taken(sue.asks({{"do", "go_on"}}));
  expect_refused(sue.asks({{"do", "step"}, {"steps", 3}}), "unauthorised", "not paused");
  expect_taken(sue.asks({{"do", "spawn"},
                         {"model", "bluerov2_heavy"},
                         {"name", "late"},
                         {"north_m", 60},
                         {"east_m", 0},
                         {"up_m", -10},
                         {"heading_deg", 90}}));
  const json late = guest.told("vehicle");
  ASSERT_FALSE(late.is_null());
  EXPECT_EQ(late["name"], "late");
  expect_taken(bob.asks(ask(2)));
}

// One authority for all doors: what a client of DDS is told.
TEST_F(Session, ADoorWithoutRolesHasNeitherTheRunNorAHelmWhilePeopleHaveThem) {
  EXPECT_EQ(arbiter->run_holder(), "the supervisors");
  const auto paused = arbiter->claim_run("dds 01", arbiter->time_s());
  ASSERT_TRUE(paused);
  EXPECT_TRUE(contains(paused->text, "held by the supervisors"));
  EXPECT_TRUE(arbiter->ask_for_run("dds 01", arbiter->time_s()));
  expect_taken(ann.asks(ask(0)));
  EXPECT_TRUE(arbiter->ask("dds 01", 0, arbiter->time_s()));
  EXPECT_TRUE(arbiter->release("dds 01", 0, arbiter->time_s()));
  // An agent at another vehicle is shown, and an operator gets the helm after the countdown.
  ASSERT_FALSE(arbiter->ask("dds 01", 1, arbiter->time_s()));
  const json agent = guest.told("helm", helm(1, "held"));
  EXPECT_EQ(agent["holder"], "dds 01");
  // Without a supervisor the run is free for whoever asks.
  sue.says({{"do", "leave"}});
  EXPECT_FALSE(
      guest.told("seats", [](const json& seats) { return seats["seats"].size() == 3; }).is_null());
  EXPECT_EQ(arbiter->run_holder(), "");
  EXPECT_FALSE(arbiter->ask_for_run("dds 01", arbiter->time_s()));
}

// Ten thousand in a soak: who has left leaves nothing behind but rows of the record.
TEST_F(Session, ManyComeAndGoAndLeaveNoSeat) {
  const int joins = std::max(100, asked_number("SLACKWATER_JOINS", 0));
  for (int i = 0; i < joins; ++i) {
    StationClient visitor(run, run.token(Role::looks_on));
    ASSERT_EQ(visitor.status(), 101) << i;
    ASSERT_TRUE(visitor.hello("visitor " + std::to_string(i)).is_object()) << i;
    visitor.says({{"do", "leave"}});
    ASSERT_EQ(visitor.closed(), 1000) << i;
    if (i % 100 != 0) continue;
    // Who says nothing for 90 s is turned out: ten thousand take longer.
    for (StationClient* seated : {&ann, &bob, &sue, &guest}) {
      seated->says({{"do", "time"}, {"at", i}});
      seated->listen(1ms);
      seated->messages.clear();
      seated->frames.clear();
    }
  }
  EXPECT_EQ(run.session().summary()["seats"], 4);
  expect_taken(ann.asks(ask(0)));
}

// Who comes before the run has begun is told so, and not shown a run without vehicles.
TEST(SessionOfASlowRun, SaysThatItIsTheMachineThatIsSlow) {
  std::atomic<bool> is_slow = false, is_waiting = false;
  SessionUnderWay run(
      two_rovs, {1, people::TokenBook::drawn(UtcTime::max()), [&](const api::RunInHand& hand) {
                   hand.run.at_opening([&, &control = hand.control](const twin::StepTime&) {
                     if (is_slow.exchange(false)) std::this_thread::sleep_for(3s);
                     if (!is_waiting.exchange(false)) return;
                     const twin::Awaited::Wait waits(control.awaited(), "a host");
                     const twin::Awaited::Wait later(control.awaited(), "another");
                     std::this_thread::sleep_for(3s);
                   });
                 }});
  StationClient gus(run, run.token(Role::looks_on));
  EXPECT_EQ(gus.hello("Gus")["run"]["by"], nullptr);
  const auto state = [](const std::string& is) {
    return [is](const json& told) { return told["state"] == is; };
  };
  is_slow = true;
  EXPECT_EQ(gus.told("run", state("stalled"))["by"], "the machine");
  EXPECT_EQ(gus.told("run", state("running"))["by"], nullptr);
  gus.listen(500ms);  // what is slow is told by the pace of the steps before it
  is_waiting = true;
  EXPECT_EQ(gus.told("run", state("stalled"))["by"], "a host");
  EXPECT_EQ(gus.told("run", state("running"))["by"], nullptr);
}

TEST(SessionBeforeItsRun, TakesNobodyYet) {
  const people::TokenBook book = people::TokenBook::drawn(UtcTime::max());
  const std::string token = book.grants()[0].token;
  people::SessionSettings settings;
  settings.now = [] { return UtcTime(); };
  people::Session session(settings, book);
  EXPECT_EQ(session.summary()["state"], "starting");
  const auto refused = session.refusal_of(token, "/sessions/run/check");
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->status, 503);
  session.end();
  EXPECT_EQ(session.refusal_of(token, "/sessions/run/check")->status, 410);
}

// Cockpit #1524, stretch_web_teleop #3: what was queued while a tab slept is carried out on return.
TEST_F(Session, NothingThatWasQueuedRunsLate) {
  expect_taken(ann.asks(ask(0)));
  const json late = ann.command("stick", 0, {{"velocity", {0.3, 0, 0, 0}}});
  ann.listen(1'100ms);
  expect_refused(ann.asks(late), "stale", "not carried out");
  json far = ann.command("stick", 0, {{"velocity", {0.3, 0, 0, 0}}});
  far["until"] = ann.clock() + 60'000;
  expect_refused(ann.asks(far), "stale", "expected at most 1.0 s");
  json early = ann.command("stick", 0, {{"velocity", {0.3, 0, 0, 0}}});
  early["at"] = early["until"] = ann.clock() + 60'000;
  expect_refused(ann.asks(early), "stale", "set the station's clock");
  json timeless = ann.command("stick", 0, {{"velocity", {0.3, 0, 0, 0}}});
  timeless.erase("at");
  expect_refused(ann.asks(timeless), "unreadable", "found no at");
  json again = ann.command("hold", 0);
  expect_taken(ann.asks(again));
  expect_refused(ann.asks(again), "stale", "count on");
}

TEST_F(Session, RawThrustersAreConfirmedFirst) {
  expect_taken(ann.asks(ask(0)));
  const auto push = [&] {
    return ann.asks(ann.command("thrusters", 0, {{"share", {0.1, 0.1, 0, 0, 0, 0, 0, 0}}}));
  };
  expect_refused(push(), "unauthorised", "not confirmed");
  expect_taken(ann.asks({{"do", "raw"}, {"vehicle", 0}, {"is_on", true}}));
  expect_taken(push());
  expect_refused(ann.asks(ann.command("thrusters", 0, {{"share", {0.1, 2}}})), "wrong_count", "");
}

// A reload is not a rival, and a late joiner sees what is so now.
TEST_F(Session, ASeatIsTakenUpAgainWithItsHelmAndOldTokensOpenNothing) {
  expect_taken(ann.asks(ask(0)));
  expect_taken(stick(ann, 0, 0.3));
  ann.hang_up();
  ASSERT_FALSE(guest.told("helm", helm(0, "lost")).is_null());
  ASSERT_FALSE(guest.told("helm", mode(0, "hold")).is_null()) << "after a second";
  StationClient again(run, anns["resume"]);
  const json back = again.hello("whoever");
  ASSERT_TRUE(back.is_object());
  EXPECT_EQ(back["seat"], anns["seat"]);
  EXPECT_EQ(back["name"], "Ann");
  EXPECT_EQ(back["helms"][0]["state"], "held");
  EXPECT_EQ(back["helms"][0]["holder"], anns["seat"]);
  expect_taken(stick(again, 0, 0.3));
  StationClient replayed(run, anns["resume"]);
  EXPECT_EQ(replayed.status(), 401);
  EXPECT_TRUE(contains(replayed.handshake().body, "used before"));
  // The same seat at a second station: the first one goes, and is told why.
  StationClient second(run, back["resume"]);
  ASSERT_TRUE(second.hello("Ann").is_object());
  EXPECT_EQ(again.closed(), 4001);
}

TEST_F(Session, RefusesStrangersBeforeAnythingIsUpgraded) {
  EXPECT_EQ(StationClient(run, "0123456789abcdef0123456789abcdef").status(), 401);
  EXPECT_EQ(StationClient(run, run.token(Role::supervises)).status(), 409);
  EXPECT_EQ(
      StationClient(run, run.token(Role::drives), "Origin: https://evil.example\r\n").status(),
      403);
  const std::string own = "Origin: http://127.0.0.1:" + std::to_string(run.port()) + "\r\n";
  EXPECT_EQ(StationClient(run, run.token(Role::drives), own).status(), 403)
      << "the host was another";
}

TEST_F(Session, TurnsOutWhatIsNoStation) {
  StationClient silent(run, run.token(Role::looks_on));
  StationClient hasty(run, run.token(Role::looks_on));
  hasty.says({{"do", "time"}, {"at", 1}});
  EXPECT_EQ(hasty.closed(), 4004);
  EXPECT_TRUE(guest.says_text("no json"));
  EXPECT_EQ(guest.closed(), 4004);
  for (int i = 0; i < 400; ++i) bob.says({{"do", "time"}, {"at", i}});
  EXPECT_EQ(bob.closed(), 4003);
  EXPECT_EQ(silent.closed(), 4002);
  // The others go on.
  expect_taken(ann.asks(ask(0)));
}

TEST_F(Session, AnswersEachUnreadableMessageAndKeepsTheStation) {
  expect_taken(ann.asks(ask(0)));
  for (const json& wrong :
       {json{{"do", "fly"}}, json{{"do", "ask"}}, json{{"do", "ask"}, {"vehicle", 7}},
        json{{"do", "ask"}, {"vehicle", -1}}, json{{"do", "ask"}, {"vehicle", "rov 1"}},
        json{{"do", "ask"}, {"vehicle", 1e300}}, ann.command("stick", 0, {{"velocity", {1, 2}}}),
        ann.command("stick", 0, {{"velocity", {1, 2, 3, nullptr}}}),
        ann.command("waypoints", 0, {{"places", {1}}}),
        ann.command("waypoints", 0, {{"places", {{{"east_m", 1}}}}}), json{{"do", "hello"}}}) {
    const json answer = ann.asks(wrong);
    ASSERT_TRUE(answer.is_object()) << wrong;
    EXPECT_EQ(answer["taken"], false) << wrong;
    EXPECT_EQ(answer["reason"], "unreadable") << wrong;
  }
  expect_taken(stick(ann, 0, 0.1));
}

// A drag asks before it is let go of, and changes nothing.
TEST_F(Session, ATrialOfWaypointsSaysTheServersOwnRefusalAndMovesNobody) {
  expect_taken(ann.asks(ask(0)));
  const auto way = [&](double up_m, bool is_trial) {
    return ann.command(
        "waypoints", 0,
        {{"places", {{{"east_m", 5}, {"north_m", 5}, {"up_m", up_m}, {"speed_m_s", 0}}}},
         {"is_trial", is_trial}});
  };
  expect_refused(ann.asks(way(-500, true)), "no_place", "");
  expect_taken(ann.asks(way(-20, true)));
  EXPECT_TRUE(guest.told("helm", mode(0, "waypoints"), 300ms).is_null());
  expect_taken(ann.asks(way(-20, false)));
  EXPECT_FALSE(guest.told("helm", mode(0, "waypoints")).is_null());
}

// What a slow station does not take in is left out and said; nothing grows.
TEST_F(Session, AStationThatDoesNotSayWhatItSawGetsNoMoreFramesAndIsTold) {
  expect_taken(ann.asks(ask(0)));
  guest.says_saw = false;
  guest.frames.clear();
  for (int i = 0; i < 60; ++i) {
    (void)stick(ann, 0, 0.3);
    guest.listen(50ms);
  }
  EXPECT_LE(guest.frames.size(), people::FrameFlow::most_ahead);
  const auto left_out = std::find_if(guest.messages.begin(), guest.messages.end(),
                                     [](const json& told) { return told["is"] == "left_out"; });
  ASSERT_NE(left_out, guest.messages.end());
  EXPECT_GT((*left_out)["frames"], 0);
}

TEST_F(Session, KeepsARecordOfWhoDidWhatAndWhatWasRefused) {
  expect_taken(ann.asks(ask(0)));
  for (int i = 0; i < 5; ++i) expect_taken(stick(ann, 0, 0.3));
  (void)bob.asks({{"do", "take_back"}, {"vehicle", 0}, {"reason", "mine"}});
  expect_taken(ann.asks(ann.command("home", 0)));
  (void)run.ended();
  std::string all;
  for (const people::Action& row : run.session().actions())
    all += row.who + " " + row.what + (row.is_taken ? "" : "!") + " " + row.after + "; ";
  EXPECT_TRUE(contains(all, "Ann ask held; Ann stick velocity; "));
  EXPECT_TRUE(contains(all, "Bob take_back! "));
  EXPECT_TRUE(contains(all, "Ann stick_end 5 of them; Ann home home; "));
  EXPECT_EQ(ann.closed(), 4000);
}

// A link that is dead without anybody's farewell: the vehicle holds, and whoever is back drives on.
TEST_F(Session, AStationOfWhichNothingIsHeardHasALostHelmUntilItSpeaks) {
  expect_taken(ann.asks(ask(0)));
  expect_taken(stick(ann, 0, 0.2));
  const json lost = guest.told("helm", helm(0, "lost"));
  ASSERT_FALSE(lost.is_null());
  ASSERT_FALSE(guest.told("helm", mode(0, "hold")).is_null());
  ann.says({{"do", "time"}, {"at", 1}});
  ASSERT_FALSE(guest.told("helm", helm(0, "held")).is_null());
  expect_taken(stick(ann, 0, 0.2));
}

// What people did is made again from the record of commands, bit by bit.
TEST_F(Session, ARunWithPeopleInItIsMadeAgainToTheLastBit) {
  expect_taken(ann.asks(ask(0)));
  expect_taken(bob.asks(ask(1)));
  for (int i = 0; i < 20; ++i) {
    expect_taken(stick(ann, 0, 0.02 * i));
    expect_taken(stick(bob, 1, -0.01 * i));
  }
  expect_taken(sue.asks(sue.command("hold", 0)));
  ann.hang_up();
  bob.listen(1500ms);
  const api::ScenarioResult& first = run.ended();
  ASSERT_GE(first.commands.size(), 41U);
  const TemporaryFolder folder;
  ingest::write_trajectories(first.file, folder / "log.nc");
  for (const std::size_t threads : {1U, 2U}) {
    api::RunChoice choice;
    choice.threads = threads;
    const api::ReplayResult again =
        api::replay(folder / "log.nc", folder / "store", std::nullopt, choice);
    EXPECT_TRUE(again.is_identical) << threads << ": " << again.difference;
  }
  // And it says who did what.
  const auto actions = api::actions_in(ingest::read_trajectories(folder / "log.nc"));
  EXPECT_EQ(actions, run.session().actions());
  EXPECT_GE(actions.size(), 10U);
}

}  // namespace
}  // namespace slackwater::tests::session_test
