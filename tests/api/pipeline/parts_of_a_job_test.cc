// The daily job and the hindcast with a part or a day that fails: what can be issued is issued.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/pipeline/daily_job.h"
#include "api/pipeline/filed_making.h"
#include "api/pipeline/hindcast.h"
#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/issue_forecast.h"
#include "api/pipeline/job_summary.h"
#include "api/pipeline/load_site_data.h"
#include "api/pipeline/snapshot_difference.h"
#include "api/pipeline/verify.h"
#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api::parts_of_a_job_test {
namespace {

using nlohmann::json;
using std::chrono::days;
using std::chrono::hours;
using tests::contains;
using tests::WaterForTests;

const UtcDay first_day = parse_day("2025-03-06");
constexpr int days_stored = 5;

/// Five days of currents and wind, no waves.
class FiveDays : public ::testing::Test {
 protected:
  FiveDays() {
    site_.id = site_.name = "test_site";
    site_.point =
        GeoPoint::from_degrees(WaterForTests::site_latitude_deg, WaterForTests::site_longitude_deg);
    site_.water_depth_m = WaterForTests::depth_m;
    for (int i = 0; i < days_stored; ++i) {
      ingest(tests::current_product(first_day + days(i)));
      ingest(tests::wind_product(first_day + days(i)));
    }
  }

  void ingest(const tests::ProductForTests& product) {
    const auto file = folder_ / ("product-" + std::to_string(++files_) + ".nc");
    static_cast<void>(ingest_file(store_, products_, tests::write_product(file, product), {},
                                  UtcTime(first_day) + days(9), {}));
  }

  DailyJob job_of(UtcDay day, const calibration::DayParts& parts = {}) {
    const SiteData data = load_site_data(store_, site_, UtcTime(first_day),
                                         UtcTime(first_day) + days(days_stored + 4));
    calibration::ForecastOptions options;
    options.day = day;
    options.issued = UtcTime(day) + days(1) + hours(5);
    options.parts = parts;
    return daily_job(data, options);
  }

  HindcastReport hindcast_with(const calibration::DayParts& parts) {
    HindcastOptions options;
    options.from = first_day + days(1);
    options.to = first_day + days(3);
    options.horizon = hours(24);
    options.parts = parts;
    return hindcast(store_, site_, options, {});
  }

  tests::TemporaryFolder folder_;
  store::Store store_ = store::Store::open(folder_ / "store", store::OpenMode::create_or_write);
  const ingest::ProductCatalogue products_ =
      ingest::ProductCatalogue::load(tests::source_folder() / "data/products");
  Site site_;
  int files_ = 0;
};

TEST_F(FiveDays, WhatIsFiledOfTheMakingIsWhatTheForecastKnowsOfIt) {
  const DailyJob job = job_of(first_day + days(2));
  const calibration::ForecastMaking making = calibration::making_of(job.forecast);
  ASSERT_TRUE(making.fit);
  ASSERT_TRUE(making.mixture);
  EXPECT_GT(making.mixture->by_day.size(), 1U) << "later days of lead have shares of their own";
  EXPECT_FALSE(making.sources.empty());
  EXPECT_EQ(filed_making(job_summary(job).dump()), making);
  EXPECT_FALSE(filed_making("{}"));
  EXPECT_FALSE(filed_making("not JSON"));
  EXPECT_FALSE(filed_making(R"({"columns": [{"calibration": {}}]})")) << "of another version";
}

TEST_F(FiveDays, WhatIsPassedOnIsTheForecastThatWasFiled) {
  calibration::ForecastOptions options;
  options.day = first_day + days(3);
  options.issued = UtcTime(first_day) + days(4) + hours(5);
  const Issue issue = issue_forecast(store_, site_, options);
  EXPECT_TRUE(issue.filed.is_new);
  EXPECT_EQ(issue.origin, ForecastOrigin::forecast);
  const Snapshot read = ingest::read_forecast(store_.content_path(issue.filed.content_sha256));
  const Snapshot passed_on = ingest::as_filed(issue.job.forecast.snapshot);
  EXPECT_EQ(difference_of(read, passed_on), "");
  EXPECT_EQ(read.columns[0].member_m_s, passed_on.columns[0].member_m_s);
  EXPECT_EQ(read.columns[0].wind_member_m_s, passed_on.columns[0].wind_member_m_s);
  EXPECT_NE(read.columns[0].member_m_s, issue.job.forecast.snapshot.columns[0].member_m_s)
      << "the file rounds members";
  const Issue again = issue_forecast(store_, site_, options);
  EXPECT_FALSE(again.filed.is_new);
  EXPECT_EQ(again.filed.content_sha256, issue.filed.content_sha256);
}

TEST_F(FiveDays, AForecastThatIsRefusedAtALookIsNotFiled) {
  calibration::ForecastOptions options;
  options.issued = UtcTime(first_day) + days(4) + hours(5);
  EXPECT_THROW(static_cast<void>(issue_forecast(
                   store_, site_, options,
                   [](const Snapshot&) { throw Error(ErrorKind::usage, "not so deep"); })),
               Error);
  EXPECT_TRUE(store_.list_forecasts().empty());
}

TEST_F(FiveDays, APartThatFailsIsInTheStoredHeadlineAndInTheSummary) {
  calibration::DayParts parts;
  parts.of_column.tide = [](auto&&...) -> calibration::FittedTide {
    expects(false, "broken for the test");
    return {};
  };
  const DailyJob job = job_of(first_day + days(2), parts);
  const std::int64_t id = publish(store_, job, ForecastOrigin::forecast).id;
  const auto rows = store_.find_forecasts({});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].id, id);
  EXPECT_TRUE(rows[0].degraded);
  EXPECT_TRUE(contains(rows[0].headline, "he tide failed")) << rows[0].headline;
  const json summary = job_summary(job);
  ASSERT_EQ(summary.at("failed").size(), 1u);
  EXPECT_EQ(summary["failed"][0]["part"], "tide");
  EXPECT_EQ(summary["failed"][0]["column"], 0);
  EXPECT_EQ(summary["failed"][0]["kind"], "internal");
  EXPECT_TRUE(contains(summary["failed"][0]["why"], "broken for the test"));
  const Snapshot read = ingest::read_forecast(store_.content_path(rows[0].content_sha256));
  EXPECT_EQ(read.headline, rows[0].headline);
  EXPECT_EQ(read.columns[0].current_status[0], SampleStatus::ok);
}

/// The currents of the day after those that are stored, with holes.
class AHoledDay : public FiveDays {
 protected:
  static constexpr days after{days_stored};

  void expect_degraded_to_the_day_before(const tests::ProductForTests& holed) {
    ingest(tests::wind_product(first_day + after));
    ingest(holed);
    const DailyJob job = job_of(first_day + after);
    EXPECT_EQ(format_day(job.forecast.plan.day), "2025-03-10");
    (void)publish(store_, job, ForecastOrigin::forecast);
    const auto rows = store_.find_forecasts({});
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_TRUE(rows[0].degraded);
    for (const char* named : {"2025-03-11", "2025-03-10"})
      EXPECT_TRUE(contains(rows[0].headline, named)) << rows[0].headline;
    const Snapshot read = ingest::read_forecast(store_.content_path(rows[0].content_sha256));
    EXPECT_TRUE(read.degraded);
    EXPECT_EQ(read.headline, rows[0].headline);
  }
};

TEST_F(AHoledDay, AGapInTheNewestDayIsAMissingDay) {
  tests::ProductForTests holed = tests::current_product(first_day + after);
  holed.time.erase(holed.time.begin() + 8, holed.time.begin() + 15);
  expect_degraded_to_the_day_before(holed);
}

TEST_F(AHoledDay, ADayOfMissingValuesIsAMissingDay) {
  tests::ProductForTests holed = tests::current_product(first_day + after);
  for (tests::ProductQuantity& q : holed.quantities)
    q.value = [value = q.value](const tests::ProductCell& cell) {
      return cell.time < UtcTime(first_day + after) + hours(12) ? value(cell) : constants::nan;
    };
  expect_degraded_to_the_day_before(holed);
}

TEST_F(FiveDays, WavesOfTheWindAreSaidToBeThatInTheSummary) {
  const json waves = job_summary(job_of(first_day + days(2))).at("waves");
  EXPECT_EQ(waves.at("source"), "computed from the wind");
  const json& computed = waves.at("computed");
  EXPECT_EQ(computed.at("of_wind_alone"), true);
  EXPECT_EQ(computed.at("fetch_assumed"), true);
  EXPECT_EQ(computed.at("fetch_km"), json({200.0, 200.0}));
  EXPECT_LT(computed.at("highest_half_fetch_m"), computed.at("highest_m"));
  EXPECT_GT(computed.at("highest_twice_fetch_m"), computed.at("highest_m"));
}

TEST_F(FiveDays, ADayOfAHindcastThatFailsIsNamedAndTheOthersAreThoseOfAHindcastWithout) {
  const UtcDay bad = first_day + days(2);
  calibration::DayParts parts;
  parts.column = [&](const ColumnData& column, const Site& site,
                     const calibration::ForecastPlan& plan, const calibration::ColumnParts& ours) {
    expects(plan.day != bad, "broken for the test");
    return calibration::forecast_column(column, site, plan, ours);
  };
  const HindcastReport report = hindcast_with(parts);
  ASSERT_EQ(report.skipped.size(), 1u);
  EXPECT_TRUE(contains(report.skipped[0], format_day(bad) + ": nothing can be forecast"))
      << report.skipped[0];
  EXPECT_TRUE(contains(report.skipped[0], "broken for the test")) << report.skipped[0];
  EXPECT_EQ(report.forecasts.size(), 2u);
  const HindcastReport whole = hindcast_with({});
  EXPECT_EQ(whole.forecasts.size(), 3u);
  std::size_t others = 0;
  for (const auto& entry : whole.skill) others += entry.day == bad ? 0 : 1;
  EXPECT_GT(others, 0u);
  EXPECT_EQ(report.skill.size(), others);
}

TEST_F(FiveDays, AHindcastWhoseDaysAllFailIsAnErrorThatSaysWhy) {
  calibration::DayParts parts;
  parts.column = [](auto&&...) -> calibration::ColumnForecast {
    expects(false, "broken for the test");
    return {};
  };
  try {
    (void)hindcast_with(parts);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::internal);
    EXPECT_TRUE(
        contains(error.message(), "no day from 2025-03-07 to 2025-03-09 could be forecast"));
    EXPECT_TRUE(contains(error.message(), "broken for the test")) << error.message();
  }
  EXPECT_TRUE(store_.find_forecasts({}).empty());
}

TEST_F(FiveDays, AForecastThatCannotBeReadIsNamedAndTheOthersAreScored) {
  for (const int i : {1, 2}) publish(store_, job_of(first_day + days(i)), ForecastOrigin::forecast);
  const auto rows = store_.find_forecasts({});
  ASSERT_EQ(rows.size(), 2u);
  const auto damage = [](const std::filesystem::path& file) {
    std::filesystem::permissions(file, std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::add);
    tests::write_bytes(file, "not a forecast any more");
  };
  damage(store_.content_path(rows[0].content_sha256));
  const calibration::Verification result = verify(store_, site_, {});
  ASSERT_EQ(result.unscored.size(), 1u);
  EXPECT_TRUE(contains(result.unscored[0], "forecast " + std::to_string(rows[0].id) + " of site"))
      << result.unscored[0];
  EXPECT_FALSE(result.entries.empty());
  for (const auto& entry : result.entries) EXPECT_EQ(entry.day, rows[1].day);
  damage(store_.content_path(rows[1].content_sha256));
  EXPECT_THROW((void)verify(store_, site_, {}), Error) << "none is left to score";
}

}  // namespace
}  // namespace slackwater::api::parts_of_a_job_test
