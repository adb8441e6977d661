// Rehearsing a tethered inspection of a monopile in 1200 waters (24 starts, 50 members): the coarse
// step holds the figures of the full one; then how long it takes, on the way that `slackwater
// rehearse` goes.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "api/ask/rehearse/rehearsal.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/coarse_beside_full.h"
#include "tests/bench/pile_mission.h"
#include "twin/run/run.h"

using namespace slackwater;
using namespace slackwater::bench;
using namespace slackwater::twin;

namespace {

/// That the way of a rehearsal is the coarse one, holds the energy of the full one, and does not
/// depend on the number of threads.
void check_rehearsal(BenchReport& report) {
  Scenario coarse = pile_mission();
  Scenario full = pile_mission("agents: {inspector: {detail: full}}\n");
  report.answer("a mission's tether is stepped coarsely, if it does not say full",
                coarse.vehicles[0].detail == StepDetail::coarse &&
                    full.vehicles[0].detail == StepDetail::full,
                "detail");
  coarse.duration_s = full.duration_s = 600;
  const Flown a = flown(coarse, 8, 2, 2);
  const Flown b = flown(coarse, 8, 2, 1);
  report.answer("two threads as one", a.energy_j == b.energy_j, "to the bit");
  const Flown c = flown(full, 8, 2, 2);
  double worst = 0;
  for (std::size_t i = 0; i < a.flights; ++i)
    worst = std::max(worst, 100 * std::abs(a.energy_j[i] / c.energy_j[i] - 1));
  char text[100];
  std::snprintf(text, sizeof text, "%.2f %% at most in %zu flights", worst, a.flights);
  report.answer("energy of a coarse flight beside a full one, at most 2 %", worst <= 2, text);
  report.answer("no flight broke", a.none_broke && c.none_broke, "limits and time alone end them");
}

/// A part of the rehearsal, in rounds as full as those of the whole: all 24 starts, 9 members of
/// 50.
void time_rehearsal(BenchReport& report) {
  const Scenario mission = pile_mission();
  constexpr std::size_t members = 9;
  std::vector<double> wall_s, step_us, first_s;
  bool whole = true;
  for (int i = 0; i < 3; ++i) {
    const Flown found = flown(mission, all_starts, members, 2);
    whole = whole && found.none_broke && found.flights == all_starts * members;
    const double hours = found.flown_s / hour_s;
    wall_s.push_back(found.wall_s * all_starts * all_members / hours);
    step_us.push_back(1e6 * found.cpu_s * tether_step_s / found.flown_s);
    first_s.push_back(found.first_answer_s);
  }
  report.answer("216 flights of an hour", whole, whole ? "all flown" : "one broke");
  report.figure({"first answer for 24 starts", "s", first_s, 10, "one flight of each"});
  report.figure({"a flight's step, with setting up", "us", step_us, 3.4, "of one core"});
  report.figure({"1200 flights of an hour on 2 cores, from 216", "s", wall_s, 150,
                 "as `slackwater rehearse` flies them"});
}

/// Eight in a run on one thread, without conduct: microseconds of one core, a step of a vehicle.
double bare_step_us(const TetherCase& c, StepDetail detail) {
  constexpr double duration_s = 120;
  std::vector<Agent> agents;
  std::vector<AgentState> states;
  for (std::size_t i = 0; i < block_lanes; ++i) {
    const Scenario scenario = tether_scenario(c, detail, 100 + i, duration_s);
    ReadyRun ready = set_up(scenario, tether_surround(scenario));
    agents.push_back(std::move(ready.agents[0]));
    states.push_back(std::move(ready.states[0]));
    agents.back().vehicle = agents.front().vehicle;
  }
  RunSettings settings;
  settings.seed = 7;
  settings.step_s = tether_step_s;
  Run run(std::move(agents), std::move(states), settings);
  const double before_s = cpu_seconds();
  const auto steps = std::llround(duration_s / tether_step_s);
  for (long long i = 0; i < steps; ++i) run.step();
  return 1e6 * (cpu_seconds() - before_s) / static_cast<double>(steps * block_lanes);
}

double set_up_ms(StepDetail detail) {
  Scenario mission = pile_mission();
  mission.vehicles[0].detail = detail;
  const Surround surround = tidal_water(mission);
  constexpr int times = 24;
  const double before_s = cpu_seconds();
  for (int i = 0; i < times; ++i) {
    mission.start = first_start() + std::chrono::hours(i);
    (void)set_up(mission, surround);
  }
  return 1e3 * (cpu_seconds() - before_s) / times;
}

void time_parts(BenchReport& report) {
  constexpr TetherCase usual{0.4, 1, 6, 60, 10};
  const Scenario scenario = tether_scenario(usual, StepDetail::coarse, 1, 60);
  const ReadyRun ready = set_up(scenario, tether_surround(scenario));
  const CoarsePlan plan = *ready.agents[0].coarse;
  std::printf(
      "step %g s; %zu waves, looked at each %g s; %zu segments of tether, stepped each %g s\n",
      tether_step_s, ready.environment->sea->waves().size(), plan.look_s, tether_segments,
      plan.pull_s);
  struct Part {
    const char* name;
    TetherCase water;
  };
  for (const StepDetail detail : {StepDetail::coarse, StepDetail::full}) {
    const std::string of = detail == StepDetail::coarse ? "coarse" : "full";
    for (const Part& part :
         {Part{"waves and tether", usual}, Part{"no waves", {0.4, 0, 6, 60, 10}},
          Part{"no tether", {0.4, 1, 6, 0, 10}}, Part{"neither", {0.4, 0, 6, 0, 10}}}) {
      std::vector<double> samples;
      for (int i = 0; i < 3; ++i) samples.push_back(bare_step_us(part.water, detail));
      report.figure({"vehicle step, " + of + ": " + part.name, "us", samples, std::nullopt,
                     "of one core, in a block of eight"});
    }
    std::vector<double> samples;
    for (int i = 0; i < 3; ++i) samples.push_back(set_up_ms(detail));
    report.figure({"setting up a flight, " + of, "ms", samples, std::nullopt, "of one core"});
  }
}

}  // namespace

int main(int argc, char** argv) {
  BenchReport report(bench_options(argc, argv));
  try {
    check_coarse_beside_full(report);
    check_rehearsal(report);
    if (!report.options().check_only && report.all_right()) {
      time_rehearsal(report);
      time_parts(report);
    }
  } catch (const std::exception& problem) {
    report.answer("rehearse", false, problem.what());
  }
  return report.exit_code();
}
