#include "calibration/propagate/ensemble_wind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "calibration/propagate/member_wind.h"
#include "tests/calibration/propagate/outlook_for_tests.h"

namespace slackwater::calibration::ensemble_wind_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t issued = 24;

std::vector<int> numbers(std::size_t count) {
  std::vector<int> number(count);
  std::iota(number.begin(), number.end(), 1);
  return number;
}

/// Members that depart by `spread_m_s` per component, each its own way, steadily.
WindDepartures steady_ensemble(std::size_t members, std::size_t times, double spread_m_s) {
  WindDepartures ensemble{numbers(members), {}};
  for (std::size_t n = 0; n < members; ++n) {
    const double angle = 2.4 * static_cast<double>(n);  // about the golden angle: no two alike
    for (std::size_t t = 0; t < times; ++t)
      ensemble.departure_m_s.push_back(std::polar(std::sqrt(2.0) * spread_m_s, angle));
  }
  return ensemble;
}

std::vector<Horizontal> departure_of(const EnsembleWind& wind, std::size_t m,
                                     std::uint64_t seed = 1) {
  Rng random(seed, "tests/ensemble_wind");
  return wind.departure(m, random);
}

/// Mean square of a component over seeds, of the first member, per sample.
std::vector<double> variance_over_seeds(const WindDepartures& ensemble,
                                        const std::vector<UtcTime>& times,
                                        const WindErrorGrowth& law, std::uint64_t seeds) {
  const std::vector<UtcTime> samples(times.begin() + 1, times.end());
  const EnsembleWind wind(ensemble, times, end_of_synthetic_day, samples, law, issued, 1);
  std::vector<double> variance(samples.size());
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const std::vector<Horizontal> drawn = departure_of(wind, 0, seed);
    for (std::size_t k = 0; k < drawn.size(); ++k)
      variance[k] += 0.5 * std::norm(drawn[k]) / static_cast<double>(seeds);
  }
  return variance;
}

TEST(ChooseDrivers, OfAsManyEachDrivesOne) {
  std::vector<std::size_t> each(issued);
  std::iota(each.begin(), each.end(), 0U);
  EXPECT_EQ(choose_drivers(issued, issued, 7), each);
}

TEST(ChooseDrivers, OfMoreNoneDrivesTwiceAndTheSeedChooses) {
  for (const std::size_t ensemble : {25U, 30U, 50U, 101U}) {
    std::vector<double> chosen(ensemble);
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
      const std::vector<std::size_t> drivers = choose_drivers(ensemble, issued, seed);
      ASSERT_EQ(drivers.size(), issued);
      EXPECT_EQ(std::set(drivers.begin(), drivers.end()).size(), issued);
      EXPECT_TRUE(std::is_sorted(drivers.begin(), drivers.end()));
      EXPECT_EQ(drivers, choose_drivers(ensemble, issued, seed));
      for (const std::size_t n : drivers) chosen.at(n) += 1.0;
    }
    // Binomial: 400 tries of probability p; five standard errors.
    const double p = static_cast<double>(issued) / static_cast<double>(ensemble);
    for (const double count : chosen)
      EXPECT_NEAR(count, 400 * p, 5 * std::sqrt(400 * p * (1 - p)) + 1e-9);
  }
}

TEST(ChooseDrivers, OfFewerAllDriveEquallyOften) {
  for (const std::size_t ensemble : {5U, 8U, 11U, 23U}) {
    std::vector<std::size_t> times_driven(ensemble);
    for (const std::size_t n : choose_drivers(ensemble, issued, 3)) ++times_driven.at(n);
    const auto [least, most] = std::minmax_element(times_driven.begin(), times_driven.end());
    EXPECT_LE(*most - *least, 1U);
    EXPECT_EQ(std::accumulate(times_driven.begin(), times_driven.end(), 0U), issued);
  }
}

TEST(ChooseDrivers, SetsGoOnWhereTheOneBeforeEndedAndNobodyDrivesAgainBeforeAllHave) {
  for (const std::size_t ensemble : {5U, 11U, 24U, 30U, 50U}) {
    std::vector<std::size_t> times_driven(ensemble);
    std::vector<std::size_t> before;
    for (std::size_t set = 0; set < 6; ++set) {
      const std::vector<std::size_t> drivers = choose_drivers(ensemble, issued, 3, set);
      ASSERT_EQ(drivers.size(), issued);
      for (const std::size_t n : drivers) ++times_driven.at(n);
      const auto [least, most] = std::minmax_element(times_driven.begin(), times_driven.end());
      EXPECT_LE(*most - *least, 1U) << ensemble << " after set " << set;
      if (ensemble > issued) {
        EXPECT_NE(drivers, before);
      }
      before = drivers;
    }
  }
}

TEST(EnsembleVariance, IsTheMeanSquareOfWhoSpeaks) {
  WindDepartures ensemble{{1, 2, 3}, {}};
  const Horizontal nothing(nan, nan);
  ensemble.departure_m_s = {{3, 4},  {1, 1}, nothing, {0, 5}, nothing,
                            nothing, {5, 0}, {1, -1}, nothing};
  const std::vector<double> variance = ensemble_variance(ensemble, 3);
  EXPECT_DOUBLE_EQ(variance[0], 12.5);
  EXPECT_DOUBLE_EQ(variance[1], 1.0);
  EXPECT_TRUE(std::isnan(variance[2]));
}

TEST(EnsembleWind, ThatSpreadsMoreThanAnAnalysisErrsIsCarriedAsItIs) {
  const auto times = leads(0, 48);
  const std::vector<UtcTime> samples(times.begin() + 1, times.end());
  const WindDepartures ensemble = steady_ensemble(30, times.size(), 2.0);
  const EnsembleWind wind(ensemble, times, end_of_synthetic_day, samples, forecast_wind_error(),
                          issued, 5);
  const std::vector<int> number = wind.numbers();
  ASSERT_EQ(number.size(), issued);
  for (std::size_t m = 0; m < issued; ++m) {
    const auto n = static_cast<std::size_t>(number[m] - 1);
    for (const Horizontal d : departure_of(wind, m))
      EXPECT_EQ(d, ensemble.departure_m_s[n * times.size()]) << m;
  }
}

TEST(EnsembleWind, ThatSpreadsLessIsRaisedToTheErrorOfAnAnalysis) {
  const auto times = leads(0, 24);
  for (const double spread : {0.0, 0.4, 0.9}) {
    const auto variance = variance_over_seeds(steady_ensemble(24, times.size(), spread), times,
                                              forecast_wind_error(), 1500);
    // A variance of 3000 numbers: a standard error of 2.6 %.
    for (const double v : variance) EXPECT_NEAR(v, 1.0, 0.13) << spread;
  }
}

TEST(EnsembleWind, BeyondItsEndGrowsIntoTheLawAsWindsForget) {
  const auto times = leads(0, 96);
  constexpr std::size_t end = 36;
  WindDepartures ensemble = steady_ensemble(24, times.size(), 2.0);
  for (std::size_t i = 0; i < ensemble.departure_m_s.size(); ++i) {
    if (i % times.size() > end) ensemble.departure_m_s[i] = Horizontal(nan, nan);
  }
  const WindErrorGrowth law = forecast_wind_error();
  const auto variance = variance_over_seeds(ensemble, times, law, 1500);
  for (std::size_t k = 0; k < variance.size(); ++k) {
    const double beyond_h = static_cast<double>(k + 1) - static_cast<double>(end);
    const double kept = beyond_h <= 0 ? 1.0 : std::exp(-2 * beyond_h / law.memory_h);
    const double sigma = law.sigma_m_s(static_cast<double>(k + 1));
    const double expected = kept * 4.0 + (1 - kept) * sigma * sigma;
    EXPECT_NEAR(variance[k] / expected, 1.0, 0.13) << k;  // five standard errors
  }
}

TEST(EnsembleWind, BeforeItsBeginningIsTheLaw) {
  const auto times = leads(0, 48);
  WindDepartures ensemble = steady_ensemble(24, times.size(), 2.0);
  for (std::size_t i = 0; i < ensemble.departure_m_s.size(); ++i) {
    if (i % times.size() < 20) ensemble.departure_m_s[i] = Horizontal(nan, nan);
  }
  const WindErrorGrowth law = forecast_wind_error();
  const auto variance = variance_over_seeds(ensemble, times, law, 1500);
  for (std::size_t k = 0; k < 19; ++k) {
    const double sigma = law.sigma_m_s(static_cast<double>(k + 1));
    EXPECT_NEAR(variance[k] / (sigma * sigma), 1.0, 0.13) << k;
  }
  EXPECT_NEAR(variance[19], 4.0, 1e-12);
}

TEST(EnsembleWind, WhoDrivesTwiceIsNotTheSameWindTwice) {
  const auto times = leads(0, 240);
  const std::vector<UtcTime> samples(times.begin() + 1, times.end());
  const WindDepartures ensemble = steady_ensemble(11, times.size(), 2.0);
  const EnsembleWind wind(ensemble, times, end_of_synthetic_day, samples, forecast_wind_error(),
                          issued, 5);
  const std::vector<int> number = wind.numbers();
  for (std::size_t m = 0; m < issued; ++m) {
    const auto n = static_cast<std::size_t>(number[m] - 1);
    const std::vector<Horizontal> blown = departure_of(wind, m);
    double more = 0;
    for (const Horizontal d : blown)
      more += 0.5 * std::norm(d - ensemble.departure_m_s[n * times.size()]) /
              static_cast<double>(blown.size());
    if (m < 11) {
      EXPECT_EQ(more, 0.0);
    } else {
      // 240 h of 12 h memory are twenty samples of two components: five standard errors.
      EXPECT_NEAR(more / (0.09 * 4.0), 1.0, 5 / std::sqrt(20.0)) << m;
      EXPECT_GT(more, 0.0);
    }
  }
}

TEST(EnsembleWind, IsReadBetweenTheTimesWhereTheWindsSamplesLie) {
  // Six-hourly departures that grow by 1 m/s an hour, samples at odd hours and past the end.
  std::vector<UtcTime> times;
  WindDepartures ensemble{numbers(5), {}};
  for (int h = 0; h <= 24; h += 6) times.push_back(add_hours(end_of_synthetic_day, h));
  for (int n = 0; n < 5; ++n) {
    for (int h = 0; h <= 24; h += 6) ensemble.departure_m_s.emplace_back(h + 2.0, 0);
  }
  const std::vector<UtcTime> samples{
      add_hours(end_of_synthetic_day, 1), add_hours(end_of_synthetic_day, 7.5),
      add_hours(end_of_synthetic_day, 24), add_hours(end_of_synthetic_day, 30)};
  const EnsembleWind wind(ensemble, times, end_of_synthetic_day, samples, forecast_wind_error(), 4,
                          1);
  const std::vector<Horizontal> blown = departure_of(wind, 0);
  const std::vector<double> expected{3.0, 9.5, 26.0, 26.0};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(blown[k].real(), expected[k], 1e-12);
    EXPECT_NEAR(blown[k].imag(), 0.0, 1e-12);
  }
}

TEST(MembersOfAnEnsemble, DepartBySigmaAboutTheCentreAsTheirWindsDrive) {
  const CalibrationInput input = unsteady_input(usual_day());
  const Calibration fitted = calibrate_day(input);
  const auto times = leads(0, 36);
  const WindDepartures ensemble = steady_ensemble(24, times.size(), 3.0);
  const Propagated p = propagate(std::span(&fitted, 1), times, input.wind, end_of_synthetic_day,
                                 forecast_wind_error(), {}, 1, ensemble);
  EXPECT_EQ(p.wind_member_number, numbers(24));
  const std::size_t size = p.mean_m_s.size();
  for (std::size_t i = 0; i < size; ++i) {
    double squares = 0;
    for (std::size_t m = 0; m < 24; ++m)
      squares += 0.5 * std::norm(p.departure_m_s[m * size + i]) / 24;
    EXPECT_NEAR(std::sqrt(squares) / p.sigma_m_s[i], 1.0, 1e-12);
  }
  for (std::size_t m = 0; m < 24; ++m) {
    for (std::size_t t = 1; t < times.size(); ++t)
      EXPECT_EQ(p.wind_departure_m_s[m * times.size() + t],
                ensemble.departure_m_s[m * times.size()]);
  }
  EXPECT_EQ(p.mean_m_s, outlook(fitted, times, input.wind).mean_m_s) << "the centre is no member";
}

TEST(MembersOfAnEnsemble, StandOffTheCentreWhereTheirWindsDo) {
  // All members blow 4 m/s more to the east than the wind used: their currents are those of that
  // wind, and the centre is doubted by as much.
  const CalibrationInput input = unsteady_input(usual_day());
  const Calibration fitted = calibrate_day(input);
  const auto times = leads(0, 36);
  WindDepartures ensemble = steady_ensemble(24, times.size(), 0.0);
  for (Horizontal& d : ensemble.departure_m_s) d = 4.0;
  const Propagated off = propagate(std::span(&fitted, 1), times, input.wind, end_of_synthetic_day,
                                   forecast_wind_error(), {}, 1, ensemble);
  const auto after =
      std::count_if(input.wind->time.begin(), input.wind->time.end(),
                    [](const TimeCell& cell) { return cell.start > end_of_synthetic_day; });
  const std::vector<Horizontal> stronger(static_cast<std::size_t>(after), 4.0);
  const Propagated blown =
      outlook(fitted, times, departed_wind(*input.wind, end_of_synthetic_day, stronger));
  const std::size_t size = off.mean_m_s.size();
  Horizontal product{};
  double expected_squares = 0;
  double found_squares = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Horizontal expected = blown.wind_driven_m_s[i] - off.wind_driven_m_s[i];
    Horizontal found{};
    for (std::size_t m = 0; m < 24; ++m) found += off.departure_m_s[m * size + i] / 24.0;
    product += found * std::conj(expected);
    expected_squares += std::norm(expected);
    found_squares += std::norm(found);
    EXPECT_GE(off.sigma_m_s[i], 0.7 * std::abs(expected)) << "1/sqrt(2) of a vector, per component";
  }
  EXPECT_GT(product.real() / std::sqrt(expected_squares * found_squares), 0.95);
  // Scaling to sigma makes up for a memory that 24 draws meet to a tenth or two.
  EXPECT_NEAR(std::sqrt(found_squares / expected_squares), 1.0, 0.25);
}

/// How often the truth lies between the third lowest and the third highest of 24 issued winds, of
/// an ensemble that spreads by `spread_m_s` where its forecast errs by `error_m_s`, both east.
double share_inside(double spread_m_s, double error_m_s, int draws) {
  const std::vector<UtcTime> times{end_of_synthetic_day, add_hours(end_of_synthetic_day, 12)};
  const std::vector<UtcTime> samples{times.back()};
  int inside = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const auto seed = static_cast<std::uint64_t>(draw);
    Rng random(seed, "tests/ensemble_wind/coverage");
    WindDepartures ensemble{numbers(issued), {}};
    for (std::size_t n = 0; n < issued; ++n) {
      ensemble.departure_m_s.emplace_back();
      ensemble.departure_m_s.push_back(spread_m_s * Horizontal(random.normal(), random.normal()));
    }
    const EnsembleWind wind(ensemble, times, end_of_synthetic_day, samples, forecast_wind_error(),
                            issued, seed);
    std::vector<double> winds;
    for (std::size_t m = 0; m < issued; ++m)
      winds.push_back(departure_of(wind, m, 1000 * seed + m / 2).back().real());
    std::sort(winds.begin(), winds.end());
    const double truth = error_m_s * random.normal();
    inside += winds[2] < truth && truth < winds[21] ? 1 : 0;
  }
  return static_cast<double>(inside) / draws;
}

TEST(EnsembleWind, ASpreadThatIsTheErrorHoldsTheTruthAsOftenAsItShould) {
  // One more of the same kind has each of 25 ranks alike; 19 of them lie inside. 400 draws: four
  // standard errors of 0.021.
  EXPECT_NEAR(share_inside(2.0, 2.0, 400), 19.0 / 25, 0.085);
}

TEST(EnsembleWind, ASpreadBelowWhatAnAnalysisErrsIsRaisedUntilItHoldsTheTruth) {
  EXPECT_NEAR(share_inside(0.3, 1.0, 400), 19.0 / 25, 0.085);
}

}  // namespace
}  // namespace slackwater::calibration::ensemble_wind_test
