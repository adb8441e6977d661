// Whose the helm of a vehicle is, by the rules that people are shown.
#include "api/door/people/helms.h"

#include "tests/support/contains.h"
#include "tests/twin/run/helm_for_tests.h"

namespace slackwater::tests::helms_test {
namespace {

using people::HelmPhase;
using people::Helms;
using people::Milliseconds;
using people::Role;
using people::Seat;

/// A run with one ROV, three people and their helms.
struct Bridge : testing::Test {
  Bridge() {
    helms.open("rov");
    for (const char* const name : {"Ann", "Bob", "Sue"}) (void)seats.take(token, name, {});
  }
  static people::TokenBook open_book() { return people::TokenBook::drawn(UtcTime::max()); }

  people::TokenBook book = open_book();
  std::string token = book.grants()[1].token;  // four operators
  people::Seats seats{book};
  std::unique_ptr<twin::Run> run =
      lone_run(lone("bluerov2_heavy", "north_m: 0, east_m: 0, depth_m: 20"));
  twin::CommandArbiter arbiter{*run};
  Helms helms{arbiter};
  Milliseconds now = 0;
  std::uint64_t sequence = 0;

  [[nodiscard]] Seat ann() const { return *seats.find(1); }
  [[nodiscard]] Seat bob() const { return *seats.find(2); }
  [[nodiscard]] Seat sue() const { return *seats.find(3); }
  [[nodiscard]] HelmPhase state() const { return helms.now(0).state; }
  std::string look() {
    std::string what;
    for (const auto& change : helms.look(seats, now)) what += change.what + ";";
    return what;
  }
  bool drive(const Seat& seat) {
    twin::Command command;
    command.what = twin::SetVelocity{{0.3, 0, 0, 0}};
    command.sequence = ++sequence;
    command.received_s = arbiter.time_s();
    if (arbiter.submit(client_of(seat), command, arbiter.time_s())) return false;
    helms.note_input(seat, 0, now);
    return true;
  }
};

TEST_F(Bridge, WhatIsGivenBackGoesToWhoeverAsks) {
  EXPECT_FALSE(helms.ask(ann(), 0, now));
  EXPECT_FALSE(helms.ask(bob(), 0, now));
  now += 1'000;
  EXPECT_FALSE(helms.give_back(ann(), 0));
  EXPECT_EQ(look(), "helm got;");
  EXPECT_TRUE(helms.holds(bob(), 0));
  EXPECT_TRUE(drive(bob()));
  // And where the holder is gone altogether.
  EXPECT_FALSE(helms.ask(sue(), 0, now));
  helms.gone(bob());
  EXPECT_EQ(look(), "helm got;");
  EXPECT_TRUE(helms.holds(sue(), 0));
}

TEST_F(Bridge, AFreeHelmIsGotAtOnceAndNobodyElseDrives) {
  EXPECT_EQ(state(), HelmPhase::free);
  EXPECT_FALSE(helms.ask(ann(), 0, now));
  EXPECT_EQ(state(), HelmPhase::held);
  EXPECT_TRUE(helms.holds(ann(), 0));
  EXPECT_TRUE(drive(ann()));
  EXPECT_FALSE(drive(bob()));
}

// The lease is the helm's, not the stick's: to let go of a stick for two seconds loses nothing.
TEST_F(Bridge, ALeaseOutlivesAPauseOfTheStickAndEndsAMinuteAfterTheLastInput) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  ASSERT_TRUE(drive(ann()));
  go_on(*run, 2);
  now += 2'000;
  EXPECT_EQ(look(), "");
  EXPECT_TRUE(drive(ann())) << "no other client got between";
  now += Helms::lease_ms - 1;
  EXPECT_EQ(look(), "");
  now += 1;
  EXPECT_EQ(look(), "lease over;");
  EXPECT_EQ(state(), HelmPhase::free);
  EXPECT_EQ(arbiter.holder(0), "");
  run->step();
  EXPECT_EQ(run->helm(0).mode, twin::HelmMode::hold) << "it was driven, and holds";
}

TEST_F(Bridge, ARequestIsGrantedDeniedOrLapses) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  ASSERT_FALSE(helms.ask(bob(), 0, now));
  EXPECT_EQ(state(), HelmPhase::requested);
  EXPECT_EQ(helms.now(0).asker, 2U);
  EXPECT_EQ(helms.now(0).until, now + Helms::request_ms);
  EXPECT_TRUE(drive(ann())) << "she has it until she grants it";
  EXPECT_TRUE(helms.ask(sue(), 0, now)) << "one asks at a time";
  EXPECT_TRUE(helms.grant(bob(), 0, seats, now)) << "who asks does not grant";
  ASSERT_FALSE(helms.deny(ann(), 0, now));
  EXPECT_EQ(state(), HelmPhase::held);
  ASSERT_FALSE(helms.ask(sue(), 0, now));
  now += Helms::request_ms;
  EXPECT_EQ(look(), "request lapsed;");
  EXPECT_TRUE(helms.holds(ann(), 0)) << "silence is no consent";
  ASSERT_FALSE(helms.ask(bob(), 0, now));
  ASSERT_FALSE(helms.grant(ann(), 0, seats, now));
  EXPECT_TRUE(helms.holds(bob(), 0));
  EXPECT_FALSE(drive(ann()));
  EXPECT_TRUE(drive(bob()));
}

TEST_F(Bridge, LeaveToTakeItOverEndsAfterTenSeconds) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  ASSERT_FALSE(helms.allow(ann(), 0, now));
  EXPECT_EQ(state(), HelmPhase::allowed);
  now += Helms::leave_ms;
  (void)look();
  EXPECT_EQ(state(), HelmPhase::held);
  ASSERT_FALSE(helms.ask(bob(), 0, now));
  EXPECT_TRUE(helms.holds(ann(), 0)) << "asks only";
  ASSERT_FALSE(helms.deny(ann(), 0, now));
  ASSERT_FALSE(helms.allow(ann(), 0, now));
  now += Helms::leave_ms - 1;
  (void)look();
  ASSERT_FALSE(helms.ask(bob(), 0, now));
  EXPECT_TRUE(helms.holds(bob(), 0));
}

TEST_F(Bridge, NobodyElseGivesItBack) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  const auto refused = helms.give_back(bob(), 0);
  ASSERT_TRUE(refused);
  EXPECT_TRUE(contains(refused->text, "not yours"));
  ASSERT_FALSE(helms.give_back(ann(), 0));
  EXPECT_EQ(state(), HelmPhase::free);
}

// Leave is given at every door: an agent takes it as a person would.
TEST_F(Bridge, LeaveToTakeItOverIsForClientsOfOtherDoorsToo) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  ASSERT_FALSE(helms.allow(ann(), 0, now));
  EXPECT_FALSE(arbiter.ask("dds 01", 0, arbiter.time_s()));
  EXPECT_EQ(look(), "helm ended;");
  EXPECT_EQ(helms.now(0).agent, "dds 01");
  EXPECT_EQ(state(), HelmPhase::held);
  EXPECT_FALSE(drive(ann()));
}

// A station that is silent has a lost helm without an end; one that is gone, until its seat ends.
TEST_F(Bridge, ALostHelmSaysUntilWhenItsSeatIsKept) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  helms.lose(ann(), now, std::nullopt);
  EXPECT_EQ(helms.now(0).until, std::nullopt);
  now += Helms::unheard_ms;
  EXPECT_EQ(look(), "link lost;") << "it was told nothing, and flies its own mission";
  helms.lose(ann(), now, now + people::Seats::kept_ms);
  EXPECT_EQ(helms.now(0).until, now + people::Seats::kept_ms);
  EXPECT_EQ(look(), "") << "once";
}

// Cut off: holds after a second, keeps the seat's helm, and goes on where it comes back.
TEST_F(Bridge, ALostLinkHoldsAfterASecondAndAReturnIsNoRival) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  ASSERT_TRUE(drive(ann()));
  run->step();
  helms.lose(ann(), now, now + people::Seats::kept_ms);
  EXPECT_EQ(state(), HelmPhase::lost);
  now += Helms::unheard_ms - 1;
  EXPECT_EQ(look(), "");
  now += 1;
  EXPECT_EQ(look(), "link lost: holds;");
  run->step();
  EXPECT_EQ(run->helm(0).mode, twin::HelmMode::hold);
  EXPECT_EQ(run->helm(0).cause, twin::HelmCause::client_lost);
  EXPECT_FALSE(drive(bob())) << "commands are no way round a seat that is kept";
  helms.back(ann(), now);
  EXPECT_EQ(state(), HelmPhase::held);
  EXPECT_TRUE(drive(ann()));
  run->step();
  EXPECT_EQ(run->helm(0).mode, twin::HelmMode::velocity);
}

TEST_F(Bridge, WhoAsksGetsTheHelmOfALostStationAfterTheCountdown) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  helms.lose(ann(), now, now + people::Seats::kept_ms);
  ASSERT_FALSE(helms.ask(bob(), 0, now));
  EXPECT_TRUE(helms.holds(ann(), 0));
  now += Helms::request_ms;
  EXPECT_TRUE(contains(look(), "helm got;"));
  EXPECT_TRUE(helms.holds(bob(), 0));
  helms.back(ann(), now);
  EXPECT_TRUE(helms.holds(bob(), 0)) << "it is his by now";
  EXPECT_FALSE(drive(ann()));
}

TEST_F(Bridge, ASeatThatIsGoneLeavesItsHelmAndItsRequest) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  ASSERT_FALSE(helms.ask(bob(), 0, now));
  helms.gone(bob());
  EXPECT_EQ(state(), HelmPhase::held);
  helms.gone(ann());
  EXPECT_EQ(state(), HelmPhase::free);
  EXPECT_EQ(arbiter.holder(0), "");
}

// One authority for all doors: a client of DDS holds, and a person comes.
TEST_F(Bridge, AnAgentsHelmIsShownAskedForAndGotAfterTheCountdown) {
  ASSERT_FALSE(arbiter.ask("dds 01", 0, arbiter.time_s()));
  (void)look();
  EXPECT_EQ(state(), HelmPhase::held);
  EXPECT_EQ(helms.now(0).agent, "dds 01");
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  EXPECT_EQ(state(), HelmPhase::requested);
  EXPECT_FALSE(drive(ann()));
  now += Helms::request_ms;
  EXPECT_EQ(look(), "helm got;");
  EXPECT_TRUE(drive(ann()));
  // And no way back for the agent but by her leave.
  EXPECT_TRUE(arbiter.ask("dds 01", 0, arbiter.time_s()));
  EXPECT_TRUE(arbiter.release("dds 01", 0, arbiter.time_s()));
}

TEST_F(Bridge, ASupervisorTakesItWhoeverHasIt) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  ASSERT_FALSE(helms.set_raw(ann(), 0, true));
  ASSERT_FALSE(helms.take_over(sue(), 0, now));
  EXPECT_TRUE(helms.holds(sue(), 0));
  EXPECT_FALSE(helms.now(0).is_raw) << "what was confirmed went with the helm";
  EXPECT_FALSE(drive(ann()));
  EXPECT_TRUE(drive(sue()));
}

TEST_F(Bridge, AVehicleThatIsGivenBackToItsMissionIsFree) {
  ASSERT_FALSE(helms.ask(ann(), 0, now));
  twin::Command resume;
  resume.what = twin::Resume{};
  resume.sequence = 1;
  ASSERT_FALSE(arbiter.submit(client_of(ann()), resume, arbiter.time_s()));
  EXPECT_EQ(look(), "helm ended;");
  EXPECT_EQ(state(), HelmPhase::free);
}

// Whoever does whatever whenever: the arbiter's holder and the helm that is shown are one.
TEST_F(Bridge, AStormOfHandOversNeverShowsAnotherHolderThanTheArbiters) {
  Rng rng(11, "storm");
  const auto pick = [&](int of) { return static_cast<int>(of * rng.uniform()); };
  for (int i = 0; i < 20'000; ++i) {
    const Seat seat = *seats.find(1 + static_cast<unsigned>(pick(3)));
    now += pick(5'000);
    switch (pick(11)) {
      case 0:
      case 1:
        (void)helms.ask(seat, 0, now);
        break;
      case 2:
        (void)helms.give_back(seat, 0);
        break;
      case 3:
        (void)helms.grant(seat, 0, seats, now);
        break;
      case 4:
        (void)helms.deny(seat, 0, now);
        break;
      case 5:
        (void)helms.allow(seat, 0, now);
        break;
      case 6:
        (void)helms.take_over(seat, 0, now);
        break;
      case 7:
        helms.lose(seat, now, now + people::Seats::kept_ms);
        break;
      case 8:
        helms.back(seat, now);
        break;
      case 9:
        (void)arbiter.ask("dds 01", 0, arbiter.time_s());
        break;
      default:
        (void)drive(seat);
    }
    if (i % 50 == 0) run->step();
    (void)look();
    const people::HelmNow& shown = helms.now(0);
    const std::string holder = arbiter.holder(0);
    if (shown.seat != 0)
      ASSERT_EQ(holder, client_of(*seats.find(shown.seat))) << i;
    else
      ASSERT_EQ(holder, shown.agent) << i;
    ASSERT_EQ(shown.state == HelmPhase::free, holder.empty() && shown.asker == 0) << i;
  }
}

}  // namespace
}  // namespace slackwater::tests::helms_test
