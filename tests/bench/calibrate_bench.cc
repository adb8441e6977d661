// One column-day (24 hourly means x 35 levels) calibrated with covariance, and the batch evaluation
// of the steady column. Both answers are verified before any time is printed; a wrong answer ends
// with exit code 1.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "calibration/solve/calibration.h"
#include "fields/base/random.h"
#include "fields/current/kernel_dispatch.h"
#include "fields/current/stress_series.h"

namespace {

using namespace slackwater;
using namespace slackwater::calibration;

constexpr int repeats = 41;

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

bool bench_calibration(const char* name, bool with_memory) {
  SteadyParameters truth;
  truth.interior_east_m_s = 0.12;
  truth.interior_north_m_s = -0.07;
  truth.eddy_viscosity_m2_s = 0.05;
  truth.bottom_friction_m_s = 8e-4;
  truth.stress_factor = 1.1;
  const CalibrationInput input = column_day(truth, with_memory);
  const Calibration fitted = calibrate_day(input);
  const SteadyParameters found = steady_parameters(fitted);
  const auto within = [&](const char* parameter, double error) {
    const double sigma = find_parameter(fitted, parameter)->sigma;
    if (std::abs(error) <= 4.0 * sigma) return true;
    std::printf("WRONG %s: %s off by %g, sigma %g\n", name, parameter, error, sigma);
    return false;
  };
  if (!within("interior_east", found.interior_east_m_s - truth.interior_east_m_s) ||
      !within("interior_north", found.interior_north_m_s - truth.interior_north_m_s) ||
      !within("eddy_viscosity", std::log(found.eddy_viscosity_m2_s / truth.eddy_viscosity_m2_s)) ||
      !within("bottom_friction", std::log(found.bottom_friction_m_s / truth.bottom_friction_m_s)) ||
      !within("stress_factor", std::log(found.stress_factor / truth.stress_factor))) {
    return false;
  }
  std::vector<double> ms;
  const std::clock_t cpu_from = std::clock();
  for (int i = 0; i < repeats; ++i) {
    const auto from = std::chrono::steady_clock::now();
    const Calibration again = calibrate_day(input);
    ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count());
    if (again.covariance != fitted.covariance) {
      std::printf("WRONG %s: a second run differs\n", name);
      return false;
    }
  }
  // Processor time beside wall time: on a shared machine only the former is the work's own.
  const double cpu_ms =
      1e3 * static_cast<double>(std::clock() - cpu_from) / CLOCKS_PER_SEC / repeats;
  std::sort(ms.begin(), ms.end());
  std::printf(
      "%-44s median %7.3f ms  best %7.3f ms  worst %7.3f ms  cpu %7.3f ms  (target 5 ms, %d "
      "steps)\n",
      name, ms[ms.size() / 2], ms.front(), ms.back(), cpu_ms, fitted.iterations);
  return true;
}

bool bench_evaluation() {
  constexpr std::size_t levels = 50;
  constexpr std::size_t times = 2000;
  std::vector<double> depths(levels);
  for (std::size_t k = 0; k < levels; ++k) depths[k] = static_cast<double>(k);
  const SteadyParameters parameters;
  const Angle latitude = Angle::from_degrees(54.0);
  const LevelResponses responses =
      level_responses(SteadyForm::finite_depth, parameters, latitude, 60.0, depths);
  std::vector<Horizontal> stress(times);
  for (std::size_t t = 0; t < times; ++t)
    stress[t] = std::polar(0.2, 0.01 * static_cast<double>(t));
  std::vector<Horizontal> reference(times * levels);
  evaluate_steady_on(KernelPath::baseline, responses, {0.1, 0.2}, stress, reference);
  std::vector<Horizontal> out(times * levels);
  for (const KernelPath path : supported_kernel_paths()) {
    std::vector<double> ns;
    for (int i = 0; i < repeats; ++i) {
      const auto from = std::chrono::steady_clock::now();
      evaluate_steady_on(path, responses, {0.1, 0.2}, stress, out);
      ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - from)
                       .count() /
                   static_cast<double>(times));
    }
    if (out != reference) {
      std::printf("WRONG %s: differs from the baseline\n", std::string(name_of(path)).c_str());
      return false;
    }
    std::sort(ns.begin(), ns.end());
    std::printf("steady column, 50 levels, %-18s median %7.1f ns per profile\n",
                std::string(name_of(path)).c_str(), ns[ns.size() / 2]);
  }
  std::vector<double> us;
  for (int i = 0; i < repeats; ++i) {
    const auto from = std::chrono::steady_clock::now();
    const LevelResponses again =
        level_responses(SteadyForm::finite_depth, parameters, latitude, 60.0, depths);
    us.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - from).count());
    if (again.stress_re != responses.stress_re) return false;
  }
  std::sort(us.begin(), us.end());
  std::printf("%-44s median %7.2f us\n", "responses of 50 levels (once a fit)", us[us.size() / 2]);
  return true;
}

}  // namespace

int main() {
  const bool good = bench_calibration("column-day 24 h x 35 levels, white noise", false) &&
                    bench_calibration("column-day 24 h x 35 levels, inertial misfit", true) &&
                    bench_evaluation();
  return good ? 0 : 1;
}
