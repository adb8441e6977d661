// Killed at any instant, and written by two at once: the store stays sound and forgets nothing that
// was reported done.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <thread>

#include "tests/support/asked_number.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::crash_test {
namespace {

using namespace std::chrono;
using nlohmann::json;

constexpr UtcDay first_day = sys_days{2025y / March / 1};
/// A store lives for this many kills; then a fresh one, so that a soak does not measure a growing
/// store.
constexpr int kills_per_store = 20;

/// What one round does: three files of a day, then the forecast made from them, as two processes.
struct Round {
  std::vector<std::string> files;
  std::vector<std::string> ingest;
  std::vector<std::string> forecast;
};

Round round_of(const StoreForTests& store, int index) {
  const UtcDay day = first_day + days(index);
  const std::string name = format_day(day) + ".nc";
  Round round;
  round.files = {write_product(store.file("currents-" + name), current_product(day)).string(),
                 write_product(store.file("wind-" + name), wind_product(day)).string(),
                 write_product(store.file("waves-" + name), wave_product(day)).string()};
  round.ingest = {"ingest"};
  round.ingest.insert(round.ingest.end(), round.files.begin(), round.files.end());
  round.forecast = {"forecast", "--site", store.site(), "--at",
                    format_utc(UtcTime(day) + days(1) + hours(5))};
  return round;
}

/// What the store was seen to hold, or said that it does.
struct Promises {
  std::set<std::string> sources;    ///< file names
  std::set<std::string> forecasts;  ///< content sha256

  /// Everything promised is there; then what is there is promised too.
  void check_and_renew(const StoreForTests& store) {
    const json list = json::parse(store.listing());
    std::set<std::string> listed_sources;
    std::set<std::string> listed_forecasts;
    for (const auto& source : list["sources"])
      listed_sources.insert(source["name"].get<std::string>());
    for (const auto& row : list["forecasts"])
      listed_forecasts.insert(row["content_sha256"].get<std::string>());
    for (const std::string& name : sources)
      EXPECT_TRUE(listed_sources.contains(name)) << name << " is lost";
    for (const std::string& hash : forecasts)
      EXPECT_TRUE(listed_forecasts.contains(hash)) << hash << " is lost";
    sources = listed_sources;
    forecasts = listed_forecasts;
  }
};

microseconds time_to_run(const StoreForTests& store, const std::vector<std::string>& command) {
  const auto start = steady_clock::now();
  const ProgramResult result = store.run(command);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return duration_cast<microseconds>(steady_clock::now() - start);
}

/// Starts a command, kills it after the delay. @return whether it was killed before it was done.
bool run_and_kill(const StoreForTests& store, const std::vector<std::string>& command,
                  microseconds delay, const std::filesystem::path& out) {
  const pid_t program = store.start(command, out);
  std::this_thread::sleep_for(delay);
  ::kill(program, SIGKILL);
  return wait_for_program(program) == 128 + SIGKILL;
}

TEST(Kill, AtAnyInstantLeavesASoundStoreThatForgetsNothing) {
  const int kills = asked_number("SLACKWATER_KILLS", 7);
  const auto seed = static_cast<unsigned>(asked_number("SLACKWATER_SEED", 20250301));
  std::mt19937_64 random(seed);
  std::unique_ptr<StoreForTests> store;
  Promises promises;
  microseconds ingest_time{};
  microseconds forecast_time{};
  int interrupted = 0;
  int reported = 0;
  for (int k = 0; k < kills; ++k) {
    if (k % kills_per_store == 0) {
      store = std::make_unique<StoreForTests>();
      promises = {};
      const Round undisturbed = round_of(*store, 0);
      ingest_time = time_to_run(*store, undisturbed.ingest);
      forecast_time = time_to_run(*store, undisturbed.forecast);
      promises.check_and_renew(*store);
    }
    const Round round = round_of(*store, 1 + k % kills_per_store);
    const bool at_forecast = k % 3 == 2;
    if (at_forecast) {
      ASSERT_EQ(store->run(round.ingest).exit_code, 0);
      promises.check_and_renew(*store);
    }
    const microseconds usual = at_forecast ? forecast_time : ingest_time;
    const auto delay = microseconds(
        static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(usual.count() + 1)));
    SCOPED_TRACE("seed " + std::to_string(seed) + ", kill " + std::to_string(k) + " of " +
                 (at_forecast ? "forecast" : "ingest") + " after " + std::to_string(delay.count()) +
                 " us of " + std::to_string(usual.count()));
    const auto out = store->file("out");
    interrupted +=
        run_and_kill(*store, at_forecast ? round.forecast : round.ingest, delay, out) ? 1 : 0;

    // A line on standard output is a promise.
    if (!at_forecast) {
      const std::string said = read_bytes(out);
      for (const std::string& file : round.files) {
        if (said.find(file + ": ") == std::string::npos) continue;
        promises.sources.insert(std::filesystem::path(file).filename().string());
        ++reported;
      }
    }
    const ProgramResult check = store->run({"store", "check"});
    ASSERT_EQ(check.exit_code, 0) << check.out << check.err;
    promises.check_and_renew(*store);

    const ProgramResult ingested = store->run(round.ingest);
    ASSERT_EQ(ingested.exit_code, 0) << ingested.err;
    const ProgramResult forecast = store->run(round.forecast);
    ASSERT_EQ(forecast.exit_code, 0) << forecast.err;
    for (const std::string& file : round.files)
      promises.sources.insert(std::filesystem::path(file).filename().string());
    promises.check_and_renew(*store);
    EXPECT_EQ(json::parse(store->listing())["sources"].size(), promises.sources.size())
        << "each file once";
  }
  // A test that always came too late would prove nothing.
  EXPECT_GE(interrupted, kills / 2) << "of " << kills;
  RecordProperty("interrupted", interrupted);
  RecordProperty("reported_before_the_kill", reported);
  // What killed processes left behind is swept, and the store is as sound after it.
  EXPECT_EQ(store->run({"store", "prune", "--orphans"}).exit_code, 0);
  EXPECT_EQ(store->run({"store", "check"}).exit_code, 0);
  promises.check_and_renew(*store);
}

TEST(TwoWriters, IngestingDifferentFilesBothSucceed) {
  const StoreForTests store;
  for (int turn = 0; turn < 5; ++turn) {
    const pid_t one = store.start(round_of(store, 2 * turn).ingest);
    const pid_t other = store.start(round_of(store, 2 * turn + 1).ingest);
    EXPECT_EQ(wait_for_program(one), 0);
    EXPECT_EQ(wait_for_program(other), 0);
  }
  EXPECT_EQ(json::parse(store.listing())["sources"].size(), 30U);
  const ProgramResult check = store.run({"store", "check"});
  EXPECT_EQ(check.exit_code, 0) << check.out;
}

TEST(TwoWriters, IngestingTheSameFilesStoreThemOnce) {
  const StoreForTests store;
  for (int turn = 0; turn < 5; ++turn) {
    const Round round = round_of(store, turn);
    const pid_t one = store.start(round.ingest);
    const pid_t other = store.start(round.ingest);
    EXPECT_EQ(wait_for_program(one), 0);
    EXPECT_EQ(wait_for_program(other), 0);
  }
  const json list = json::parse(store.listing());
  EXPECT_EQ(list["sources"].size(), 15U);
  EXPECT_EQ(list["granules"].size(), 15U);
  const ProgramResult check = store.run({"store", "check", "--json"});
  EXPECT_EQ(check.exit_code, 0) << check.out;
  EXPECT_EQ(json::parse(check.out)["findings"].size(), 0U)
      << "nothing is left lying about: " << check.out;
}

TEST(TwoWriters, IngestWhileForecasting) {
  const StoreForTests store;
  ASSERT_EQ(store.run(round_of(store, 0).ingest).exit_code, 0);
  for (int turn = 1; turn <= 5; ++turn) {
    const pid_t ingest = store.start(round_of(store, turn).ingest);
    const pid_t forecast = store.start(round_of(store, turn - 1).forecast);
    EXPECT_EQ(wait_for_program(ingest), 0);
    EXPECT_EQ(wait_for_program(forecast), 0);
  }
  const json list = json::parse(store.listing());
  EXPECT_EQ(list["sources"].size(), 18U);
  EXPECT_EQ(list["forecasts"].size(), 5U);
  EXPECT_EQ(store.run({"store", "check"}).exit_code, 0);
}

TEST(TwoWriters, PruningOrphansNeverTakesAFileThatIsBeingStored) {
  const StoreForTests store;
  ASSERT_EQ(store.run(round_of(store, 0).ingest).exit_code, 0);
  for (int turn = 1; turn <= 5; ++turn) {
    const pid_t ingest = store.start(round_of(store, turn).ingest);
    const pid_t prune = store.start({"store", "prune", "--orphans"});
    const pid_t again = store.start({"store", "prune", "--orphans"});
    EXPECT_EQ(wait_for_program(ingest), 0);
    EXPECT_EQ(wait_for_program(prune), 0);
    EXPECT_EQ(wait_for_program(again), 0);
  }
  EXPECT_EQ(json::parse(store.listing())["sources"].size(), 18U);
  EXPECT_EQ(store.run({"store", "check"}).exit_code, 0);
}

}  // namespace
}  // namespace slackwater::tests::crash_test
