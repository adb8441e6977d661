// Six-hourly currents without tide (GLO12's uo and vo) of a sea with known truth, through the real
// ingest: inertial motion and eddies, which a harmonic fit takes for tide.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "api/pipeline/daily_job.h"
#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/load_site_data.h"
#include "fields/base/numbers/random.h"
#include "fields/current/coriolis.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::detided_test {
namespace {

using std::chrono::days;
using std::chrono::hours;

const UtcDay first_day = parse_day("2024-03-01");
constexpr int record_days = 15;
constexpr double latitude_deg = 36.0;  // inertial period 20.4 h
const UtcTime end_of_record = UtcTime(first_day) + days(record_days);

/// Inertial motion that is made anew within four days, eddies within five; less of both below.
class Sea {
 public:
  explicit Sea(std::uint64_t seed) {
    Rng random(seed, "tests/detided");
    const auto one = [&] {
      const double east = random.normal();
      return Horizontal(east, random.normal()) / std::sqrt(2.0);
    };
    const double f_rad_h = 3600 * coriolis_parameter_rad_s(Angle::from_degrees(latitude_deg));
    const double kept = std::exp(-1 / 96.0);
    const double kept_slow = std::exp(-1 / 120.0);
    Horizontal inertial = inertial_m_s * one();
    Horizontal eddies = eddies_m_s * one();
    for (int h = 0; h <= 24 * (record_days + 3); ++h) {
      hour_.push_back(inertial + eddies);
      inertial =
          inertial * std::polar(kept, -f_rad_h) + inertial_m_s * std::sqrt(1 - kept * kept) * one();
      eddies = kept_slow * eddies + eddies_m_s * std::sqrt(1 - kept_slow * kept_slow) * one();
    }
  }
  /// At whole hours.
  [[nodiscard]] Horizontal at(UtcTime time, double depth_m) const {
    const double hour = hours_between(UtcTime(first_day), time);
    return std::exp(-depth_m / 60) * hour_[static_cast<std::size_t>(std::lround(hour))];
  }

 private:
  static constexpr double inertial_m_s = 0.15;
  static constexpr double eddies_m_s = 0.05;
  std::vector<Horizontal> hour_;
};

/// The file as a provider writes it whose product `title` names.
calibration::DailyForecast forecast_of(const Sea& sea, const char* title) {
  ProductForTests product = current_product(first_day, 0);
  product.title = title;
  for (UtcTime time(first_day); time <= end_of_record; time += hours(6))
    product.time.push_back(time);
  product.depth_m = {0, 15, 40};
  product.latitude_deg = {35.9, 36.0, 36.1};
  product.longitude_deg = {6.4, 6.5, 6.6};
  product.quantity("uo").value = [&](const ProductCell& cell) {
    return sea.at(cell.time, cell.depth_m).real();
  };
  product.quantity("vo").value = [&](const ProductCell& cell) {
    return sea.at(cell.time, cell.depth_m).imag();
  };
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  const auto products = ingest::ProductCatalogue::load(source_folder() / "data" / "products");
  static_cast<void>(api::ingest_file(store, products, write_product(folder / "uv.nc", product), {},
                                     end_of_record + hours(4), {}));
  Site site;
  site.id = site.name = "deep";
  site.point = GeoPoint::from_degrees(latitude_deg, 6.5);
  site.water_depth_m = 2000;
  calibration::ForecastOptions options;
  options.issued = end_of_record + hours(5);
  return api::daily_job(api::load_site_data(store, site, UtcTime(first_day), end_of_record),
                        options)
      .forecast;
}

double squared_error(const Sea& sea, const Snapshot& made) {
  double sum = 0;
  for (std::size_t t = 1; t < made.time.size(); ++t) {
    for (std::size_t k = 0; k < made.depth_m.size(); ++k) {
      const std::size_t o = t * made.depth_m.size() + k;
      sum += std::norm(made.columns[0].current_m_s[o] - sea.at(made.time[t], made.depth_m[k]));
    }
  }
  return sum / static_cast<double>((made.time.size() - 1) * made.depth_m.size());
}

std::size_t notes_on_tide(const calibration::DailyForecast& made) {
  const auto& notes = made.columns.at(0).notes;
  return static_cast<std::size_t>(std::count_if(
      notes.begin(), notes.end(),
      [](const std::string& note) { return note.find("are detided") != std::string::npos; }));
}

bool has_weight(const calibration::DailyForecast& made, calibration::Method method) {
  const auto& share = made.earned->blend.share;
  return std::any_of(share.begin(), share.end(),
                     [&](const auto& s) { return s.method == method && s.weight > 0; });
}

TEST(Detided, SixHourlyCurrentsWithoutTideAreBetterForecastWithoutOne) {
  constexpr int seeds = 16;
  double as_it_is = 0;
  double as_if_tidal = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Sea sea(static_cast<std::uint64_t>(seed));
    const auto detided = forecast_of(sea, "GLOBAL_ANALYSISFORECAST_PHY_001_024 6-hourly currents");
    const auto tidal = forecast_of(sea, "NWSHELF_ANALYSISFORECAST_PHY_004_013 6-hourly currents");
    EXPECT_EQ(notes_on_tide(detided), 1U);
    EXPECT_EQ(notes_on_tide(tidal), 0U);
    ASSERT_TRUE(detided.earned);
    EXPECT_FALSE(has_weight(detided, calibration::Method::tide_harmonic));
    EXPECT_FALSE(has_weight(detided, calibration::Method::tide_phase));
    as_it_is += squared_error(sea, detided.snapshot) / seeds;
    as_if_tidal += squared_error(sea, tidal.snapshot) / seeds;
  }
  std::printf("detided, %d seas: error %.4f m/s, with a fitted tide %.4f m/s\n", seeds,
              std::sqrt(as_it_is), std::sqrt(as_if_tidal));
  EXPECT_LT(std::sqrt(as_it_is), 0.99 * std::sqrt(as_if_tidal));
}

}  // namespace
}  // namespace slackwater::tests::detided_test
