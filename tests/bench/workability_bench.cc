// Sixty years of hourly history in memory, held against twenty pairs of limits and durations, with
// all figures overall, by month and by year; beside the same in vectorised numpy.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "fields/base/numbers/random.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/timed_child.h"
#include "tests/support/temporary_folder.h"
#include "twin/risk/bound.h"
#include "twin/risk/workability/workability.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

struct Pair {
  double height_m = 0;
  double wind_m_s = 0;
  std::size_t hours = 0;
};

std::vector<Pair> pairs_of(bool few) {
  std::vector<Pair> pairs;
  for (const double height_m : {1.0, 1.5, 2.0, 2.5})
    for (const std::size_t hours : {3, 8, 12, 26, 60})
      pairs.push_back({height_m, 6 + 4 * height_m, hours});
  if (few) pairs.resize(6);
  return pairs;
}

/// A sea and a wind that rise and fall over days and over the year, with gaps.
struct MadeUpHistory {
  StepClock clock;
  std::vector<double> height_m;
  std::vector<double> wind_m_s;
};

MadeUpHistory made_up_history(int years) {
  MadeUpHistory made;
  const UtcTime first = parse_utc("1960-01-01T00:00:00Z");
  const UtcTime end = std::chrono::sys_days(std::chrono::year(1960 + years) / 1 / 1);
  made.clock = {first, std::chrono::hours(1),
                static_cast<std::size_t>((end - first) / std::chrono::hours(1))};
  Rng random(60, "bench/workability");
  double slow = 0;
  double quick = 0;
  for (std::size_t i = 0; i < made.clock.steps; ++i) {
    slow = 0.985 * slow + 0.17 * random.normal();
    quick = 0.8 * quick + 0.6 * random.normal();
    const double season = std::cos(2 * 3.14159265358979 * static_cast<double>(i) / 8766);
    const bool is_gap = i % 5000 < 7 && i > 100;
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    made.height_m.push_back(is_gap ? nothing : std::exp(0.3 + 0.25 * season + 0.5 * slow));
    made.wind_m_s.push_back(is_gap ? nothing : std::abs(8 + 1.5 * season + 3 * slow + 1.2 * quick));
  }
  return made;
}

std::vector<twin::Workability> all_answers(const MadeUpHistory& made,
                                           const std::vector<twin::MonthSteps>& months,
                                           const std::vector<Pair>& pairs) {
  std::vector<twin::Workability> answers;
  twin::StepMarks marks(made.clock.steps);
  twin::StepMarks known(made.clock.steps);
  for (const Pair& pair : pairs) {
    std::fill(marks.begin(), marks.end(), 1);
    std::fill(known.begin(), known.end(), 1);
    twin::keep_within({twin::BoundSide::at_most, pair.height_m}, made.height_m, marks);
    twin::keep_within({twin::BoundSide::at_most, pair.wind_m_s}, made.wind_m_s, marks);
    twin::keep_known(made.height_m, known);
    twin::keep_known(made.wind_m_s, known);
    twin::AccessHistory history;
    history.steps = made.clock.steps;
    history.step_h = 1;
    history.windows = twin::runs_of(marks);
    history.missing = twin::outside(twin::runs_of(known), made.clock.steps);
    history.months = months;
    answers.push_back(twin::workability_of(history, {pair.hours}));
  }
  return answers;
}

/// The figures of the script, in its order.
std::vector<double> row_of(const twin::WindowStatistics& s) {
  const auto number = [](std::size_t count) { return static_cast<double>(count); };
  std::vector<double> row{number(s.steps),
                          number(s.accessible_steps),
                          number(s.workable_starts),
                          number(s.windows),
                          number(s.workable_windows),
                          number(s.longest_window_steps),
                          number(s.waiting.censored),
                          number(s.waiting.counted)};
  if (s.waiting.counted == 0) {
    row.insert(row.end(), {0, -1, -1, -1, -1});
    return row;
  }
  row.insert(row.end(), {std::round(s.waiting.mean_h * number(s.waiting.counted)), s.waiting.p10_h,
                         s.waiting.p50_h, s.waiting.p80_h, s.waiting.p90_h});
  return row;
}

nlohmann::json rows_of(const twin::Workability& found) {
  nlohmann::json rows = {row_of(found.overall)};
  for (const auto& month : found.by_month) rows.push_back(row_of(month.statistics));
  for (const auto& year : found.by_year) rows.push_back(row_of(year.statistics));
  return rows;
}

template <typename T>
void write_raw(const std::filesystem::path& file, const std::vector<T>& values) {
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(T)));
}

void write_problem(const std::filesystem::path& folder, const MadeUpHistory& made,
                   const std::vector<twin::MonthSteps>& months, const std::vector<Pair>& pairs) {
  write_raw(folder / "height.bin", made.height_m);
  write_raw(folder / "wind.bin", made.wind_m_s);
  std::vector<std::int64_t> month, year;
  for (const twin::MonthSteps& one : months) {
    month.insert(month.end(), one.steps.steps(), one.month);
    year.insert(year.end(), one.steps.steps(), one.year);
  }
  write_raw(folder / "month.bin", month);
  write_raw(folder / "year.bin", year);
  nlohmann::json list = nlohmann::json::array();
  for (const Pair& pair : pairs) list.push_back({pair.height_m, pair.wind_m_s, pair.hours});
  std::ofstream(folder / "pairs.json") << list.dump();
}

/// Processor seconds of numpy for all pairs, every figure compared with ours.
std::optional<double> run_numpy(BenchReport& report, const MadeUpHistory& made,
                                const std::vector<twin::MonthSteps>& months,
                                const std::vector<Pair>& pairs,
                                const std::vector<twin::Workability>& ours) {
  const char* name = "the same in numpy";
  constexpr const char* python = "/usr/bin/python3";
  if (timed_child({python, "-c", "import numpy"}).exit_code != 0) {
    report.skipped(name, std::string(python) + " has no numpy; install python3-scipy");
    return std::nullopt;
  }
  const tests::TemporaryFolder folder;
  write_problem(folder.path(), made, months, pairs);
  const char* repeats = report.options().check_only ? "1" : "5";
  const ChildCost child = timed_child({"env", "OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1", python,
                                       SLACKWATER_BENCH_SOURCE "/numpy_workability.py",
                                       folder.path().string(), repeats});
  if (child.exit_code != 0) {
    report.answer(name, false, child.out);
    return std::nullopt;
  }
  const nlohmann::json answer = nlohmann::json::parse(child.out);
  std::size_t figures = 0;
  std::size_t different = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const nlohmann::json rows = rows_of(ours[p]);
    const nlohmann::json& theirs = answer.at("answers").at(p);
    different += rows.size() == theirs.size() ? 0 : 1;
    for (std::size_t r = 0; r < std::min(rows.size(), theirs.size()); ++r) {
      for (std::size_t f = 0; f < rows[r].size(); ++f) {
        ++figures;
        different += rows[r][f].get<double>() == theirs[r].at(f).get<double>() ? 0 : 1;
      }
    }
  }
  char text[120];
  std::snprintf(text, sizeof text, "%zu figures of %zu pairs, %zu different", figures, pairs.size(),
                different);
  report.answer(name, different == 0, text);
  return answer.at("seconds").get<double>();
}

void run(BenchReport& report) {
  const bool check_only = report.options().check_only;
  const MadeUpHistory made = made_up_history(check_only ? 6 : 60);
  const std::vector<Pair> pairs = pairs_of(check_only);
  const std::vector<twin::MonthSteps> months = twin::months_of(made.clock, std::nullopt);
  const std::vector<twin::Workability> answers = all_answers(made, months, pairs);
  const twin::WindowStatistics& one = answers.front().overall;
  char text[160];
  std::snprintf(text, sizeof text, "%zu hours; of the first pair %.3f accessible, %.3f workable",
                one.steps, one.accessibility(), one.workability());
  report.answer("limits are now kept and now exceeded",
                one.accessibility() > 0.1 && one.accessibility() < 0.9 &&
                    one.workability() < one.accessibility(),
                text);
  const std::optional<double> numpy_s = run_numpy(report, made, months, pairs, answers);
  if (check_only) return;
  std::vector<double> seconds;
  std::size_t checksum = 0;
  for (int i = 0; i < 9; ++i) {
    const std::clock_t from = std::clock();
    // The months are worked out anew: they are part of the question.
    for (const twin::Workability& found :
         all_answers(made, twin::months_of(made.clock, std::nullopt), pairs))
      checksum += found.overall.workable_starts;
    seconds.push_back(static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC);
  }
  report.figure({"60 years of hours, 20 limit/duration pairs, one core", "s", seconds, 0.2,
                 "checksum " + std::to_string(checksum)});
  if (!numpy_s) return;
  Figure ratio{"numpy over ours", "x", {*numpy_s / median_of(seconds)}, {}, ""};
  ratio.at_least = 5;
  report.figure(ratio);
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "workability", run); }
