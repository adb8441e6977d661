// Who may pause a run, step it and let vehicles join.
#include "twin/helm/run_authority.h"

#include <gtest/gtest.h>

#include "tests/twin/run/helm_for_tests.h"
#include "twin/helm/command_arbiter.h"

namespace slackwater::tests::run_authority_test {
namespace {

using twin::RefusalReason;
using twin::RunAuthority;

TEST(RunAuthority, IsGotByAskingAndWhileNobodyIsHeldUpByTheFirstPause) {
  RunAuthority authority;
  EXPECT_EQ(authority.holder(), "");
  EXPECT_FALSE(authority.claim("ann", "", 0));
  EXPECT_EQ(authority.holder(), "ann");
  EXPECT_FALSE(authority.claim("ann", "rov is held by bob", 1)) << "who has it may, whoever drives";
  const auto refused = authority.claim("bob", "", 1);
  ASSERT_TRUE(refused);
  EXPECT_EQ(*refused,
            "the run is held by ann; one client at a time commands it; ask for it when that client "
            "has given it back");
  EXPECT_TRUE(authority.ask("bob", 1));
  EXPECT_TRUE(authority.release("bob", 1));
  EXPECT_FALSE(authority.release("ann", 2));
  EXPECT_FALSE(authority.ask("bob", 2));
  EXPECT_EQ(authority.holder(), "bob");
}

TEST(RunAuthority, WhoCommandsAVehicleIsNotPausedByAStrangerWhoDidNotAsk) {
  RunAuthority authority;
  const auto refused = authority.claim("ann", "rov is held by bob", 0);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->find("rov is held by bob, and nobody has the run: ask for the run"), 0U);
  EXPECT_EQ(authority.holder(), "") << "to be refused is no way to get it";
  EXPECT_FALSE(authority.ask("ann", 0));
  EXPECT_FALSE(authority.claim("ann", "rov is held by bob", 0));
}

TEST(RunAuthority, IsKeptUntilItsHolderIsGoneOrLetsAnotherTakeIt) {
  RunAuthority authority;
  ASSERT_FALSE(authority.ask("ann", 0));
  EXPECT_TRUE(authority.ask("bob", 10'000)) << "time does not take it";
  ASSERT_FALSE(authority.allow_take_over("ann", 10'000));
  EXPECT_FALSE(authority.ask("bob", 10'005));
  EXPECT_EQ(authority.holder(), "bob");
  authority.lost("ann", 10'006);
  EXPECT_EQ(authority.holder(), "bob");
  authority.lost("bob", 10'006);
  EXPECT_EQ(authority.holder(), "");
}

/// A run with one ROV.
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

  std::optional<twin::Refusal> spawn(const std::string& name, const std::string& client) {
    return arbiter.spawn(client, {"bluerov2_heavy", name, {30, 0, 15}, 0}, newcomer_yard,
                         arbiter.time_s());
  }
};

TEST(RunAuthority, OfARunIsAskedByWhoLetsVehiclesJoin) {
  Served served;
  ASSERT_FALSE(served.arbiter.ask("bob", 0, 0));
  const auto refused = served.spawn("late", "ann");
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->reason, RefusalReason::unauthorised);
  EXPECT_EQ(refused->text.find("bluerov2_heavy is held by bob, and nobody"), 0U) << refused->text;
  EXPECT_FALSE(served.spawn("his", "bob")) << "who drives holds nobody else up";
  EXPECT_EQ(served.arbiter.run_holder(), "bob");
  EXPECT_TRUE(served.spawn("late", "ann"));
  EXPECT_TRUE(served.arbiter.claim_run("ann", 0));
  served.run->step();
  ASSERT_EQ(served.run->agents().size(), 2U);
  served.arbiter.lost("bob", served.arbiter.time_s());
  EXPECT_FALSE(served.spawn("late", "ann"));
  EXPECT_EQ(served.arbiter.run_holder(), "ann");
}

// An agent that is taken off one vehicle goes on with its others.
TEST(RunAuthority, OfWhoLosesOneVehicleStaysAndSoDoOtherHelms) {
  Served served;
  ASSERT_FALSE(served.spawn("late", "ann"));
  served.run->step();
  for (const std::size_t vehicle : {0U, 1U}) {
    twin::Command ahead;
    ahead.agent = vehicle;
    ahead.what = twin::SetVelocity{{0.2, 0, 0, 0}};
    ASSERT_FALSE(served.arbiter.ask("ann", vehicle, served.arbiter.time_s()));
    ASSERT_FALSE(served.arbiter.submit("ann", ahead, served.arbiter.time_s()));
  }
  served.run->step();
  served.arbiter.lost("bob", 1, served.arbiter.time_s());
  served.arbiter.lost("ann", 0, served.arbiter.time_s());
  EXPECT_EQ(served.arbiter.holder(0), "");
  EXPECT_EQ(served.arbiter.holder(1), "ann");
  EXPECT_EQ(served.arbiter.run_holder(), "ann");
  served.run->step();
  EXPECT_EQ(served.run->helm(0).cause, twin::HelmCause::client_lost);
  EXPECT_NE(served.run->helm(1).cause, twin::HelmCause::client_lost);
}

TEST(RunAuthority, RefusalsAreCountedOfTheRun) {
  Served served;
  ASSERT_FALSE(served.arbiter.ask_for_run("bob", 0));
  EXPECT_TRUE(served.arbiter.claim_run("ann", 0));
  EXPECT_TRUE(served.arbiter.release_run("ann", 0));
  const auto counts = served.arbiter.refusals();
  ASSERT_EQ(counts.size(), 1U);
  EXPECT_EQ(counts[0].vehicle, "the run");
  EXPECT_EQ(counts[0].count, 2U);
  EXPECT_EQ(counts[0].reason, RefusalReason::unauthorised);
}

}  // namespace
}  // namespace slackwater::tests::run_authority_test
