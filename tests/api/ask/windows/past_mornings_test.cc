// Chances are calibrated on the mornings that the store holds, and on nothing that was not a
// forecast then.
#include "api/pipeline/past_mornings.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "api/ask/windows/windows.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "tests/support/farm_for_tests.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::past_mornings_test {
namespace {

using namespace slackwater::api;
using std::chrono::days;

const UtcDay first = parse_day("2025-03-01");

class PastMornings : public testing::Test {
 protected:
  /// A week of products, a forecast each morning from the third day on.
  static void SetUpTestSuite() {
    made_ = std::make_unique<StoreForTests>();
    made_->ingest_days(first, 7);
    made_->write("farm.yaml", farm_at_the_site(*made_));
    std::ifstream in(source_folder() / "data/tasks/scour_survey.yaml");
    std::string sheet{std::istreambuf_iterator<char>(in), {}};
    // Of its limits that on the waves alone, near the sea of the test products.
    std::string waves, line;
    std::istringstream lines(sheet);
    while (std::getline(lines, line))
      if (line.find("        - {current_speed") == std::string::npos &&
          line.find("        - {wind_speed") == std::string::npos &&
          line.find("        - {least_water") == std::string::npos)
        waves += line + "\n";
    made_->write("waves.yaml", waves);
    for (int d = 2; d <= 6; ++d) issue(first + days(d), first + days(d + 1));
  }
  static void TearDownTestSuite() { made_.reset(); }

  static void issue(UtcDay day, UtcDay morning) {
    const ProgramResult issued =
        made_->run({"forecast", "--site", made_->path("farm.yaml"), "--day", format_day(day),
                    "--at", format_day(morning) + "T05:00:00Z", "--wind", "persist"});
    ASSERT_EQ(issued.exit_code, 0) << issued.err;
  }
  static TaskWindows windows_on(UtcDay day) {
    WindowsQuestion question;
    question.site = made_->path("farm.yaml");
    question.day = day;
    question.tasks = {made_->path("waves.yaml")};
    question.practice = AlphaPractice::of_tables({});
    return windows_of(question, made_->store()).tasks.front();
  }

  inline static std::unique_ptr<StoreForTests> made_;
};

TEST_F(PastMornings, AreThoseWhoseDayHasEnded) {
  // Of D = 7 March: the forecasts of 3, 4 and 5 speak of 5, 6 and 7 March, that of 6 of the 8th.
  const TaskWindows last = windows_on(first + days(6));
  EXPECT_EQ(last.calibration.mornings, 3U);
  EXPECT_GT(last.calibration.starts, 100U);
  EXPECT_EQ(last.past.mornings, 3U);
  EXPECT_EQ(windows_on(first + days(2)).calibration.mornings, 0U) << "nothing came before it";
  EXPECT_EQ(windows_on(first + days(4)).calibration.mornings, 1U);
}

// The sea of the products is a formula: which starts held is known without any of our code.
TEST_F(PastMornings, KnowWhatCame) {
  const TaskWindows last = windows_on(first + days(6));
  const double held_for_s = last.planned_s + last.contingency_s;
  std::size_t starts = 0, held = 0;
  for (int d = 2; d <= 4; ++d) {
    const UtcTime midnight = UtcTime(first + days(d + 2));
    for (int s = 0; s < 48; ++s) {
      const UtcTime start = midnight + std::chrono::minutes(30 * s);
      const UtcTime end =
          start + std::chrono::round<Duration>(std::chrono::duration<double>(held_for_s));
      // Products end an hour before the midnight of their last day.
      if (end > UtcTime(first + days(7)) - std::chrono::hours(1)) continue;
      bool holds = true;
      for (UtcTime time = start; time <= end; time += std::chrono::minutes(10))
        holds &= WaterForTests::significant_height_m({time, 0, WaterForTests::site_latitude_deg,
                                                      WaterForTests::site_longitude_deg}) <= 1.5;
      ++starts;
      held += holds ? 1 : 0;
    }
  }
  EXPECT_EQ(last.calibration.starts, starts);
  ASSERT_GT(held, 10U);
  ASSERT_LT(held, starts - 10);
  // Steps of ten minutes, lines between hours: a start or two on the edge may be told otherwise.
  EXPECT_NEAR(last.calibration.held * static_cast<double>(starts), static_cast<double>(held), 4);
}

TEST_F(PastMornings, CorrectWhatTheFuturesSay) {
  const TaskWindows last = windows_on(first + days(6));
  ASSERT_NE(last.calibration.shift, 0);
  for (const TaskStart& start : last.starts)
    EXPECT_EQ(start.probability, last.calibration(start.by_futures));
  WindowsQuestion question;
  question.site = made_->path("farm.yaml");
  question.tasks = {made_->path("waves.yaml")};
  question.chances_as_futures_say = true;
  const TaskWindows plain = windows_of(question, made_->store()).tasks.front();
  EXPECT_EQ(plain.calibration.mornings, 0U);
  for (std::size_t s = 0; s < plain.starts.size(); ++s) {
    EXPECT_EQ(plain.starts[s].probability, plain.starts[s].by_futures);
    EXPECT_EQ(plain.starts[s].by_futures, last.starts[s].by_futures);
  }
}

// A day that is forecast when it is over is no forecast of it, though nothing in it is hindsight.
TEST_F(PastMornings, OfWhatWasIssuedAfterTheDayAreNone) {
  const std::size_t before = windows_on(first + days(6)).calibration.mornings;
  issue(first + days(1), first + days(7));  // speaks of the 4th, issued on the 8th
  const TaskWindows last = windows_on(first + days(6));
  EXPECT_EQ(last.calibration.mornings, before);
}

// A file that cannot be read takes its own morning, and no other.
TEST_F(PastMornings, AreReadWithoutThoseThatAreDamaged) {
  const Site site = find_site(made_->path("farm.yaml"), {});
  store::Store store = store::Store::open(made_->store(), store::OpenMode::read_only);
  std::filesystem::path broken;
  Snapshot last;
  for (const store::ForecastRow& row : store.list_forecasts()) {
    if (row.day == first + days(3)) broken = store.content_path(row.content_sha256);
    if (row.day == first + days(6))
      last = ingest::read_forecast(store.proven_content(row.content_sha256));
  }
  const std::size_t all = past_mornings(made_->store(), site, last, 1).size();
  ASSERT_GE(all, 3U);
  const std::string bytes = read_bytes(broken);
  write_bytes(broken, bytes.substr(0, bytes.size() / 2));
  EXPECT_EQ(past_mornings(made_->store(), site, last, 1).size(), all - 1);
  write_bytes(broken, bytes);
}

}  // namespace
}  // namespace slackwater::tests::past_mornings_test
