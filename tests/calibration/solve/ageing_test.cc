#include "calibration/solve/ageing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calibration/solve/parameter_set.h"
#include "tests/calibration/solve/unsteady_day.h"

namespace slackwater::calibration::ageing_test {
namespace {

Calibration fitted_day() {
  UnsteadyDay day = random_unsteady_day(SteadyForm::mixed_layer, 4);
  return calibrate_day(unsteady_input(day));
}

const KnownParameter& named(const std::vector<KnownParameter>& known, const std::string& name) {
  return *std::find_if(known.begin(), known.end(),
                       [&](const KnownParameter& k) { return k.name == name; });
}

TEST(Ageing, CarriesTheShapeOfTheColumnAndTheFactorAndNothingOfTheDaysOwn) {
  const std::vector<KnownParameter> known = aged(fitted_day(), 1);
  std::vector<std::string> names;
  for (const KnownParameter& k : known) names.push_back(k.name);
  EXPECT_EQ(names, (std::vector<std::string>{"eddy_viscosity", "base_friction", "stress_factor",
                                             "mixed_layer_depth"}));
}

TEST(Ageing, TheVarianceGrowsByTheRandomWalkAndNeverPassesTheGeneralPriors) {
  const Calibration fitted = fitted_day();
  const Ageing ageing;
  const std::vector<std::pair<std::string, double>> growth{
      {"eddy_viscosity", ageing.eddy_viscosity},
      {"base_friction", ageing.friction},
      {"stress_factor", ageing.stress_factor},
      {"mixed_layer_depth", ageing.mixed_layer_depth}};
  for (const auto& [name, daily] : growth) {
    const Parameter* p = find_parameter(fitted, name);
    double before = p->sigma;
    for (const double days : {1.0, 2.0, 5.0, 30.0, 1000.0}) {
      const double sigma = named(aged(fitted, days), name).sigma;
      const double walked = std::sqrt(p->sigma * p->sigma + daily * daily * days);
      EXPECT_NEAR(sigma, std::min(walked, p->prior_sigma), 1e-14) << name << ' ' << days;
      EXPECT_GE(sigma, before);
      before = sigma;
    }
    EXPECT_EQ(before, p->prior_sigma);
    EXPECT_NEAR(named(aged(fitted, 0), name).sigma, p->sigma, 1e-15);
  }
}

TEST(Ageing, TheMeanStaysTodayAndReturnsToTheGeneralPriorInTime) {
  Calibration fitted = fitted_day();
  for (Parameter& p : fitted.parameters) {
    if (p.is_logarithmic) p.value = 2.0 * p.prior;
  }
  for (const std::string name :
       {"eddy_viscosity", "base_friction", "stress_factor", "mixed_layer_depth"}) {
    const double prior = find_parameter(fitted, name)->prior;
    EXPECT_NEAR(named(aged(fitted, 0), name).value / prior, 2.0, 1e-12);
    double before = 2.0;
    for (const double days : {1.0, 2.0, 5.0, 30.0, 1000.0}) {
      const double ratio = named(aged(fitted, days), name).value / prior;
      EXPECT_LT(ratio, before);
      EXPECT_GT(ratio, 1.0);
      before = ratio;
    }
    EXPECT_LT(before, 1.02) << name;
  }
}

TEST(Ageing, ReturnsToTheGeneralPriorAndNotToYesterdays) {
  Calibration fitted = fitted_day();
  for (Parameter& p : fitted.parameters) {
    if (p.is_logarithmic) p.prior = 3.0 * p.value;  // of the day before, say
  }
  const double general =
      prior_parameters(fitted.layout, fitted.water_depth_m, {})[ParameterLayout::log_viscosity]
          .prior;
  EXPECT_NEAR(named(aged(fitted, 1e6), "eddy_viscosity").value / general, 1.0, 1e-4);
}

/// Six currents of a day: three levels at two hours.
CalibrationInput short_day(UnsteadyDay day, std::uint64_t seed) {
  day.seed = seed;
  CalibrationInput input = synthetic_input(day);
  for (std::size_t t = 0; t < input.current.times(); ++t) {
    for (std::size_t k = 0; k < input.current.levels(); ++k) {
      if ((t != 6 && t != 18) || (k != 0 && k != 4 && k != 9))
        input.current.status[input.current.offset(t, k)] = SampleStatus::missing;
    }
  }
  return input;
}

struct ChainScore {
  double chain = 0;   ///< rms error of the last day, in standard deviations of the general prior
  double single = 0;  ///< of the last day alone
  double chain_normalised = 0;  ///< mean square of error over stated sigma
  double single_normalised = 0;
};

/// Viscosity, friction and factor of the fifth short day, over many seeds; `walk` times the
/// ageing's own random walk moves the truth from day to day.
ChainScore chain_score(double walk) {
  ChainScore score;
  double n = 0;
  const Ageing ageing;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    UnsteadyDay day = random_unsteady_day(SteadyForm::finite_depth, seed);
    Rng rng(seed, "tests/chain");
    std::vector<KnownParameter> known;
    for (std::uint64_t d = 0; d < 5; ++d) {
      day.truth.eddy_viscosity_m2_s *= std::exp(walk * ageing.eddy_viscosity * rng.normal());
      day.truth.bottom_friction_m_s *= std::exp(walk * ageing.friction * rng.normal());
      day.truth.stress_factor *= std::exp(walk * ageing.stress_factor * rng.normal());
      CalibrationInput input = short_day(day, 100 * seed + d);
      const Calibration single = calibrate_day(input);
      input.known = known;
      const Calibration chain = calibrate_day(input);
      known = aged(chain, 1);
      if (d < 4) continue;
      const std::vector<double> of_single = estimate_errors(single, day.truth);
      const std::vector<double> of_chain = estimate_errors(chain, day.truth);
      for (std::size_t i = 2; i < of_chain.size(); ++i) {
        const double scale = single.parameters[i].prior_sigma;
        score.single += std::pow(of_single[i] / scale, 2);
        score.chain += std::pow(of_chain[i] / scale, 2);
        score.chain_normalised += std::pow(of_chain[i] / chain.parameters[i].sigma, 2);
        score.single_normalised += std::pow(of_single[i] / single.parameters[i].sigma, 2);
        n += 1;
      }
    }
  }
  return {std::sqrt(score.chain / n), std::sqrt(score.single / n), score.chain_normalised / n,
          score.single_normalised / n};
}

TEST(Ageing, AChainOfFiveShortDaysKnowsTheWaterBetterThanOneOfThem) {
  for (const double walk : {0.0, 0.5}) {
    const ChainScore score = chain_score(walk);
    std::printf("walk %.1f: rms error chain %.3f, single %.3f; normalised %.2f, %.2f\n", walk,
                score.chain, score.single, score.chain_normalised, score.single_normalised);
    EXPECT_LT(score.chain, 0.9 * score.single) << walk;
    EXPECT_LT(score.chain_normalised, 1.4) << walk;
  }
}

}  // namespace
}  // namespace slackwater::calibration::ageing_test
