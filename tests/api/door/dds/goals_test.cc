// Goals of the navigation action of `slackwater live`, whenever they come.
#include <gtest/gtest.h>

#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/dds/without_leaks.h"
#include "tests/api/door/live/live_records.h"
#include "tests/strangers/live/services.h"
#include "tests/support/started_program.h"

namespace slackwater::tests::goals_test {
namespace {

using namespace std::chrono_literals;

// Twenty times as fast as the clock, steps are under way much of the time: what is accepted then is
// in force with the next, and not over by what the vehicle did before.
TEST(Goals, AcceptedInTheMiddleOfAStepGoOn) {
  const OwnDomain domain;
  StartedProgram run(start_program({"live", live_scenario(), "--dds-domain",
                                    std::to_string(domain.number()), "--real-time-factor", "20"},
                                   without_leaks()));
  peer::Node node(domain.number());
  const std::string action = "/rov/navigate/_action/";
  peer::SendGoal send_goal(node, action + "send_goal");
  peer::CancelGoal cancel_goal(node, action + "cancel_goal");
  for (std::uint8_t i = 1; i <= 30; ++i) {
    slackwater_msgs::action::Navigate_SendGoal_Request goal;
    goal.goal_id().uuid()[0] = i;
    geometry_msgs::msg::PoseStamped place;
    place.pose().position().x(i % 2 == 0 ? 40 : -60);
    place.pose().position().y(-40);
    place.pose().position().z(-8);
    goal.goal().path().poses().push_back(place);
    const auto sent = send_goal.call(goal, 40);
    ASSERT_TRUE(sent && sent->accepted()) << int{i};
    std::this_thread::sleep_for(20ms);  // some steps
    action_msgs::srv::CancelGoal_Request cancel;
    cancel.goal_info().goal_id(goal.goal_id());
    const auto cancelled = cancel_goal.call(cancel);
    ASSERT_TRUE(cancelled);
    EXPECT_EQ(cancelled->return_code(), 0) << int{i} << ": over before it was cancelled";
  }
  EXPECT_EQ(run.end(SIGINT), 0);
}

}  // namespace
}  // namespace slackwater::tests::goals_test
