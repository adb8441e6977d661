// The provider's own forecast on real analyses: a later day's file is ingested as the forecast that
// was issued at the end of the day before, as it is (a perfect provider) and with a smooth error.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/load_site_data.h"
#include "calibration/day/daily_forecast.h"
#include "calibration/verify/score_forecast.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/scenarios/real_pairs.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::real_provider_test {
namespace {

using std::chrono::days;

/// 0.06 m/s, turning once in eight days.
Horizontal smooth_error(UtcTime time) {
  return std::polar(0.06, 2 * std::numbers::pi * hours_between(UtcTime{}, time) / 192);
}

struct RealSet {
  const char* name;
  std::filesystem::path currents;
  std::filesystem::path wind;
  const char* day;
  /// Files as forecasts, with the days at whose start they were issued.
  std::vector<std::pair<std::string, const char*>> runs;
  std::size_t every = 1;  ///< of the wet cells
};

void ingest_as_forecast(store::Store& store, const RealSet& set) {
  const auto products = ingest::ProductCatalogue::load(source_folder() / "data" / "products");
  for (const auto& [part, day] : set.runs) {
    ingest::IngestOptions options;
    options.as = DataStatus::forecast;
    options.issued = UtcTime(parse_day(day));
    for (const auto& file : api::product_files({set.currents})) {
      if (file.filename().string().find(part) == std::string::npos) continue;
      // It came in long after: the moment of issue counts.
      static_cast<void>(
          api::ingest_file(store, products, file, options, UtcTime(parse_day("2030-01-01")), {}));
    }
  }
}

/// Root mean square error of the first day of lead, of what is issued and of the provider.
struct DayErrors {
  double issued = 0;
  double provider = 0;
};

DayErrors errors_of(const SiteData& data, UtcDay day) {
  calibration::ForecastOptions options;
  options.day = day;
  options.issued = UtcTime(day) + days(1);
  options.horizon = std::chrono::hours(24);
  options.hindsight = true;
  options.threads = 2;
  const calibration::DailyForecast made = calibration::make_forecast(data, options);
  calibration::VerifyOptions verify;
  verify.from_archive = true;
  verify.bands = {{0, 150}};
  verify.leads = {{0, 24}};
  DayErrors errors;
  for (const calibration::SkillEntry& entry :
       calibration::score_forecast(data, made.snapshot, {made.plan.dataset}, verify).entries) {
    if (entry.variable != calibration::current_variable || entry.lead.to_h != 24) continue;
    if (entry.lead.from_h != 0 || entry.column) continue;
    if (entry.method == calibration::Method::forecast) errors.issued = entry.vector.rmse_m_s;
    if (entry.method == calibration::Method::provider) errors.provider = entry.vector.rmse_m_s;
  }
  return errors;
}

bool is_run(const PieceColumn<Horizontal>& piece) {
  return piece.origin->status == DataStatus::forecast;
}

void drop_runs(SiteData& data) {
  for (ColumnData& column : data.columns) std::erase_if(column.current.pieces, is_run);
}

void add_smooth_error(SiteData& data) {
  for (ColumnData& column : data.columns) {
    for (auto& piece : column.current.pieces) {
      if (!is_run(piece)) continue;
      for (std::size_t t = 0; t < piece.column.times(); ++t) {
        for (std::size_t k = 0; k < piece.column.levels(); ++k) {
          piece.column.value[piece.column.offset(t, k)] +=
              smooth_error(piece.column.time[t].centre());
        }
      }
    }
  }
}

void expect_the_provider_helps(const RealSet& set) {
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  ingest_all(store, {set.currents}, true);
  ingest_all(store, {set.wind}, false);
  ingest_as_forecast(store, set);
  std::vector<GeoPoint> cells = wet_cells(store, 0, 1);
  std::vector<GeoPoint> some;
  for (std::size_t i = 0; i < cells.size(); i += set.every) some.push_back(cells[i]);
  const UtcDay day = parse_day(set.day);
  SiteData data =
      api::load_site_data(store, site_of(set.name, some),
                          UtcTime(day) - calibration::history_wanted, UtcTime(day) + days(3));
  const DayErrors perfect = errors_of(data, day);
  add_smooth_error(data);
  const DayErrors smooth = errors_of(data, day);
  drop_runs(data);
  const DayErrors ours = errors_of(data, day);
  std::printf(
      "%-8s %zu columns: ours %.4f; perfect provider %.4f, issued %.4f; its error smooth %.4f, "
      "issued %.4f m/s\n",
      set.name, some.size(), ours.issued, perfect.provider, perfect.issued, smooth.provider,
      smooth.issued);
  EXPECT_LT(perfect.provider, 1e-6) << "the same file";
  EXPECT_LT(perfect.issued, 0.35 * ours.issued);
  EXPECT_NEAR(smooth.provider, 0.06, 1e-3);
  EXPECT_LT(smooth.issued, smooth.provider);
  EXPECT_LT(smooth.issued, ours.issued);
}

TEST(RealProvider, Otranto) {
  SLACKWATER_NEEDS_SHARED(shared);
  expect_the_provider_helps({"otranto",
                             shared / "data/otranto_2021-10/currents",
                             shared / "data/otranto_2021-10/wind",
                             "2021-10-13",
                             {{"211013", "2021-10-13"}, {"211014", "2021-10-14"}},
                             200});
}

TEST(RealProvider, Elba) {
  SLACKWATER_NEEDS_SHARED(shared);
  expect_the_provider_helps({"elba",
                             shared / "data/elba_2014-05/currents",
                             shared / "data/elba_2014-05/wind",
                             "2014-05-18",
                             {{"20140518", "2014-05-18"},
                              {"20140519", "2014-05-19"},
                              {"20140520", "2014-05-19"}},  // they run from noon to noon
                             24});
}

TEST(RealProvider, Brest) {
  SLACKWATER_NEEDS_SHARED(shared);
  expect_the_provider_helps({"brest",
                             shared / "data/brest/windows/2024-06-01_currents.nc",
                             shared / "data/brest/windows/2024-06-01_wind.nc",
                             "2024-06-01",
                             {{"2024-06-01", "2024-06-02"}},
                             1});
}

}  // namespace
}  // namespace slackwater::tests::real_provider_test
