// What `verify` scores: forecasts of known error, issued, run again, hindcast, through the store.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/load_site_data.h"
#include "api/pipeline/verify.h"
#include "api/show/morning/verified_text.h"
#include "calibration/verify/skill_set.h"
#include "calibration/verify/verdict.h"
#include "fields/base/error.h"
#include "fields/record/leading_dataset.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/support/known_error_for_tests.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api::verify_as_issued_test {
namespace {

using calibration::Method;
using calibration::SkillEntry;
using std::chrono::days;
using std::chrono::hours;
using tests::WaterForTests;

const UtcDay first_day = parse_day("2025-03-01");
constexpr int days_stored = 20;

/// Twenty days of the test water's currents, and forecasts of any error beside them.
class KnownErrors : public ::testing::Test {
 protected:
  KnownErrors() {
    site_.id = site_.name = "test_site";
    site_.point =
        GeoPoint::from_degrees(WaterForTests::site_latitude_deg, WaterForTests::site_longitude_deg);
    site_.water_depth_m = WaterForTests::depth_m;
    const auto products = ingest::ProductCatalogue::load(tests::source_folder() / "data/products");
    for (int i = 0; i < days_stored; ++i) {
      const auto file = folder_ / ("currents-" + std::to_string(i) + ".nc");
      const auto product = tests::current_product(first_day + days(i));
      static_cast<void>(ingest_file(store_, products, tests::write_product(file, product), {},
                                    UtcTime(first_day + days(i)) + hours(26), {}));
    }
    data_.emplace(load_site_data(store_, site_, UtcTime(first_day),
                                 UtcTime(first_day) + days(days_stored + 4)));
  }

  /// Day D as the i-th of the record.
  static UtcDay day(int i) { return first_day + days(i); }
  static UtcTime morning_of(int i) { return UtcTime(day(i)) + hours(29); }

  /// Files a forecast of day D that is wrong by `error_m_s`, to the east, everywhere.
  std::int64_t file(int i, double error_m_s, UtcTime issued,
                    ForecastOrigin origin = ForecastOrigin::forecast) {
    const ColumnData& column = data_->columns.front();
    const Snapshot made = tests::forecast_of_known_error(
        site_.id, day(i), issued, column.point, {0, 5, 10, 20, 30},
        [&](UtcTime time, double depth_m) {
          const tests::ProductCell cell{time, depth_m, site_.point.latitude_deg(),
                                        site_.point.longitude_deg()};
          return Horizontal(WaterForTests::eastward_m_s(cell) + error_m_s,
                            WaterForTests::northward_m_s(cell));
        });
    const auto dataset =
        leading_dataset(column.current, UtcTime(day(i)), UtcTime(day(i)) + days(1));
    store::NewForecast row;
    row.content_file = store_.staging_folder() / "made_up.nc";
    ingest::write_forecast(row.content_file, made);
    row.row.site_id = made.site_id;
    row.row.day = made.day;
    row.row.issued = issued;
    row.row.valid_from = made.time.front();
    row.row.valid_to = made.time.back();
    row.row.origin = origin;
    row.row.summary_json = nlohmann::json{{"dataset", dataset.value()}}.dump();
    row.row.code_version = "test";
    return store_.commit_forecasts(std::span(&row, 1)).front().id;
  }

  std::vector<SkillEntry> scored() { return verify(store_, site_, {}).entries; }

  /// Our own rows over the whole column, lead 0-24 h.
  static std::vector<SkillEntry> ours(const std::vector<SkillEntry>& entries) {
    std::vector<SkillEntry> found;
    for (const SkillEntry& e : entries)
      if (e.method == Method::forecast && e.band == calibration::standard_bands().front() &&
          e.lead == calibration::LeadBin{0, 24})
        found.push_back(e);
    return found;
  }

  PastSkill past(int i) {
    Snapshot now;
    now.day = day(i);
    now.issued = morning_of(i);
    return verify_past(store_, site_, *data_, now, WindPolicy::best);
  }

  tests::TemporaryFolder folder_;
  store::Store store_ = store::Store::open(folder_ / "store", store::OpenMode::create_or_write);
  Site site_;
  std::optional<SiteData> data_;
};

TEST_F(KnownErrors, TheForecastThatWasIssuedIsScoredWhateverWasRunLater) {
  file(5, 0.30, morning_of(5));
  file(5, 0.20, morning_of(5) + hours(2));                   // a file came late
  file(5, 0.01, morning_of(9));                              // run again
  file(5, 0.02, UtcTime(day(6)), ForecastOrigin::hindcast);  // hindcast
  file(6, 0.25, morning_of(6));
  file(5, 0.03, morning_of(5) + hours(3));  // a replay: filed after the next day's forecast
  const std::vector<SkillEntry> rows = ours(scored());
  ASSERT_EQ(rows.size(), 2U) << "a day is one pair";
  EXPECT_EQ(rows[0].issued, morning_of(5) + hours(2));
  EXPECT_EQ(rows[0].origin, ForecastOrigin::forecast);
  EXPECT_NEAR(rows[0].vector.rmse_m_s, 0.20, 1e-4);
  EXPECT_NEAR(rows[1].vector.rmse_m_s, 0.25, 1e-4);
  const PastSkill shown = past(8);
  ASSERT_TRUE(shown.verdict);
  EXPECT_EQ(shown.verdict->forecast.score.pairs, 2U);
  EXPECT_NEAR(shown.verdict->forecast.score.rmse, std::hypot(0.20, 0.25) / std::sqrt(2), 1e-4);
  EXPECT_NE(verified_text(shown).find("2 pairs of days (few: no interval)"), std::string::npos)
      << verified_text(shown);
}

TEST_F(KnownErrors, AHindcastIsNoPastForecast) {
  for (const int i : {4, 5, 6}) file(i, 0.1, UtcTime(day(i + 1)), ForecastOrigin::hindcast);
  const PastSkill none = past(8);
  EXPECT_FALSE(none.verdict);
  EXPECT_NE(verified_text(none).find("Not verified yet"), std::string::npos) << verified_text(none);
  const auto rows = ours(scored());
  ASSERT_EQ(rows.size(), 3U) << "verify scores it, as what it is";
  for (const SkillEntry& e : rows) EXPECT_EQ(e.origin, ForecastOrigin::hindcast);
  file(7, 0.3, morning_of(7));
  const auto entries = scored();
  const auto verdicts = calibration::verdicts_of(entries);
  ASSERT_EQ(verdicts.size(), 2U) << "never in one set with issued forecasts";
  EXPECT_EQ(verdicts[0].forecast.score.pairs, 1U);
  EXPECT_NEAR(verdicts[0].forecast.score.rmse, 0.3, 1e-4);
  EXPECT_EQ(verdicts[1].forecast.score.pairs, 3U);
}

TEST_F(KnownErrors, ABaselineOfTheLaterDaysIsHeldAgainstUsOnThoseDays) {
  // Storms at first: our error is 0.5 m/s on the days before tide-harmonic has its fifteen days.
  for (int i = 11; i <= 17; ++i) file(i, i < 14 ? 0.5 : 0.1, morning_of(i));
  const auto entries = scored();
  const calibration::SkillSet* forecast = nullptr;
  const calibration::SkillSet* tide = nullptr;
  const auto sets = calibration::sets_of(
      calibration::whole_current(entries, WindPolicy::best, ForecastOrigin::forecast));
  for (const calibration::SkillSet& set : sets.sets) {
    if (set.of.lead != calibration::LeadBin{0, 24}) continue;
    if (set.of.method == Method::forecast) forecast = &set;
    if (set.of.method == Method::tide_harmonic) tide = &set;
  }
  ASSERT_TRUE(forecast && tide);
  EXPECT_EQ(forecast->score.pairs, 7U);
  EXPECT_NEAR(forecast->score.rmse, std::sqrt((3 * 0.25 + 4 * 0.01) / 7), 1e-4);
  EXPECT_EQ(tide->score.pairs, 4U);
  EXPECT_EQ(tide->first_day, day(14));
  EXPECT_NEAR(*tide->forecast_rmse, 0.1, 1e-4) << "not 0.34, which is over other days";
}

}  // namespace
}  // namespace slackwater::api::verify_as_issued_test
