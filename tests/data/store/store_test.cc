#include "data/store/store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "fields/base/error.h"
#include "tests/data/store/run_sql.h"
#include "tests/data/store/sample_rows.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::store::tests::store_test {
namespace {

using slackwater::tests::TemporaryFolder;

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

ErrorKind kind_of_opening(const std::filesystem::path& folder, OpenMode mode,
                          std::string& message) {
  try {
    static_cast<void>(Store::open(folder, mode));
  } catch (const Error& error) {
    message = error.message();
    return error.kind();
  }
  return ErrorKind::internal;
}

class StoreTest : public testing::Test {
 protected:
  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_ / "some" / "store";
  Store store_ = Store::open(folder_, OpenMode::create_or_write);
};

TEST_F(StoreTest, ReturnsWhatWasIngestedToTheLastField) {
  ASSERT_TRUE(samples::ingest(store_, 1));
  EXPECT_EQ(store_.find_source(samples::source(1).sha256, ""), samples::source(1));
  const auto granules = store_.find_granules({});
  ASSERT_EQ(granules.size(), 2U);
  for (int part = 0; part < 2; ++part) {
    const GranuleRow& found = granules[static_cast<std::size_t>(part)];
    GranuleRow expected = samples::granule_row(1);
    expected.id = found.id;
    expected.source_sha256 = samples::source(1).sha256;
    expected.content_sha256 = sha256_of_text(samples::content_of(1, part));
    expected.ingested_at = samples::source(1).ingested_at;
    EXPECT_EQ(found, expected);
    EXPECT_EQ(bytes_of(store_.content_path(found.content_sha256)), samples::content_of(1, part));
    EXPECT_EQ(store_.granule(found.id), found);
  }
}

TEST_F(StoreTest, KeepsOptionalFieldsAsTheyAre) {
  SourceFile source = samples::source(7);
  source.cut_key = "bbox 1 2 3 4";
  source.published_at = parse_utc("2024-02-28T18:00:00Z");
  auto granules = samples::granules(store_, 7);
  granules.resize(1);
  GranuleRow& row = granules[0].row;
  row.contains_stokes = row.is_point_series = true;
  row.station = "Brest (Atlantic) — 6200450";
  row.status = DataStatus::forecast;
  row.reference_time = parse_utc("2024-02-28T12:00:00.250Z");
  row.ensemble_member = 17;
  row.first_time = row.last_time = std::nullopt;
  row.lowest_level_m = row.highest_level_m = std::nullopt;
  row.vertical = VerticalKind::none;
  store_.commit_ingest(source, granules);
  GranuleRow found = store_.find_granules({}).at(0);
  row.id = found.id;
  row.source_sha256 = source.sha256;
  row.cut_key = source.cut_key;
  row.content_sha256 = found.content_sha256;
  row.ingested_at = source.ingested_at;
  row.published_at = source.published_at;
  EXPECT_EQ(found, row);
  EXPECT_EQ(store_.list_sources().at(0), source);
}

TEST_F(StoreTest, IngestingTheSameFileAgainChangesNothing) {
  ASSERT_TRUE(samples::ingest(store_, 1));
  const auto before = store_.find_granules({});
  EXPECT_FALSE(samples::ingest(store_, 1));
  EXPECT_EQ(store_.find_granules({}), before);
  EXPECT_TRUE(std::filesystem::is_empty(store_.staging_folder()));
  EXPECT_TRUE(store_.check(true).findings.empty());
}

TEST_F(StoreTest, TheSameFileCutDifferentlyIsAnotherSourceThatSharesContent) {
  samples::ingest(store_, 1);
  SourceFile cut = samples::source(1);
  cut.cut_key = "bbox 18 40 19 41";
  EXPECT_FALSE(store_.find_source(cut.sha256, cut.cut_key));
  EXPECT_TRUE(store_.commit_ingest(cut, samples::granules(store_, 1)));
  EXPECT_EQ(store_.list_sources().size(), 2U);
  EXPECT_EQ(store_.find_granules({}).size(), 4U);
  EXPECT_EQ(store_.check(true).content_files, 2U);
}

TEST_F(StoreTest, AFailedCommitLeavesNothingAndCanBeRepeated) {
  auto granules = samples::granules(store_, 1);
  granules[1].row.last_time =
      *granules[1].row.first_time - std::chrono::hours(1);  // refused by the schema
  EXPECT_THROW(store_.commit_ingest(samples::source(1), granules), Error);
  EXPECT_TRUE(store_.list_sources().empty());
  EXPECT_TRUE(store_.find_granules({}).empty());
  EXPECT_TRUE(store_.check(true).findings.empty()) << "content files stay behind";
  granules[1].row.last_time = *granules[1].row.first_time + std::chrono::hours(1);
  EXPECT_TRUE(store_.commit_ingest(samples::source(1), granules));
}

TEST_F(StoreTest, FindsGranulesByNameTimeStatusAndKnowledge) {
  for (const int day : {3, 1, 2}) samples::ingest(store_, day);
  auto wind = samples::granules(store_, 4);
  wind.resize(1);
  wind[0].row = samples::granule_row(2);
  wind[0].row.standard_names = {"eastward_wind", "northward_wind"};
  wind[0].row.status = DataStatus::forecast;
  store_.commit_ingest(samples::source(4), wind);
  const auto count = [&](const GranuleQuery& query) { return store_.find_granules(query).size(); };

  GranuleQuery query;
  EXPECT_EQ(count(query), 7U);
  query.any_of = {"eastward_wind", "wind_speed"};
  EXPECT_EQ(count(query), 1U);
  query.any_of = {"northward_sea_water_velocity", "eastward_sea_water_velocity"};
  EXPECT_EQ(count(query), 6U) << "a granule with both names comes once";
  query = {};
  query.from = samples::granule_row(2).first_time;
  query.to = samples::granule_row(2).last_time;
  EXPECT_EQ(count(query), 7U) << "the ends touch: closed intervals";
  query.from = *query.from + Duration(1);
  query.to = *query.to - Duration(1);
  EXPECT_EQ(count(query), 3U);
  query.status = DataStatus::analysis;
  EXPECT_EQ(count(query), 2U);
  query = {};
  query.ingested_by = samples::source(2).ingested_at;
  EXPECT_EQ(count(query), 4U) << "known at an instant: ingested then or earlier";

  const auto all = store_.find_granules({});
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LE(all[i - 1].first_time, all[i].first_time);
}

TEST_F(StoreTest, FindsGranulesByPlaceWithAMarginInKilometres) {
  samples::ingest(store_, 1);  // 18 to 19 E, 40 to 41 N
  const auto found = [&](double latitude_deg, double longitude_deg, double margin_km) {
    GranuleQuery query;
    query.point = GeoPoint{Angle::from_degrees(latitude_deg), Angle::from_degrees(longitude_deg)};
    query.margin_km = margin_km;
    return !store_.find_granules(query).empty();
  };
  EXPECT_TRUE(found(40.5, 18.5, 0));
  EXPECT_TRUE(found(40, 19, 0)) << "a corner belongs to the box";
  EXPECT_FALSE(found(40.5, 19.1, 0));
  // 0.1 degree of longitude at 40.5 N is 8.48 km; 0.1 degree of latitude is 11.1 km.
  EXPECT_TRUE(found(40.5, 19.1, 8.6));
  EXPECT_FALSE(found(40.5, 19.1, 8.2));
  EXPECT_TRUE(found(39.9, 18.5, 11.2));
  EXPECT_FALSE(found(39.9, 18.5, 10.9));
  GranuleQuery query;
  query.box = BoundingBox{10, 30, 18.001, 40.001};
  EXPECT_EQ(store_.find_granules(query).size(), 2U);
  query.box = BoundingBox{10, 30, 17.9, 40.5};
  EXPECT_TRUE(store_.find_granules(query).empty());
}

TEST_F(StoreTest, ReturnsAForecastAsIssuedWithItsInputs) {
  samples::ingest(store_, 1);
  std::vector<std::int64_t> inputs;
  for (const GranuleRow& granule : store_.find_granules({})) inputs.push_back(granule.id);
  std::ranges::reverse(inputs);
  const std::int64_t id = samples::issue(store_, 1, inputs);
  ForecastRow expected = samples::forecast_row(1, inputs);
  expected.id = id;
  expected.content_sha256 = sha256_of_text(samples::forecast_content(1));
  EXPECT_EQ(store_.list_forecasts(), std::vector{expected});
  EXPECT_EQ(bytes_of(store_.content_path(expected.content_sha256)), samples::forecast_content(1));
}

TEST_F(StoreTest, FindsForecastsBySiteDayOriginAndPolicy) {
  std::vector<NewForecast> forecasts;
  for (int number = 1; number <= 4; ++number) {
    const auto file = store_.staging_folder() / std::to_string(number);
    samples::write_file(file, samples::forecast_content(number));
    forecasts.push_back({samples::forecast_row(number), file});
  }
  forecasts[0].row.origin = ForecastOrigin::hindcast;
  forecasts[1].row.wind_policy = WindPolicy::persist;
  forecasts[3].row.site_id = "elba";
  std::vector<std::int64_t> ids;
  for (const FiledForecast& filed : store_.commit_forecasts(forecasts)) ids.push_back(filed.id);
  ASSERT_EQ(ids.size(), 4U);
  // The same day once more, made otherwise: never overwritten.
  const auto other = store_.staging_folder() / "other";
  samples::write_file(other, samples::forecast_content(5));
  const std::int64_t again = store_.commit_forecast(samples::forecast_row(3), other).id;

  const auto found = [&](const ForecastQuery& query) {
    std::vector<std::int64_t> result;
    for (const ForecastRow& row : store_.find_forecasts(query)) result.push_back(row.id);
    return result;
  };
  ForecastQuery otranto;
  otranto.site_id = "otranto";
  EXPECT_EQ(found(otranto), (std::vector{ids[0], ids[1], ids[2], again}));
  ForecastQuery query = otranto;
  query.from_day = query.to_day = samples::forecast_row(3).day;
  EXPECT_EQ(found(query), (std::vector{ids[2], again}));
  query = otranto;
  query.origin = ForecastOrigin::hindcast;
  EXPECT_EQ(found(query), std::vector{ids[0]});
  query = otranto;
  query.wind_policy = WindPolicy::persist;
  EXPECT_EQ(found(query), std::vector{ids[1]});
  EXPECT_EQ(store_.list_forecasts().size(), 5U);
}

TEST_F(StoreTest, AForecastIssuedAgainToTheByteKeepsItsNumberAndAnyDifferenceGetsItsOwn) {
  samples::ingest(store_, 1);
  std::vector<std::int64_t> inputs;
  for (const GranuleRow& granule : store_.find_granules({})) inputs.push_back(granule.id);
  const std::int64_t first = samples::issue(store_, 1, inputs);
  const auto filed = [&](const ForecastRow& row, int content) {
    const auto file = store_.staging_folder() / "again";
    samples::write_file(file, samples::forecast_content(content));
    return store_.commit_forecast(row, file);
  };
  const FiledForecast again = filed(samples::forecast_row(1, inputs), 1);
  EXPECT_EQ(again.id, first);
  EXPECT_FALSE(again.is_new);
  EXPECT_EQ(store_.list_forecasts().size(), 1U);

  std::vector<ForecastRow> others(7, samples::forecast_row(1, inputs));
  others[0].site_id = "elba";
  others[1].issued += std::chrono::seconds(1);
  others[2].wind_policy = WindPolicy::persist;
  others[3].origin = ForecastOrigin::hindcast;
  others[4].summary_json = "{}";
  others[5].code_version = "0.2.0";
  others[6].input_granules.pop_back();
  std::size_t rows = 1;
  for (const ForecastRow& other : others) {
    EXPECT_TRUE(filed(other, 1).is_new) << rows;
    EXPECT_EQ(store_.list_forecasts().size(), ++rows);
  }
  EXPECT_TRUE(filed(samples::forecast_row(1, inputs), 2).is_new) << "other content";
  EXPECT_TRUE(store_.check(true).findings.empty());
}

TEST_F(StoreTest, RefusesAForecastWhoseWindPolicyIsUnknown) {
  static_cast<void>(samples::issue(store_, 1));
  ASSERT_EQ(run_sql(folder_,
                    "DROP TRIGGER forecast_is_immutable; UPDATE forecast SET wind_policy='storm'"),
            "");
  try {
    static_cast<void>(store_.list_forecasts());
    FAIL() << "read a policy that is none";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(error.message().find("the column wind_policy holds 'storm': found wind policy "
                                   "'storm', expected best, forecast or persist"),
              std::string::npos)
        << error.message();
  }
}

TEST_F(StoreTest, StoresSeveralForecastsOrNone) {
  const auto file = store_.staging_folder() / "good";
  const auto other = store_.staging_folder() / "bad";
  samples::write_file(file, samples::forecast_content(1));
  samples::write_file(other, samples::forecast_content(2));
  const NewForecast forecasts[] = {{samples::forecast_row(1), file},
                                   {samples::forecast_row(2, {4711}), other}};
  try {
    store_.commit_forecasts(forecasts);
    FAIL() << "an input that is not there was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
    EXPECT_NE(error.message().find("granule 4711"), std::string::npos) << error.message();
  }
  EXPECT_TRUE(store_.list_forecasts().empty());
  EXPECT_TRUE(store_.check(true).findings.empty());
}

TEST_F(StoreTest, TheCatalogueItselfRefusesToChangeWhatWasStored) {
  samples::ingest(store_, 1);
  samples::issue(store_, 1, {store_.find_granules({}).front().id});
  EXPECT_EQ(run_sql(folder_, "UPDATE forecast SET headline = 'calm'"),
            "a forecast as issued is never changed");
  EXPECT_EQ(run_sql(folder_, "UPDATE forecast_input SET granule_id = 2"),
            "a forecast as issued is never changed");
  EXPECT_EQ(run_sql(folder_, "UPDATE granule SET status = 'forecast'"),
            "a granule row is never changed");
  EXPECT_EQ(run_sql(folder_, "UPDATE source SET name = 'x'"), "a source row is never changed");
  EXPECT_EQ(run_sql(folder_, "DELETE FROM source"), "FOREIGN KEY constraint failed")
      << "an input of a forecast stays";
}

TEST_F(StoreTest, AReaderSeesWhatAWriterCommitsMeanwhile) {
  Store reader = Store::open(folder_, OpenMode::read_only);
  EXPECT_TRUE(reader.list_sources().empty());
  samples::ingest(store_, 1);
  EXPECT_EQ(reader.list_sources().size(), 1U);
}

TEST(StoreOpening, NamesIngestWhereThereIsNoStore) {
  const TemporaryFolder temporary;
  std::string message;
  EXPECT_EQ(kind_of_opening(temporary / "nothing", OpenMode::read_only, message),
            ErrorKind::not_found);
  EXPECT_NE(message.find("slackwater ingest"), std::string::npos) << message;
  EXPECT_FALSE(std::filesystem::exists(temporary / "nothing"));
}

TEST(StoreOpening, RefusesAFileInThePlaceOfTheFolder) {
  const TemporaryFolder temporary;
  samples::write_file(temporary / "store", "not a folder");
  std::string message;
  EXPECT_EQ(kind_of_opening(temporary / "store", OpenMode::create_or_write, message),
            ErrorKind::unavailable);
  EXPECT_NE(message.find("store"), std::string::npos);
}

TEST(StoreOpening, SweepsTheStagingFoldersOfDeadProcessesOnly) {
  const TemporaryFolder temporary;
  Store living = Store::open(temporary / "store", OpenMode::create_or_write);
  const auto living_folder = living.staging_folder();
  const auto dead =
      temporary / "store" / "staging" / "1-abcdef";  // pid 1 lives, but does not hold the lock
  std::filesystem::create_directory(dead);
  samples::write_file(dead / "half", "half a granule");
  Store other = Store::open(temporary / "store", OpenMode::create_or_write);
  const auto report = other.check(false);
  EXPECT_TRUE(report.sound);
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NE(report.findings[0].found.find("1-abcdef"), std::string::npos);
  const auto other_folder = other.staging_folder();
  EXPECT_FALSE(std::filesystem::exists(dead));
  EXPECT_TRUE(std::filesystem::exists(living_folder));
  EXPECT_NE(living_folder, other_folder);
}

}  // namespace
}  // namespace slackwater::store::tests::store_test
