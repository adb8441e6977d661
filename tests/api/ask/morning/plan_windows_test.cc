// A plan takes the windows of a forecast as they are, and reads the forecast once.
#include "api/ask/morning/plan_windows.h"

#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "api/ask/plan/plan_setup.h"
#include "api/door/cli/decide/windows_file.h"
#include "api/show/windows/windows_answer.h"
#include "data/store/layout.h"
#include "tests/support/contains.h"
#include "tests/support/farm_for_tests.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::plan_windows_test {
namespace {

using namespace slackwater::api;

/// Counts how often a file is opened, by this process or another.
class Opens {
 public:
  explicit Opens(const std::filesystem::path& file) {
    // Equal events that follow one another are told once; a closing between them keeps them apart.
    EXPECT_GE(inotify_add_watch(queue_, file.c_str(), IN_OPEN | IN_CLOSE), 0) << file;
  }
  ~Opens() { close(queue_); }
  Opens(const Opens&) = delete;
  Opens& operator=(const Opens&) = delete;

  /// Since it was asked last.
  [[nodiscard]] std::size_t count() const {
    std::size_t opened = 0;
    alignas(inotify_event) std::array<char, 4096> bytes{};
    for (ssize_t read = 0; (read = ::read(queue_, bytes.data(), bytes.size())) > 0;)
      for (ssize_t at = 0; at < read;) {
        inotify_event event{};
        std::memcpy(&event, bytes.data() + at, sizeof event);
        at += static_cast<ssize_t>(sizeof event + event.len);
        opened += (event.mask & IN_OPEN) != 0 ? 1 : 0;
      }
    return opened;
  }

 private:
  int queue_ = inotify_init1(IN_NONBLOCK);
};

class PlanWindows : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<StoreForTests>();
    made_->ingest_days(parse_day("2025-03-01"), 3);
    std::string farm = farm_at_the_site(*made_);
    const std::size_t first = farm.find("{id: T1");
    const std::string one = farm.substr(first, farm.find('}', first) + 1 - first);
    for (const char* id : {"T2", "T3"})
      farm.insert(first, std::string(one).replace(5, 2, id) + ", ");
    made_->write("farm.yaml", farm);
    const ProgramResult issued =
        made_->run({"forecast", "--site", made_->path("farm.yaml"), "--at", "2025-03-04T05:00:00Z",
                    "--out", made_->path("issued.nc")});
    ASSERT_EQ(issued.exit_code, 0) << issued.err;
  }
  static void TearDownTestSuite() { made_.reset(); }

  static PlanFile plan(const std::string& turbines) {
    return load_plan_file(
        made_->write("plan.yaml",
                     "name: Looks\nsite: farm.yaml\ngrid: 1h\n"
                     "vessels:\n  - {id: ctv1, crews: 1, speed_kn: 20, hours: 00:00-24:00}\n"
                     "crews:\n  - {id: blue, skills: [], shift: 00:00-24:00, vessel: ctv1}\n"
                     "vehicles:\n  - {id: rov1, kind: rov, vessel: ctv1}\n"
                     "tasks:\n  - {task: scour_survey, turbines: [" +
                         turbines + "], vehicles: [rov]}\n"),
        made_->store());
  }
  static WindowsQuestion question() {
    WindowsQuestion question;
    question.practice = AlphaPractice::of_tables({});
    return question;
  }
  static std::vector<DayChances::Task> tasks(const WindowsQuestion& question,
                                             const std::string& turbines) {
    return windows_for_plan(plan(turbines), question, made_->store()).tasks;
  }
  /// How often the store is opened for a plan of these turbines.
  static std::size_t opens_for(const WindowsQuestion& question, const std::string& turbines) {
    const Opens opens(store::catalogue_file(made_->store()));
    EXPECT_FALSE(tasks(question, turbines).empty());
    return opens.count();
  }

  inline static std::unique_ptr<StoreForTests> made_;
};

TEST_F(PlanWindows, AreThoseOfTheFileThatTellsThem) {
  WindowsQuestion asked = question();
  asked.site = made_->path("farm.yaml");
  asked.every = std::chrono::hours(1);
  asked.tasks = {"scour_survey"};
  for (const char* turbine : {"T1", "T3"}) {
    asked.turbines = {turbine};
    const WindowsAnswer answer = windows_of(asked, made_->store());
    const DayChances file = parse_windows(windows_json(asked, answer).dump(), "windows.json");
    EXPECT_EQ(tasks(question(), turbine), file.tasks) << turbine;
    const DayChances own = windows_for_plan(plan(turbine), question(), made_->store());
    EXPECT_EQ(own.site, file.site);
    EXPECT_EQ(own.day, file.day);
  }
}

TEST_F(PlanWindows, SayToABitWhatEachTurbineHasByItself) {
  const std::vector<DayChances::Task> both = tasks(question(), "T1, T2");
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both.front(), tasks(question(), "T1").front());
  EXPECT_EQ(both.back(), tasks(question(), "T2").front());
}

TEST_F(PlanWindows, OpenTheStoreOnceForManyTurbines) {
  const std::size_t one = opens_for(question(), "T1");
  ASSERT_GT(one, 0U) << "an opening is not seen";
  EXPECT_EQ(opens_for(question(), "T1, T2, T3"), one);
}

TEST_F(PlanWindows, NeedNoStoreWhereTheWaterIsAtHand) {
  WindowsQuestion asked = question();
  asked.site = made_->path("farm.yaml");
  asked.tasks = {"scour_survey"};
  const WindowsAnswer known = windows_of(asked, made_->store());
  asked.water = known.water;
  asked.past = known.past;
  EXPECT_EQ(opens_for(asked, "T1, T2"), 0U);
  EXPECT_EQ(tasks(asked, "T1, T2"), tasks(question(), "T1, T2"));
}

/// One job that cannot be worked out, a limit on what nobody forecasts, takes nothing from others.
TEST_F(PlanWindows, LeaveOutAJobThatCannotBeWorkedOut) {
  std::ifstream in(source_folder() / "data/tasks/scour_survey.yaml");
  std::string sheet{std::istreambuf_iterator<char>(in), {}};
  sheet.insert(sheet.find("- {significant_wave_height_m"),
               "- {least_visibility_m: 500, source: ours, status: estimate}\n        ");
  const std::string foggy = made_->write("foggy.yaml", sheet);
  PlanFile file = plan("T1");
  file.work.push_back(file.work.front());
  file.work.back().task = foggy;
  const DayChances chances = windows_for_plan(file, question(), made_->store());
  ASSERT_EQ(chances.tasks.size(), 2U);
  const bool is_first = chances.tasks.front().task == "scour_survey";
  const DayChances::Task& possible = chances.tasks[is_first ? 0 : 1];
  const DayChances::Task& impossible = chances.tasks[is_first ? 1 : 0];
  EXPECT_EQ(possible, tasks(question(), "T1").front());
  EXPECT_TRUE(impossible.starts.empty());
  EXPECT_TRUE(contains(impossible.impossible, "visibility")) << impossible.impossible;
  const PlanProblem problem = problem_of(file, chances, 0.5);
  EXPECT_TRUE(problem.jobs.front().without_starts.empty());
  EXPECT_TRUE(contains(problem.jobs.back().without_starts, "visibility"));
}

/// A start that flights took from is worth no more to the plan than they leave of it.
TEST_F(PlanWindows, TakeWhatFlightsAtTheSameTurbineLeave) {
  WindowsQuestion asked = question();
  asked.site = made_->path("farm.yaml");
  asked.every = std::chrono::hours(1);
  asked.tasks = {"scour_survey"};
  asked.turbines = {"T1"};
  TaskWindows flown = windows_of(asked, made_->store()).tasks.front();
  ASSERT_GT(flown.starts[3].probability, 0.01);
  flown.starts[3].worth = 0.01;
  const std::vector<DayChances::Task> weighed =
      windows_for_plan(plan("T1, T2"), question(), made_->store(), {flown}).tasks;
  const std::vector<DayChances::Task> plain = tasks(question(), "T1, T2");
  EXPECT_EQ(weighed[0].starts[3].probability, 0.01);
  EXPECT_EQ(weighed[0].starts[5], plain[0].starts[5]);
  EXPECT_EQ(weighed[1], plain[1]) << "another turbine";
}

/// Nobody forecast the wind of these days, nor the waves that it raises: flights that took nothing
/// from their chances make no go of them.
TEST_F(PlanWindows, FlightsMakeNoGoOfWhatNobodyForecast) {
  WindowsQuestion asked = question();
  asked.rule = {0.04, 0.02};  // the day has no good start: a go as soon as that
  const WindowsQuestion of_plan = asked;
  asked.site = made_->path("farm.yaml");
  asked.tasks = {"scour_survey"};
  asked.turbines = {"T1"};
  asked.every = std::chrono::hours(1);
  WindowsAnswer flown = windows_of(asked, made_->store());
  std::size_t capped = 0;
  for (TaskStart& start : flown.tasks[0].starts) {
    EXPECT_FALSE(start.unforecast.empty());
    capped += start.worth < start.probability ? 1U : 0U;
  }
  ASSERT_GT(capped, 0U);
  // What flights took is next to nothing.
  for (TaskStart& start : flown.tasks[0].starts) start.worth = start.probability - 1e-6;
  const DayChances chances = windows_for_plan(plan("T1"), of_plan, made_->store(), flown.tasks);
  for (const DayChances::Start& start : chances.tasks[0].starts)
    EXPECT_LT(start.probability, 0.04) << format_utc(start.time);
}

}  // namespace
}  // namespace slackwater::tests::plan_windows_test
