#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "tests/calibration/solve/synthetic_day.h"

namespace slackwater::calibration::stated_noise_fit_test {
namespace {

/// A day of which some levels are read by a poor instrument.
CalibrationInput half_poor_day(std::uint64_t seed, bool is_stated) {
  SyntheticDay day;
  day.seed = seed;
  day.noise_m_s = 0.005;
  day.truth.interior_east_m_s = 0.2;
  CalibrationInput input = synthetic_input(day);
  Rng random(seed, "tests/half_poor_day");
  for (std::size_t t = 0; t < input.current.times(); ++t) {
    for (std::size_t k = 0; k < input.current.levels(); ++k) {
      const double noise = k % 2 == 0 ? 0.3 : 0.0;
      const double east = random.normal();
      input.current.value[input.current.offset(t, k)] += noise * Horizontal(east, random.normal());
      if (is_stated) input.noise_m_s.push_back(noise);
    }
  }
  return input;
}

TEST(StatedNoiseInTheFit, ValuesCountByIt) {
  double stated = 0;
  double silent = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const auto miss = [&](bool is_stated) {
      const Calibration fitted = calibrate_day(half_poor_day(seed, is_stated));
      return std::norm(steady_parameters(fitted).interior_m_s() - Horizontal(0.2, 0.0));
    };
    stated += miss(true) / 12;
    silent += miss(false) / 12;
  }
  std::printf("interior off by %.4f m/s with the noise stated, %.4f without\n", std::sqrt(stated),
              std::sqrt(silent));
  EXPECT_LT(std::sqrt(stated), 0.7 * std::sqrt(silent));
}

TEST(StatedNoiseInTheFit, ThatIsTheSameForAllMovesNoEstimate) {
  SyntheticDay day;
  day.noise_m_s = 0.1;
  CalibrationInput input = synthetic_input(day);
  const Calibration silent = calibrate_day(input);
  input.noise_m_s.assign(input.current.value.size(), 0.1);
  const Calibration stated = calibrate_day(input);
  for (std::size_t i = 0; i < stated.parameters.size(); ++i) {
    EXPECT_NEAR(stated.parameters[i].value, silent.parameters[i].value,
                0.2 * silent.parameters[i].sigma *
                    (silent.parameters[i].is_logarithmic ? silent.parameters[i].value : 1.0))
        << stated.parameters[i].name;
  }
  EXPECT_EQ(stated.noise_m_s, input.noise_m_s);
}

TEST(StatedNoiseInTheFit, IsOneForEachValue) {
  CalibrationInput input = synthetic_input(SyntheticDay{});
  input.noise_m_s = {0.1};
  EXPECT_THROW((void)calibrate_day(input), ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration::stated_noise_fit_test
