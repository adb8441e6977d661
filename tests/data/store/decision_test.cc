#include "data/store/decision.h"

#include <gtest/gtest.h>

#include "data/store/database.h"
#include "data/store/migrations.h"
#include "data/store/store.h"
#include "fields/base/error.h"
#include "tests/data/store/run_sql.h"
#include "tests/data/store/sample_rows.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::store::tests::decision_test {
namespace {

using slackwater::tests::TemporaryFolder;

const UtcTime after_everything = parse_utc("2100-01-01T00:00:00Z");

/// About the fifth hour of what granules of a number hold.
DecisionRow decision(std::int64_t forecast, int number = 1) {
  DecisionRow row;
  row.site_id = "otranto";
  row.task = "scour_survey";
  row.turbine = "A01";
  row.start = *samples::granule_row(number).first_time + std::chrono::hours(5);
  row.work = std::chrono::minutes(125);
  row.decided = Decided::go;
  row.by = "Åsa \"O'Neil\" <b>";
  row.recorded_at = row.start - std::chrono::hours(2);
  row.by_clock = false;
  row.forecast = forecast;
  row.probability = 0.925;
  row.verdict = "go";
  row.note = "swell from the west; half of the crew";
  row.hand_over = "the tow leaves at noon";
  return row;
}

class Decisions : public testing::Test {
 protected:
  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_ / "store";
  Store store_ = Store::open(folder_, OpenMode::create_or_write);
};

TEST_F(Decisions, ComeBackToTheLastFieldWithTheForecastTheyRestOn) {
  const std::int64_t forecast = samples::issue(store_, 1);
  DecisionRow full = decision(forecast);
  full.id = store_.record_decision(full);
  full.forecast_sha256 = sha256_of_text(samples::forecast_content(1));
  full.forecast_issued = samples::forecast_row(1).issued;
  DecisionRow bare = decision(forecast);
  bare.decided = Decided::no_go;
  bare.work.reset();
  bare.probability.reset();
  bare.turbine = bare.verdict = bare.note = bare.hand_over = "";
  bare.unsaid = "the forecast has no value";
  bare.by_clock = true;
  bare.start += std::chrono::hours(1);
  bare.id = store_.record_decision(bare);
  bare.forecast_sha256 = full.forecast_sha256;
  bare.forecast_issued = full.forecast_issued;
  const auto found = store_.find_decisions({});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], full);
  EXPECT_EQ(found[1], bare);
}

TEST_F(Decisions, AreFoundBySiteTaskAndStart) {
  const std::int64_t forecast = samples::issue(store_, 1);
  DecisionRow row = decision(forecast);
  store_.record_decision(row);
  row.task = "blade_scan";
  row.start += std::chrono::hours(1);
  store_.record_decision(row);
  row.site_id = "elsewhere";
  store_.record_decision(row);
  const auto count = [&](const DecisionQuery& query) {
    return store_.find_decisions(query).size();
  };
  EXPECT_EQ(count({}), 3U);
  EXPECT_EQ(count({"otranto", "", {}, {}}), 2U);
  EXPECT_EQ(count({"otranto", "blade_scan", {}, {}}), 1U);
  EXPECT_EQ(count({"otranto", "", row.start, {}}), 1U) << "its first instant is in";
  EXPECT_EQ(count({"otranto", "", {}, row.start}), 1U) << "its last is not";
}

TEST_F(Decisions, OfOneStartAreAllKeptInTheOrderOfFiling) {
  const std::int64_t forecast = samples::issue(store_, 1);
  DecisionRow row = decision(forecast);
  const std::int64_t first = store_.record_decision(row);
  row.decided = Decided::no_go;
  row.recorded_at -= std::chrono::hours(9);  // stated to be earlier, and filed later
  const std::int64_t second = store_.record_decision(row);
  const auto found = store_.find_decisions({});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].id, first);
  EXPECT_EQ(found[1].id, second);
  EXPECT_LT(first, second);
}

TEST_F(Decisions, AreNeverChangedNorRemovedWhoeverAsks) {
  samples::issue(store_, 1);
  store_.record_decision(decision(store_.list_forecasts().front().id));
  EXPECT_EQ(run_sql(folder_, "UPDATE decision SET decided = 'no_go'"),
            "a decision is never changed: record another one");
  EXPECT_EQ(run_sql(folder_, "DELETE FROM decision"), "a decision is never removed");
  EXPECT_EQ(run_sql(folder_, "DELETE FROM forecast"), "FOREIGN KEY constraint failed");
  EXPECT_EQ(store_.find_decisions({}).front().decided, Decided::go);
}

TEST_F(Decisions, TheTableItselfRefusesWhatIsNoRecord) {
  DecisionRow row = decision(samples::issue(store_, 1));
  row.by = "  ";
  EXPECT_THROW(store_.record_decision(row), Error);
  row.by = std::string(201, 'x');
  EXPECT_THROW(store_.record_decision(row), Error);
  row = decision(row.forecast);
  row.note = std::string(2001, 'x');
  EXPECT_THROW(store_.record_decision(row), Error);
  row = decision(row.forecast);
  row.hand_over = std::string(2001, 'x');
  EXPECT_THROW(store_.record_decision(row), Error);
  row = decision(row.forecast);
  row.probability = 1.1;
  EXPECT_THROW(store_.record_decision(row), Error);
  EXPECT_TRUE(store_.find_decisions({}).empty());
}

TEST_F(Decisions, RestOnAForecastThatIsThere) {
  try {
    store_.record_decision(decision(4711));
    ADD_FAILURE() << "recorded";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
    EXPECT_NE(error.message().find("forecast 4711"), std::string::npos) << error.message();
  }
}

// Granules of a number hold the day that the forecast of this number was fitted to; it speaks of
// the days after.
TEST_F(Decisions, KeepTheirForecastAndWhatCameFromPruning) {
  for (int number = 1; number <= 5; ++number) {
    samples::ingest(store_, number);
    samples::issue(store_, number);
  }
  const std::int64_t second = store_.list_forecasts()[1].id;
  store_.record_decision(decision(second, 4));
  const PruneOptions all{after_everything, true, false, true};
  const PruneReport dry = store_.prune(all);
  const PruneReport report = store_.prune({after_everything, true, false});
  for (const PruneReport& one : {dry, report}) {
    EXPECT_EQ(one.forecasts, 4U);
    EXPECT_EQ(one.kept_forecasts, 1U);
    EXPECT_EQ(one.sources, 2U);
    EXPECT_EQ(one.kept_sources, 3U);
  }
  ASSERT_EQ(store_.list_forecasts().size(), 1U);
  EXPECT_EQ(store_.list_forecasts().front().id, second);
  std::vector<std::string> kept;
  for (const SourceFile& source : store_.list_sources()) kept.push_back(source.name);
  // The hour in which the forecast begins, the day before the work, the day of the work.
  const std::vector<std::string> wanted{samples::source(2).name, samples::source(3).name,
                                        samples::source(4).name};
  EXPECT_EQ(kept, wanted);
  EXPECT_EQ(store_.find_decisions({}).size(), 1U);
  const CheckReport check = store_.check(true);
  EXPECT_TRUE(check.findings.empty());
  EXPECT_EQ(check.decisions, 1U);
}

// What a model had said of these hours does not tell what came.
TEST_F(Decisions, DoNotKeepForecastsOfTheProviderFromPruning) {
  auto run = samples::granules(store_, 1);
  for (NewGranule& granule : run) {
    granule.row.status = DataStatus::forecast;
    granule.row.reference_time = *granule.row.first_time - std::chrono::hours(24);
  }
  store_.commit_ingest(samples::source(1), run);
  samples::issue(store_, 1);
  store_.record_decision(decision(store_.list_forecasts().front().id));
  const PruneReport report = store_.prune({after_everything, false, false});
  EXPECT_EQ(report.sources, 1U);
  EXPECT_EQ(report.kept_sources, 0U);
}

TEST_F(Decisions, AreToldWhereTheFileOfTheirForecastIsLost) {
  samples::issue(store_, 1);
  const ForecastRow forecast = store_.list_forecasts().front();
  std::filesystem::remove(store_.content_path(forecast.content_sha256));
  ASSERT_EQ(store_.check(true).findings.size(), 1U);
  EXPECT_NE(store_.check(true).findings[0].advice.find("prune --forecasts"), std::string::npos);
  store_.record_decision(decision(forecast.id));
  const std::string advice = store_.check(true).findings[0].advice;
  EXPECT_EQ(advice.find("prune --forecasts"), std::string::npos) << advice;
  EXPECT_NE(advice.find("decisions were made on it"), std::string::npos) << advice;
}

TEST(DecisionsOfAnOlderStore, AreRecordedAfterItsFirstOpening) {
  const TemporaryFolder temporary;
  const auto folder = temporary / "store";
  std::filesystem::create_directories(folder / "files");
  {
    Database database = Database::open(folder / "catalogue.sqlite", Database::Access::write);
    database.execute("PRAGMA journal_mode = WAL");
    migrate(database, 4);
    ASSERT_EQ(schema_version(database), 4);
  }
  EXPECT_TRUE(Store::open(folder, OpenMode::read_only).find_decisions({}).empty());
  Store store = Store::open(folder, OpenMode::create_or_write);
  EXPECT_GT(store.record_decision(decision(samples::issue(store, 1))), 0);
  EXPECT_TRUE(store.check(true).sound);
}

TEST(DecisionsOfAnOlderStore, KeepTheirNoteAndHandNothingOver) {
  const TemporaryFolder temporary;
  const auto folder = temporary / "store";
  DecisionRow row;
  {
    Store store = Store::open(folder, OpenMode::create_or_write);
    row = decision(samples::issue(store, 1));
  }
  {
    // A store of schema 7 with one decision.
    Database database = Database::open(folder / "catalogue.sqlite", Database::Access::write);
    database.execute("ALTER TABLE decision DROP COLUMN hand_over");
    database.execute("PRAGMA user_version = 7");
    ASSERT_EQ(schema_version(database), 7);
    database.execute(
        "INSERT INTO decision (site_id, task, turbine, start_ms, decided, decided_by, "
        "recorded_at_ms, by_clock, forecast_id, verdict, unsaid, note) VALUES ('bay', 'scour', '', "
        "0, 'go', 'Ann', 0, 1, " +
        std::to_string(row.forecast) + ", '', 'none', 'For the next shift: tow')");
  }
  for (const OpenMode mode : {OpenMode::read_only, OpenMode::create_or_write}) {
    const auto found = Store::open(folder, mode).find_decisions({});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].note, "For the next shift: tow");
    EXPECT_EQ(found[0].hand_over, "");
  }
}

TEST(ActionsOfAnOlderStore, HaveNoReasonAndStandForOne) {
  const TemporaryFolder temporary;
  const auto folder = temporary / "store";
  std::filesystem::create_directories(folder / "files");
  {
    Database database = Database::open(folder / "catalogue.sqlite", Database::Access::write);
    database.execute("PRAGMA journal_mode = WAL");
    migrate(database, 6);
    database.execute("INSERT INTO session (name, begun_ms) VALUES ('run', 0)");
    database.execute(
        "INSERT INTO session_action VALUES (1, 1, 0, 1.5, 30, 2, 'Ann', 'operator', 'ask', 'rov', "
        "'free', 'held', 1, '')");
  }
  for (const OpenMode mode : {OpenMode::read_only, OpenMode::create_or_write}) {
    const auto actions = Store::open(folder, mode).find_actions(1);
    ASSERT_EQ(actions.size(), 1U);
    EXPECT_EQ(actions[0].who, "Ann");
    EXPECT_EQ(actions[0].reason, "");
    EXPECT_EQ(actions[0].count, 1U);
  }
}

TEST(DecidedNames, AreReadBackAndNothingElseIs) {
  for (const Decided decided : {Decided::go, Decided::no_go})
    EXPECT_EQ(decided_from(name_of(decided)), decided);
  EXPECT_THROW(static_cast<void>(decided_from("no-go")), Error);
}

}  // namespace
}  // namespace slackwater::store::tests::decision_test
