#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "calibration/solve/parameter_set.h"
#include "fields/current/coriolis.h"
#include "tests/bench/timed_child.h"
#include "tests/bench/unsteady_calibration.h"
#include "tests/bench/unsteady_day.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::bench {
namespace {

using namespace calibration;

constexpr const char* python = "/usr/bin/python3";
constexpr double same_cost = 1e-3;
constexpr double at_least_as_fast = 10;

nlohmann::json json_of(const DayProblem& problem, const std::vector<double>& start, int repeats) {
  const ColumnDay& day = problem.day;
  nlohmann::json out = {
      {"coriolis_rad_s", coriolis_parameter_rad_s(day.latitude)},
      {"water_depth_m", day.water_depth_m},
      {"depth_m", day.depth_m},
      {"hourly_first_h", hours_between(day.start, day.hourly.first)},
      {"sigma_m_s", problem.sigma_m_s},
      {"start", start},
      {"repeats", repeats},
  };
  for (const TimeCell& cell : day.time) {
    out["cell_start_h"].push_back(hours_between(day.start, cell.start));
    out["cell_end_h"].push_back(hours_between(day.start, cell.end));
  }
  const auto put = [&](const char* name, const char* unit, Horizontal value) {
    out[std::string(name) + "east_" + unit].push_back(value.real());
    out[std::string(name) + "north_" + unit].push_back(value.imag());
  };
  for (const Horizontal& stress : day.stress_pa) put("stress_", "pa", stress);
  for (const Horizontal& stress : day.hourly.stress_pa) put("hourly_", "pa", stress);
  for (const Pair& pair : problem.pairs) put("", "m_s", pair.observed_m_s);
  for (const Parameter& p : problem.parameters) {
    out["prior"].push_back(estimated(p, p.prior));
    out["prior_sigma"].push_back(p.prior_sigma);
    out["lower"].push_back(estimated(p, p.lower));
    out["upper"].push_back(estimated(p, p.upper));
  }
  return out;
}

struct Ours {
  DayMinimum minimum;
  std::vector<double> ms;
};

/// The problem set up and solved anew each time. Processor time on both sides: what else the
/// machine does would decide a ratio of wall times.
Ours solve_ours(const DayProblem& problem, const std::vector<double>& start, int repeats) {
  Ours ours;
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t from = std::clock();
    DayFit fit(problem);
    ours.minimum = fit.minimise(start, problem.sigma_m_s, 1.0, DayFit::Precision::full);
    ours.ms.push_back(1e3 * static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC);
  }
  return ours;
}

}  // namespace

void bench_against_scipy(BenchReport& report) {
  const char* name = "the same least squares in scipy";
  if (timed_child({python, "-c", "import scipy.optimize"}).exit_code != 0) {
    report.skipped(name, std::string(python) + " has no scipy; install python3-scipy");
    return;
  }
  const UnsteadyDay day = unsteady_day(1);
  const DayProblem problem = plain_problem(day);
  std::vector<double> start;
  for (const Parameter& p : problem.parameters) start.push_back(estimated(p, p.prior));
  const bool check_only = report.options().check_only;
  const tests::TemporaryFolder folder;
  const std::string file = (folder / "problem.json").string();
  std::ofstream(file) << json_of(problem, start, check_only ? 1 : 5);
  const Ours ours = solve_ours(problem, start, check_only ? 1 : 51);
  // One core for both: numpy's linear algebra would take all.
  const ChildCost child = timed_child({"env", "OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1", python,
                                       SLACKWATER_BENCH_SOURCE "/scipy_calibration.py", file});
  if (child.exit_code != 0) {
    report.answer(name, false, child.out);
    return;
  }
  const nlohmann::json scipy = nlohmann::json::parse(child.out);
  bool right = scipy["jacobian_error"].get<double>() < 1e-5;
  char text[240];
  std::snprintf(text, sizeof text, "cost %.6f here (%d steps)", ours.minimum.cost,
                ours.minimum.iterations);
  std::string found = text;
  for (const char* kind : {"two_point", "analytic"}) {
    const double cost = scipy[kind]["cost"];
    right = right && std::abs(cost - ours.minimum.cost) < same_cost * ours.minimum.cost;
    std::snprintf(text, sizeof text, ", %.6f %s (%d evaluations)", cost, kind,
                  scipy[kind]["nfev"].get<int>());
    found += text;
  }
  report.answer(name, right, found);
  if (!right) return;
  const double ours_ms = median_of(ours.ms);
  report.figure(
      {"the minimum alone, plain squares, processor time", "ms", ours.ms, std::nullopt, ""});
  for (const char* kind : {"two_point", "analytic"}) {
    const double scipy_ms = 1e3 * scipy[kind]["seconds"].get<double>();
    const std::string label = std::string("  scipy, ") + kind;
    report.figure({label, "ms", {scipy_ms}, std::nullopt, ""});
    // The target is for scipy as it comes: with differences.
    Figure ratio{label + " over ours", "x", {scipy_ms / ours_ms}, std::nullopt, ""};
    if (std::string(kind) == "two_point") ratio.at_least = at_least_as_fast;
    report.figure(ratio);
  }
}

}  // namespace slackwater::bench
