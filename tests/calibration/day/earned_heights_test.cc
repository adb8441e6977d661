#include "calibration/day/earned_heights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "calibration/day/past_plan.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "fields/wave/height_error.h"
#include "tests/support/known_series_for_tests.h"
#include "tests/support/shared_data.h"

namespace slackwater::calibration::earned_heights_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay first_day = parse_day("2024-05-01");

/// Of day D, issued five hours after it.
ForecastPlan plan_of_day(UtcDay day, WindPolicy wind) {
  ForecastPlan plan;
  plan.day = day;
  plan.issued = plan.end_of_day() + hours(5);
  plan.seen_by = plan.issued;
  plan.wind = wind;
  plan.best.known_by = plan.issued;
  plan.best.issued = plan.issued;
  for (int h = 0; h <= 72; ++h) plan.stamps.push_back(plan.end_of_day() + hours(h));
  return plan;
}

Site site_at_sea() {
  Site site;
  site.id = "bank";
  site.fetch = Fetch(300e3);
  return site;
}

HorizonSea sea_of(const ColumnData& column, const ForecastPlan& plan, std::vector<double>& spread) {
  const Site site = site_at_sea();
  const HorizonWind wind =
      horizon_wind(column.wind, plan.wind, plan.end_of_day(), plan.stamps, plan.best);
  HorizonSea sea =
      horizon_sea(column, site, plan.wind, plan.end_of_day(), plan.stamps, wind, plan.best);
  spread = spread_beforehand(sea, wind, column, site, plan);
  return sea;
}

/// A path of hours that forgets: standard normal, exp(-t / 12 h).
std::vector<double> path(std::size_t size, Rng& random, double memory_h = 12) {
  const double kept = std::exp(-1 / memory_h);
  std::vector<double> z{random.normal()};
  while (z.size() < size)
    z.push_back(kept * z.back() + std::sqrt(1 - kept * kept) * random.normal());
  return z;
}

struct Erring {
  double bias = 0;
  double sigma = 0.1;
};

/// Sixty days of a sea about 1.5 m high, analysed, and a provider's run of it each morning, whose
/// heights err as is said.
KnownSeriesForTests erring_product(const Erring& erring, std::uint64_t seed) {
  Rng random(seed, "sea");
  const std::size_t all = 24 * 64;
  auto truth = std::make_shared<std::vector<double>>(path(all, random, 30));
  for (double& z : *truth) z = height_error::height_at(1.5, 0.35, z);
  const auto at = [truth](UtcTime time) {
    return (*truth)[static_cast<std::size_t>(std::lround(hours_between(UtcTime(first_day), time)))];
  };
  const auto period = [](UtcTime) { return 6.0; };
  const auto from_west = [](UtcTime) { return 270.0; };
  KnownSeriesForTests sea;
  sea.waves(analysis_of("waves", 1), instants(UtcTime(first_day), UtcTime(first_day) + days(63)),
            at, period, from_west);
  for (int d = 1; d < 60; ++d) {
    const UtcTime issued = UtcTime(first_day) + days(d);
    const std::vector<double> z = path(24 * 4, random);
    sea.waves(
        forecast_of("waves", issued, 10 + d), instants(issued, issued + hours(75)),
        [=](UtcTime time) {
          const double off =
              erring.bias +
              erring.sigma * z[static_cast<std::size_t>(std::lround(hours_between(issued, time)))];
          return height_error::height_at(at(time), 1, off);
        },
        period, from_west);
  }
  return sea;
}

TEST(HeightSpread, GoesBySourceAndLead) {
  KnownSeriesForTests sea;
  const UtcDay day = first_day + days(10);
  const UtcTime end = UtcTime(day) + days(1);
  sea.waves(
      analysis_of("waves"), instants(end - days(3), end - hours(6)), [](UtcTime) { return 2.0; },
      [](UtcTime) { return 6.0; }, [](UtcTime) { return 270.0; });
  std::vector<double> kept, computed;
  const HorizonSea without_wind = sea_of(sea.data, plan_of_day(day, WindPolicy::best), kept);
  ASSERT_EQ(without_wind.carried_from, end - hours(6));
  EXPECT_DOUBLE_EQ(kept[24], height_error::of_kept(30));
  KnownSeriesForTests ends_later;
  ends_later.waves(
      received(analysis_of("waves"), end), instants(end - days(3), end + hours(6)),
      [](UtcTime) { return 2.0; }, [](UtcTime) { return 6.0; }, [](UtcTime) { return 270.0; });
  (void)sea_of(ends_later.data, plan_of_day(day, WindPolicy::best), kept);
  EXPECT_DOUBLE_EQ(kept[24], height_error::of_kept(18)) << "kept since the product ended";
  sea.wind(analysis_of("wind"), instants(end - days(3), end),
           steady(vector_from_direction(10, 270)));
  (void)sea_of(sea.data, plan_of_day(day, WindPolicy::persist), computed);
  EXPECT_GT(computed[48], 0.3) << "the error of a wind that persists";
  EXPECT_LT(computed[1], computed[48]);
  sea.waves(
      forecast_of("waves", end - hours(12)), instants(end - hours(12), end + days(4)),
      [](UtcTime) { return 2.0; }, [](UtcTime) { return 6.0; }, [](UtcTime) { return 270.0; });
  std::vector<double> product;
  (void)sea_of(sea.data, plan_of_day(day, WindPolicy::best), product);
  EXPECT_DOUBLE_EQ(product[48], height_error::of_product(2, 48));
  EXPECT_LT(product[48], computed[48]);
}

/// Errors that are known: what is earned from three weeks comes near to them, and the band then
/// holds eight of ten heights of days that nobody has seen.
TEST(EarnedHeights, AProductsOwnErrorsAreFoundAndItsBandHolds) {
  for (const Erring erring : {Erring{0.10, 0.08}, Erring{-0.15, 0.30}}) {
    double held = 0, all = 0, bias = 0, factor_error = 0, days_seen = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const KnownSeriesForTests sea = erring_product(erring, seed);
      const ForecastPlan plan = plan_of_day(first_day + days(40), WindPolicy::best);
      const EarnedHeights earned = earned_heights(sea.data, site_at_sea(), plan, ColumnParts{}, 1);
      const EarnedHeight& product = earned.of_source[0];
      EXPECT_GE(product.days, 20U);
      // What is taken out of a height as far off the usual as the heights usually are.
      const double usual_m = usual_height_m(sea.data, plan);
      bias += product.off(height_error::height_at(usual_m, 1, erring.bias), usual_m, 24) / 12;
      ForecastColumn column;
      const HorizonSea made = sea_of(sea.data, plan, column.height_spread);
      column.sea = made.sea;
      column.sea_source = made.source;
      apply(earned, plan, usual_m, column);
      factor_error += std::log(column.height_spread[24] / erring.sigma) / 12;
      days_seen = static_cast<double>(product.days);
      const PieceColumn<double>& truth = sea.data.significant_height.pieces.front();
      for (std::size_t t = 0; t < truth.column.times(); ++t) {
        const double lead_h = hours_between(plan.end_of_day(), truth.column.time[t].centre());
        if (lead_h <= 0 || lead_h > 60) continue;
        const auto h = static_cast<std::size_t>(std::lround(lead_h));
        const double central_m = column.sea[h].significant_height_m;
        const double z = constants::normal_p90;
        held +=
            truth.column.value[t] >=
                height_error::height_at(central_m, column.height_spread[h], -z) &&
            truth.column.value[t] <= height_error::height_at(central_m, column.height_spread[h], z);
        ++all;
      }
    }
    const double shrunk = 2 * days_seen / (2 * days_seen + 8);
    EXPECT_NEAR(bias, shrunk * erring.bias, 0.03);
    // Errors that know nothing of the sea, which is spread by 0.35: a part of those of 0.30 shows
    // in the forecast's distance from the usual, and is taken out.
    EXPECT_NEAR(factor_error, erring.sigma < 0.1 ? 0.35 : std::log(0.35 / std::hypot(0.35, 0.30)),
                0.25)
        << "shrunk to the published";
    // Twelve seas of two and a half days are some sixty independent hours.
    EXPECT_NEAR(held / all, erring.sigma < 0.1 ? 0.92 : 0.8, 0.1);
  }
}

TEST(EarnedHeights, AnAnalysisThatWasTheForecastIsNoPair) {
  KnownSeriesForTests sea;
  sea.waves(
      analysis_of("waves"), instants(UtcTime(first_day), UtcTime(first_day) + days(60)),
      [](UtcTime) { return 2.0; }, [](UtcTime) { return 6.0; }, [](UtcTime) { return 270.0; });
  ForecastPlan plan = plan_of_day(first_day + days(40), WindPolicy::best);
  plan.best.known_by = UtcTime::max();
  const EarnedHeights earned = earned_heights(sea.data, site_at_sea(), plan, ColumnParts{}, 1);
  for (const EarnedHeight& of : earned.of_source) {
    EXPECT_EQ(of.hours, 0U);
    EXPECT_EQ(of.factor, 1);
    EXPECT_EQ(of.bias, 0);
  }
}

struct RealSea {
  std::vector<UtcTime> time;
  std::vector<double> height_m, period_s;
  std::vector<Horizontal> wind_m_s;
};

/// A sea that forgets as exp(-t / 30 h), kept as last known: the best forecast of
/// ln(Hs + 0.3 m) at a lead t is exp(-t / 30 h) of the way from the usual to what was known, so
/// that the regression is 1.
TEST(EarnedHeights, AKeptSeaFallsBackToTheUsualAsTheTheorySays) {
  double regression = 0, kept2 = 0, drawn2 = 0, best2 = 0;
  constexpr int seeds = 24;
  constexpr double lead_h = 36;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Rng random(seed, "kept sea");
    const std::vector<double> z = path(24 * 64, random, 30);
    const auto index = [](UtcTime time) {
      return static_cast<std::size_t>(std::lround(hours_between(UtcTime(first_day), time)));
    };
    KnownSeriesForTests sea;
    sea.waves(
        analysis_of("waves"), instants(UtcTime(first_day), UtcTime(first_day) + days(63)),
        [&](UtcTime time) { return height_error::height_at(1.5, 0.35, z[index(time)]); },
        [](UtcTime) { return 6.0; }, [](UtcTime) { return 270.0; });
    const ForecastPlan plan = plan_of_day(first_day + days(40), WindPolicy::persist);
    const EarnedHeights earned = earned_heights(sea.data, site_at_sea(), plan, ColumnParts{}, 1);
    const EarnedHeight& kept = earned.of_source[static_cast<std::size_t>(HeightSource::kept)];
    EXPECT_EQ(kept.days, 21U);
    regression += kept.regression / seeds;
    // The next twenty days, by what was earned until then.
    const double usual_m = usual_height_m(sea.data, plan);
    for (int d = 1; d <= 20; ++d) {
      const UtcTime known = plan.end_of_day() + days(d);
      const double known_m = height_error::height_at(1.5, 0.35, z[index(known)]);
      const double then = 0.35 * z[index(known + hours(static_cast<int>(lead_h)))] +
                          std::log(1.5 + height_error::shift_m);
      const double said = std::log(known_m + height_error::shift_m);
      kept2 += std::pow(said - then, 2);
      drawn2 += std::pow(said - kept.off(known_m, usual_m, lead_h) - then, 2);
      const double usual = std::log(1.5 + height_error::shift_m);
      best2 += std::pow(usual + std::exp(-lead_h / 30) * (said - usual) - then, 2);
    }
  }
  std::printf(
      "kept sea at %.0f h: regression %.2f of 1; error %.3f kept, %.3f drawn, %.3f at best\n",
      lead_h, regression, std::sqrt(kept2 / (20 * seeds)), std::sqrt(drawn2 / (20 * seeds)),
      std::sqrt(best2 / (20 * seeds)));
  EXPECT_GT(regression, 0.7);
  EXPECT_LT(regression, 1.05) << "1, shrunk a little to nothing known";
  EXPECT_LT(drawn2, 0.8 * kept2);
  EXPECT_LT(drawn2, 1.25 * best2) << "21 days know the usual height to some 0.1";
}

TEST(EarnedHeights, OfARightForecastNothingIsTaken) {
  const KnownSeriesForTests sea = erring_product({0, 0.01}, 1);
  const ForecastPlan plan = plan_of_day(first_day + days(40), WindPolicy::best);
  const EarnedHeight product =
      earned_heights(sea.data, site_at_sea(), plan, ColumnParts{}, 1).of_source[0];
  EXPECT_NEAR(product.bias, 0, 0.01);
  EXPECT_NEAR(product.regression, 0, 0.03);
}

TEST(EarnedHeights, AFewHoursAreNoUsualHeight) {
  KnownSeriesForTests sea;
  const UtcTime end = plan_of_day(first_day + days(10), WindPolicy::persist).end_of_day();
  sea.waves(
      analysis_of("waves"), instants(end - hours(40), end), [](UtcTime) { return 4.0; },
      [](UtcTime) { return 6.0; }, [](UtcTime) { return 270.0; });
  const ForecastPlan plan = plan_of_day(first_day + days(10), WindPolicy::persist);
  EXPECT_TRUE(std::isnan(usual_height_m(sea.data, plan)));
  EarnedHeight half;
  half.regression = 0.5;
  EXPECT_EQ(half.off(4, constants::nan, 48), 0);
}

/// Thirteen years at alpha ventus, every twentieth day: the sea as known at midnight kept for two
/// days, and drawn to the usual as the three weeks before say.
TEST(EarnedHeights, AKeptSeaErrsLessAtAlphaVentus) {
  SLACKWATER_NEEDS_SHARED(shared);
  std::ifstream in(shared / "data/weather_windows/alpha_ventus_weather_2002_2014.csv");
  std::string line;
  std::getline(in, line);
  ASSERT_EQ(line, "index,datetime,hour,windspeed,waveheight");
  std::vector<double> height_m;
  while (std::getline(in, line)) height_m.push_back(std::stod(line.substr(line.rfind(',') + 1)));
  ASSERT_EQ(height_m.size(), 113'952U);
  std::array<double, 2> kept2{}, drawn2{};
  int count = 0;
  for (std::size_t day = 30; 24 * (day + 3) < height_m.size(); day += 20, ++count) {
    const UtcDay as_day = first_day + days(30);
    const UtcTime from = UtcTime(as_day) - days(23);
    const std::size_t known = 24 * (day + 1);  // the end of D
    KnownSeriesForTests sea;
    sea.waves(
        analysis_of("waves"), instants(from, UtcTime(as_day) + days(1)),
        [&](UtcTime time) {
          return height_m[known -
                          static_cast<std::size_t>(hours_between(time, UtcTime(as_day) + days(1)))];
        },
        [](UtcTime) { return 6.0; }, [](UtcTime) { return 270.0; });
    const ForecastPlan plan = plan_of_day(as_day, WindPolicy::persist);
    const EarnedHeights earned = earned_heights(sea.data, site_at_sea(), plan, ColumnParts{}, 1);
    const EarnedHeight& kept = earned.of_source[static_cast<std::size_t>(HeightSource::kept)];
    for (const int lead_d : {1, 2}) {
      const auto i = static_cast<std::size_t>(lead_d - 1);
      const double said = std::log(height_m[known] + height_error::shift_m);
      const double then =
          std::log(height_m[known + 24 * static_cast<std::size_t>(lead_d)] + height_error::shift_m);
      const double off = kept.off(height_m[known], usual_height_m(sea.data, plan), 24.0 * lead_d);
      kept2[i] += std::pow(said - then, 2);
      drawn2[i] += std::pow(said - off - then, 2);
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    std::printf(
        "alpha ventus, %d days, lead %zu h: error of ln(Hs + 0.3 m) %.3f kept, %.3f drawn\n", count,
        24 * (i + 1), std::sqrt(kept2[i] / count), std::sqrt(drawn2[i] / count));
    EXPECT_LT(drawn2[i], (i == 0 ? 0.88 : 0.78) * kept2[i]);
  }
}

/// NORA3, hourly: its columns by their names.
RealSea read_nora3(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::vector<std::string> names;
  RealSea sea;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::stringstream row(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (names.empty()) {
      names = cells;
      continue;
    }
    const auto value = [&](const char* name) {
      return std::stod(cells.at(
          static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())));
    };
    cells[0][10] = 'T';
    sea.time.push_back(parse_utc(cells[0] + "Z"));
    sea.height_m.push_back(value("hs"));
    sea.period_s.push_back(value("tp"));
    sea.wind_m_s.push_back(
        vector_from_direction(value("wind_speed_10m"), value("wind_direction_10m")));
  }
  return sea;
}

/// Every second day of three autumn months, forecast from what was known by then without any run of
/// wind or waves: the share of the heights that the band of eight in ten holds.
void expect_bands_hold(bool with_wind, bool with_waves, double least, double most) {
  SLACKWATER_NEEDS_SHARED(shared);
  const RealSea real =
      read_nora3(shared / "data/nora3/NORA3_wind_wave_lon1.32_lat53.324_20221001_20221231.csv");
  ASSERT_EQ(real.time.size(), 2208U);
  const auto index = [&](UtcTime time) {
    return static_cast<std::size_t>(std::lround(hours_between(real.time.front(), time)));
  };
  KnownSeriesForTests sea;
  const std::vector<TimeCell> times = instants(real.time.front(), real.time.back());
  if (with_waves)
    sea.waves(
        analysis_of("waves"), times, [&](UtcTime time) { return real.height_m[index(time)]; },
        [&](UtcTime time) { return real.period_s[index(time)]; }, [](UtcTime) { return 300.0; });
  if (with_wind)
    sea.wind(analysis_of("wind", 2), times,
             [&](UtcTime time, double) { return real.wind_m_s[index(time)]; });
  std::array<double, 2> held{}, all{}, squares{};
  const UtcDay first = day_of(real.time.front());
  for (int d = 30; d < 88; d += 2) {
    const ForecastPlan plan = plan_of_day(first + days(d), WindPolicy::persist);
    const EarnedHeights earned = earned_heights(sea.data, site_at_sea(), plan, ColumnParts{}, 1);
    ForecastColumn column;
    const HorizonSea made = sea_of(sea.data, plan, column.height_spread);
    column.sea = made.sea;
    column.sea_source = made.source;
    apply(earned, plan, usual_height_m(sea.data, plan), column);
    for (std::size_t h = 1; h <= 48; ++h) {
      const std::size_t at = index(plan.stamps[h]);
      if (at >= real.height_m.size()) continue;
      const double z = std::log((real.height_m[at] + height_error::shift_m) /
                                (column.sea[h].significant_height_m + height_error::shift_m)) /
                       column.height_spread[h];
      held[(h - 1) / 24] += std::abs(z) <= constants::normal_p90;
      squares[(h - 1) / 24] += z * z;
      ++all[(h - 1) / 24];
    }
  }
  for (std::size_t lead = 0; lead < 2; ++lead) {
    std::printf(
        "%s, %s: day of lead %zu, %.0f hours: %.0f %% inside the band of 80 %%, rms z %.2f\n",
        with_wind ? "wind persists" : "no wind", with_waves ? "waves known" : "no waves", lead + 1,
        all[lead], 100 * held[lead] / all[lead], std::sqrt(squares[lead] / all[lead]));
    EXPECT_GE(held[lead] / all[lead], least) << lead;
    EXPECT_LE(held[lead] / all[lead], most) << lead;
  }
}

// Thirty days of lead are some fifty independent heights: a standard error of 6 %.
TEST(HeightBands, OfAKeptSeaHold) { expect_bands_hold(false, true, 0.68, 0.92); }
TEST(HeightBands, OfASeaThatAPersistedWindRaisesHold) { expect_bands_hold(true, true, 0.68, 0.92); }

}  // namespace
}  // namespace slackwater::calibration::earned_heights_test
