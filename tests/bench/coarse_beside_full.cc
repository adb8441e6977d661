#include "tests/bench/coarse_beside_full.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/support/shared_data.h"
#include "twin/control/patterns.h"
#include "twin/environment/made_up_field.h"
#include "twin/run/run.h"
#include "twin/tether/node_load.h"

namespace slackwater::bench {

using namespace twin;

namespace {

constexpr double water_depth_m = 40;
constexpr Triple<double> winch_m{-22, 0, 0};

UtcTime begin() { return parse_utc("2025-06-02T06:00:00Z"); }

/// What is asked of a rehearsal.
struct Figures {
  double mean_n = 0;  ///< at the top
  double high_n = 0;  ///< one in a hundred is higher
  double most_n = 0;
  double bow_m = 0;    ///< farthest node from the chord, in the mean
  double reach_m = 0;  ///< farthest node from the winch over ground, in the mean
  double off_m = 0;    ///< of the vehicle from its way, in the mean
  double energy_j = 0;
  bool has_halted = false;
};

Figures figures_of(const TetherCase& c, StepDetail detail, double duration_s) {
  const Scenario scenario = tether_scenario(c, detail, 11, duration_s);
  ReadyRun ready = set_up(scenario, tether_surround(scenario));
  RunSettings settings;
  settings.seed = 7;
  settings.step_s = tether_step_s;
  Run run(std::move(ready.agents), std::move(ready.states), settings);
  constexpr double settling_s = 30;
  Figures out;
  double before_j = 0;
  double count = 0;
  std::vector<double> tensions_n;
  while (run.time_s() < duration_s) {
    run.step();
    const AgentState& state = run.states()[0];
    if (run.time_s() < settling_s) {
      before_j = state.vehicle.drawn_j;
      continue;
    }
    const Triple<double> chord = direction_of(state.vehicle.body.position_m - winch_m);
    double bow_m = 0, reach_m = 0;
    for (const Triple<double>& node_m : state.tether.node_m) {
      const Triple<double> from_m = node_m - winch_m;
      bow_m = std::max(bow_m, length_of(from_m - dot(from_m, chord) * chord));
      reach_m = std::max(reach_m, std::hypot(from_m.x, from_m.y));
    }
    out.mean_n += state.tether.tension_n[0];
    tensions_n.push_back(state.tether.tension_n[0]);
    out.bow_m += bow_m;
    out.reach_m += reach_m;
    out.off_m += std::abs(track_error(state.mission, state.vehicle.body.position_m).across_m);
    count += 1;
  }
  for (double* mean : {&out.mean_n, &out.bow_m, &out.reach_m, &out.off_m}) *mean /= count;
  std::sort(tensions_n.begin(), tensions_n.end());
  out.high_n = tensions_n[tensions_n.size() * 99 / 100];
  out.most_n = tensions_n.back();
  const AgentState& end = run.states()[0];
  out.energy_j = end.vehicle.drawn_j - before_j;
  out.has_halted = end.halt != Halt::none || end.tether.whole < 0.5;
  return out;
}

std::vector<TetherCase> range_of_missions(bool is_short) {
  struct Sea {
    double height_m, period_s;
  };
  struct Line {
    double tether_m, depth_m;
  };
  constexpr std::array seas{Sea{0, 6}, Sea{0.5, 4}, Sea{1.5, 4}, Sea{1.5, 6}, Sea{1.5, 10}};
  constexpr std::array lines{Line{40, 5}, Line{80, 15}, Line{120, 30}, Line{150, 20}};
  std::vector<TetherCase> cases;
  for (const double u : {0.0, 0.3, 0.8})
    for (const Sea& sea : seas)
      for (const Line& line : lines)
        cases.push_back({u, sea.height_m, sea.period_s, line.tether_m, line.depth_m});
  if (!is_short) return cases;
  return {cases[8], cases[24], cases[29], cases[38], cases[48], cases[53]};
}

/// The largest of the differences of one kind and where it was.
struct Worst {
  explicit Worst(const char* of) : what(of) {}
  const char* what;
  double percent = 0;
  std::string where;
  void take(double found, double expected, double least, const std::string& name) {
    const double by = 100 * std::abs(found - expected) / std::max(std::abs(expected), least);
    if (by < percent) return;
    percent = by;
    where = name;
  }
  [[nodiscard]] std::string text() const {
    char text[200];
    std::snprintf(text, sizeof text, "%s %.1f %% (%s)", what, percent, where.c_str());
    return text;
  }
};

}  // namespace

std::string TetherCase::name() const {
  char text[120];
  std::snprintf(text, sizeof text, "%.1f m/s, Hs %.1f m, Tp %2.0f s, %3.0f m in %2.0f m",
                surface_m_s, height_m, period_s, tether_m, depth_m);
  return text;
}

Scenario tether_scenario(const TetherCase& c, StepDetail detail, std::uint64_t seed,
                         double duration_s) {
  Scenario s;
  s.name = "rehearsal";
  s.seed = seed;
  s.step_s = tether_step_s;
  s.duration_s = duration_s;
  s.origin = GeoPoint::from_degrees(54, 6.6);
  s.has_origin = true;
  MadeUpWater water;
  water.depth_m = water_depth_m;
  const double u = c.surface_m_s;
  water.current = {{0, u, 0.1 * u}, {15, 0.7 * u, 0}, {40, 0.2 * u, 0}};
  s.water = water;
  s.waves.from_forecast = false;
  if (c.height_m > 0) s.waves.made_up.partitions = {{c.height_m, c.period_s, 270, {}, 10}};
  ScenarioStructure pile;
  pile.name = "pile";
  pile.diameter_m = 6;
  pile.top_m = -20;
  pile.bottom_m = water_depth_m;
  pile.turns_current = true;
  s.structures = {pile};
  ScenarioVehicle rov;
  rov.name = "rov";
  rov.model = "bluerov2_heavy";
  rov.start_m = {-9, 0, c.depth_m};
  rov.speed_m_s = 0.2;
  rov.detail = detail;
  ScenarioTask task;
  task.waypoints = orbit({0, 0, c.depth_m}, 8, constants::pi, 40, c.depth_m, 3, 0);
  rov.tasks = {task};
  if (c.tether_m > 0) rov.tether = {{winch_m, c.tether_m}};
  s.vehicles = {rov};
  return s;
}

Surround tether_surround(const Scenario& scenario) {
  Surround surround;
  surround.site = scenario.origin;
  surround.data_folder = tests::source_folder() / "data";
  surround.field = made_up_field(std::get<MadeUpWater>(scenario.water), scenario.origin, begin(),
                                 begin() + std::chrono::hours(2));
  return surround;
}

void check_coarse_beside_full(BenchReport& report) {
  const bool is_short = report.options().check_only;
  Worst tension{"mean tension"}, bow{"bow"}, reach{"reach"}, off{"off the way"}, energy{"energy"},
      high{"tension of one step in a hundred"};
  bool same_fate = true, no_snap = true;
  if (!is_short && !report.options().json)
    std::printf("%-46s %8s %8s %8s %8s %8s %8s %8s\n", "full step, and the coarse one beside it",
                "mean N", "1 % N", "most N", "bow m", "reach m", "off m", "kJ");
  for (const TetherCase& c : range_of_missions(is_short)) {
    const Figures full = figures_of(c, StepDetail::full, 300);
    const Figures coarse = figures_of(c, StepDetail::coarse, 300);
    const std::string name = c.name();
    tension.take(coarse.mean_n, full.mean_n, 1, name);
    high.take(coarse.high_n, full.high_n, 5, name);
    no_snap = no_snap && coarse.most_n < 2 * full.most_n + 20;
    // Slack line in still water lies where chance has put it.
    if (c.surface_m_s > 0) {
      bow.take(coarse.bow_m, full.bow_m, 1, name);
      reach.take(coarse.reach_m, full.reach_m, 1, name);
    }
    off.take(coarse.off_m, full.off_m, 1, name);
    energy.take(coarse.energy_j, full.energy_j, 1, name);
    same_fate = same_fate && !full.has_halted && !coarse.has_halted;
    if (is_short || report.options().json) continue;
    const auto row = [](const std::string& head, const Figures& f) {
      std::printf("%-46s %8.2f %8.2f %8.1f %8.2f %8.2f %8.3f %8.2f\n", head.c_str(), f.mean_n,
                  f.high_n, f.most_n, f.bow_m, f.reach_m, f.off_m, f.energy_j / 1000);
    };
    row(name, full);
    row("", coarse);
  }
  for (const Worst* worst : {&tension, &bow, &reach, &off, &energy})
    report.answer("coarse beside full, at most 2 %", worst->percent <= 2, worst->text());
  report.answer("coarse beside full, at most 10 %", high.percent <= 10, high.text());
  report.answer("no tug is twice as hard", no_snap, no_snap ? "none" : "one is");
  report.answer("no tether parts, no vehicle halts", same_fate, same_fate ? "none" : "one did");
}

}  // namespace slackwater::bench
