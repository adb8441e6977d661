#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "data/store/database.h"
#include "data/store/migrations.h"
#include "data/store/store.h"
#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/data/store/run_sql.h"
#include "tests/data/store/sample_rows.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::store::tests::damaged_store_test {
namespace {

using slackwater::tests::TemporaryFolder;

class DamagedStore : public testing::Test {
 protected:
  void SetUp() override {
    Store store = open();
    samples::ingest(store, 1);
    samples::ingest(store, 2);
    samples::issue(store, 1);
    content_ = store.content_path(sha256_of_text(samples::content_of(2, 0)));
    forecast_content_ = store.content_path(sha256_of_text(samples::forecast_content(1)));
  }
  [[nodiscard]] Store open() const { return Store::open(folder_, OpenMode::create_or_write); }
  /// The message with which both ways of opening refuse; it must lead to `store check`.
  void expect_refusal() const {
    for (const OpenMode mode : {OpenMode::read_only, OpenMode::create_or_write}) {
      try {
        Store store = Store::open(folder_, mode);
        static_cast<void>(store.list_sources());
        static_cast<void>(store.find_granules({}));
        ADD_FAILURE() << "a damaged catalogue was read";
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::invalid_input) << error.message();
        EXPECT_NE(error.message().find("slackwater store check"), std::string::npos)
            << error.message();
      }
    }
    const CheckReport report = check_store(folder_, true);
    EXPECT_FALSE(report.sound);
    ASSERT_FALSE(report.findings.empty());
    EXPECT_NE(report.findings[0].advice.find("restore catalogue.sqlite"), std::string::npos);
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_ / "store";
  std::filesystem::path catalogue_ = folder_ / "catalogue.sqlite";
  std::filesystem::path content_;
  std::filesystem::path forecast_content_;
};

TEST_F(DamagedStore, RandomBytesInPlaceOfTheCatalogueAreRefused) {
  Rng rng(3, "bytes");
  std::string bytes;
  for (int i = 0; i < 20000; ++i) bytes += static_cast<char>(rng.bits() & 0xffU);
  samples::write_file(catalogue_, bytes);
  expect_refusal();
}

TEST_F(DamagedStore, ATruncatedCatalogueIsRefused) {
  std::filesystem::resize_file(catalogue_, std::filesystem::file_size(catalogue_) / 2);
  expect_refusal();
}

TEST_F(DamagedStore, AnEmptyOrMissingCatalogueIsNotTakenForANewStore) {
  std::filesystem::resize_file(catalogue_, 0);
  expect_refusal();
  std::filesystem::remove(catalogue_);
  expect_refusal();
  EXPECT_FALSE(std::filesystem::exists(catalogue_))
      << "an empty catalogue was put over the content";
}

TEST_F(DamagedStore, OverwrittenPagesAreFoundByCheck) {
  // Pages in the middle of the file, where rows lie; the header stays good.
  const auto size = std::filesystem::file_size(catalogue_);
  std::fstream stream(catalogue_, std::ios::binary | std::ios::in | std::ios::out);
  for (std::uintmax_t page = 4096; page + 4096 <= size; page += 8192) {
    stream.seekp(static_cast<std::streamoff>(page));
    stream << std::string(4096, 'x');
  }
  stream.close();
  const CheckReport report = check_store(folder_, false);
  EXPECT_FALSE(report.sound);
}

TEST_F(DamagedStore, AMissingContentFileIsNamedAndIngestingAgainPutsItBack) {
  std::filesystem::remove(content_);
  Store store = open();
  const CheckReport report = store.check(false);
  EXPECT_FALSE(report.sound);
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NE(report.findings[0].found.find(content_.string() + " is missing"), std::string::npos);
  EXPECT_NE(report.findings[0].advice.find("ingest product_2.nc again"), std::string::npos)
      << report.findings[0].advice;
  EXPECT_FALSE(store.find_source(samples::source(2).sha256, "")) << "as if it were not there";
  const auto before = store.find_granules({});
  EXPECT_TRUE(samples::ingest(store, 2));
  EXPECT_EQ(store.find_granules({}), before)
      << "mended in place: forecasts still find their inputs";
  EXPECT_TRUE(store.check(true).findings.empty());
}

TEST_F(DamagedStore, ADamagedContentFileOfTheSameSizeIsNamedAndIngestingAgainMendsIt) {
  Store store = open();
  const std::string sha256 = content_.stem().string();
  EXPECT_EQ(store.content_fault(sha256), std::nullopt);
  EXPECT_EQ(store.proven_content(sha256), content_);
  std::fstream stream(content_, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekg(3);
  const auto byte = static_cast<char>(stream.get());
  stream.seekp(3);
  stream.put(static_cast<char>(byte ^ 1));
  stream.close();
  ASSERT_TRUE(store.content_fault(sha256)) << "though it was found whole before";
  EXPECT_NE(store.content_fault(sha256)->find("sha256 differs"), std::string::npos);
  try {
    static_cast<void>(store.proven_content(sha256));
    FAIL() << "a damaged file was taken for whole";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(error.message().find(content_.string()), std::string::npos) << error.message();
    EXPECT_NE(error.message().find("store check"), std::string::npos) << error.message();
  }
  EXPECT_FALSE(store.find_source(samples::source(2).sha256, "")) << "as if it were not there";
  EXPECT_TRUE(store.names_source(samples::source(2).sha256, ""));
  EXPECT_TRUE(samples::ingest(store, 2));
  EXPECT_EQ(store.content_fault(sha256), std::nullopt);
  EXPECT_FALSE(samples::ingest(store, 2)) << "whole again: nothing to do";
  EXPECT_TRUE(store.check(true).findings.empty());
}

TEST_F(DamagedStore, ALostFileThatIsNowDecodedToOtherBytesBecomesANewSource) {
  std::filesystem::remove(content_);
  Store store = open();
  auto granules = samples::granules(store, 2);
  samples::write_file(granules[0].content_file, "decoded otherwise");
  EXPECT_TRUE(store.commit_ingest(samples::source(2), granules));
  EXPECT_EQ(store.list_sources().size(), 2U);
  EXPECT_TRUE(store.check(true).sound);
}

TEST_F(DamagedStore, UnlessAForecastWasMadeFromIt) {
  Store store = open();
  for (const GranuleRow& granule : store.find_granules({})) {
    if (granule.source_sha256 == samples::source(2).sha256) samples::issue(store, 5, {granule.id});
  }
  std::filesystem::remove(content_);
  auto granules = samples::granules(store, 2);
  samples::write_file(granules[0].content_file, "decoded otherwise");
  try {
    store.commit_ingest(samples::source(2), granules);
    FAIL() << "an input of an issued forecast was replaced";
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("restore the files"), std::string::npos) << error.message();
  }
}

TEST_F(DamagedStore, AFlippedBitIsFoundByTheDeepCheckAndMendedAsItSays) {
  {
    std::fstream stream(content_, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(1234);
    stream.put('\x01');
  }
  Store store = open();
  EXPECT_TRUE(store.check(false).sound) << "sizes agree";
  const CheckReport report = store.check(true);
  EXPECT_FALSE(report.sound);
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NE(report.findings[0].found.find("sha256 differs"), std::string::npos);
  std::filesystem::remove(content_);
  samples::ingest(store, 2);
  EXPECT_TRUE(store.check(true).findings.empty());
}

TEST_F(DamagedStore, ADamagedForecastCannotBeMadeAgainAndCheckSaysSo) {
  std::filesystem::resize_file(forecast_content_, 10);
  const CheckReport report = check_store(folder_, false);
  EXPECT_FALSE(report.sound);
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NE(report.findings[0].found.find("has 10 bytes"), std::string::npos);
  EXPECT_NE(report.findings[0].advice.find("cannot be made again"), std::string::npos);
}

TEST_F(DamagedStore, LeftoversAreHarmless) {
  samples::write_file(folder_ / "files" / "README", "a stranger's");
  const std::string content = "nobody names me";
  const std::string name = sha256_of_text(content);
  std::filesystem::create_directories(folder_ / "files" / name.substr(0, 2));
  samples::write_file(folder_ / "files" / name.substr(0, 2) / (name + ".nc"), content);
  const CheckReport report = check_store(folder_, true);
  EXPECT_TRUE(report.sound);
  EXPECT_EQ(report.findings.size(), 2U);
  for (const CheckFinding& finding : report.findings) EXPECT_FALSE(finding.harmful);
  Store store = open();
  EXPECT_EQ(store.prune({std::nullopt, false, false}).content_files, 0U);
  EXPECT_EQ(store.prune({std::nullopt, false, true}).content_files, 1U);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "files" / "README"));
}

TEST_F(DamagedStore, AStoreOfANewerProgramIsRefusedInBothModes) {
  {
    Database database = Database::open(catalogue_, Database::Access::write);
    database.execute("PRAGMA user_version = 99");
  }
  for (const OpenMode mode : {OpenMode::read_only, OpenMode::create_or_write}) {
    try {
      static_cast<void>(Store::open(folder_, mode));
      ADD_FAILURE() << "opened";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      EXPECT_NE(error.message().find("schema version 99"), std::string::npos) << error.message();
    }
  }
}

/// A store as each earlier program left it is brought up to date by either way of opening, with its
/// rows.
TEST(Migrations, BringEveryEarlierVersionUpToDateWithItsRows) {
  ASSERT_GE(newest_schema_version(), 3);
  for (const OpenMode mode : {OpenMode::read_only, OpenMode::create_or_write}) {
    for (int version = 1; version < newest_schema_version(); ++version) {
      SCOPED_TRACE("from version " + std::to_string(version));
      const TemporaryFolder temporary;
      const auto folder = temporary / "store";
      std::filesystem::create_directories(folder / "files");
      {
        Database database = Database::open(folder / "catalogue.sqlite", Database::Access::write);
        database.execute("PRAGMA journal_mode = WAL");
        migrate(database, version);
        EXPECT_EQ(schema_version(database), version);
        database.execute(
            "INSERT INTO source (sha256, cut_key, name, bytes, product_id, dataset_id, "
            "attribution, "
            "ingested_at_ms) VALUES ('" +
            samples::source(1).sha256 + "', '', 'old.nc', 1, 'P', 'D', 'A', 0)");
      }
      Store store = Store::open(folder, mode);
      ASSERT_EQ(store.list_sources().size(), 1U);
      EXPECT_EQ(store.list_sources()[0].name, "old.nc");
      EXPECT_EQ(store.list_sources()[0].published_at, std::nullopt);  // nobody knows
      EXPECT_TRUE(store.list_forecasts().empty());
      EXPECT_TRUE(store.check(true).sound);
    }
  }
}

/// What SQL does to a catalogue past our own rules.
struct Damage {
  const char* sql;
  const char* found;  ///< by `check_store`
};

// Each can be read as SQLite, and says what this program does not write.
TEST_F(DamagedStore, ACatalogueThatSaysOtherThingsIsNamedAndNeverOursToMend) {
  const std::string sound = samples::read_file(catalogue_);
  const std::string free =
      "PRAGMA ignore_check_constraints = 1; PRAGMA foreign_keys = 0; "
      "DROP TRIGGER IF EXISTS forecast_is_immutable; "
      "DROP TRIGGER IF EXISTS source_is_immutable; ";
  const std::vector<Damage> all{
      {"DROP TABLE session_action", "the table session_action is gone"},
      {"DROP INDEX granule_by_time", "the index granule_by_time is gone"},
      {"DROP TRIGGER granule_is_immutable", "the trigger granule_is_immutable is gone"},
      {"CREATE TABLE more (a)", "the table more is none of ours"},
      {"ALTER TABLE source ADD COLUMN more TEXT", "the table source is not as this program"},
      {"PRAGMA user_version = 3", "damaged"},
      {"PRAGMA user_version = 99", "has schema version 99"},
      {"PRAGMA user_version = -1", "has schema version -1"},
      {"UPDATE forecast SET content_sha256 = '../../../etc/passwd'", "expected a checksum"},
      {"UPDATE forecast SET content_sha256 = upper(content_sha256)", "expected a checksum"},
      {"UPDATE forecast SET site_id = hex(zeroblob(1500000))", "holds 3000000 bytes"},
      {"UPDATE forecast SET day = 'yesterday'", "the column day holds 'yesterday'"},
      {"UPDATE forecast SET wind_policy = 'none'", "the column wind_policy holds 'none'"},
      {"UPDATE source SET sha256 = 'x' WHERE id = 1", "expected a checksum"},
      {"UPDATE forecast SET summary_json = summary_json || '}'",
       "the summary_json of forecast 1 is no JSON"},
      {"UPDATE forecast SET summary_json = '[\"' || CAST(x'ff' AS TEXT) || '\"]'",
       "the summary_json of forecast 1 is no JSON"},
      {"ALTER TABLE forecast RENAME COLUMN summary_json TO text", "the table forecast is not as"},
      {"DELETE FROM source WHERE id = 1", "names a row of table source that is not there"}};
  for (const Damage& damage : all) {
    samples::write_file(catalogue_, sound);
    ASSERT_EQ(run_sql(folder_, free + damage.sql), "") << damage.sql;
    const CheckReport report = check_store(folder_, false);
    EXPECT_FALSE(report.sound) << damage.sql;
    EXPECT_TRUE(std::any_of(report.findings.begin(), report.findings.end(),
                            [&](const CheckFinding& finding) {
                              return finding.found.find(damage.found) != std::string::npos;
                            }))
        << damage.sql << ": " << (report.findings.empty() ? "" : report.findings[0].found);
    try {
      Store store = Store::open(folder_, OpenMode::read_only);
      static_cast<void>(store.list_forecasts());
      static_cast<void>(store.list_sources());
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input) << damage.sql << ": " << error.message();
    }
  }
}

// A file of a stranger names its station so; the store that took it is not damaged by that.
TEST_F(DamagedStore, ALongNameOfOtherLettersIsNoDamage) {
  ASSERT_EQ(run_sql(folder_,
                    "DROP TRIGGER granule_is_immutable; UPDATE granule SET station = "
                    "CAST(replace(hex(zeroblob(2000)), '00', x'ff') AS TEXT)"),
            "");
  EXPECT_EQ(open().find_granules({}).at(0).station.size(), 6000U);
  ASSERT_EQ(run_sql(folder_,
                    "CREATE TRIGGER granule_is_immutable BEFORE UPDATE ON granule\n"
                    "BEGIN SELECT RAISE(ABORT, 'a granule row is never changed'); END"),
            "");
  EXPECT_TRUE(check_store(folder_, false).sound);
}

TEST_F(DamagedStore, TextOfOtherLettersIsReadWithoutThem) {
  ASSERT_EQ(run_sql(folder_,
                    "DROP TRIGGER forecast_is_immutable; "
                    "UPDATE forecast SET headline = CAST(x'41ff42' AS TEXT)"),
            "");
  EXPECT_EQ(open().list_forecasts().at(0).headline,
            "A\xef\xbf\xbd"
            "B");
}

// Wherever a bit of the catalogue is another one, it is said what it is, or nothing is lost by it.
TEST_F(DamagedStore, NoSingleByteIsAFaultOfOurs) {
  const std::string sound = samples::read_file(catalogue_);
  Rng rng(7, "places");
  std::size_t refused = 0;
  for (int turn = 0; turn < 300; ++turn) {
    std::string bytes = sound;
    bytes[rng.bits() % bytes.size()] ^= static_cast<char>(1U << rng.bits() % 8U);
    for (const char* const more : {"-wal", "-shm"})
      std::filesystem::remove(catalogue_.string() + more);
    samples::write_file(catalogue_, bytes);
    try {
      Store store = Store::open(folder_, OpenMode::read_only);
      static_cast<void>(store.list_forecasts());
      static_cast<void>(store.list_sources());
      static_cast<void>(store.find_granules({}));
      static_cast<void>(check_store(folder_, false));
    } catch (const Error& error) {
      ++refused;
      EXPECT_NE(error.kind(), ErrorKind::internal) << error.message();
    }
  }
  EXPECT_GT(refused, 10U);
}

}  // namespace
}  // namespace slackwater::store::tests::damaged_store_test
