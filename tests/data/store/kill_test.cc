#include <gtest/gtest.h>
#include <unistd.h>

#include <set>

#include "fields/base/numbers/random.h"
#include "tests/data/store/sample_rows.h"
#include "tests/data/store/worker_process.h"
#include "tests/support/asked_number.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::store::tests::kill_test {
namespace {

using slackwater::tests::asked_number;
using slackwater::tests::TemporaryFolder;

/// SLACKWATER_KILLS and SLACKWATER_SEED widen the search.
TEST(StoreUnderKills, StaysSoundAndKeepsAllThatWasReportedDone) {
  const int kills = asked_number("SLACKWATER_KILLS", 20);
  const auto seed = static_cast<std::uint64_t>(asked_number("SLACKWATER_SEED", 1));
  SCOPED_TRACE("seed " + std::to_string(seed));
  const TemporaryFolder folder;
  Rng rng(seed, "kills");
  std::set<int> ingested;
  std::set<int> issued;
  for (int kill = 0; kill < kills; ++kill) {
    SCOPED_TRACE("kill " + std::to_string(kill));
    const int first = 1000 * (kill + 1);
    WorkerProcess worker(folder / "store", {"begin", "loop:" + std::to_string(first)});
    ASSERT_TRUE(worker.wait_for("begin"));
    // From the making of the store to several commits later.
    ::usleep(static_cast<useconds_t>(rng.uniform(0, 250'000)));
    worker.kill();
    for (const std::string& line : worker.finish()) {
      ASSERT_FALSE(line.starts_with("failed")) << line;
      if (line.starts_with("done ingest:")) ingested.insert(std::stoi(line.substr(12)));
      if (line.starts_with("done forecast:")) issued.insert(std::stoi(line.substr(14)));
    }
    EXPECT_EQ(worker.exit_code(), -9);
    if (!std::filesystem::exists(folder / "store" / "catalogue.sqlite")) continue;
    Store store = Store::open(folder / "store", OpenMode::create_or_write);
    const CheckReport report = store.check(true);
    EXPECT_TRUE(report.sound) << report.findings.front().found;
    for (const int number : ingested) {
      EXPECT_TRUE(store.find_source(samples::source(number).sha256, "")) << number;
    }
    std::set<UtcDay> days;
    for (const ForecastRow& forecast : store.list_forecasts()) days.insert(forecast.day);
    for (const int number : issued) EXPECT_TRUE(days.contains(samples::forecast_row(number).day));
  }
  EXPECT_GT(ingested.size(), 3U) << "the kills came before any work was done";
}

TEST(TwoWriters, EachFinishAllTheirWorkAndNothingIsStoredTwice) {
  const TemporaryFolder folder;
  std::vector<std::string> steps;
  for (int number = 1; number <= 15; ++number) {
    steps.push_back("ingest:" + std::to_string(number));
    steps.push_back("forecast:" + std::to_string(number));
  }
  WorkerProcess one(folder / "store", steps);
  WorkerProcess two(folder / "store", steps);
  for (WorkerProcess* worker : {&one, &two}) {
    const auto said = worker->finish();
    for (const std::string& step : steps) EXPECT_TRUE(has_line(said, "done " + step)) << step;
  }
  Store store = Store::open(folder / "store", OpenMode::read_only);
  const CheckReport report = store.check(true);
  EXPECT_TRUE(report.sound);
  EXPECT_TRUE(report.findings.empty()) << report.findings.front().found;
  EXPECT_EQ(report.sources, 15U);
  EXPECT_EQ(report.granules, 30U);
  EXPECT_EQ(report.forecasts, 15U) << "what both issue alike is one forecast";
}

}  // namespace
}  // namespace slackwater::store::tests::kill_test
