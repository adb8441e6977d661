// Are the members as honest as the band? They are what the vehicles fly in: their quantiles, and
// how they hang together in time and depth, against truths that are known.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "api/pipeline/load_site_data.h"
#include "calibration/day/daily_forecast.h"
#include "fields/base/parallel.h"
#include "fields/record/choose.h"
#include "tests/scenarios/member_tally.h"
#include "tests/scenarios/real_pairs.h"
#include "tests/support/asked_number.h"
#include "tests/support/known_series_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/unlike_ocean.h"

namespace slackwater::tests::member_spread_test {
namespace {

using std::chrono::days;
using std::chrono::hours;

const UtcDay first_day = parse_day("2024-02-01");
constexpr int days_before =
    28;  ///< before the first D of an ocean: what is rehearsed, and its days
constexpr int days_an_ocean = 30;
const std::vector<double> depth_m{1, 4, 8, 13, 19, 26, 32};

/// What is known of an ocean: hourly instants of a good analysis, and its wind.
KnownSeriesForTests known_ocean(const UnlikeOcean& ocean, std::uint64_t seed, int all_days) {
  KnownSeriesForTests known;
  known.data.water_depth = {UnlikeOcean::water_depth_m, "site"};
  Rng noise(seed, "tests/analysis_noise");
  const auto time = instants(UtcTime(first_day), UtcTime(first_day) + days(all_days));
  known.current(analysis_of("model"), time, depth_m, [&](UtcTime when, double depth) {
    const double east = noise.normal();
    return ocean.current(when, depth) + 0.004 * Horizontal(east, noise.normal());
  });
  known.wind(analysis_of("weather", 2), time,
             [&](UtcTime when, double) { return ocean.analysed_wind(when); });
  return known;
}

/// Consecutive forecasts of one ocean, to 72 h, with the wind as analysed.
MemberTally forecasts_of(std::uint64_t seed, int count) {
  const int all_days = days_before + count + 4;
  const UnlikeOcean ocean(seed, first_day, all_days);
  const KnownSeriesForTests known = known_ocean(ocean, seed, all_days);
  std::vector<ColumnData> columns{known.data};
  const SiteData data = site_of(std::move(columns));
  calibration::RehearsedDays rehearsals(data);
  MemberTally tally;
  for (int d = 0; d < count; ++d) {
    calibration::ForecastOptions options;
    options.day = first_day + days(days_before + d);
    options.issued = UtcTime(*options.day) + days(1) + hours(5);
    options.hindsight = true;
    options.rehearsals = &rehearsals;
    const auto forecast = calibration::make_forecast(data, options);
    tally.add(forecast.snapshot, forecast.snapshot.columns.front(),
              [&](UtcTime time, std::size_t k) { return ocean.current(time, depth_m[k]); });
  }
  return tally;
}

int days_to_run() { return std::max(12, asked_number("SLACKWATER_DAYS", 30)); }

/// Oceans of thirty days each; the last may be shorter.
MemberTally unlike_oceans(int count) {
  const auto oceans = static_cast<std::size_t>((count + days_an_ocean - 1) / days_an_ocean);
  std::vector<MemberTally> tallies(oceans);
  for_all(oceans, 2, [&](std::size_t i) {
    const int left = count - static_cast<int>(i) * days_an_ocean;
    tallies[i] = forecasts_of(i + 1, std::min(left, days_an_ocean));
  });
  MemberTally sum;
  for (const MemberTally& tally : tallies) sum.add(tally);
  sum.print("oceans of other physics");
  return sum;
}

/// The same of a real set, where a later analysis is the truth.
MemberTally forecasts_of_set(const char* name, const std::vector<std::filesystem::path>& currents,
                             const std::vector<std::filesystem::path>& wind, std::size_t first,
                             std::size_t every, const char* from, const char* to) {
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  ingest_all(store, currents, true);
  ingest_all(store, wind, false);
  const Site site = site_of(name, wet_cells(store, first, every));
  const UtcTime begin(parse_day(from));
  const UtcTime end = UtcTime(parse_day(to)) + days(2);
  const SiteData data = api::load_site_data(store, site, begin - calibration::history_wanted, end);
  calibration::RehearsedDays rehearsals(data);
  MemberTally tally;
  for (UtcDay day = parse_day(from); day <= parse_day(to); day += days(1)) {
    calibration::ForecastOptions options;
    options.day = day;
    options.issued = UtcTime(day) + days(1);
    options.horizon = hours(24);
    options.hindsight = true;
    options.threads = 2;
    options.rehearsals = &rehearsals;
    const auto forecast = calibration::make_forecast(data, options);
    for (std::size_t i = 0; i < data.columns.size(); ++i) {
      const Chosen<Horizontal> truth = choose(data.columns[i].current, {}, {});
      // Hourly means stand at half past: a stamp takes the two about it.
      const auto at = [&](UtcTime time, std::size_t k) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        Horizontal sum{};
        double weight = 0;
        for (std::size_t t = 0; t < truth.column.times(); ++t) {
          const double apart = std::abs(hours_between(time, truth.column.time[t].centre()));
          if (apart >= 1.0 || !truth.column.has(t, k)) continue;
          sum += (1.0 - apart) * truth.column.value[truth.column.offset(t, k)];
          weight += 1.0 - apart;
        }
        return weight > 0.99 ? sum / weight : Horizontal(nan, nan);
      };
      tally.add(forecast.snapshot, forecast.snapshot.columns[i], at);
    }
  }
  tally.print(name);
  return tally;
}

/// Standard deviations of increments within a factor of the truth's, and of what the band itself
/// is too wide or narrow by.
void expect_increments(const MemberTally& tally, double factor) {
  const LeadDayTally& day = tally.lead_day.front();
  const double width = std::sqrt(day.sigma_square / day.square);
  for (std::size_t l = 0; l < tally.in_time.size(); ++l) {
    EXPECT_LT(tally.in_time[l].ratio() / width, factor) << MemberTally::lag_h[l] << " h";
    EXPECT_GT(tally.in_time[l].ratio() / width, 1 / factor) << MemberTally::lag_h[l] << " h";
  }
  for (std::size_t l = 0; l < tally.in_depth.size(); ++l) {
    if (tally.in_depth[l].truth <= 0) continue;
    EXPECT_LT(tally.in_depth[l].ratio() / width, factor) << MemberTally::layer_m[l] << " m";
    EXPECT_GT(tally.in_depth[l].ratio() / width, 1 / factor) << MemberTally::layer_m[l] << " m";
  }
}

/// Plants without dependence are worse.
/// @param depth  by how much where levels are dealt anew
void expect_dependence(const MemberTally& tally, double depth) {
  EXPECT_GT(tally.dealt_over_times.variogram_time, 1.03 * tally.as_drawn.variogram_time);
  EXPECT_GT(tally.dealt_over_levels.variogram_depth, depth * tally.as_drawn.variogram_depth);
}
void expect_less_energy(const MemberTally& tally) {
  EXPECT_GT(tally.dealt_over_times.energy, 1.003 * tally.as_drawn.energy);
  EXPECT_GT(tally.dealt_over_levels.energy, 1.003 * tally.as_drawn.energy);
}

void expect_the_band_of_the_normal_law(const MemberTally& tally) {
  for (const LeadDayTally& day : tally.lead_day) {
    // Errors are not normal and 24 members are few: quantiles of theirs lie 0.3 sigma about the
    // band's, and hold one or two percent more.
    EXPECT_NEAR(day.coverage_members(), day.coverage_normal(), 0.03);
    EXPECT_NEAR(day.crps_members / day.crps_normal, 1.0, 0.02);
  }
}

TEST(MemberSpread, IsTheBandsAndThatOfTheErrorsInOceansOfOtherPhysics) {
  const int count = days_to_run();
  const MemberTally all = unlike_oceans(count);
  expect_the_band_of_the_normal_law(all);
  expect_increments(all, 1.5);
  expect_dependence(all, 3.0);
  expect_less_energy(all);
  // Each day of lead has earned a factor of its own; a later one rests on fewer independent errors.
  const bool is_long = count >= 200;
  EXPECT_GT(all.lead_day[0].coverage_normal(), is_long ? 0.78 : 0.70);
  EXPECT_LT(all.lead_day[0].coverage_normal(), is_long ? 0.82 : 0.90);
  for (const std::size_t day : {1U, 2U}) {
    EXPECT_GT(all.lead_day[day].coverage_normal(), is_long ? 0.77 : 0.66);
    EXPECT_LT(all.lead_day[day].coverage_normal(), is_long ? 0.83 : 0.92);
  }
}

TEST(MemberSpread, HangsTogetherAsTheErrorsOffElbaDo) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto tally = forecasts_of_set("elba", {shared / "data/elba_2014-05"}, {}, 0, 3,
                                      "2014-05-17", "2014-05-19");
  // Three days, few levels, too few of a past to narrow the band by: the energy score cannot tell.
  expect_increments(tally, 2.0);
  expect_dependence(tally, 1.05);
}

TEST(MemberSpread, HangsTogetherAsTheErrorsInTheStraitOfOtrantoDo) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto set = shared / "data/otranto_2021-10";
  const auto tally = forecasts_of_set("otranto", {set / "currents"}, {set / "wind"}, 1, 12,
                                      "2021-10-12", "2021-10-13");
  // Levels within 12 m of each other err more alike than their members, by a factor of two.
  expect_increments(tally, 2.2);
  expect_dependence(tally, 1.3);
  expect_less_energy(tally);
}

}  // namespace
}  // namespace slackwater::tests::member_spread_test
