// The hours that are left of the day of the issue: people decide at half past five, for today.
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "api/show/morning/gantt_html.h"
#include "api/show/morning/morning_json.h"
#include "api/show/morning/morning_text.h"
#include "tests/support/contains.h"
#include "tests/support/farm_for_tests.h"

namespace slackwater::tests::today_test {
namespace {

using namespace slackwater::api;

class Today : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<StoreForTests>();
    made_->ingest_days(parse_day("2025-03-01"), 3);
    made_->write("farm.yaml", farm_at_the_site(*made_));
    const ProgramResult issued = made_->run(
        {"forecast", "--site", made_->path("farm.yaml"), "--at", "2025-03-04T05:10:00Z"});
    ASSERT_EQ(issued.exit_code, 0) << issued.err;
  }
  static void TearDownTestSuite() { made_.reset(); }

  static MorningQuestion question() {
    MorningQuestion question;
    question.windows.site = made_->path("farm.yaml");
    question.windows.tasks = {"scour_survey", "access_window"};
    question.windows.practice = AlphaPractice::of_tables({});
    return question;
  }

  inline static std::unique_ptr<StoreForTests> made_;
};

TEST_F(Today, AreTheHoursFromTheIssueToMidnight) {
  const Morning morning = morning_of(question(), made_->store());
  ASSERT_TRUE(morning.today);
  EXPECT_EQ(format_utc(morning.today->from), "2025-03-04T05:30:00Z") << "no start is in the past";
  EXPECT_EQ(format_utc(morning.today->to), "2025-03-05T00:00:00Z");
  EXPECT_EQ(morning.today->to, morning.windows.from) << "tomorrow goes on from there";
  for (const TaskWindows& task : morning.today->tasks) {
    ASSERT_FALSE(task.starts.empty());
    EXPECT_EQ(task.starts.front().start, morning.today->from);
  }
  // What they say is what is said to who asks for these hours.
  WindowsQuestion asked = question().windows;
  asked.from = morning.today->from;
  asked.to = morning.today->to;
  const WindowsAnswer same = windows_of(asked, made_->store());
  ASSERT_EQ(same.tasks.size(), morning.today->tasks.size());
  for (std::size_t i = 0; i < same.tasks.size(); ++i)
    for (std::size_t s = 0; s < same.tasks[i].starts.size(); ++s)
      EXPECT_EQ(same.tasks[i].starts[s].probability, morning.today->tasks[i].starts[s].probability);
}

TEST_F(Today, StandBeforeTomorrowWhereverItIsTold) {
  const Morning morning = morning_of(question(), made_->store());
  const std::string text = morning_text(morning);
  EXPECT_EQ(text.rfind("Today: ", 0), 0U) << text;
  EXPECT_LT(text.find("Tue 4 Mar 05:30"), text.find("on Wed 5 Mar")) << text;
  EXPECT_TRUE(contains(gantt_today_html(morning), "gantt-today"));
  const auto json = morning_json(morning, {}, "");
  EXPECT_EQ(json.at("today").at("from"), "2025-03-04T05:30:00Z");
  EXPECT_EQ(json.at("today").at("tasks").size(), 2U);
}

/// Nothing newer was issued since: what was tomorrow is today.
TEST_F(Today, AreOfTheDayThatIsToldOnceItHasCome) {
  MorningQuestion asked = question();
  asked.now = parse_utc("2025-03-05T05:10:00Z");
  const Morning morning = morning_of(asked, made_->store());
  ASSERT_TRUE(morning.today);
  EXPECT_EQ(format_utc(morning.today->from), "2025-03-05T05:30:00Z") << "no start is in the past";
  EXPECT_EQ(morning.today->to, morning.windows.to);
  EXPECT_EQ(format_utc(morning.windows.from), "2025-03-05T00:00:00Z");
  for (const char* none :
       {"2025-03-04T23:45:00Z", "2025-03-05T23:45:00Z", "2025-03-06T05:10:00Z"}) {
    asked.now = parse_utc(none);
    EXPECT_FALSE(morning_of(asked, made_->store()).today) << none;
  }
}

TEST_F(Today, AreNotAddedToHoursThatWereAskedFor) {
  MorningQuestion asked = question();
  asked.windows.from = parse_utc("2025-03-05T06:00:00Z");
  const Morning morning = morning_of(asked, made_->store());
  EXPECT_FALSE(morning.today);
  EXPECT_EQ(gantt_today_html(morning), "");
  EXPECT_EQ(morning_text(morning).rfind("Today", 0), std::string::npos);
  EXPECT_TRUE(morning_json(morning, {}, "").at("today").is_null());
}

}  // namespace
}  // namespace slackwater::tests::today_test
