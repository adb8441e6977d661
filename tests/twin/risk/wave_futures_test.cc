#include "twin/risk/wave_futures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "fields/wave/growth.h"
#include "fields/wave/height_error.h"

namespace slackwater::tests::wave_futures_test {
namespace {

const UtcTime from = parse_utc("2025-03-04T00:00:00Z");
constexpr double wind_m_s = 9;

/// Three days of a sea of one height and one spread.
Snapshot sea_of(double height_m, double spread, std::uint64_t seed = 5) {
  Snapshot forecast;
  forecast.site_id = "bank";
  forecast.seed = seed;
  forecast.members = 25;
  forecast.columns.resize(1);
  for (int h = 0; h <= 72; ++h) {
    forecast.time.push_back(from + std::chrono::hours(h));
    forecast.columns[0].sea.push_back({height_m, 7, 250});
    forecast.columns[0].height_spread.push_back(spread);
  }
  return forecast;
}

/// With a wind from the west that each member has stronger or weaker for three days by itself.
Snapshot with_winds(Snapshot forecast, double sigma_m_s) {
  ForecastColumn& column = forecast.columns[0];
  column.wind_m_s.assign(forecast.time.size(), {wind_m_s, 0});
  Rng random(1, "winds");
  for (std::size_t m = 1; m < forecast.members; ++m) {
    const double stronger_m_s = sigma_m_s * random.normal();
    for (std::size_t t = 0; t < forecast.time.size(); ++t)
      column.wind_member_m_s.emplace_back(wind_m_s + stronger_m_s, 0);
  }
  return forecast;
}

double z_of(double height_m, double central_m, double spread) {
  return std::log((height_m + height_error::shift_m) / (central_m + height_error::shift_m)) /
         spread;
}

TEST(WaveFutures, TheCentralOneIsTheForecast) {
  const twin::WaveFutures waves(sea_of(1.4, 0.2), 3);
  EXPECT_EQ(waves.height_m(0, 1.4, from + std::chrono::hours(20)), 1.4);
  EXPECT_TRUE(std::isnan(waves.height_m(1, std::nan(""), from)));
  EXPECT_EQ(waves.futures(), 3U);
  EXPECT_EQ(twin::WaveFutures(Snapshot(), 4).futures(), 4U) << "a forecast without waves";
}

/// At each stamp the members are a normal, evenly: no seed has more high seas than another.
TEST(WaveFutures, OfASetAreOppositeAndAsWideAsTheForecastSaysAtEachStamp) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const twin::WaveFutures waves(sea_of(2, 0.25, seed), 25);
    for (const int hour : {0, 12, 42, 72}) {
      const UtcTime time = from + std::chrono::hours(hour);
      std::vector<double> z;
      for (std::size_t f = 1; f < 25; ++f) z.push_back(z_of(waves.height_m(f, 2, time), 2, 0.25));
      for (std::size_t f = 0; f < 24; f += 2) EXPECT_NEAR(z[f], -z[f + 1], 1e-9) << hour;
      std::sort(z.begin(), z.end());
      EXPECT_NEAR(z.back(), 2.037, 0.001) << "the normal's 47 of 48";
      EXPECT_NEAR(std::sqrt(std::inner_product(z.begin(), z.end(), z.begin(), 0.0) / 24), 0.97,
                  0.01);
    }
  }
}

TEST(WaveFutures, AllSetsTogetherAreANormalBetweenTheHoursToo) {
  const Snapshot forecast = sea_of(3, 0.2);
  const std::size_t all = twin::WaveFutures::many;
  EXPECT_EQ(all, 1993U);
  const twin::WaveFutures waves(forecast, all);
  for (const int minutes : {12 * 60, 24 * 60 + 30, 47 * 60 + 15}) {
    const UtcTime time = from + std::chrono::minutes(minutes);
    for (const double p90 : {-constants::normal_p90, constants::normal_p90}) {
      std::size_t below = 0;
      for (std::size_t f = 1; f < all; ++f)
        below += waves.height_m(f, 3, time) < height_error::height_at(3, 0.2, p90) ? 1U : 0U;
      EXPECT_NEAR(static_cast<double>(below) / static_cast<double>(all - 1), p90 < 0 ? 0.1 : 0.9,
                  minutes % 60 == 0 ? 0.002 : 0.015)
          << minutes;
    }
  }
}

TEST(WaveFutures, RememberHalfADay) {
  const Snapshot forecast = sea_of(6, 0.2);
  const std::size_t all = twin::WaveFutures::many;
  const twin::WaveFutures waves(forecast, all);
  double both = 0, squares = 0;
  for (std::size_t f = 1; f < all; ++f) {
    const double a = z_of(waves.height_m(f, 6, from + std::chrono::hours(24)), 6, 0.2);
    both += a * z_of(waves.height_m(f, 6, from + std::chrono::hours(36)), 6, 0.2);
    squares += a * a;
  }
  EXPECT_NEAR(both / squares, std::exp(-1), 0.08);
}

TEST(WaveFutures, AFutureIsTheSameWhateverIsAskedAndAnotherAtAnotherSiteOrDay) {
  Snapshot forecast = sea_of(1.5, 0.3);
  const UtcTime time = from + std::chrono::minutes(29 * 60 + 20);
  const auto height_m = [&](std::size_t future, std::size_t of) {
    return twin::WaveFutures(forecast, of).height_m(future, 1.5, time);
  };
  const double here_m = height_m(2, 3);
  EXPECT_EQ(here_m, height_m(2, 40));
  EXPECT_GE(twin::WaveFutures(forecast, 40).height_m(3, 0.01, time), 0);
  forecast.site_id = "reef";
  EXPECT_NE(here_m, height_m(2, 3));
  forecast.site_id = "bank";
  forecast.day += std::chrono::days(1);
  EXPECT_NE(here_m, height_m(2, 3));
}

/// Further members of a forecast leave the seas of the first as they were.
TEST(WaveFutures, OfTheFirstMembersAreTheSameBesideFurtherOnes) {
  Snapshot issued = with_winds(sea_of(1.8, 0.3), 1.5);
  Snapshot further = sea_of(1.8, 0.3);
  further.members = 400;
  further = with_winds(std::move(further), 1.5);
  const twin::WaveFutures few(issued, 25), many(further, 400);
  for (std::size_t f = 0; f < 25; ++f)
    EXPECT_EQ(few.height_m(f, 1.8, from + std::chrono::hours(40)),
              many.height_m(f, 1.8, from + std::chrono::hours(40)))
        << f;
  EXPECT_EQ(many.member_of(399), 399U);
  EXPECT_EQ(few.member_of(24), 24U);
}

/// A member whose wind is stronger has the higher sea, as far as the growth law says.
TEST(WaveFutures, FollowTheWindOfTheirMemberAsASeaGrows) {
  const Snapshot forecast = with_winds(sea_of(1.8, 0.3), 1.5);
  const std::size_t all = twin::WaveFutures::many;
  const twin::WaveFutures waves(forecast, all);
  const UtcTime time = from + std::chrono::hours(48);
  const std::size_t times = forecast.time.size();
  double both = 0, squares = 0;
  for (std::size_t f = 1; f < all; ++f) {
    const std::size_t member = waves.member_of(f);
    ASSERT_TRUE(member >= 1 && member <= 24);
    const double stronger_m_s =
        forecast.columns[0].wind_member_m_s[(member - 1) * times].real() - wind_m_s;
    both += stronger_m_s * 0.3 * z_of(waves.height_m(f, 1.8, time), 1.8, 0.3);
    squares += stronger_m_s * stronger_m_s;
  }
  const double per_wind = both / squares;
  EXPECT_NEAR(per_wind, height_error::per_wind, 0.015);
  const auto grown = [](double speed_m_s) {
    return std::log(fetch_limited_sea(speed_m_s, 200e3, 40).significant_height_m +
                    height_error::shift_m);
  };
  const double by_growth = (grown(wind_m_s + 1) - grown(wind_m_s - 1)) / 2;
  EXPECT_GT(per_wind, 0.5 * by_growth) << "some of a sea is swell: less than the law";
  EXPECT_LT(per_wind, 1.1 * by_growth);
}

/// The chance that a sea stays below a limit for some hours.
double chance_below(const twin::WaveFutures& waves, double limit_m, int first_h, int hours) {
  std::size_t held = 0;
  for (std::size_t f = 0; f < waves.futures(); ++f) {
    bool holds = true;
    for (int half = 0; half <= 2 * hours; ++half)
      holds =
          holds &&
          waves.height_m(f, 1.6, from + std::chrono::minutes(60 * first_h + 30 * half)) <= limit_m;
    held += holds ? 1U : 0U;
  }
  return static_cast<double>(held) / static_cast<double>(waves.futures());
}

/// The greatest departure from the mean over fifty seeds.
double moves_by(std::size_t futures, double limit_m, int first_h, int hours, double& mean) {
  std::vector<double> chances;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    chances.push_back(
        chance_below(twin::WaveFutures(with_winds(sea_of(1.6, 0.22, seed), 1.3), futures), limit_m,
                     first_h, hours));
  mean = std::accumulate(chances.begin(), chances.end(), 0.0) / 50;
  double most = 0;
  for (const double chance : chances) most = std::max(most, std::abs(chance - mean));
  return most;
}

TEST(WaveFutures, AChanceMovesByTwoHundredthsAtMostWithTheSeed) {
  const std::size_t all = twin::WaveFutures::many;
  double widest = 0;
  for (const double limit_m : {1.5, 1.8, 2.2}) {
    for (const int hours : {2, 5}) {
      double mean = 0;
      const double many = moves_by(all, limit_m, 30, hours, mean);
      EXPECT_LE(many, 0.02) << "P " << mean << " of " << limit_m << " m over " << hours << " h";
      EXPECT_GT(mean, 0.1);
      widest = std::max(widest, moves_by(25, limit_m, 30, hours, mean));
    }
  }
  EXPECT_GT(widest, 0.03) << "25 futures are too few";
}

}  // namespace
}  // namespace slackwater::tests::wave_futures_test
