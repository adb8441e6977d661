#include <gtest/gtest.h>

#include <cmath>

#include "calibration/propagate/member_wind.h"
#include "tests/calibration/propagate/outlook_for_tests.h"

namespace slackwater::calibration::members_test {
namespace {

WindErrorGrowth with_wind_error() {
  WindErrorGrowth error;
  error.initial_m_s = 0.5;
  error.saturation_m_s = 2.5;
  return error;
}

TEST(Members, DepartBySigmaAboutAMeanOfZeroAtEveryTimeAndLevel) {
  for (const bool has_wind : {true, false}) {
    const CalibrationInput input = unsteady_input(usual_day());
    const Calibration fitted = calibrate_day(input);
    const std::optional<VectorColumn> wind = has_wind ? input.wind : std::nullopt;
    const Propagated p = outlook(fitted, leads(0, 36), wind, with_wind_error());
    const std::size_t size = p.mean_m_s.size();
    ASSERT_EQ(p.departure_m_s.size(), 24 * size);
    for (std::size_t i = 0; i < size; ++i) {
      Horizontal sum{};
      double squares = 0;
      for (std::size_t m = 0; m < 24; ++m) {
        sum += p.departure_m_s[m * size + i];
        squares += 0.5 * std::norm(p.departure_m_s[m * size + i]) / 24;
      }
      EXPECT_LT(std::abs(sum), 1e-13);
      EXPECT_NEAR(std::sqrt(squares) / p.sigma_m_s[i], 1.0, 1e-12);
    }
  }
}

TEST(Members, ComeInPairsOfOppositeWind) {
  const CalibrationInput input = unsteady_input(usual_day());
  const auto times = leads(1, 24);
  const Propagated p = outlook(calibrate_day(input), times, input.wind, with_wind_error());
  ASSERT_EQ(p.wind_departure_m_s.size(), 24 * times.size());
  for (std::size_t pair = 0; pair < 12; ++pair) {
    for (std::size_t t = 0; t < times.size(); ++t) {
      const Horizontal plus = p.wind_departure_m_s[2 * pair * times.size() + t];
      EXPECT_GT(std::abs(plus), 0.0);
      EXPECT_EQ(plus, -p.wind_departure_m_s[(2 * pair + 1) * times.size() + t]);
    }
  }
}

TEST(Members, AreTheSameBitsForASeedAndOthersForAnother) {
  const CalibrationInput input = unsteady_input(usual_day());
  const Calibration fitted = calibrate_day(input);
  const Propagated a = outlook(fitted, leads(1, 12), input.wind, with_wind_error(), 5);
  const Propagated b = outlook(fitted, leads(1, 12), input.wind, with_wind_error(), 5);
  const Propagated c = outlook(fitted, leads(1, 12), input.wind, with_wind_error(), 6);
  EXPECT_EQ(a.departure_m_s, b.departure_m_s);
  EXPECT_EQ(a.sigma_m_s, b.sigma_m_s);
  EXPECT_EQ(a.mean_m_s, c.mean_m_s);  // the centre is no draw
  EXPECT_NE(a.departure_m_s, c.departure_m_s);
}

TEST(Members, AWindThatIsDoubtedMoreWidensTheForecast) {
  const CalibrationInput input = unsteady_input(usual_day());
  const Calibration fitted = calibrate_day(input);
  const Propagated sure = outlook(fitted, leads(1, 48), input.wind);
  const Propagated doubted = outlook(fitted, leads(1, 48), input.wind, with_wind_error());
  EXPECT_EQ(sure.mean_m_s, doubted.mean_m_s);
  // At one place twelve pairs may have doubts that happen to cancel; over two days they do not.
  const auto variance = [](const Propagated& p) {
    double sum = 0;
    for (const double sigma : p.sigma_m_s) sum += sigma * sigma;
    return sum;
  };
  EXPECT_GT(variance(doubted), 1.02 * variance(sure));
}

TEST(Members, NoneAskedForLeavesTheMean) {
  const CalibrationInput input = unsteady_input(usual_day());
  const Calibration fitted = calibrate_day(input);
  Spread spread;
  spread.members = 0;
  const Propagated p = outlook(fitted, leads(1, 12), input.wind, {}, 1, spread);
  EXPECT_TRUE(p.departure_m_s.empty());
  EXPECT_EQ(p.mean_m_s, outlook(fitted, leads(1, 12), input.wind).mean_m_s);
}

TEST(Members, SigmaIsTheSameBesideAnyNumberOfMembers) {
  const CalibrationInput input = unsteady_input(usual_day());
  const Calibration fitted = calibrate_day(input);
  const auto sigma_beside = [&](int members) {
    Spread spread;
    spread.members = members;
    return outlook(fitted, leads(1, 72), input.wind, with_wind_error(), 1, spread).sigma_m_s;
  };
  const std::vector<double> usual = sigma_beside(24);
  for (const int members : {0, 2, 8, 50}) EXPECT_EQ(sigma_beside(members), usual) << members;
}

TEST(Members, AreTheSameBitsWhateverTheirNumber) {
  const CalibrationInput input = unsteady_input(usual_day());
  const Calibration fitted = calibrate_day(input);
  const auto times = leads(1, 12);
  const auto beside = [&](int members, bool has_wind) {
    Spread spread;
    spread.members = members;
    return outlook(fitted, times, has_wind ? std::optional(input.wind) : std::nullopt,
                   with_wind_error(), 1, spread);
  };
  for (const bool has_wind : {true, false}) {
    const Propagated most = beside(60, has_wind);
    const std::size_t size = most.mean_m_s.size();
    ASSERT_EQ(most.departure_m_s.size(), 60 * size);
    for (const int members : {1, 7, 24, 25, 48}) {
      const Propagated fewer = beside(members, has_wind);
      ASSERT_EQ(fewer.departure_m_s.size(), std::size_t(members) * size);
      EXPECT_TRUE(std::equal(fewer.departure_m_s.begin(), fewer.departure_m_s.end(),
                             most.departure_m_s.begin()))
          << members;
      EXPECT_TRUE(std::equal(fewer.wind_departure_m_s.begin(), fewer.wind_departure_m_s.end(),
                             most.wind_departure_m_s.begin()))
          << members;
    }
    for (std::size_t i = 24 * times.size(); i < most.wind_departure_m_s.size(); ++i) {
      EXPECT_NE(most.wind_departure_m_s[i], most.wind_departure_m_s[i % (24 * times.size())]);
    }
    // Each set spreads as sigma says, and none repeats another.
    for (std::size_t i = 0; i < size; ++i) {
      double squares = 0;
      for (std::size_t m = 24; m < 48; ++m)
        squares += 0.5 * std::norm(most.departure_m_s[m * size + i]) / 24;
      EXPECT_NEAR(std::sqrt(squares) / most.sigma_m_s[i], 1.0, 1e-12);
      for (std::size_t m = 24; m < 60; ++m)
        EXPECT_NE(most.departure_m_s[m * size + i], most.departure_m_s[m % 24 * size + i]);
    }
  }
}

TEST(Members, SigmaHardlyDependsOnTheSeed) {
  // What the wind leaves open on the second day, by sixteen seeds: 13 % of itself; 16 % where pairs
  // are left as they fall (24 independent squares alone: 1/sqrt(2 * 24) = 14 %; the parameters).
  const CalibrationInput input = unsteady_input(usual_day());
  const Calibration fitted = calibrate_day(input);
  const auto times = leads(25, 48);
  const Propagated sure = outlook(fitted, times, input.wind);
  double scatter = 0;
  double count = 0;
  std::vector<std::vector<double>> of_wind;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    const Propagated p = outlook(fitted, times, input.wind, with_wind_error(), seed);
    of_wind.emplace_back();
    for (std::size_t i = 0; i < p.sigma_m_s.size(); ++i) {
      const double memory = std::pow(sure.sigma_m_s[i], 2);
      of_wind.back().push_back(std::sqrt(std::max(0.0, std::pow(p.sigma_m_s[i], 2) - memory)));
    }
  }
  for (std::size_t i = 0; i < of_wind.front().size(); ++i) {
    double sum = 0;
    double squares = 0;
    for (const auto& one : of_wind) {
      sum += one[i] / 16;
      squares += one[i] * one[i] / 16;
    }
    if (sum < 0.005) continue;
    scatter += (squares - sum * sum) / (sum * sum);
    count += 1;
  }
  ASSERT_GT(count, 20);
  EXPECT_LT(std::sqrt(scatter / count), 0.145);
}

TEST(Members, WindsOfManyPairsSpreadAsTheirErrorSays) {
  const CalibrationInput input = unsteady_input(usual_day());
  const auto times = leads(1, 24);
  const Propagated p = outlook(calibrate_day(input), times, input.wind, with_wind_error());
  for (std::size_t t = 0; t < times.size(); ++t) {
    double squares = 0;
    for (std::size_t m = 0; m < 24; ++m)
      squares += 0.5 * std::norm(p.wind_departure_m_s[m * times.size() + t]) / 24;
    const double law = with_wind_error().sigma_m_s(static_cast<double>(t + 1));
    EXPECT_NEAR(std::sqrt(squares) / law, 1.0, 1e-9);
  }
}

TEST(Members, ParametersAreDrawnFromThePosterior) {
  const Calibration fitted = calibrate_day(unsteady_input(usual_day()));
  const std::size_t n = fitted.parameters.size();
  const std::size_t i = ParameterLayout::log_viscosity;
  const std::size_t j = fitted.layout.log_factor();
  Rng rng(3, "tests/drawn_parameters");
  constexpr int draws = 4000;
  double ii = 0;
  double jj = 0;
  double ij = 0;
  for (int d = 0; d < draws; ++d) {
    std::vector<double> z(n);
    for (double& x : z) x = rng.normal();
    const SteadyParameters p = drawn_parameters(fitted, z);
    const double a = std::log(p.eddy_viscosity_m2_s / fitted.parameters[i].value);
    const double b = std::log(p.stress_factor / fitted.parameters[j].value);
    ii += a * a / draws;
    jj += b * b / draws;
    ij += a * b / draws;
    EXPECT_EQ(p.interior_m_s(), steady_parameters(fitted).interior_m_s());
  }
  // A variance of 4000 draws has a standard error of 2 %.
  EXPECT_NEAR(ii / fitted.covariance[i * n + i], 1, 0.1);
  EXPECT_NEAR(jj / fitted.covariance[j * n + j], 1, 0.1);
  EXPECT_NEAR(
      ij / std::sqrt(ii * jj),
      fitted.covariance[i * n + j] / (fitted.parameters[i].sigma * fitted.parameters[j].sigma),
      0.08);
}

TEST(Members, TheCentralWindDrivenPartIsThatOfTheForecast) {
  // Two paths to one number: the steady form with its transient, and the rows that were fitted.
  for (const SteadyForm form :
       {SteadyForm::finite_depth, SteadyForm::mixed_layer, SteadyForm::three_layer}) {
    const CalibrationInput input = unsteady_input(usual_day(form));
    const Calibration fitted = calibrate_day(input);
    const auto times = leads(0, 24);
    const Propagated p = outlook(fitted, times, input.wind);
    const auto driven =
        WindDriven(fitted, times, end_of_synthetic_day)
            .under(StressSeries(*input.wind, fitted.drag_law), steady_parameters(fitted));
    for (std::size_t i = 0; i < driven.size(); ++i)
      EXPECT_LT(std::abs(driven[i] - p.wind_driven_m_s[i]), 1e-12) << name_of(form);
  }
}

}  // namespace
}  // namespace slackwater::calibration::members_test
