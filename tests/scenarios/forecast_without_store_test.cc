// One forecast, whichever way its files come: through a store, or read by a program that has none.
#include <gtest/gtest.h>

#include <cstring>

#include "api/made_up/synthetic/product_files.h"
#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/load_site_data.h"
#include "calibration/day/daily_forecast.h"
#include "calibration/verify/score_forecast.h"
#include "ingest/read_pieces.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api::forecast_without_store_test {
namespace {

using std::chrono::days;
using std::chrono::hours;

/// What is forecast, and from what.
struct Task {
  Site site;
  UtcDay day;
  std::vector<std::filesystem::path> files;
  ingest::IngestOptions options;

  [[nodiscard]] UtcTime from() const { return UtcTime(day) - calibration::history_wanted; }
  [[nodiscard]] UtcTime to() const { return UtcTime(day) + days(4); }
};

ingest::ProductCatalogue products() {
  return ingest::ProductCatalogue::load(tests::source_folder() / "data" / "products");
}

SiteData through_a_store(const Task& task) {
  const tests::TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  for (const auto& file : task.files)
    static_cast<void>(ingest_file(store, products(), file, task.options, UtcTime{}, {}));
  return load_site_data(store, task.site, task.from(), task.to());
}

SiteData without_a_store(const Task& task) {
  std::vector<ingest::FileToRead> files;
  for (const auto& file : task.files) files.push_back({file, task.options, UtcTime{}});
  return site_data_of(
      task.site, ingest::read_pieces(files, products(), task.site, task.from(), task.to()).pieces);
}

template <typename T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same_bits(const ForecastColumn& a, const ForecastColumn& b) {
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.water_depth_m, b.water_depth_m);
  EXPECT_EQ(a.water_depth_source, b.water_depth_source);
  EXPECT_TRUE(same_bits(a.current_m_s, b.current_m_s));
  EXPECT_TRUE(same_bits(a.current_sigma_m_s, b.current_sigma_m_s));
  EXPECT_EQ(a.current_status, b.current_status);
  EXPECT_TRUE(same_bits(a.member_m_s, b.member_m_s));
  EXPECT_TRUE(same_bits(a.wind_m_s, b.wind_m_s));
  EXPECT_EQ(a.wind_source, b.wind_source);
  EXPECT_TRUE(same_bits(a.wind_member_m_s, b.wind_member_m_s));
  EXPECT_TRUE(same_bits(a.sea, b.sea));
  EXPECT_EQ(a.sea_source, b.sea_source);
}

void expect_same_bits(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.site_id, b.site_id);
  EXPECT_EQ(a.day, b.day);
  EXPECT_EQ(a.issued, b.issued);
  EXPECT_EQ(a.wind_policy, b.wind_policy);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.depth_m, b.depth_m);
  EXPECT_EQ(a.members, b.members);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.degraded, b.degraded);
  EXPECT_EQ(a.contains_stokes, b.contains_stokes);
  EXPECT_EQ(a.headline, b.headline);
  EXPECT_EQ(a.attributions, b.attributions);
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t i = 0; i < a.columns.size(); ++i) expect_same_bits(a.columns[i], b.columns[i]);
}

/// The two forecasts, and what they say of themselves when the next day is in.
void expect_one_forecast(const Task& task) {
  const SiteData stored = through_a_store(task);
  const SiteData read = without_a_store(task);
  calibration::ForecastOptions job;
  job.day = task.day;
  job.issued = UtcTime(task.day) + days(1) + hours(5);
  const calibration::DailyForecast a = calibration::make_forecast(stored, job);
  const calibration::DailyForecast b = calibration::make_forecast(read, job);
  EXPECT_FALSE(a.columns.front().forms.empty()) << "the day was not fitted";
  expect_same_bits(a.snapshot, b.snapshot);
  EXPECT_EQ(a.plan.dataset, b.plan.dataset);
  EXPECT_EQ(a.input_granules, b.input_granules);
  ASSERT_EQ(a.columns.front().origins.size(), b.columns.front().origins.size());
  for (std::size_t i = 0; i < a.columns.front().origins.size(); ++i)
    EXPECT_EQ(a.columns.front().origins[i]->sources, b.columns.front().origins[i]->sources);

  const auto skill = calibration::score_forecast(stored, a.snapshot, {a.plan.dataset}, {}).entries;
  const auto again = calibration::score_forecast(read, b.snapshot, {b.plan.dataset}, {}).entries;
  EXPECT_FALSE(skill.empty());
  ASSERT_EQ(skill.size(), again.size());
  for (std::size_t i = 0; i < skill.size(); ++i) {
    EXPECT_EQ(skill[i].method, again[i].method);
    EXPECT_EQ(skill[i].vector.rmse_m_s, again[i].vector.rmse_m_s);
  }
}

TEST(ForecastWithoutAStore, IsThatOfAStoreOfTheSameSyntheticFiles) {
  const tests::TemporaryFolder folder;
  const SyntheticOcean ocean;
  const UtcDay first = ocean.settings().first_day;
  Task task;
  task.day = first + days(4);
  const UtcTime end = UtcTime(task.day) + days(1);
  task.site = find_site(write_site_yaml(ocean, folder.path()).string(), {});
  task.site.water_depth_m.reset();  // the bathymetry's
  task.files = {write_bathymetry(ocean, folder.path())};
  for (UtcDay day = first; day <= task.day + days(1); day += days(1)) {
    for (const auto& file : write_current_product(ocean, day, day, folder.path()))
      task.files.push_back(file);
    task.files.push_back(write_wave_product(ocean, day, day, folder.path()));
    task.files.push_back(write_wind_analysis(ocean, day, day, folder.path()));
  }
  task.files.push_back(write_current_forecast(ocean, end, 24, folder.path()));
  task.files.push_back(write_wind_forecast(ocean, end, 72, folder.path()));
  task.files.push_back(write_wave_forecast(ocean, end, 72, folder.path()));
  expect_one_forecast(task);
}

TEST(ForecastWithoutAStore, IsThatOfAStoreOfTheSameFilesOffBrest) {
  SLACKWATER_NEEDS_SHARED(shared);
  for (const char* const date : {"2023-11-02", "2024-06-01", "2024-08-05"}) {
    SCOPED_TRACE(date);
    Task task;
    task.day = parse_day(date);
    task.site.id = "brest";
    task.site.point = GeoPoint::from_degrees(46.83334, -6.083328);
    for (const char* const part : {"_currents.nc", "_wind.nc"})
      task.files.push_back(shared / "data/brest/windows" / (std::string(date) + part));
    expect_one_forecast(task);
  }
}

TEST(ForecastWithoutAStore, IsThatOfAStoreWhereEastAndNorthAreFilesOfTheirOwn) {
  SLACKWATER_NEEDS_SHARED(shared);
  Task task;
  task.day = parse_day("2021-10-12");
  task.site.id = "otranto";
  task.site.point = GeoPoint::from_degrees(40.4, 18.9);
  task.files = product_files({shared / "data/otranto_2021-10"});
  task.options.as = DataStatus::analysis;
  expect_one_forecast(task);
}

}  // namespace
}  // namespace slackwater::api::forecast_without_store_test
