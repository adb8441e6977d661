// What is said of a task below its row, and what is drawn in it.
#include "api/show/morning/task_words.h"

#include <gtest/gtest.h>

#include "api/show/morning/gantt_html.h"
#include "tests/support/contains.h"

namespace slackwater::tests::task_words_test {
namespace {

using namespace slackwater::api;

/// A task planned for three hours, flown from its one start.
Morning morning_with(double flown_s, std::size_t done, std::size_t flights) {
  Morning morning;
  morning.windows.from = parse_utc("2025-03-05T00:00:00Z");
  morning.windows.to = morning.windows.from + std::chrono::hours(24);
  TaskWindows task;
  task.name = "Anodes";
  task.planned_s = 3 * 3600;
  TaskStart start;
  start.start = morning.windows.from + std::chrono::hours(8);
  start.probability = start.worth = 0.4;
  start.interval = {0.2, 0.6};
  TwinChance twin;
  twin.flights = flights;
  twin.probability = static_cast<double>(done) / static_cast<double>(flights);
  twin.interval = twin::success_interval(done, flights);
  twin.p_done = {done, flights, twin.interval.low, twin.interval.high};
  twin.duration_s.assign(done, flown_s);
  start.twin = twin;
  task.starts.push_back(start);
  morning.windows.tasks.push_back(task);
  return morning;
}

std::string words_of(const Morning& morning) {
  std::string all;
  for (const std::string& line : task_words(morning, morning.windows.tasks.front()))
    all += line + "\n";
  return all;
}

TEST(TaskWords, SayWhereFlightsAndSheetAreAboutDifferentTimes) {
  const std::string shorter = words_of(morning_with(23 * 60, 24, 25));
  EXPECT_TRUE(contains(shorter, "24 of 25 done")) << shorter;
  EXPECT_TRUE(contains(shorter, "23 min (8 in 10: 23 to 23)")) << shorter;
  EXPECT_TRUE(contains(shorter,
                       "shorter than the 3.0 h that the sheet plans: the chance above is "
                       "for all of these, the flights are of the mission alone"))
      << shorter;
  const std::string as_long = words_of(morning_with(2.5 * 3600, 24, 25));
  EXPECT_FALSE(contains(as_long, "shorter than")) << as_long;
}

TEST(TaskWords, SayDoneAndSeenApart) {
  Morning morning = morning_with(23 * 60, 24, 25);
  TwinChance& twin = *morning.windows.tasks.front().starts.front().twin;
  twin.p_seen = FlightCount{3, 25, 0.02, 0.3};
  twin.probability = 3.0 / 25;
  twin.interval = {0.02, 0.3};
  const std::string words = words_of(morning);
  EXPECT_TRUE(contains(words, "24 of 25 done, 3 seen as asked (95 % interval of both 2 to 30 %)"))
      << words;
}

TEST(TaskWords, TheLineOfARingIsAsLongAsItsFlightsLeaveOpen) {
  const auto height_of_line = [](std::size_t flights) {
    const std::string html = gantt_html(morning_with(3600, flights, flights));
    const std::size_t line = html.find("class=\"open\"");
    if (line == std::string::npos) return -1.0;
    return std::stod(html.substr(html.find("height:", line) + 7));
  };
  EXPECT_GT(height_of_line(1), 80) << "one of one: anything from a few per cent on";
  EXPECT_GT(height_of_line(5), height_of_line(25));
  EXPECT_GT(height_of_line(25), height_of_line(100));
  EXPECT_GE(height_of_line(100), 1);
  EXPECT_LT(height_of_line(100), 12);
}

}  // namespace
}  // namespace slackwater::tests::task_words_test
