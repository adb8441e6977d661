// A run of `slackwater live` ends while clients wait for it.
#include <gtest/gtest.h>

#include <future>

#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/dds/without_leaks.h"
#include "tests/api/door/live/live_records.h"
#include "tests/strangers/live/services.h"
#include "tests/support/started_program.h"

namespace slackwater::tests::end_of_run_test {
namespace {

using namespace std::chrono_literals;

constexpr double at_most_s = 60;  // of what the end of the run would have to answer

class EndOfRun : public testing::Test {
 protected:
  /// Whether it was paused, and does not move on by itself any more.
  bool pauses() {
    const auto reply = pause_.call({}, 40);
    return reply && reply->success();
  }
  /// With everything that was asked of it on its way.
  int end() {
    std::this_thread::sleep_for(1s);
    return run_.end(SIGINT);
  }
  /// The answer to what is asked on a thread of its own, there within seconds of the end.
  template <typename Reply>
  Reply in_time(std::future<Reply>& reply) {
    if (reply.wait_for(5s) == std::future_status::ready) return reply.get();
    ADD_FAILURE() << "still waiting after the end of the run";
    return {};
  }

  OwnDomain domain_;
  StartedProgram run_{
      start_program({"live", live_scenario(), "--dds-domain", std::to_string(domain_.number())},
                    without_leaks(), "/dev/null", "/dev/null")};
  peer::Node node_{domain_.number()};
  // All from the start: who is new to a service may have to ask it twice.
  peer::Trigger pause_{node_, "/slackwater/pause"};
  peer::Step step_{node_, "/slackwater/step"};
  peer::Spawn spawn_{node_, "/slackwater/spawn"};
  peer::SendGoal send_goal_{node_, "/rov/navigate/_action/send_goal"};
  peer::GetResult get_result_{node_, "/rov/navigate/_action/get_result"};
};

TEST_F(EndOfRun, AbortsTheGoalAndRefusesWhoHasNotJoined) {
  slackwater_msgs::action::Navigate_SendGoal_Request goal;
  goal.goal_id().uuid()[0] = 1;
  geometry_msgs::msg::PoseStamped place;
  place.pose().position().x(20);
  place.pose().position().y(-25);
  place.pose().position().z(-8);
  goal.goal().path().poses().push_back(place);
  const auto sent = send_goal_.call(goal, 40);
  ASSERT_TRUE(sent && sent->accepted());
  ASSERT_TRUE(pauses());
  auto result = std::async(std::launch::async, [&] {
    slackwater_msgs::action::Navigate_GetResult_Request asked;
    asked.goal_id(goal.goal_id());
    return get_result_.call(asked, at_most_s);
  });
  auto joined = std::async(std::launch::async, [&] {
    slackwater_msgs::srv::Spawn_Request asked;
    asked.model("bluerov2_heavy");
    asked.name("late");
    asked.pose().pose().position().y(40);
    asked.pose().pose().position().z(-5);
    asked.pose().pose().orientation().w(1);
    return spawn_.call(asked, at_most_s);
  });
  EXPECT_EQ(end(), 0);
  const auto aborted = in_time(result);
  ASSERT_TRUE(aborted);
  EXPECT_EQ(aborted->status(), 6) << "action_msgs: aborted";
  EXPECT_EQ(aborted->result().message(), "the run is over");
  const auto refused = in_time(joined);
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->success());
  EXPECT_EQ(refused->message(), "the run ended before late joined it");
}

TEST_F(EndOfRun, SaysOfStepsThatTheyWereNotMade) {
  ASSERT_TRUE(pauses());
  auto made = std::async(std::launch::async, [&] {
    slackwater_msgs::srv::Step_Request asked;
    asked.steps(1'000'000);
    return step_.call(asked, at_most_s);
  });
  EXPECT_EQ(end(), 0);
  const auto reply = in_time(made);
  ASSERT_TRUE(reply);
  EXPECT_FALSE(reply->success());
}

}  // namespace
}  // namespace slackwater::tests::end_of_run_test
