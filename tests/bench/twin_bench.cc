// A vehicle-step in waves and current, and a thousand vehicles in one sea.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "tests/bench/bench_report.h"
#include "tests/support/shared_data.h"
#include "twin/environment/made_up_field.h"
#include "twin/run/run_log.h"
#include "twin/run/set_up.h"

using namespace slackwater;
using namespace slackwater::bench;
using namespace slackwater::twin;

namespace {

struct Kind {
  const char* model;
  std::size_t count;
  double north_m;  ///< of the first
  double down_m;
};

/// Vehicles of some kinds on parallel lines eastwards, in a sheared current, wind and waves of 1 m.
Scenario fleet(std::span<const Kind> kinds, double step_s, double duration_s,
               std::size_t components, bool has_tether = false) {
  Scenario s;
  s.name = "fleet";
  s.seed = 7;
  s.step_s = step_s;
  s.duration_s = duration_s;
  s.origin = GeoPoint::from_degrees(54, 6.6);
  s.has_origin = true;
  MadeUpWater water;
  water.depth_m = 60;
  water.current = {{0, 0.3, 0.1}, {40, 0.1, 0.0}};
  water.wind_speed_m_s = 6;
  water.wind_from_deg = 270;
  s.water = water;
  s.waves.from_forecast = false;
  s.waves.made_up.partitions = {{1, 6, 270, {}, 10}};
  s.waves.components = components;
  for (const Kind& kind : kinds) {
    for (std::size_t i = 0; i < kind.count; ++i) {
      ScenarioVehicle v;
      v.name = std::string(kind.model) + std::to_string(i);
      v.model = kind.model;
      v.start_m = {kind.north_m + 3.0 * static_cast<double>(i), 0, kind.down_m};
      v.heading_rad = constants::pi / 2;
      ScenarioTask task;
      task.waypoints = {{{v.start_m.x, 10e3, kind.down_m}, 0}};
      v.tasks = {task};
      if (has_tether)
        v.tether = ScenarioVehicle::TetherStart{Triple<double>{v.start_m.x, 0, 0}, 50};
      s.vehicles.push_back(v);
    }
  }
  return s;
}

/// A run of a scenario with its log each second. What the log holds is the answer.
struct Made {
  RunLog log;
  std::size_t steps = 0;
  double wall_s = 0;
};
Made made(const Scenario& scenario, bool is_batch, std::size_t threads) {
  Surround surround;
  surround.site = scenario.origin;
  surround.data_folder = tests::source_folder() / "data";
  const UtcTime from = parse_utc("2025-06-02T06:00:00Z");
  surround.field =
      made_up_field(std::get<MadeUpWater>(scenario.water), scenario.origin, from,
                    from + Duration(static_cast<Duration::rep>(scenario.duration_s * 1000) + 1000));
  ReadyRun ready = set_up(scenario, surround);
  RunSettings settings;
  settings.seed = scenario.seed;
  settings.step_s = scenario.step_s;
  settings.is_batch = is_batch;
  settings.threads = threads;
  Run run(std::move(ready.agents), std::move(ready.states), settings);
  const auto steps = static_cast<std::size_t>(std::llround(scenario.duration_s / scenario.step_s));
  const auto every = static_cast<std::size_t>(std::llround(1 / scenario.step_s));
  Made out;
  out.log.reserve(run.agents().size(), steps / every + 1);
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 1; i <= steps; ++i) {
    run.step();
    if (i % every == 0) out.log.append(run.time_s(), run.agents(), run.states());
  }
  out.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const Agent& agent : run.agents()) out.steps += agent.steps_per_barrier * steps;
  return out;
}

/// That all went on and went east as fast as they were to.
bool is_under_way(const Made& run, double least_m) {
  for (std::size_t i = 0; i < run.log.rows.size(); ++i) {
    const std::vector<double> x = run.log.column(i, "x");
    if (run.log.column(i, "halt").back() != 0 || !(x.back() > least_m)) return false;
  }
  return true;
}

/// A kind of vehicle and what its step is to cost at most.
struct StepCase {
  const char* model;
  double step_s;
  double down_m;
  std::size_t components;
  bool has_tether = false;
  std::optional<double> most_batch_ns{};
  std::optional<double> most_single_ns{};

  [[nodiscard]] std::string name() const {
    return std::string(model) + ", " + std::to_string(components) + " waves" +
           (has_tether ? ", tether" : "");
  }
};
// A million steps a second in batch, a quarter of a million singly.
constexpr std::array cases{
    StepCase{"bluerov2_heavy", 0.02, 10, 64, false, 1000, 4000},
    StepCase{"bluerov2_heavy", 0.02, 10, 200, true},
    StepCase{"lrauv_tethys", 0.1, 10, 64},
    StepCase{"x500", 0.004, -30, 64},
    StepCase{"wamv16", 0.05, 0, 64},
    StepCase{"ctv24", 0.1, 0, 64},
};

/// Bits, since what is missing is no number, which equals nothing.
bool has_same_bits(const twin::RunLog& a, const twin::RunLog& b) {
  return std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(),
                    [](const std::vector<double>& x, const std::vector<double>& y) {
                      return x.size() == y.size() &&
                             std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
                    });
}

void bench_step(BenchReport& report, const StepCase& c) {
  const auto of = [&](std::size_t vehicles, double seconds) {
    const std::array kinds{Kind{c.model, vehicles, 0, c.down_m}};
    // A barrier each step, but for those of a few milliseconds: a log row falls on a barrier.
    return fleet(kinds, c.step_s, seconds, c.components, c.has_tether);
  };
  const Made by_eight = made(of(8, 20), true, 1);
  const Made by_one = made(of(8, 20), false, 1);
  const bool same = has_same_bits(by_eight.log, by_one.log);
  report.answer(c.name(), same && is_under_way(by_eight, 0.5),
                same ? "the same bits by eight and one by one" : "other bits by eight");
  if (!same || report.options().check_only) return;
  const double seconds = std::max(1.0, std::round(2000 * c.step_s));
  std::vector<double> batch_ns, single_ns;
  for (int i = 0; i < 5; ++i) {
    const auto per_step = [](const Made& run) {
      return 1e9 * run.wall_s / static_cast<double>(run.steps);
    };
    batch_ns.push_back(per_step(made(of(64, seconds), true, 1)));
    single_ns.push_back(per_step(made(of(8, seconds), false, 1)));
  }
  report.figure({c.name() + ", step in batch", "ns", batch_ns, c.most_batch_ns, "one core"});
  report.figure({c.name() + ", step singly", "ns", single_ns, c.most_single_ns, "one core"});
}

/// LOTUSim steps about 750 vehicles at the pace of the clock.
void bench_thousand(BenchReport& report) {
  const std::size_t tenth = report.options().check_only ? 10 : 1;
  const std::array kinds{
      Kind{"lrauv_tethys", 400 / tenth, 0, 10}, Kind{"wamv16", 300 / tenth, 2000, 0},
      Kind{"bluerov2_heavy", 200 / tenth, 4000, 10}, Kind{"x500", 100 / tenth, 6000, -30}};
  const Scenario scenario = fleet(kinds, 0.1, 20, 64);
  const Made run = made(scenario, true, 2);
  report.answer("a thousand vehicles", is_under_way(run, 0.5),
                std::to_string(run.log.rows.size()) + " vehicles under way");
  if (report.options().check_only) return;
  std::vector<double> factor;
  for (int i = 0; i < 3; ++i)
    factor.push_back(scenario.duration_s / made(scenario, true, 2).wall_s);
  report.figure({"400 AUV, 300 USV, 200 ROV, 100 UAV on 2 threads", "x real time", factor,
                 std::nullopt, "LOTUSim: about 750 vehicles at 1", 20.0});
}

}  // namespace

int main(int argc, char** argv) {
  BenchReport report(bench_options(argc, argv));
  try {
    for (const StepCase& c : cases) bench_step(report, c);
    bench_thousand(report);
  } catch (const std::exception& problem) {
    report.answer("twin", false, problem.what());
  }
  return report.exit_code();
}
