// Whose helm it was and what it did, told from the record and the commands of a log.
#include "api/door/people/playback/helm_story.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/api/door/people/playback/log_for_tests.h"

namespace slackwater::tests::helm_story_test {
namespace {

struct HelmStory : testing::Test {
  std::vector<people::Action> actions;
  std::vector<twin::Command> commands;
  void order(double time_s, twin::CommandWhat what) {
    twin::Command command;
    command.step = static_cast<std::uint64_t>(std::llround(time_s / 0.05));
    command.what = std::move(what);
    commands.push_back(command);
  }
  void does(double time_s, unsigned seat, const std::string& what, const std::string& before,
            const std::string& after) {
    actions.push_back(logged_action(actions.size() + 1, time_s, seat, what, before, after));
  }
  [[nodiscard]] people::LoggedHelm at(double time_s) const {
    people::LoggedHelm found;
    for (const auto& helm :
         people::helm_story({0, "first", {1, 60}, 1000}, actions, commands, 0.05))
      if (helm.from_s <= time_s) found = helm;
    return found;
  }
};

TEST_F(HelmStory, OfNobodyIsTheVehiclesOwn) {
  EXPECT_EQ(at(500).mode, twin::HelmMode::own);
  EXPECT_EQ(at(500).phase, people::HelmPhase::free);
}

TEST_F(HelmStory, ThatIsNotRenewedHoldsAndThenGoesHome) {
  for (int i = 0; i < 10; ++i) order(10 + 0.1 * i, twin::SetVelocity{});
  EXPECT_EQ(at(9.9).mode, twin::HelmMode::own);
  EXPECT_EQ(at(11.8).mode, twin::HelmMode::velocity) << "1 s after the last one at 10.9 s";
  EXPECT_EQ(at(12).mode, twin::HelmMode::hold);
  EXPECT_EQ(at(12).cause, twin::HelmCause::not_renewed);
  EXPECT_EQ(at(71.8).mode, twin::HelmMode::hold);
  EXPECT_EQ(at(72).mode, twin::HelmMode::home);
  EXPECT_EQ(at(72).cause, twin::HelmCause::held_too_long);
}

TEST_F(HelmStory, ThatIsToldToHoldStaysAndResumes) {
  order(10, twin::HoldHere{});
  order(300, twin::Resume{});
  EXPECT_EQ(at(299).mode, twin::HelmMode::hold);
  EXPECT_EQ(at(300).mode, twin::HelmMode::own);
}

TEST_F(HelmStory, PassesFromHandToHand) {
  does(1, 1, "ask", "free", "held");
  does(5, 2, "ask", "held", "requested");
  EXPECT_EQ(at(6).holder, "Ann");
  EXPECT_EQ(at(6).asker, "Sue");
  does(8, 1, "deny", "requested", "held");
  EXPECT_EQ(at(8).asker, "");
  does(9, 2, "hold", "held", "hold");
  EXPECT_EQ(at(9).holder, "Sue") << "a supervisor's HOLD takes the helm";
  does(12, 2, "give_back", "held", "free");
  EXPECT_EQ(at(12).phase, people::HelmPhase::free);
  EXPECT_EQ(at(8.5).holder, "Ann") << "what comes later changes nothing of what was";
}

TEST_F(HelmStory, ForgetsNobodyWhoseLinkWasDown) {
  does(1, 1, "ask", "free", "held");
  does(5, 1, "cut_off", "", "cut off");
  actions.back().vehicle.clear();
  EXPECT_EQ(at(5).phase, people::HelmPhase::lost);
  EXPECT_EQ(at(5).holder, "Ann");
  does(9, 1, "come_back", "", "back");
  actions.back().vehicle.clear();
  EXPECT_EQ(at(9).phase, people::HelmPhase::held);
  does(20, 1, "leave", "", "left");
  actions.back().vehicle.clear();
  EXPECT_EQ(at(20).phase, people::HelmPhase::free);
}

TEST_F(HelmStory, TakesNoNoticeOfWhatWasRefused) {
  does(1, 1, "ask", "free", "held");
  does(2, 2, "take_back", "held", "held by the supervisor: so");
  actions.back().is_taken = false;
  EXPECT_EQ(at(3).holder, "Ann");
}

}  // namespace
}  // namespace slackwater::tests::helm_story_test
