// `demo --out DIR`: whose store it replaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/program.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::demo_store_test {
namespace {

using namespace std::chrono;

constexpr UtcDay day = sys_days{2025y / March / 6};

ProgramResult demo(const std::filesystem::path& folder, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"demo", "--days", "1", "--out", folder.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

/// One demonstration for all tests that read it.
class DemoStore : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    first_ = new ProgramResult(demo(*folder_ / "demo"));
  }
  static void TearDownTestSuite() {
    delete first_;
    delete folder_;
  }
  static std::filesystem::path store() { return *folder_ / "demo" / "store"; }
  static ProgramResult run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"--store", store().string()});
    return run_program(arguments);
  }
  static TemporaryFolder* folder_;
  static ProgramResult* first_;
};
TemporaryFolder* DemoStore::folder_ = nullptr;
ProgramResult* DemoStore::first_ = nullptr;

TEST_F(DemoStore, ItsCommandsWorkByTheNameOfTheSite) {
  ASSERT_EQ(first_->exit_code, 0) << first_->err;
  EXPECT_EQ(run({"verify", "--site", "synthetic"}).exit_code, 0);
  // What it prints to go on with is a command that works.
  const auto from = first_->out.rfind("--time ") + 7;
  const std::string time = first_->out.substr(from, first_->out.find('\n', from) - from);
  const ProgramResult profile = run({"profile", "--site", "synthetic", "--time", time});
  EXPECT_EQ(profile.exit_code, 0) << profile.err;
}

TEST_F(DemoStore, EndsWithTheAnswerInTenLines) {
  const std::string answer = first_->out.substr(first_->out.rfind("\n\n") + 2);
  EXPECT_LE(std::count(answer.begin(), answer.end(), '\n'), 10) << answer;
  EXPECT_TRUE(contains(answer, " of 8 on ") || contains(answer, " of 8 tasks on ")) << answer;
  EXPECT_TRUE(contains(answer, "report.html")) << answer;
}

TEST_F(DemoStore, OfItsOwnIsReplacedAndNoOther) {
  ASSERT_EQ(demo(*folder_ / "demo").exit_code, 0);
  std::ofstream(store() / "sites" / "mine.yaml")
      << "id: mine\nlatitude_deg: 48.85\nlongitude_deg: -2.55\n";
  const ProgramResult refused = demo(*folder_ / "demo");
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_TRUE(contains(refused.err, "mine.yaml") && contains(refused.err, "--force"))
      << refused.err;
  EXPECT_TRUE(std::filesystem::exists(store() / "sites" / "mine.yaml"));
  std::filesystem::remove(store() / "sites" / "mine.yaml");
}

TEST_F(DemoStore, WithAForecastOfOnesOwnIsKept) {
  const auto from = first_->out.rfind("--time ") + 7;
  const std::string noon = first_->out.substr(from, first_->out.find('\n', from) - from);
  const ProgramResult own = run({"forecast", "--site", "synthetic", "--at", noon});
  ASSERT_EQ(own.exit_code, 0) << own.err;
  const ProgramResult refused = demo(*folder_ / "demo");
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_TRUE(contains(refused.err, "1 forecast of synthetic")) << refused.err;
}

TEST(DemoOut, RefusesAStoreOfRealWorkAndLeavesItToTheByte) {
  const TemporaryFolder folder;
  const StoreForTests real(folder / "store");
  for (int i = 0; i < 2; ++i) {
    real.ingest(write_product(folder / ("currents" + std::to_string(i) + ".nc"),
                              current_product(day + days(i))));
  }
  const std::string site = write_site(folder / "site.yaml").string();
  ASSERT_EQ(real.run({"forecast", "--site", site, "--at", "2025-03-08T05:00:00Z"}).exit_code, 0);
  const auto digests = real.digests();
  const ProgramResult refused = demo(folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  for (const char* words : {"1 forecast of test_site", "2 product files", "--force", "--out"})
    EXPECT_TRUE(contains(refused.err, words)) << words << " in: " << refused.err;
  EXPECT_EQ(real.digests(), digests);
  EXPECT_FALSE(std::filesystem::exists(folder / "products")) << "nothing else was begun";
  EXPECT_FALSE(std::filesystem::exists(folder / "report.html"));

  const ProgramResult forced = demo(folder.path(), {"--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_TRUE(contains(forced.err, "deleting") && contains(forced.err, "1 forecast of test_site"))
      << forced.err;
}

TEST(DemoOut, NeverDeletesAFolderThatIsNoStore) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "store");
  std::ofstream(folder / "store" / "thesis.txt") << "years of work";
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--force"}}) {
    const ProgramResult refused = demo(folder.path(), more);
    EXPECT_EQ(refused.exit_code, 2) << refused.err;
    EXPECT_TRUE(contains(refused.err, "no store")) << refused.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "store" / "thesis.txt"));
  }
}

TEST(DemoOut, RefusesAStoreThatItCannotRead) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "store");
  std::ofstream(folder / "store" / "catalogue.sqlite") << "not a database, and longer than a page";
  EXPECT_EQ(demo(folder.path()).exit_code, 2);
  EXPECT_TRUE(std::filesystem::exists(folder / "store" / "catalogue.sqlite"));
}

}  // namespace
}  // namespace slackwater::tests::demo_store_test
