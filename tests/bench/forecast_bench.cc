// The whole `slackwater forecast` command with four days of hourly data in the store: read,
// calibrate, propagate, publish, write CF. Its answer is held against the known truth of the
// synthetic ocean before it is timed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "fields/service/snapshot.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/synthetic_store.h"
#include "tests/bench/timed_child.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr int repeats = 7;
constexpr double target_s = 2.0;
constexpr std::size_t stamps_of_72_hours = 73;

/// Root mean square error over the first day and all wet levels: of the forecast, and of holding
/// the true current of the end of D, which is the best that persistence can do. NaN where a served
/// value is not finite.
struct FirstDay {
  double error_m_s = 0;
  double persistence_m_s = 0;
  std::size_t values = 0;
};

FirstDay score(const SyntheticStore& synthetic, const Snapshot& snapshot) {
  FirstDay day;
  const ForecastColumn& column = snapshot.columns.front();
  const std::size_t levels = snapshot.depth_m.size();
  for (std::size_t t = 1; t <= 24; ++t) {
    for (std::size_t k = 0; k < levels; ++k) {
      if (!has_value(column.current_status[t * levels + k])) continue;
      const auto truth =
          synthetic.ocean().current_truth(column.point, snapshot.depth_m[k], snapshot.time[t]);
      const auto held =
          synthetic.ocean().current_truth(column.point, snapshot.depth_m[k], snapshot.time.front());
      if (!truth || !held) continue;
      day.error_m_s += std::norm(column.current_m_s[t * levels + k] - *truth);
      day.persistence_m_s += std::norm(*held - *truth);
      ++day.values;
    }
  }
  const double n = std::max<double>(1, static_cast<double>(day.values));
  day.error_m_s = std::sqrt(day.error_m_s / n);
  day.persistence_m_s = std::sqrt(day.persistence_m_s / n);
  return day;
}

void run(BenchReport& report) {
  const SyntheticStore synthetic;
  const std::filesystem::path out = synthetic.file("forecast.nc");
  std::vector<double> wall_s;
  std::vector<double> cpu_s;
  const int runs = report.options().check_only ? 1 : repeats;
  for (int i = 0; i < runs; ++i) {
    const std::filesystem::path store = synthetic.copy_of_store("timed");
    const ChildCost cost = slackwater_or_throw(synthetic.forecast_arguments(store, out));
    wall_s.push_back(cost.wall_s);
    cpu_s.push_back(cost.cpu_s);
    const Snapshot snapshot = ingest::read_forecast(out);
    const FirstDay day = score(synthetic, snapshot);
    char text[160];
    std::snprintf(
        text, sizeof text,
        "%zu stamps x %zu levels, day 1 off the truth by %.3f m/s, persistence by %.3f m/s",
        snapshot.time.size(), snapshot.depth_m.size(), day.error_m_s, day.persistence_m_s);
    // At a tidal site a forecast worth the name leaves less than two thirds of what persistence
    // leaves.
    const bool right = snapshot.time.size() == stamps_of_72_hours && day.values >= 24 * 5 &&
                       day.error_m_s < day.persistence_m_s * 2 / 3;
    if (i == 0 || !right) report.answer("forecast", right, text);
    if (!right) return;
  }
  report.figure({"slackwater forecast, four days of hourly data", "s", wall_s, target_s, ""});
  report.figure({"  its processor time", "s", cpu_s, std::nullopt, ""});
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "forecast", run); }
