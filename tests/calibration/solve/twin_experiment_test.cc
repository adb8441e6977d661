// Known truth in, the same parameters out, within the uncertainty that the calibration states.
#include <gtest/gtest.h>

#include "tests/calibration/solve/synthetic_day.h"

namespace slackwater::calibration::twin_experiment_test {
namespace {

SyntheticDay shelf_day(std::uint64_t seed) {
  SyntheticDay day;
  day.seed = seed;
  Rng rng(seed, "tests/twin_truth");
  day.truth.interior_east_m_s = rng.uniform(-0.4, 0.4);
  day.truth.interior_north_m_s = rng.uniform(-0.4, 0.4);
  day.truth.eddy_viscosity_m2_s = 0.03 * std::exp(0.7 * rng.normal());
  day.truth.bottom_friction_m_s = 5e-4 * std::exp(0.5 * rng.normal());
  day.truth.stress_factor = std::exp(0.2 * rng.normal());
  day.latitude_deg = (seed % 2 == 0 ? 1 : -1) * rng.uniform(25, 65);
  return day;
}

SyntheticDay deep_day(std::uint64_t seed) {
  SyntheticDay day = shelf_day(seed);
  day.form = SteadyForm::three_layer;
  day.water_depth_m = 420;
  day.truth.bottom_eddy_viscosity_m2_s = 5e-3 * std::exp(0.5 * day.truth.interior_east_m_s);
  day.depth_m = {0.5, 3, 6, 10, 15, 22, 30, 45, 70, 120, 250, 380, 400, 410, 415, 418};
  return day;
}

/// Mean square of (estimate - truth)/sigma over the cases: 1 if the stated uncertainty is the true
/// one.
template <typename MakeDay>
double mean_square_of_normalised_errors(MakeDay make_day, int cases, double worst_allowed) {
  double squares = 0;
  int n = 0;
  for (int seed = 1; seed <= cases; ++seed) {
    const SyntheticDay day = make_day(static_cast<std::uint64_t>(seed));
    const Calibration fitted = calibrate_day(synthetic_input(day));
    const std::vector<double> errors = estimate_errors(fitted, day.truth);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double normalised = errors[i] / fitted.parameters[i].sigma;
      EXPECT_LT(std::abs(normalised), worst_allowed)
          << "seed " << seed << ' ' << fitted.parameters[i].name;
      squares += normalised * normalised;
      ++n;
    }
  }
  return squares / n;
}

// 5 parameters x 40 days = 200 normalised errors: the mean square has a standard error of 0.1, and
// the largest of 200 normal deviates passes 4.5 once in 700 such tests (the seeds are fixed).
constexpr int days = 40;

TEST(TwinExperiment, ShelfParametersAreFoundWithinTheirSigmaInBothHemispheres) {
  const double z2 = mean_square_of_normalised_errors(shelf_day, days, 4.5);
  EXPECT_GT(z2, 0.6);
  EXPECT_LT(z2, 1.4);
}

TEST(TwinExperiment, DeepParametersAreFoundWithinTheirSigmaInBothHemispheres) {
  const double z2 = mean_square_of_normalised_errors(deep_day, days, 4.5);
  EXPECT_GT(z2, 0.6);
  EXPECT_LT(z2, 1.4);
}

TEST(TwinExperiment, GapsWidenTheUncertaintyAndDoNotBiasTheAnswer) {
  const auto with_gaps = [](std::uint64_t seed) {
    SyntheticDay day = shelf_day(seed);
    day.missing_share = 0.6;
    return day;
  };
  const double z2 = mean_square_of_normalised_errors(with_gaps, days, 4.5);
  EXPECT_GT(z2, 0.6);
  EXPECT_LT(z2, 1.4);
  const Calibration whole = calibrate_day(synthetic_input(shelf_day(4)));
  const Calibration holed = calibrate_day(synthetic_input(with_gaps(4)));
  EXPECT_LT(holed.observations, whole.observations / 2);
  for (std::size_t i = 0; i < whole.parameters.size(); ++i) {
    EXPECT_GT(holed.parameters[i].sigma, 1.2 * whole.parameters[i].sigma);
  }
}

TEST(TwinExperiment, MeansAreFittedAsMeans) {
  const auto hourly_means = [](std::uint64_t seed) {
    SyntheticDay day = shelf_day(seed);
    day.is_mean = true;
    return day;
  };
  const double z2 = mean_square_of_normalised_errors(hourly_means, days, 4.5);
  EXPECT_GT(z2, 0.6);
  EXPECT_LT(z2, 1.4);

  // One mean over the whole day, without noise: an instant's stress could not explain it to a tenth
  // of a millimetre.
  SyntheticDay day = shelf_day(2);
  CalibrationInput input = synthetic_input(day);
  input.current.time = {{synthetic_midnight, add_hours(synthetic_midnight, 24)}};
  input.current.source = {DataStatus::analysis};
  input.current.value = synthetic_truth(day, input.current.time);
  input.current.status.assign(input.current.value.size(), SampleStatus::ok);
  input.observation_sigma_m_s = 1e-4;
  EXPECT_LT(calibrate_day(input).rms_m_s, 1e-4);
}

TEST(TwinExperiment, WithoutNoiseTheTruthComesBack) {
  for (const bool is_deep : {false, true}) {
    SyntheticDay day = is_deep ? deep_day(6) : shelf_day(6);
    day.noise_m_s = 0;
    CalibrationInput input = synthetic_input(day);
    input.observation_sigma_m_s = 1e-6;  // the data outweigh the priors by ten digits
    const Calibration fitted = calibrate_day(input);
    for (const double error : estimate_errors(fitted, day.truth)) EXPECT_LT(std::abs(error), 1e-5);
    EXPECT_LT(fitted.rms_m_s, 1e-7);
  }
}

TEST(TwinExperiment, AFewWildValuesHardlyMoveTheAnswer) {
  const SyntheticDay day = shelf_day(8);
  CalibrationInput input = synthetic_input(day);
  const Calibration clean = calibrate_day(input);
  Rng rng(9, "tests/wild");
  for (Horizontal& value : input.current.value) {
    if (rng.uniform() < 0.03) value += Horizontal{1.5, -1.0};
  }
  const Calibration wild = calibrate_day(input);
  for (std::size_t i = 0; i < clean.parameters.size(); ++i) {
    const Parameter& p = clean.parameters[i];
    const double moved = p.is_logarithmic ? std::log(wild.parameters[i].value / p.value)
                                          : wild.parameters[i].value - p.value;
    EXPECT_LT(std::abs(moved), 3 * p.sigma) << p.name;
  }
}

TEST(TwinExperiment, TurningTheDayTurnsTheInteriorAndLeavesTheShape) {
  const SyntheticDay day = shelf_day(3);
  CalibrationInput input = synthetic_input(day);
  const Calibration before = calibrate_day(input);
  const Horizontal turn = std::polar(1.0, 2.1);
  for (Horizontal& value : input.current.value) value *= turn;
  for (Horizontal& value : input.wind->value) value *= turn;
  const Calibration after = calibrate_day(input);
  const SteadyParameters p = steady_parameters(before);
  const SteadyParameters q = steady_parameters(after);
  // The minimum is followed to 1e-9 of the cost, about 1e-4 of a sigma.
  EXPECT_LT(std::abs(q.interior_m_s() - turn * p.interior_m_s()), 1e-5);
  EXPECT_NEAR(std::log(q.eddy_viscosity_m2_s / p.eddy_viscosity_m2_s), 0, 1e-4);
  EXPECT_NEAR(std::log(q.bottom_friction_m_s / p.bottom_friction_m_s), 0, 1e-4);
  EXPECT_NEAR(std::log(q.stress_factor / p.stress_factor), 0, 1e-4);
}

}  // namespace
}  // namespace slackwater::calibration::twin_experiment_test
