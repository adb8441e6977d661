#include "twin/risk/wave_futures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/wave/height_error.h"

namespace slackwater::tests::wave_futures_test {
namespace {

const UtcTime from = parse_utc("2025-03-04T00:00:00Z");

TEST(WaveFutures, TheCentralOneIsTheForecast) {
  const twin::WaveFutures waves(5, 3, from, from + std::chrono::hours(72));
  EXPECT_EQ(waves.height_m(0, 1.4, from + std::chrono::hours(20)), 1.4);
  EXPECT_TRUE(std::isnan(waves.height_m(1, std::nan(""), from)));
}

TEST(WaveFutures, SpreadAsForecastsErrAndDoSoBetweenTheHoursToo) {
  const std::size_t members = 4000;
  const twin::WaveFutures waves(5, members, from, from + std::chrono::hours(72));
  for (const int minutes : {12 * 60, 24 * 60 + 30, 47 * 60 + 15}) {
    const UtcTime time = from + std::chrono::minutes(minutes);
    double sum = 0, squares = 0;
    for (std::size_t m = 1; m < members; ++m) {
      const double off_m = waves.height_m(m, 3, time) - 3;
      sum += off_m;
      squares += off_m * off_m;
    }
    const auto n = static_cast<double>(members - 1);
    const double sigma_m = wave_height_sigma_m(3, minutes / 60.0);
    // Four standard errors of a mean and of a deviation.
    EXPECT_NEAR(sum / n, 0, 4 * sigma_m / std::sqrt(n)) << minutes;
    EXPECT_NEAR(std::sqrt(squares / n), sigma_m, 4 * sigma_m / std::sqrt(2 * n)) << minutes;
  }
}

TEST(WaveFutures, RememberHalfADay) {
  const std::size_t members = 4000;
  const twin::WaveFutures waves(5, members, from, from + std::chrono::hours(72));
  double both = 0, squares = 0;
  for (std::size_t m = 1; m < members; ++m) {
    const double a = waves.height_m(m, 6, from + std::chrono::hours(24)) - 6;
    const double b = waves.height_m(m, 6, from + std::chrono::hours(36)) - 6;
    both += a * b / (wave_height_sigma_m(6, 24) * wave_height_sigma_m(6, 36));
    squares += a * a / (wave_height_sigma_m(6, 24) * wave_height_sigma_m(6, 24));
  }
  EXPECT_NEAR(both / squares, std::exp(-1), 0.06);
}

TEST(WaveFutures, AMemberIsTheSameWhateverIsAsked) {
  const twin::WaveFutures few(5, 3, from, from + std::chrono::hours(30));
  const twin::WaveFutures many(5, 40, from, from + std::chrono::hours(72));
  const UtcTime time = from + std::chrono::minutes(29 * 60 + 20);
  EXPECT_EQ(few.height_m(2, 1.5, time), many.height_m(2, 1.5, time));
  const twin::WaveFutures other(6, 3, from, from + std::chrono::hours(30));
  EXPECT_NE(few.height_m(2, 1.5, time), other.height_m(2, 1.5, time));
  EXPECT_GE(many.height_m(3, 0.01, time), 0);
}

}  // namespace
}  // namespace slackwater::tests::wave_futures_test
