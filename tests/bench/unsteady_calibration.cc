#include "tests/bench/unsteady_calibration.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <thread>
#include <vector>

#include "calibration/solve/parameter_set.h"
#include "tests/bench/unsteady_day.h"

namespace slackwater::bench {
namespace {

using namespace calibration;
using SteadyClock = std::chrono::steady_clock;

constexpr double target_ms = 10;
constexpr double target_thousand_s = 10;
constexpr unsigned threads = 2;

double seconds_since(SteadyClock::time_point from) {
  return std::chrono::duration<double>(SteadyClock::now() - from).count();
}

double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// How many of its sigmas each parameter lies off the truth.
std::vector<double> sigmas_off(const UnsteadyDay& day, const Calibration& fitted) {
  std::vector<double> off;
  for (std::size_t i = 0; i < day.truth.size(); ++i) {
    const Parameter& p = fitted.parameters[i];
    off.push_back(std::abs(estimated(p, p.value) - day.truth[i]) / p.sigma);
  }
  return off;
}

/// Calibrates the days on some threads; per parameter of each day, how many sigmas it is off.
std::vector<std::vector<double>> calibrate_all(const std::vector<UnsteadyDay>& days) {
  std::vector<std::vector<double>> off(days.size());
  const auto work = [&](std::size_t first) {
    for (std::size_t i = first; i < days.size(); i += threads)
      off[i] = sigmas_off(days[i], calibrate_day(days[i].input));
  };
  std::vector<std::jthread> workers;
  for (unsigned t = 0; t < threads; ++t) workers.emplace_back(work, t);
  workers.clear();
  return off;
}

}  // namespace

void bench_unsteady_day(BenchReport& report) {
  const char* name = "unsteady column-day, 20 modes, 9 parameters";
  const UnsteadyDay day = unsteady_day(1);
  const Calibration fitted = calibrate_day(day.input);
  const std::vector<double> off = sigmas_off(day, fitted);
  double squares = 0;
  for (const double z : off) squares += z * z;
  const double worst = *std::max_element(off.begin(), off.end());
  const double rms = std::sqrt(squares / static_cast<double>(off.size()));
  const bool repeatable = calibrate_day(day.input).covariance == fitted.covariance;
  char text[200];
  std::snprintf(
      text, sizeof text,
      "%zu parameters %.2f sigma off the truth (rms; worst %.1f), %d steps, a second run %s",
      off.size(), rms, worst, fitted.iterations, repeatable ? "equal" : "DIFFERS");
  // Nine normal numbers: the largest passes 3.5 once in 240 draws.
  const bool right = off.size() == 9 && worst < 3.5 && rms < 1.5 && repeatable;
  report.answer(name, right, text);
  if (!right || report.options().check_only) return;
  std::vector<double> ms;
  std::vector<double> cpu_ms;
  for (int i = 0; i < 101; ++i) {
    const auto from = SteadyClock::now();
    const double cpu_from = processor_s();
    const Calibration again = calibrate_day(day.input);
    cpu_ms.push_back(1e3 * (processor_s() - cpu_from));
    ms.push_back(1e3 * seconds_since(from));
  }
  report.figure({name, "ms", ms, target_ms, ""});
  report.figure({"  its processor time", "ms", cpu_ms, std::nullopt, ""});
}

void bench_thousand_columns(BenchReport& report) {
  const std::size_t count = report.options().check_only ? 40 : 1000;
  std::vector<UnsteadyDay> days;
  for (std::size_t i = 0; i < count; ++i) days.push_back(unsteady_day(1000 + i));
  const auto from = SteadyClock::now();
  const double cpu_from = processor_s();
  const std::vector<std::vector<double>> off = calibrate_all(days);
  const double wall_s = seconds_since(from);
  const double cpu_s = processor_s() - cpu_from;
  std::size_t inside = 0;
  std::size_t all = 0;
  for (const std::vector<double>& column : off) {
    for (const double z : column) {
      ++all;
      if (z < 1.96) ++inside;
    }
  }
  const double share = static_cast<double>(inside) / static_cast<double>(all);
  // Parameters of one column are correlated: counted as one independent number a column, 99.9 %.
  const double slack = 3.3 * std::sqrt(0.95 * 0.05 / static_cast<double>(count));
  char text[160];
  std::snprintf(text, sizeof text, "95 %% intervals hold %.1f %% of the truth of %zu columns",
                100 * share, count);
  report.answer("1000 columns, 2 threads", std::abs(share - 0.95) < slack, text);
  report.figure({"1000 columns, 2 threads", "s", {wall_s}, target_thousand_s, ""});
  report.figure({"  their processor time", "s", {cpu_s}, std::nullopt, ""});
}

}  // namespace slackwater::bench
