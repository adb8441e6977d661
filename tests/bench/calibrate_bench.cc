// One column-day (24 hourly means x 35 levels) calibrated with covariance, steady and unsteady; the
// same least squares in scipy; a thousand columns; and the responses of the steady column.
// All answers are verified before any time is printed; a wrong answer ends with exit code 1.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "calibration/solve/calibration.h"
#include "fields/base/numbers/random.h"
#include "fields/current/steady_column.h"
#include "fields/current/stress_series.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/unsteady_calibration.h"

namespace {

using namespace slackwater;
using namespace slackwater::calibration;
using namespace slackwater::bench;

constexpr int repeats = 41;
constexpr double target_ms = 5;

CalibrationInput column_day(const SteadyParameters& truth, bool with_memory) {
  CalibrationInput input;
  input.latitude = Angle::from_degrees(54.0);
  input.water_depth_m = 90.0;
  const UtcTime start = parse_utc("2024-03-01T00:00:00Z");
  VectorColumn wind;
  for (int h = -3; h <= 27; ++h) {
    wind.time.push_back(TimeCell::instant(add_hours(start, h)));
    wind.value.push_back(vector_from_direction(9.0 + 4.0 * std::sin(0.35 * h), 240.0 + 5.0 * h));
    wind.status.push_back(SampleStatus::ok);
  }
  VectorColumn& current = input.current;
  current.vertical = VerticalKind::depth_m;
  for (int k = 0; k < 35; ++k) current.levels_m.push_back(0.5 + 88.0 * std::pow(k / 34.0, 1.5));
  const StressSeries stress(wind, DragLaw::paper_linear);
  const LevelResponses responses = level_responses(SteadyForm::finite_depth, truth, input.latitude,
                                                   input.water_depth_m, current.levels_m);
  Rng rng(7, "bench/calibrate");
  for (int h = 0; h < 24; ++h) {
    const TimeCell cell{add_hours(start, h), add_hours(start, h + 1)};
    current.time.push_back(cell);
    current.source.push_back(DataStatus::analysis);
    for (std::size_t k = 0; k < responses.levels(); ++k) {
      const Horizontal model =
          truth.interior_m_s() * responses.interior(k) + *stress.over(cell) * responses.stress(k);
      const Horizontal inertial = with_memory ? std::polar(0.08, -0.42 * h) : Horizontal{};
      current.value.push_back(model + inertial +
                              Horizontal{0.02 * rng.normal(), 0.02 * rng.normal()});
      current.status.push_back(SampleStatus::ok);
    }
  }
  input.wind = wind;
  return input;
}

void bench_calibration(BenchReport& report, const char* name, bool with_memory) {
  SteadyParameters truth;
  truth.interior_east_m_s = 0.12;
  truth.interior_north_m_s = -0.07;
  truth.eddy_viscosity_m2_s = 0.05;
  truth.bottom_friction_m_s = 8e-4;
  truth.stress_factor = 1.1;
  const CalibrationInput input = column_day(truth, with_memory);
  const Calibration fitted = calibrate_day(input);
  const SteadyParameters found = steady_parameters(fitted);
  double worst = 0;
  const auto within = [&](const char* parameter, double error) {
    worst = std::max(worst, std::abs(error) / find_parameter(fitted, parameter)->sigma);
  };
  within("interior_east", found.interior_east_m_s - truth.interior_east_m_s);
  within("interior_north", found.interior_north_m_s - truth.interior_north_m_s);
  within("eddy_viscosity", std::log(found.eddy_viscosity_m2_s / truth.eddy_viscosity_m2_s));
  within("bottom_friction", std::log(found.bottom_friction_m_s / truth.bottom_friction_m_s));
  within("stress_factor", std::log(found.stress_factor / truth.stress_factor));
  const bool repeatable = calibrate_day(input).covariance == fitted.covariance;
  char text[160];
  std::snprintf(text, sizeof text,
                "worst of five parameters %.1f sigma off the truth, %d steps, a second run %s",
                worst, fitted.iterations, repeatable ? "equal" : "DIFFERS");
  const bool right = worst <= 4.0 && repeatable;
  report.answer(name, right, text);
  if (!right || report.options().check_only) return;
  std::vector<double> ms;
  const std::clock_t cpu_from = std::clock();
  for (int i = 0; i < repeats; ++i) {
    const auto from = std::chrono::steady_clock::now();
    const Calibration again = calibrate_day(input);
    ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count());
  }
  // Processor time beside wall time: on a shared machine only the former is the work's own.
  const double cpu_ms =
      1e3 * static_cast<double>(std::clock() - cpu_from) / CLOCKS_PER_SEC / repeats;
  report.figure({name, "ms", ms, target_ms, ""});
  report.figure({"  its processor time, mean", "ms", {cpu_ms}, std::nullopt, ""});
}

void bench_responses(BenchReport& report) {
  std::vector<double> depths(50);
  for (std::size_t k = 0; k < depths.size(); ++k) depths[k] = static_cast<double>(k);
  const SteadyParameters parameters;
  const Angle latitude = Angle::from_degrees(54.0);
  const LevelResponses responses =
      level_responses(SteadyForm::finite_depth, parameters, latitude, 60.0, depths);
  std::vector<double> us;
  for (int i = 0; i < repeats; ++i) {
    const auto from = std::chrono::steady_clock::now();
    const LevelResponses again =
        level_responses(SteadyForm::finite_depth, parameters, latitude, 60.0, depths);
    us.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - from).count());
    if (again.stress_re != responses.stress_re) report.answer("responses", false, "they differ");
  }
  report.figure({"responses of 50 levels", "us", us, std::nullopt, "once a fit"});
}

}  // namespace

int main(int argc, char** argv) {
  BenchReport report(bench_options(argc, argv));
  bench_calibration(report, "column-day 24 h x 35 levels, white noise", false);
  bench_calibration(report, "column-day 24 h x 35 levels, inertial misfit", true);
  bench_unsteady_day(report);
  bench_against_scipy(report);
  bench_thousand_columns(report);
  bench_responses(report);
  return report.exit_code();
}
