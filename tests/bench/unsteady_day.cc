#include "tests/bench/unsteady_day.h"

#include <cmath>

#include "calibration/residuals/column_rows.h"
#include "calibration/solve/parameter_set.h"
#include "fields/base/numbers/random.h"

namespace slackwater::bench {
namespace {

using namespace calibration;

constexpr double noise_m_s = 0.02;
constexpr int levels = 35;

const UtcTime& start_of_day() {
  static const UtcTime start = parse_utc("2024-03-10T00:00:00Z");
  return start;
}

/// Fresh to strong, veering, with weather at two time scales.
VectorColumn stormy_wind(double phase) {
  VectorColumn wind;
  for (int h = -76; h <= 25; ++h) {
    const double speed_m_s =
        9.0 + 4.0 * std::sin(0.13 * h + phase) + 2.0 * std::sin(0.35 * h + 2 * phase);
    wind.time.push_back(TimeCell::instant(add_hours(start_of_day(), h)));
    wind.value.push_back(vector_from_direction(speed_m_s, 240.0 + 3.0 * h));
    wind.status.push_back(SampleStatus::ok);
  }
  return wind;
}

ColumnDay column_day(const CalibrationInput& input) {
  ColumnDay day;
  day.layout.form = *input.form;
  day.layout.is_unsteady = true;
  day.latitude = input.latitude;
  day.water_depth_m = input.water_depth_m;
  day.depth_m = input.current.levels_m;
  day.time = input.current.time;
  day.start = start_of_day();
  const StressSeries stress(*input.wind, input.drag_law);
  for (const TimeCell& cell : day.time) day.stress_pa.push_back(*stress.over(cell));
  day.hourly = HourlyStress::sample(stress, day.start, stress_history_h, 24.0);
  return day;
}

std::vector<double> drawn_truth(Rng& random) {
  const auto about = [&](double centre, double spread) {
    return centre + spread * random.normal();
  };
  std::vector<double> truth = {about(0.12, 0.05), about(-0.07, 0.05), about(std::log(0.02), 0.1),
                               about(std::log(8e-4), 0.2), about(std::log(1.1), 0.1)};
  for (const double centre : {0.03, -0.02, 0.05, 0.04}) truth.push_back(about(centre, 0.02));
  return truth;
}

}  // namespace

UnsteadyDay unsteady_day(std::uint64_t seed) {
  UnsteadyDay out;
  CalibrationInput& input = out.input;
  Rng random(seed, "bench/unsteady_day");
  input.latitude = Angle::from_degrees(54.0);
  input.water_depth_m = 150.0;
  input.form = SteadyForm::finite_depth;
  input.is_unsteady = true;
  input.observation_sigma_m_s = noise_m_s;
  input.wind = stormy_wind(random.normal());
  VectorColumn& current = input.current;
  current.vertical = VerticalKind::depth_m;
  for (int k = 0; k < levels; ++k)
    current.levels_m.push_back(0.5 + 147.0 * std::pow(k / (levels - 1.0), 1.5));
  for (int h = 0; h < 24; ++h) {
    current.time.push_back({add_hours(start_of_day(), h), add_hours(start_of_day(), h + 1)});
    current.source.push_back(DataStatus::analysis);
  }
  out.truth = drawn_truth(random);
  ColumnRows rows(column_day(input));
  rows.evaluate(out.truth.data(), false);
  for (Eigen::Index i = 0; i < rows.model().size(); ++i) {
    const double east = noise_m_s * random.normal();
    current.value.push_back(rows.model().data()[i] + Horizontal(east, noise_m_s * random.normal()));
    current.status.push_back(SampleStatus::ok);
  }
  return out;
}

DayProblem plain_problem(const UnsteadyDay& day) {
  DayProblem problem;
  problem.day = column_day(day.input);
  const VectorColumn& current = day.input.current;
  for (std::size_t t = 0; t < current.times(); ++t) {
    for (std::size_t k = 0; k < current.levels(); ++k)
      problem.pairs.push_back({current.value[current.offset(t, k)], t, k});
  }
  problem.parameters = prior_parameters(problem.day.layout, day.input.water_depth_m, {});
  problem.sigma_m_s = noise_m_s;
  problem.loss = Loss::plain;
  return problem;
}

}  // namespace slackwater::bench
