// A site of which only the waves are known: what rests on waves is answered, what rests on more is
// refused by its name.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "api/ask/windows/windows.h"
#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/farm_for_tests.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::waves_alone_test {
namespace {

using namespace slackwater::api;

TEST(WavesAlone, AnswerATaskOfWavesAndNoOther) {
  const StoreForTests made;
  made.ingest(write_product(made.file("waves.nc"), wave_product(parse_day("2025-03-01"), 48)));
  made.write("farm.yaml", farm_at_the_site(made));
  std::ifstream in(source_folder() / "data/tasks/scour_survey.yaml");
  std::string waves;
  for (std::string line; std::getline(in, line);)
    if (!contains(line, "- {current_speed") && !contains(line, "- {wind_speed") &&
        !contains(line, "- {least_water"))
      waves += line + "\n";
  made.write("waves.yaml", waves);
  const ProgramResult issued = made.run({"forecast", "--site", made.path("farm.yaml"), "--day",
                                         "2025-03-02", "--at", "2025-03-03T05:00:00Z"});
  ASSERT_EQ(issued.exit_code, 0) << issued.err;
  WindowsQuestion question;
  question.site = made.path("farm.yaml");
  question.tasks = {made.path("waves.yaml")};
  question.practice = AlphaPractice::of_tables({});
  const TaskWindows answer = windows_of(question, made.store()).tasks.front();
  ASSERT_FALSE(answer.starts.empty());
  for (const TaskStart& start : answer.starts) {
    EXPECT_GT(start.probability, 0.01) << "the sea kept is near the limit, not far above it";
    EXPECT_LT(start.worth, question.rule.go) << "nobody forecast it";
  }
  question.tasks = {"scour_survey"};
  try {
    (void)windows_of(question, made.store());
    ADD_FAILURE() << "a limit on the current was answered without currents";
  } catch (const Error& refused) {
    EXPECT_EQ(refused.kind(), ErrorKind::invalid_input);
    EXPECT_TRUE(contains(refused.message(), "current at most") ||
                contains(refused.message(), "wind at 10 m at most"))
        << refused.message();
    EXPECT_TRUE(contains(refused.message(), "if_missing: not_checked")) << refused.message();
  }
}

}  // namespace
}  // namespace slackwater::tests::waves_alone_test
