#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "api/pipeline/daily_job.h"
#include "api/pipeline/hindcast.h"
#include "api/pipeline/job_summary.h"
#include "api/pipeline/load_site_data.h"
#include "fields/base/numbers/random.h"
#include "tests/scenarios/real_pairs.h"
#include "tests/support/point_series_for_tests.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/temporary_folder.h"

// An ocean whose truth is known, a product that errs for days on end, and a profiler near the site:
// does tomorrow's forecast profit? The whole way is walked: files, store, calibration, forecast.
// The product's error and the difference between two places are drawn anew with every seed, with
// other memories and shapes in depth than calibration/fuse assumes.

namespace slackwater::tests::fusion_twin_test {
namespace {

const UtcDay first_day = parse_day("2024-03-01");
constexpr int days_before = 16;  // the last is D
const UtcDay day_d = first_day + std::chrono::days(days_before - 1);
constexpr double site_latitude = 54.0;
constexpr double site_longitude = 6.5;
constexpr double metres_per_degree = 111320.0;

/// Tide with less of it at the bed, on a drift that turns within a fortnight.
Horizontal truth(UtcTime time, double depth_m) {
  const double hour = hours_between(UtcTime(first_day), time);
  const double m2 = 2 * std::numbers::pi * hour / 12.4206;
  const Horizontal tide{0.45 * std::cos(m2), 0.18 * std::sin(m2)};
  const Horizontal drift = std::polar(0.06, 2 * std::numbers::pi * hour / 340);
  return (1 - 0.3 * std::pow(depth_m / 30, 3)) * tide + (1 - 0.5 * depth_m / 30) * drift;
}

/// A red process in time, linear in depth: hourly values at the surface and the bed.
class SlowError {
 public:
  SlowError(Rng& random, double sigma_m_s, double memory_h, int hours) {
    const double a = std::exp(-1 / memory_h);
    for (auto& end : ends_) {
      Horizontal x = sigma_m_s * Horizontal{random.normal(), random.normal()};
      for (int h = 0; h <= hours; ++h) {
        end.push_back(x);
        x = a * x + sigma_m_s * std::sqrt(1 - a * a) * Horizontal{random.normal(), random.normal()};
      }
    }
  }
  /// Linear between the hours and between the ends: the barotropic part is common to both.
  [[nodiscard]] Horizontal at(UtcTime time, double depth_m) const {
    const double hour = std::max(0.0, hours_between(UtcTime(first_day), time));
    const auto low = std::min(static_cast<std::size_t>(hour), ends_[0].size() - 2);
    const double share = hour - static_cast<double>(low);
    const auto value = [&](const std::vector<Horizontal>& end) {
      return (1 - share) * end[low] + share * end[low + 1];
    };
    return 0.8 * value(ends_[0]) + 0.6 * (1 - 2 * depth_m / 30) * value(ends_[1]);
  }

 private:
  std::array<std::vector<Horizontal>, 2> ends_;
};

/// The ocean of one seed.
struct Twin {
  explicit Twin(std::uint64_t seed)
      : random(seed, "fusion_twin"),
        slow(random, 0.10, 96, 24 * (days_before + 3)),
        quick(random, 0.04, 4, 24 * (days_before + 3)),
        elsewhere(random, 0.04, 30, 24 * (days_before + 3)),
        noise(seed, "fusion_twin/noise") {}

  Rng random;
  SlowError slow;
  SlowError quick;
  SlowError elsewhere;  ///< of the profiler's place against the site
  Rng noise;
};

/// Where a profiler stands and what is wrong with it.
struct Profiler {
  double distance_m = 2000;
  Horizontal offset{};         ///< it is simply wrong
  int last_day = days_before;  ///< stops after this day
  double difference = 1;       ///< share of `elsewhere`
  double noise_m_s = 0.02;     ///< of a bin in one sample
  Horizontal turn{1, 0};       ///< its frame against true north
  double late_h = 0;           ///< its clock
  double stuck_h = 0;          ///< at the end
  double spikes = 0;           ///< share of its values that are wild
  std::string station = "NEAR";
  std::optional<double> standard_error_m_s;
};

void write_product_days(const TemporaryFolder& folder, store::Store& store, const Twin& twin,
                        double share_of_error) {
  ProductForTests product = current_product(first_day, 24 * days_before + 1);
  product.latitude_deg = {53.9, 54.0, 54.1};
  product.longitude_deg = {6.4, 6.5, 6.6};
  const auto value = [&twin, share_of_error](const ProductCell& cell) {
    return truth(cell.time, cell.depth_m) +
           share_of_error *
               (twin.slow.at(cell.time, cell.depth_m) + twin.quick.at(cell.time, cell.depth_m));
  };
  product.quantity("uo").value = [value](const ProductCell& cell) { return value(cell).real(); };
  product.quantity("vo").value = [value](const ProductCell& cell) { return value(cell).imag(); };
  ingest_all(store, {write_product(folder / "product.nc", product)}, true);
}

void write_profiler(const TemporaryFolder& folder, store::Store& store, Twin& twin,
                    const Profiler& profiler) {
  PointSeriesForTests series;
  series.station = profiler.station;
  series.standard_error_m_s = profiler.standard_error_m_s;
  series.latitude_deg = site_latitude + profiler.distance_m / metres_per_degree;
  series.longitude_deg = site_longitude;
  series.time = stepping_times(first_day, profiler.last_day, 10);
  series.depth_m = {4, 7, 10, 13, 16, 19, 22, 25};
  Rng wild(1, "fusion_twin/spikes");
  std::map<double, Horizontal> last;
  series.value = [&](UtcTime time, double depth) {
    const UtcTime then = add_hours(time, -profiler.late_h);
    const Horizontal seen =
        truth(then, depth) + profiler.difference * twin.elsewhere.at(then, depth);
    Horizontal value = profiler.turn * seen + profiler.offset +
                       profiler.noise_m_s * Horizontal{twin.noise.normal(), twin.noise.normal()};
    if (wild.uniform() < profiler.spikes)
      value += std::polar(1.2, wild.uniform(0, 2 * std::numbers::pi));
    Horizontal& kept = last[depth];
    if (hours_between(time, UtcTime(day_d) + std::chrono::days(1)) > profiler.stuck_h) kept = value;
    return kept;
  };
  ingest_all(store, {write_point_series(folder / (profiler.station + ".nc"), series)}, false);
}

struct Issued {
  calibration::DailyForecast forecast;
  std::string summary_json;
  double rmse_m_s = 0;  ///< of the vector against the truth at the site, lead (0, 24] h
};

Site twin_site() {
  Site site = site_of("twin", {GeoPoint::from_degrees(site_latitude, site_longitude)});
  site.columns.clear();
  site.water_depth_m = 30;
  return site;
}

Issued issue(std::uint64_t seed, const std::vector<Profiler>& profilers,
             double share_of_error = 1) {
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  Twin twin(seed);
  write_product_days(folder, store, twin, share_of_error);
  for (const Profiler& profiler : profilers) write_profiler(folder, store, twin, profiler);
  const Site site = twin_site();
  const UtcTime end = UtcTime(day_d) + std::chrono::days(1);
  const SiteData data =
      api::load_site_data(store, site, UtcTime(first_day), end + std::chrono::days(1));
  calibration::ForecastOptions options;
  options.day = day_d;
  options.issued = end;
  options.horizon = std::chrono::hours(24);
  Issued issued;
  api::DailyJob job = api::daily_job(data, options);
  issued.summary_json = api::job_summary(job).dump();
  issued.forecast = std::move(job.forecast);
  const Snapshot& snapshot = issued.forecast.snapshot;
  double squares = 0;
  int count = 0;
  for (std::size_t t = 1; t < snapshot.time.size(); ++t) {
    for (std::size_t k = 0; k < snapshot.depth_m.size(); ++k) {
      const Horizontal value =
          snapshot.columns.front().current_m_s[t * snapshot.depth_m.size() + k];
      squares += std::norm(value - truth(snapshot.time[t], snapshot.depth_m[k]));
      ++count;
    }
  }
  issued.rmse_m_s = std::sqrt(squares / count);
  return issued;
}

/// Twelve oceans; two under the sanitizers, where each takes ten times as long.
#ifdef __SANITIZE_ADDRESS__
const std::vector<std::uint64_t> seeds{1, 2};
#else
const std::vector<std::uint64_t> seeds{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
#endif

/// The error of each seed.
std::vector<double> errors(const std::vector<Profiler>& profilers, double share_of_error = 1) {
  std::vector<double> found;
  for (const std::uint64_t seed : seeds)
    found.push_back(issue(seed, profilers, share_of_error).rmse_m_s);
  return found;
}

double pooled(const std::vector<double>& errors) {
  double squares = 0;
  for (const double error : errors) squares += error * error;
  return std::sqrt(squares / static_cast<double>(errors.size()));
}

const std::vector<double>& without_profiler() {
  static const std::vector<double> found = errors({});
  return found;
}

TEST(FusionTwin, AProfilerNearTheSiteSharpensTomorrowsForecast) {
  Profiler at_hand;
  at_hand.distance_m = 300;
  at_hand.difference = 0.3;
  const double alone = pooled(without_profiler());
  const double near = pooled(errors({at_hand}));
  const std::vector<double> at_two_kilometres = errors({Profiler{}});
  const double two_kilometres = pooled(at_two_kilometres);
  const double without_error = pooled(errors({}, 0));
  int sharper = 0;
  for (std::size_t i = 0; i < seeds.size(); ++i)
    sharper += at_two_kilometres[i] < without_profiler()[i] ? 1 : 0;
  std::printf(
      "D+1 error over %zu seeds: product alone %.4f, with a profiler at 2 km %.4f (sharper in %d), "
      "at 0.3 km %.4f, of a product without error %.4f\n",
      seeds.size(), alone, two_kilometres, sharper, near, without_error);
  EXPECT_LT(two_kilometres, 0.75 * alone);
  EXPECT_LT(near, 0.65 * alone);
  EXPECT_GE(6 * sharper, 5 * static_cast<int>(seeds.size()));
  // What is left is what no observation of D can mend.
  EXPECT_LT(near, 2.0 * without_error);
}

TEST(FusionTwin, TheProfilerIsTheTruthAtItsOwnDepthsAndTimes) {
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  Twin twin(2);
  write_product_days(folder, store, twin, 1);
  Profiler longer;
  longer.last_day = days_before + 1;
  write_profiler(folder, store, twin, longer);
  api::HindcastOptions options;
  options.from = options.to = day_d;
  options.horizon = std::chrono::hours(24);
  options.verify.leads = {{0, 24}};
  options.verify.bands = {{0, 100}};
  using calibration::Method;
  std::set<Method> methods;
  for (const calibration::SkillEntry& entry :
       api::hindcast(store, twin_site(), options, {}).skill) {
    const bool is_whole_day = entry.lead.from_h == 0 && entry.lead.to_h == 24;
    if (entry.variable != "sea_water_velocity" || !is_whole_day) continue;
    methods.insert(entry.method);
    EXPECT_EQ(entry.truth, "station NEAR");
    // Eight depths, every ten minutes from 00:10 to 23:50; the repetitions need a value there.
    if (entry.method == Method::forecast || entry.method == Method::day_mean) {
      EXPECT_EQ(entry.vector.n, 8U * 143U) << name_of(entry.method);
    }
  }
  for (const Method method : {Method::forecast, Method::persistence, Method::day_mean,
                              Method::tide_phase, Method::tide_harmonic})
    EXPECT_TRUE(methods.contains(method)) << name_of(method);
}

TEST(FusionTwin, TheRecordSaysWithWhatItWasFused) {
  const Issued issued = issue(1, {Profiler{}});
  const std::vector<std::string>& notes = issued.forecast.columns.front().notes;
  EXPECT_NE(std::find(notes.begin(), notes.end(), "fused with station NEAR at 2.0 km"),
            notes.end());
  EXPECT_NE(issued.summary_json.find("fused with station NEAR at 2.0 km"), std::string::npos);
  EXPECT_EQ(issued.forecast.input_granules.size(), 2U) << "the product's and the profiler's";
  EXPECT_EQ(issued.forecast.snapshot.depth_m, (std::vector<double>{0, 5, 10, 20, 30}))
      << "the product's levels, from surface to bed";
}

TEST(FusionTwin, AWrongProfilerFarAwayChangesNothing) {
  Profiler far;
  far.distance_m = 12000;
  far.offset = {0.5, -0.5};
  EXPECT_EQ(issue(3, {far}).rmse_m_s, issue(3, {}).rmse_m_s);
}

TEST(FusionTwin, AProfilerAtTheEdgeOfReachThatSeesOtherWaterDoesNotHarm) {
  Profiler edge;
  edge.distance_m = 9500;
  edge.difference = 2.5;  // 10 cm/s of its own: as much as the product errs
  EXPECT_LT(pooled(errors({edge})), 1.02 * pooled(without_profiler()));
}

TEST(FusionTwin, AProfilerThatFellSilentDaysAgoDoesNotHarmAndIsSaidToBeUnused) {
  Profiler stale;
  stale.last_day = days_before - 4;
  EXPECT_LT(pooled(errors({stale})), 1.03 * pooled(without_profiler()));
  const Issued issued = issue(1, {stale});
  EXPECT_NE(
      issued.summary_json.find("station NEAR at 2.0 km is not used: it ended 4.0 days before"),
      std::string::npos);
  EXPECT_EQ(issued.summary_json.find("fused with"), std::string::npos);
  EXPECT_EQ(issued.forecast.snapshot.headline.find("NEAR"), std::string::npos) << "late, no liar";
}

TEST(FusionTwin, AProfilerThatLiesIsLeftOutAndNamed) {
  // What is said of each; the forecast is the product's.
  Profiler biased;
  biased.offset = {1, 0};
  Profiler reversed;
  reversed.turn = {-1, 0};
  Profiler turned;
  turned.turn = std::polar(1.0, std::numbers::pi / 6);
  Profiler late;
  late.late_h = 3;
  const double alone = issue(3, {}).rmse_m_s;
  for (const auto& [liar, why] : {std::pair{biased, "it differs from the product by 1.0"},
                                  std::pair{reversed, "its tide runs opposite to the product's"},
                                  std::pair{turned, "degrees anticlockwise of the product's"},
                                  std::pair{late, "3.0 h late compared with the product's"}}) {
    const Issued issued = issue(3, {liar});
    const Snapshot& snapshot = issued.forecast.snapshot;
    EXPECT_TRUE(snapshot.degraded);
    EXPECT_EQ(snapshot.headline.find("Station NEAR at 2.0 km is not used: "), 0U)
        << snapshot.headline;
    EXPECT_NE(snapshot.headline.find(why), std::string::npos) << snapshot.headline;
    EXPECT_NE(issued.summary_json.find(why), std::string::npos);
    // Days of the rehearsal that had not yet seen enough of it may have used it.
    EXPECT_NEAR(issued.rmse_m_s, alone, 0.02 * alone) << why;
  }
}

TEST(FusionTwin, NoiseIsNotTakenForVariability) {
  Profiler noisy;
  noisy.noise_m_s = 0.3;
  const double alone = pooled(without_profiler());
  const double with = pooled(errors({noisy}));
  std::printf("D+1 error with a noise of 0.3 m/s a bin: %.4f, product alone %.4f\n", with, alone);
  EXPECT_LT(with, alone);
  const Issued issued = issue(1, {noisy});
  EXPECT_NE(issued.summary_json.find("its values scatter by 0.3"), std::string::npos);
}

TEST(FusionTwin, AProfilerStuckForTheLastTwoDaysDoesNotHarmAndIsATrouble) {
  Profiler stuck;
  stuck.stuck_h = 48;
  const double alone = pooled(without_profiler());
  const double with = pooled(errors({stuck}));
  std::printf("D+1 error with a profiler stuck for 48 h: %.4f, product alone %.4f\n", with, alone);
  EXPECT_LT(with, 1.02 * alone);
  const Snapshot snapshot = issue(1, {stuck}).forecast.snapshot;
  EXPECT_TRUE(snapshot.degraded);
  EXPECT_NE(snapshot.headline.find("tation NEAR at 2.0 km is stuck"), std::string::npos)
      << snapshot.headline;
}

TEST(FusionTwin, SpikesDoNotCostWhatAProfilerBrings) {
  Profiler spiky;
  spiky.spikes = 0.02;
  const double with = pooled(errors({spiky}));
  std::printf("D+1 error with 2 %% of wild values: %.4f\n", with);
  EXPECT_LT(with, 0.78 * pooled(without_profiler()));
}

TEST(FusionTwin, TwoProfilersAreBothUsed) {
  Profiler second;
  second.station = "SECOND";
  second.distance_m = -4000;
  const Issued issued = issue(1, {Profiler{}, second});
  EXPECT_NE(issued.summary_json.find("fused with station NEAR at 2.0 km"), std::string::npos);
  EXPECT_NE(issued.summary_json.find("fused with station SECOND at 4.0 km"), std::string::npos);
  EXPECT_EQ(issued.forecast.input_granules.size(), 3U);
}

TEST(FusionTwin, AStandardErrorInTheFileWeakensTheProfiler) {
  Profiler doubtful;
  doubtful.standard_error_m_s = 0.3;
  const Issued issued = issue(1, {doubtful});
  EXPECT_NE(issued.summary_json.find("it states an error of 0.30 m/s, so it gets less weight"),
            std::string::npos);
  const double plain = issue(1, {Profiler{}}).rmse_m_s;
  const double alone = issue(1, {}).rmse_m_s;
  EXPECT_LT(std::abs(issued.rmse_m_s - alone), 0.5 * std::abs(plain - alone));
}

}  // namespace
}  // namespace slackwater::tests::fusion_twin_test
