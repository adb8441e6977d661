// What a start is worth: the chance of its limits, and what its flights leave of it.
#include <gtest/gtest.h>

#include "api/windows/windows.h"

namespace slackwater::tests {
namespace {

api::TaskStart start_of(double probability, std::size_t flights, std::size_t done) {
  api::TaskStart start;
  start.probability = probability;
  if (flights == 0) return start;
  api::TwinChance twin;
  twin.flights = flights;
  twin.probability = static_cast<double>(done) / static_cast<double>(flights);
  start.twin = twin;
  return start;
}

TEST(WorthOf, FlightsThatFailTakeFromAStartThatTheLimitsAllow) {
  EXPECT_DOUBLE_EQ(api::worth_of(start_of(0.96, 0, 0)), 0.96);
  EXPECT_DOUBLE_EQ(api::worth_of(start_of(0.96, 17, 0)), 1.0 / 19);
  EXPECT_DOUBLE_EQ(api::worth_of(start_of(0.96, 25, 12)), 13.0 / 27);
  EXPECT_DOUBLE_EQ(api::worth_of(start_of(0.96, 3, 0)), 0.96) << "too few to say anything";
}

TEST(WorthOf, FlightsThatAreDoneAddNothingToWhatTheLimitsSay) {
  EXPECT_DOUBLE_EQ(api::worth_of(start_of(0.4, 25, 25)), 0.4);
}

TEST(WorthOf, TheBestStartIsTheOneThatIsWorthMost) {
  api::TaskWindows task;
  task.starts = {start_of(0.96, 17, 2), start_of(0.7, 17, 17), start_of(0.7, 0, 0)};
  EXPECT_EQ(api::best_of(task), &task.starts[1]) << "the first of equals";
  task.starts.clear();
  EXPECT_EQ(api::best_of(task), nullptr);
}

}  // namespace
}  // namespace slackwater::tests
