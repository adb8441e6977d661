#include "twin/helm/command_arbiter.h"

#include <thread>

#include "tests/twin/run/helm_for_tests.h"

namespace slackwater::tests::command_arbiter_test {
namespace {

using twin::Command;
using twin::CommandArbiter;
using twin::HelmCause;
using twin::HelmMode;
using twin::RefusalReason;

const std::string rov_start = "north_m: 0, east_m: 0, depth_m: 20";

/// A run with one ROV and its arbiter.
struct Served {
  std::unique_ptr<twin::Run> run = lone_run(lone("bluerov2_heavy", rov_start));
  CommandArbiter arbiter{*run};
  std::map<std::string, std::uint64_t> sequence{};

  std::optional<twin::Refusal> say(const std::string& client, twin::CommandWhat what) {
    Command command{0, 0, std::move(what), "", ++sequence[client], arbiter.time_s()};
    return arbiter.submit(client, std::move(command), arbiter.time_s());
  }
  const twin::HelmState& helm() const { return run->helm(0); }
};

const twin::SetVelocity ahead{{0.5, 0, 0, 0}};
const twin::Reroute near{{{{1, 0, 20}, 0}}};

TEST(CommandArbiter, TakesAFirstCommandAndKeepsItsSourceSequenceAndTime) {
  Served served;
  go_on(*served.run, 3);
  ASSERT_FALSE(served.say("dds 01", ahead));
  EXPECT_EQ(served.arbiter.holder(0), "dds 01");
  served.run->step();
  ASSERT_EQ(served.run->commands_taken().size(), 1U);
  const Command& taken = served.run->commands_taken()[0];
  EXPECT_EQ(taken.source, "dds 01");
  EXPECT_EQ(taken.sequence, 1U);
  EXPECT_NEAR(taken.received_s, 3, 1e-9);
  EXPECT_EQ(taken.step, 60U);
}

TEST(CommandArbiter, AnswersAnotherClientWithTheHoldersNameAndCountsIt) {
  Served served;
  ASSERT_FALSE(served.say("ann", ahead));
  for (int i = 0; i < 3; ++i) {
    const auto answer = served.say("bob", ahead);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->reason, RefusalReason::unauthorised);
    EXPECT_NE(answer->text.find("ann"), std::string::npos);
  }
  ASSERT_EQ(served.arbiter.refusals().size(), 1U);
  const twin::RefusalCount count = served.arbiter.refusals()[0];
  EXPECT_EQ(count.source, "bob");
  EXPECT_EQ(count.vehicle, "bluerov2_heavy");
  EXPECT_EQ(count.count, 3U);
  served.run->step();
  EXPECT_EQ(served.run->commands_taken().size(), 1U);
}

TEST(CommandArbiter, VelocityThatIsNotRenewedHoldsAndIsNobodysAfterASecond) {
  Served served;
  ASSERT_FALSE(served.say("ann", ahead));
  go_on(*served.run, 0.9);
  EXPECT_EQ(served.arbiter.holder(0), "ann");
  go_on(*served.run, 0.15);
  EXPECT_EQ(served.arbiter.holder(0), "");
  EXPECT_EQ(served.helm().mode, HelmMode::hold);
  EXPECT_FALSE(served.say("bob", ahead));
}

TEST(CommandArbiter, AListIsHeldUntilItIsDone) {
  Served served;
  ASSERT_FALSE(served.say("ann", near));
  served.run->step();
  EXPECT_EQ(served.arbiter.holder(0), "ann");
  EXPECT_TRUE(served.say("bob", near));
  while (served.helm().mode == HelmMode::waypoints && served.run->time_s() < 60) served.run->step();
  EXPECT_EQ(served.helm().cause, HelmCause::list_done);
  EXPECT_EQ(served.arbiter.holder(0), "");
  // A new list that has not begun is not over.
  ASSERT_FALSE(served.say("bob", near));
  EXPECT_EQ(served.arbiter.holder(0), "bob");
}

TEST(CommandArbiter, AListThatComesBetweenOpeningAndBarrierIsNotOverAtThatBarrier) {
  Served served;
  bool was_said = false;
  served.run->add_client([&](const twin::StepTime& time) {
    if (time.step == 5) was_said = !served.say("ann", near);
  });
  go_on(*served.run, 6 * helm_step_s);
  ASSERT_TRUE(was_said);
  EXPECT_EQ(served.arbiter.holder(0), "ann");
  EXPECT_EQ(served.helm().mode, HelmMode::own);
  EXPECT_TRUE(served.arbiter.is_waiting(0));
  served.run->step();
  EXPECT_EQ(served.helm().mode, HelmMode::waypoints);
  EXPECT_FALSE(served.arbiter.is_waiting(0));
  EXPECT_EQ(served.arbiter.holder(0), "ann");
}

TEST(CommandArbiter, AClientThatIsGoneLeavesAHoldThatGoesHome) {
  Served served;
  ASSERT_FALSE(served.say("ann", twin::Reroute{{{{50, 0, 20}, 0.5}}}));
  go_on(*served.run, 10);
  served.arbiter.lost("ann", served.arbiter.time_s());
  EXPECT_EQ(served.arbiter.holder(0), "");
  go_on(*served.run, 1);
  EXPECT_EQ(served.helm().cause, HelmCause::client_lost);
  go_on(*served.run, 60);
  EXPECT_EQ(served.helm().mode, HelmMode::home);
  // It may come back, and count from the beginning.
  served.sequence.clear();
  EXPECT_FALSE(served.say("ann", ahead));
}

TEST(CommandArbiter, WhoGivesAMovingVehicleBackLeavesItHolding) {
  Served served;
  ASSERT_FALSE(served.say("ann", ahead));
  served.run->step();
  EXPECT_TRUE(served.arbiter.release("bob", 0, served.arbiter.time_s()));
  EXPECT_FALSE(served.arbiter.release("ann", 0, served.arbiter.time_s()));
  served.run->step();
  EXPECT_EQ(served.helm().mode, HelmMode::hold);
  EXPECT_EQ(served.arbiter.holder(0), "");
}

TEST(CommandArbiter, WhoGivesALoopBackLeavesItHoldingAndAListGoingOn) {
  const twin::Waypoint there{{30, 0, 20}, 0}, back{{0, 0, 20}, 0};
  for (const bool is_loop : {false, true}) {
    Served served;
    ASSERT_FALSE(served.say("ann", twin::Reroute{{there, back}, is_loop}));
    go_on(*served.run, 2);
    ASSERT_EQ(served.helm().mode, HelmMode::waypoints);
    EXPECT_EQ(served.arbiter.holder(0), "ann");
    EXPECT_FALSE(served.arbiter.release("ann", 0, served.arbiter.time_s()));
    go_on(*served.run, 2);
    EXPECT_EQ(served.helm().mode, is_loop ? HelmMode::hold : HelmMode::waypoints);
    EXPECT_EQ(served.arbiter.holder(0), "");
  }
}

TEST(CommandArbiter, TakesNoMoreThanAThousandCommandsOfAVehicleForOneStep) {
  Served served;
  const std::size_t most = twin::RefusalLimits{}.most_at_once;
  for (std::size_t i = 0; i < most; ++i) ASSERT_FALSE(served.say("ann", ahead)) << i;
  EXPECT_EQ(served.arbiter.taken(0), most);
  const auto answer = served.say("ann", ahead);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->reason, RefusalReason::too_many);
  EXPECT_NE(answer->text.find("1000 commands"), std::string::npos) << answer->text;
  EXPECT_EQ(served.arbiter.taken(0), most);
  served.run->step();
  EXPECT_EQ(served.run->commands_taken().size(), most);
  EXPECT_FALSE(served.say("ann", ahead)) << "the next step has room again";
}

/// Whoever is not at the helm keeps nobody waiting with a list that takes long to look at.
TEST(CommandArbiter, AsksWhoItIsBeforeWhatItSays) {
  Served served;
  ASSERT_FALSE(served.arbiter.ask("ann", 0, 0));
  const auto answer = served.say("bob", twin::Reroute{{{{1e300, 0, 20}, 0}}});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->reason, RefusalReason::unauthorised);
}

TEST(CommandArbiter, WhoGivesItBackToItsMissionHoldsItNoMore) {
  Served served;
  ASSERT_FALSE(served.say("ann", ahead));
  served.run->step();
  ASSERT_FALSE(served.say("ann", twin::Resume{}));
  EXPECT_EQ(served.arbiter.holder(0), "");
  served.run->step();
  EXPECT_EQ(served.helm().mode, HelmMode::own);
}

TEST(CommandArbiter, HandsOverWithLeave) {
  Served served;
  ASSERT_FALSE(served.arbiter.ask("ann", 0, 0));
  EXPECT_TRUE(served.arbiter.ask("bob", 0, 1));
  ASSERT_FALSE(served.arbiter.allow_take_over("ann", 0, 1));
  EXPECT_FALSE(served.arbiter.ask("bob", 0, 2));
  EXPECT_EQ(served.arbiter.holder(0), "bob");
}

TEST(CommandArbiter, DoesNotKnowOtherVehicles) {
  Served served;
  Command command{0, 3, twin::HoldHere{}, "", 1, 0};
  const auto answer = served.arbiter.submit("ann", command, 0);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->reason, RefusalReason::unknown_vehicle);
  EXPECT_TRUE(served.arbiter.ask("ann", 3, 0));
  EXPECT_EQ(served.arbiter.vehicle("bluerov2_heavy"), 0U);
  EXPECT_FALSE(served.arbiter.vehicle("rov"));
  const twin::Refusal unknown = served.arbiter.refuse_unknown("ann", "rov", 0);
  EXPECT_NE(unknown.text.find("expected one of bluerov2_heavy"), std::string::npos);
}

TEST(CommandArbiter, AVehicleThatHaltsIsNobodys) {
  Served served;
  ASSERT_FALSE(served.arbiter.ask("ann", 0, 0));
  twin::VehicleState<double> elsewhere = state_of_lone(*served.run).vehicle;
  elsewhere.body.position_m.z = 200;
  ASSERT_FALSE(served.say("ann", twin::PutVehicle{elsewhere}));
  go_on(*served.run, 1);
  EXPECT_EQ(served.arbiter.holder(0), "");
  const auto answer = served.say("ann", ahead);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->reason, RefusalReason::vehicle_halted);
}

TEST(CommandArbiter, RecordsNothingThatAFileCannotHold) {
  Served served;
  const std::string odd("b\0b\xff\n", 5);
  (void)served.arbiter.refuse_unknown(odd, odd + std::string(5000, 'x'), 0);
  const twin::RefusalCount count = served.arbiter.refusals().at(0);
  EXPECT_EQ(count.source, "b?b??");
  EXPECT_EQ(count.vehicle.size(), 200U);
  EXPECT_LE(count.last_text.size(), 1000U);
  ASSERT_FALSE(served.say(odd, ahead));
  served.run->step();
  EXPECT_EQ(served.run->commands_taken()[0].source, "b?b??");
}

TEST(CommandArbiter, CountsOfEndlesslyManySourcesDoNotGrowWithoutEnd) {
  Served served;
  ASSERT_FALSE(served.arbiter.ask("ann", 0, 0));
  for (int i = 0; i < 3000; ++i) EXPECT_TRUE(served.say("bob" + std::to_string(i), ahead));
  const auto counts = served.arbiter.refusals();
  EXPECT_EQ(counts.size(), CommandArbiter::most_counts + 1);
  EXPECT_EQ(counts.back().source, "others");
  EXPECT_EQ(counts.back().count, 3000 - CommandArbiter::most_counts);
}

TEST(CommandArbiter, NoCommandOfAnyoneButTheHolderIsTakenWhoeverSaysWhatWhen) {
  // Random doings of three clients between steps; who held the vehicle when is kept beside it.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed, "steward_test");
    Served served;
    const std::string clients[] = {"ann", "bob", "eve"};
    std::vector<std::string> holders;
    for (int i = 0; i < 200; ++i) {
      for (int k = 0; k < 3; ++k) {
        const std::string& client = clients[rng.bits() % 3];
        const std::string before = served.arbiter.holder(0);
        const double now_s = served.arbiter.time_s();
        const bool is_allowed = before.empty() || before == client;
        switch (rng.bits() % 8) {
          case 0:
            ASSERT_EQ(served.say(client, near).has_value(), !is_allowed);
            if (is_allowed) holders.push_back(client);
            break;
          case 1:
            ASSERT_EQ(served.say(client, twin::Resume{}).has_value(), !is_allowed);
            if (is_allowed) holders.push_back(client);
            break;
          case 2:
            ASSERT_EQ(served.arbiter.release(client, 0, now_s).has_value(), before != client);
            break;
          case 3:
            ASSERT_EQ(served.arbiter.ask(client, 0, now_s).has_value(), !is_allowed);
            break;
          case 4:
            served.arbiter.lost(client, now_s);
            break;
          default:
            ASSERT_EQ(served.say(client, ahead).has_value(), !is_allowed);
            if (is_allowed) holders.push_back(client);
        }
      }
      served.run->step();
    }
    std::vector<std::string> sources;
    for (const Command& command : served.run->commands_taken()) {
      const auto* hold = std::get_if<twin::HoldHere>(&command.what);
      if (hold == nullptr || !hold->is_client_lost) sources.push_back(command.source);
    }
    EXPECT_EQ(sources, holders);
  }
}

TEST(CommandArbiter, TakesCommandsFromManyThreads) {
  Served served;
  std::atomic<bool> is_over = false;
  std::atomic<std::uint64_t> accepted = 0;
  std::vector<std::thread> people;
  for (int p = 0; p < 3; ++p)
    people.emplace_back([&, p] {
      const std::string client = "client " + std::to_string(p);
      for (std::uint64_t n = 1; !is_over; ++n) {
        const double now_s = served.arbiter.time_s();
        if (!served.arbiter.submit(client, {0, 0, ahead, "", n, now_s}, now_s)) ++accepted;
        if (n % 50 == 0) (void)served.arbiter.release(client, 0, now_s);
        std::this_thread::sleep_for(std::chrono::microseconds(100));
      }
    });
  while (accepted == 0) std::this_thread::yield();
  for (int i = 0; i < 300; ++i) served.run->step();
  is_over = true;
  for (std::thread& thread : people) thread.join();
  served.run->step();
  std::uint64_t velocities = 0;
  for (const Command& command : served.run->commands_taken())
    velocities += std::holds_alternative<twin::SetVelocity>(command.what) ? 1 : 0;
  EXPECT_EQ(velocities, accepted);
}

}  // namespace
}  // namespace slackwater::tests::command_arbiter_test
