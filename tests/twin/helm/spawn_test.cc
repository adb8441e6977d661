// Who lets a vehicle join a run, and who is at its helm.
#include <atomic>
#include <thread>

#include "tests/twin/run/helm_for_tests.h"
#include "twin/helm/command_arbiter.h"

namespace slackwater::tests::spawn_test {
namespace {

using twin::Newcomer;
using twin::RefusalReason;

/// A run with one ROV and room for three more.
struct Served {
  twin::Scenario scenario =
      twin::parse_scenario(lone("bluerov2_heavy", "north_m: 0, east_m: 0, depth_m: 20"), "t.yaml");
  twin::ReadyRun ready = twin::set_up(scenario, surround_of(scenario));
  twin::NewcomerYard newcomer_yard{scenario, source_folder() / "data", ready.vehicles,
                                   ready.agents};
  std::unique_ptr<twin::Run> run = [this] {
    twin::RunSettings settings = settings_of(helm_step_s);
    settings.most_newcomers = 3;
    return std::make_unique<twin::Run>(ready.agents, ready.states, settings);
  }();
  twin::CommandArbiter arbiter{*run};

  std::optional<twin::Refusal> spawn(const Newcomer& newcomer, const std::string& client = "ann") {
    return arbiter.spawn(client, newcomer, newcomer_yard, arbiter.time_s());
  }
  std::optional<twin::Refusal> say(const std::string& client, std::size_t vehicle,
                                   twin::CommandWhat what) {
    return arbiter.submit(client, {0, vehicle, std::move(what), "", ++sequence, arbiter.time_s()},
                          arbiter.time_s());
  }
  std::atomic<std::uint64_t> sequence = 0;
};

Newcomer named(const std::string& name) { return {"bluerov2_heavy", name, {30, 0, 15}, 0}; }

TEST(CommandArbiterOfNewcomers, LetsOneInWithTheNextStepAndGivesNobodyItsHelm) {
  Served served;
  go_on(*served.run, 2);
  ASSERT_FALSE(served.spawn(named("late")));
  EXPECT_EQ(served.arbiter.vehicle("late"), std::nullopt) << "it is on its way";
  served.run->step();
  ASSERT_EQ(served.arbiter.vehicle("late"), 1U);
  EXPECT_EQ(served.arbiter.holder(1), "");
  EXPECT_EQ(served.arbiter.standing(1).mode, twin::HelmMode::own);
  const twin::Command& taken = served.run->commands_taken()[0];
  EXPECT_EQ(taken.source, "ann");
  EXPECT_EQ(taken.agent, 1U);
  EXPECT_NEAR(taken.received_s, 2, 1e-9);
  // Who asks for it has it, whoever let it in.
  ASSERT_FALSE(served.arbiter.ask("bob", 1, served.arbiter.time_s()));
  const auto refused = served.say("ann", 1, twin::HoldHere{});
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->reason, RefusalReason::unauthorised);
  ASSERT_FALSE(served.say("bob", 1, twin::Reroute{{{{32, 0, 15}, 0}}}));
  go_on(*served.run, 20);
  EXPECT_NEAR(served.run->seen(1).position_m.x, 32, 0.5);
  // A client that is lost leaves it like any other.
  ASSERT_FALSE(served.arbiter.ask("bob", 1, served.arbiter.time_s()));
  ASSERT_FALSE(served.say("bob", 1, twin::SetVelocity{{0.2, 0, 0, 0}}));
  served.run->step();
  served.arbiter.lost("bob", served.arbiter.time_s());
  served.run->step();
  EXPECT_EQ(served.run->helm(1).cause, twin::HelmCause::client_lost);
}

TEST(CommandArbiterOfNewcomers, RefusesWithOneClearAnswerAndLeavesTheRunAsItIs) {
  Served served, alone;
  served.run->step();
  alone.run->step();
  const auto expect_refused = [&](const Newcomer& newcomer, RefusalReason reason,
                                  const std::string& what) {
    const auto refusal = served.spawn(newcomer);
    ASSERT_TRUE(refusal) << newcomer.name;
    EXPECT_EQ(refusal->reason, reason) << refusal->text;
    EXPECT_NE(refusal->text.find(what), std::string::npos) << refusal->text;
    // A record has the name of the reason.
    EXPECT_EQ(twin::refusal_reason_of(twin::name_of(reason)), reason);
  };
  expect_refused({"no_such_boat", "late", {30, 0, 15}, 0}, RefusalReason::unknown_model,
                 "expected a name of the catalogue");
  expect_refused({"../vehicles/x500", "late", {30, 0, 15}, 0}, RefusalReason::unknown_model,
                 "found '../vehicles/x500'");
  expect_refused({"bluerov2_heavy", "late", {30, 0, std::nan("")}, 0}, RefusalReason::no_place,
                 "found nan");
  expect_refused({"bluerov2_heavy", "late", {30, 0, 99}, 0}, RefusalReason::no_place, "below_bed");
  expect_refused(named("bluerov2_heavy"), RefusalReason::bad_name, "is taken");
  expect_refused(named(""), RefusalReason::bad_name, "found ''");
  expect_refused(named("a\nb"), RefusalReason::bad_name, "found 'a?b'");
  EXPECT_EQ(served.arbiter.refusals().size(), 5U) << "counted by name and reason";
  for (int i = 0; i < 40; ++i) {
    served.run->step();
    alone.run->step();
  }
  EXPECT_TRUE(served.run->commands_taken().empty());
  ASSERT_EQ(served.run->states().size(), 1U);
  EXPECT_EQ(std::memcmp(&served.run->states()[0].vehicle, &alone.run->states()[0].vehicle,
                        sizeof(twin::VehicleState<double>)),
            0);
}

TEST(CommandArbiterOfNewcomers, HasRoomForAStatedNumberAndEachNameOnce) {
  Served served;
  ASSERT_FALSE(served.spawn(named("one")));
  const auto twice = served.spawn(named("one"));
  ASSERT_TRUE(twice) << "it is on its way";
  EXPECT_EQ(twice->reason, RefusalReason::bad_name);
  ASSERT_FALSE(served.spawn(named("two")));
  served.run->step();
  ASSERT_FALSE(served.spawn(named("three")));
  for (int i = 0; i < 2; ++i) {
    const auto full = served.spawn(named("four"));
    ASSERT_TRUE(full);
    EXPECT_EQ(full->reason, RefusalReason::too_many);
    EXPECT_NE(full->text.find("found 4 vehicles"), std::string::npos) << full->text;
    served.run->step();
  }
  EXPECT_EQ(served.run->agents().size(), 4U);
}

TEST(CommandArbiterOfNewcomers, LetsThemInFromManyThreadsWhileTheRunGoesOn) {
  Served served;
  std::atomic<int> taken = 0;
  std::atomic<bool> is_over = false;
  std::vector<std::thread> people;
  for (int who = 0; who < 3; ++who)
    people.emplace_back([&, who] {
      const std::string client = "client " + std::to_string(who);
      for (int i = 0; i < 4; ++i)
        if (!served.spawn(named("late" + std::to_string(i)), client)) ++taken;
      while (!is_over)
        for (std::size_t vehicle = 0; vehicle < 5; ++vehicle)
          (void)served.say(client, vehicle, twin::HoldHere{});
    });
  for (int i = 0; i < 400; ++i) served.run->step();
  is_over = true;
  for (std::thread& one : people) one.join();
  for (int i = 0; i < 5; ++i) served.run->step();
  EXPECT_EQ(taken, 3);
  EXPECT_EQ(served.run->agents().size(), 4U);
}

}  // namespace
}  // namespace slackwater::tests::spawn_test
