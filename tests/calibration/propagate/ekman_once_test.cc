// A product already holds the answer of its water to the wind: the forecast gives it once.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/calibration/propagate/outlook_for_tests.h"

namespace slackwater::calibration::ekman_once_test {
namespace {

double rms(const std::vector<Horizontal>& a, const std::vector<Horizontal>& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += std::norm(a[i] - b[i]);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

/// D+1 of the product itself, and its part that the wind makes.
struct NextDay {
  std::vector<UtcTime> times = leads(1, 24);
  std::vector<Horizontal> current;
  std::vector<Horizontal> ekman;

  NextDay(const UnsteadyDay& day, bool is_unsteady) {
    std::vector<TimeCell> cells;
    for (const UtcTime time : times) cells.push_back(TimeCell::instant(time));
    current = is_unsteady ? unsteady_truth(day, cells) : synthetic_truth(day, cells);
    UnsteadyDay still = day;
    still.truth.interior_east_m_s = still.truth.interior_north_m_s = 0;
    still.inertial_m_s = 0;
    ekman = is_unsteady ? unsteady_truth(still, cells) : synthetic_truth(still, cells);
  }
};

TEST(EkmanOnce, TheForecastOfAProductWithEkmanFlowIsTheProductAndNotMore) {
  for (const bool is_unsteady : {false, true}) {
    for (const SteadyForm form : {SteadyForm::finite_depth, SteadyForm::mixed_layer}) {
      UnsteadyDay day = usual_day(form);
      day.noise_m_s = 0.004;  // the memory follows what it takes for no noise
      const CalibrationInput input = is_unsteady ? unsteady_input(day) : synthetic_input(day);
      const NextDay truth(day, is_unsteady);
      const Propagated forecast = outlook(calibrate_day(input), truth.times, input.wind);
      std::vector<Horizontal> twice = truth.current;
      for (std::size_t i = 0; i < twice.size(); ++i) twice[i] += truth.ekman[i];
      const double doubled = rms(twice, truth.current);
      ASSERT_GT(doubled, 0.05);  // what a second helping would add
      EXPECT_LT(rms(forecast.mean_m_s, truth.current), 0.25 * doubled)
          << name_of(form) << is_unsteady;
      EXPECT_LT(rms(forecast.wind_driven_m_s, truth.ekman), 0.1 * doubled)
          << name_of(form) << is_unsteady;
    }
  }
}

TEST(EkmanOnce, AProductWithoutEkmanFlowIsGivenLittleAndItIsKnownHowMuch) {
  // The wind blows but the product does not answer: the factor falls as far as its prior lets it.
  const UnsteadyDay day = usual_day();
  CalibrationInput input = synthetic_input(day);
  const NextDay truth(day, false);
  UnsteadyDay deaf = day;
  deaf.truth.stress_factor = 0.1;
  const std::vector<Horizontal> answer = synthetic_truth(day, input.current.time);
  const std::vector<Horizontal> little = synthetic_truth(deaf, input.current.time);
  for (std::size_t i = 0; i < answer.size(); ++i) input.current.value[i] += little[i] - answer[i];
  const Propagated forecast = outlook(calibrate_day(input), truth.times, input.wind);
  const std::vector<Horizontal> none(truth.ekman.size());
  EXPECT_LT(rms(forecast.wind_driven_m_s, none), 0.25 * rms(truth.ekman, none));
}

TEST(EkmanOnce, WithoutWindTheEkmanFlowOfADayIsCarriedAndNotAddedTo) {
  const UnsteadyDay day = usual_day();
  CalibrationInput input = steady_wind_input(day);
  const std::optional<VectorColumn> wind = input.wind;
  input.wind.reset();
  const Propagated forecast = outlook(calibrate_day(input), leads(1, 24), wind);
  const LevelResponses r =
      level_responses(day.form, day.truth, input.latitude, day.water_depth_m, day.depth_m);
  const Horizontal stress = wind_stress_pa({8, 3}, input.drag_law);
  for (std::size_t i = 0; i < forecast.mean_m_s.size(); ++i) {
    const std::size_t k = i % r.levels();
    const Horizontal product = day.truth.interior_m_s() * r.interior(k) + stress * r.stress(k);
    EXPECT_LT(std::abs(forecast.mean_m_s[i] - product), 0.05);
    EXPECT_EQ(forecast.wind_driven_m_s[i], Horizontal{});
  }
}

}  // namespace
}  // namespace slackwater::calibration::ekman_once_test
