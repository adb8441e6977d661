#include "calibration/propagate/wind_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "fields/base/check.h"
#include "tests/support/shared_data.h"

namespace slackwater::calibration::wind_error_test {
namespace {

const UtcTime end = parse_utc("2024-03-02T00:00:00Z");

std::vector<UtcTime> hours_after(std::initializer_list<double> leads) {
  std::vector<UtcTime> times;
  for (const double lead : leads) times.push_back(add_hours(end, lead));
  return times;
}

/// Second moments of one component over many members: at each time, and between neighbours.
struct Moments {
  std::vector<double> variance;
  std::vector<double> with_next;
};
Moments moments_of(std::span<const UtcTime> times, const WindErrorGrowth& growth, int members) {
  Rng random(11, "wind_error_test");
  Moments moments{std::vector<double>(times.size()), std::vector<double>(times.size())};
  for (int m = 0; m < members; ++m) {
    const auto departures = draw_wind_departures(times, end, growth, random);
    for (std::size_t k = 0; k < times.size(); ++k) {
      moments.variance[k] += 0.5 * std::norm(departures[k]) / members;
      if (k + 1 == times.size()) continue;
      moments.with_next[k] += 0.5 * (std::conj(departures[k]) * departures[k + 1]).real() / members;
    }
  }
  return moments;
}

// 2 x 20 000 normals: a variance is known to sqrt(2/40000) = 0.7 %; four of those.
constexpr int many = 20000;
constexpr double monte_carlo = 0.028;

TEST(WindDepartures, HaveTheVarianceOfTheFormulaHoweverTheTimesAreSpaced) {
  const auto times = hours_after({0, 0.5, 1, 3, 6, 7, 24, 48, 71, 72});
  for (const WindErrorGrowth& growth :
       {analysed_wind_error(), forecast_wind_error(12.0), persisted_wind_error(4.0)}) {
    const Moments moments = moments_of(times, growth, many);
    for (std::size_t k = 0; k < times.size(); ++k) {
      const double sigma = growth.sigma_m_s(hours_between(end, times[k]));
      EXPECT_NEAR(moments.variance[k], sigma * sigma, monte_carlo * sigma * sigma);
    }
  }
}

TEST(WindDepartures, OfAPersistedWindAreThoseOfAGaussMarkovWindGivenItsValueAtTheEndOfD) {
  const auto times = hours_after({1, 6, 12, 24, 48, 72});
  const Moments moments = moments_of(times, persisted_wind_error(5.0, 24.0), many);
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const double s = hours_between(end, times[k]);
    const double t = hours_between(end, times[k + 1]);
    // Ornstein-Uhlenbeck conditioned on t = 0: sigma^2 (e^{-(t-s)/tau} - e^{-(t+s)/tau}).
    const double expected = 25.0 * (std::exp(-(t - s) / 24.0) - std::exp(-(t + s) / 24.0));
    EXPECT_NEAR(moments.with_next[k], expected, monte_carlo * 25.0);
  }
}

TEST(WindDepartures, AnAnalysisErrorIsStationaryAndForgetsExponentially) {
  const auto times = hours_after({0, 1, 4, 10, 22});
  const WindErrorGrowth growth = analysed_wind_error();
  const Moments moments = moments_of(times, growth, many);
  const double variance = growth.initial_m_s * growth.initial_m_s;
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const double apart = hours_between(times[k], times[k + 1]);
    EXPECT_NEAR(moments.with_next[k], variance * std::exp(-apart / growth.memory_h),
                monte_carlo * variance);
  }
}

TEST(WindDepartures, AreZeroBeforeTheEndOfDAndAtItWhereTheWindIsKnown) {
  const auto times = hours_after({-24, -1, 0, 1});
  Rng random(1, "zero");
  const auto persisted = draw_wind_departures(times, end, persisted_wind_error(), random);
  EXPECT_EQ(persisted[0], Horizontal{});
  EXPECT_EQ(persisted[1], Horizontal{});
  EXPECT_EQ(persisted[2], Horizontal{});
  EXPECT_NE(persisted[3], Horizontal{});
  const auto analysed = draw_wind_departures(times, end, analysed_wind_error(), random);
  EXPECT_EQ(analysed[1], Horizontal{});
  EXPECT_NE(analysed[2], Horizontal{});
}

TEST(WindDepartures, ASeedMeansTheSameMember) {
  const auto times = hours_after({0, 1, 2, 3});
  Rng one(5, "member/3");
  Rng same(5, "member/3");
  Rng other(6, "member/3");
  const auto growth = forecast_wind_error();
  const auto first = draw_wind_departures(times, end, growth, one);
  EXPECT_EQ(first, draw_wind_departures(times, end, growth, same));
  EXPECT_NE(first, draw_wind_departures(times, end, growth, other));
}

TEST(WindDepartures, FollowASpreadThatFallsWhereABetterSourceBegins) {
  const auto times = hours_after({1, 2, 3});
  const std::vector<double> sigma{3.0, 0.5, 0.0};
  Rng random(2, "falls");
  double variance = 0;
  double shared = 0;
  for (int m = 0; m < many; ++m) {
    const auto d = draw_wind_departures(times, sigma, 12.0, random);
    variance += 0.5 * std::norm(d[1]) / many;
    shared += 0.5 * (std::conj(d[0]) * d[1]).real() / many;
    EXPECT_EQ(d[2], Horizontal{});
  }
  EXPECT_NEAR(variance, 0.25, monte_carlo * 0.25);
  EXPECT_NEAR(shared, 1.5 * std::exp(-1.0 / 12.0), monte_carlo * 1.5);
}

TEST(WindErrorGrowth, ForecastsErrAsDocumentedAndNeverMoreThanUnrelatedWinds) {
  const WindErrorGrowth growth = forecast_wind_error();
  EXPECT_NEAR(growth.sigma_m_s(0), 1.0, 1e-12);
  EXPECT_NEAR(growth.sigma_m_s(24), 1.3, 0.05);
  EXPECT_NEAR(growth.sigma_m_s(72), 2.5, 0.05);
  EXPECT_NEAR(growth.sigma_m_s(120), 3.8, 0.05);
  EXPECT_NEAR(growth.sigma_m_s(2400), std::sqrt(2.0) * wind_climate_sigma_m_s, 1e-9);
  EXPECT_EQ(forecast_wind_error(18.0).sigma_m_s(6), growth.sigma_m_s(24));
}

TEST(WindErrorGrowth, RefusesAnErrorThatShrinks) {
  WindErrorGrowth growth = analysed_wind_error();
  growth.saturation_m_s = 0.5;
  EXPECT_THROW((void)growth.sigma_m_s(1), ContractViolation);
  Rng random(1, "unordered");
  const std::vector<UtcTime> times{end, end};
  EXPECT_THROW((void)draw_wind_departures(times, end, analysed_wind_error(), random),
               ContractViolation);
}

TEST(ClimateSigma, AShortRecordChangesLittleAndALongOneDecides) {
  Rng random(9, "record");
  const WindErrorGrowth free = persisted_wind_error(8.0, wind_memory_h);
  std::vector<UtcTime> times;
  for (int hour = 0; hour < 365 * 24; ++hour) times.push_back(add_hours(end, hour));
  const auto wind = draw_wind_departures(times, end, free, random);
  const std::span all_times(times);
  const std::span all_wind(wind);
  EXPECT_EQ(climate_sigma_m_s(all_times.first(1), all_wind.first(1)), wind_climate_sigma_m_s);
  const double three_days = climate_sigma_m_s(all_times.first(72), all_wind.first(72));
  EXPECT_NEAR(three_days, wind_climate_sigma_m_s, 1.0);
  // 180 independent samples, two components: 4 % standard error; the prior pulls by 2 %.
  EXPECT_NEAR(climate_sigma_m_s(all_times, all_wind), 8.0, 0.8);
}

/// Hourly 10 m wind of the NORA3 record, towards.
void read_nora3(const std::filesystem::path& file, std::vector<UtcTime>& times,
                std::vector<Horizontal>& wind) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#' || line[0] == 't') continue;
    std::stringstream row(line);
    std::string time, speed, direction;
    std::getline(row, time, ',');
    std::getline(row, speed, ',');
    std::getline(row, direction, ',');
    time[10] = 'T';
    times.push_back(parse_utc(time + "Z"));
    wind.push_back(vector_from_direction(std::stod(speed), std::stod(direction)));
  }
}

TEST(PersistedWindError, IsThatOfARealOffshoreWind) {
  SLACKWATER_NEEDS_SHARED(shared);
  std::vector<UtcTime> times;
  std::vector<Horizontal> wind;
  read_nora3(shared / "data/nora3/NORA3_wind_wave_lon1.32_lat53.324_20221001_20221231.csv", times,
             wind);
  ASSERT_EQ(wind.size(), 2208u);
  const double sigma = climate_sigma_m_s(times, wind);
  EXPECT_NEAR(sigma, 5.4, 0.1);
  Horizontal mean{};
  for (const Horizontal w : wind) mean += w / 2208.0;
  const WindErrorGrowth growth = persisted_wind_error(sigma);
  for (const std::size_t lead : {3u, 6u, 12u, 24u, 48u, 72u}) {
    double square = 0;
    const double keep = std::exp(-static_cast<double>(lead) / wind_memory_h);
    for (std::size_t i = 0; i + lead < wind.size(); ++i) {
      square += 0.5 * std::norm(wind[i + lead] - mean - keep * (wind[i] - mean));
    }
    const double error = std::sqrt(square / static_cast<double>(wind.size() - lead));
    // Two weeks' worth of independent days leave 10 % between any model and the record.
    EXPECT_NEAR(growth.sigma_m_s(static_cast<double>(lead)) / error, 1.0, 0.1) << lead << " h";
  }
}

TEST(WindErrorExtra, AddsToTheLawWhereItIsGivenAndNowhereElse) {
  WindErrorGrowth growth = forecast_wind_error();
  const auto hour = [&](int h) { return end + std::chrono::hours(h); };
  growth.extra_at = {hour(10), hour(20), hour(30)};
  growth.extra_sigma_m_s = {0, 3, 1};
  const std::vector<UtcTime> times{hour(-1), hour(5), hour(15), hour(20), hour(40)};
  const std::vector<double> sigma = departure_sigma_m_s(times, end, growth);
  EXPECT_EQ(sigma[0], 0) << "what the calibration was fitted to";
  EXPECT_EQ(sigma[1], growth.sigma_m_s(5));
  EXPECT_NEAR(sigma[2], std::hypot(growth.sigma_m_s(15), 1.5), 1e-12);
  EXPECT_NEAR(sigma[3], std::hypot(growth.sigma_m_s(20), 3.0), 1e-12);
  EXPECT_EQ(sigma[4], growth.sigma_m_s(40));
}

}  // namespace
}  // namespace slackwater::calibration::wind_error_test
