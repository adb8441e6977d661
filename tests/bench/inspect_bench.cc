// Inspecting a monopile and its anodes with a camera in 1200 waters (24 starts, 50 members), and
// three vehicles at one pile for an hour: what coverage costs, after it has been shown to be that
// of 2000 rays a look.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include "tests/bench/bench_report.h"
#include "tests/bench/pile_mission.h"
#include "tests/bench/timed_child.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "twin/inspection/inspection.h"

using namespace slackwater;
using namespace slackwater::bench;
using namespace slackwater::twin;

namespace {

/// What the ROV looks at. @param rays  of a look; 0: as a rehearsal has it
std::string with_coverage(int rays) {
  return "agents:\n  inspector:\n    inspection:\n"
         "      surfaces:\n"
         "        - {kind: monopile, from: {depth_m: 2}, to: {above_bed_m: 1}}\n"
         "        - {kind: anodes, from: {depth_m: 4}, to: {above_bed_m: 2}}\n"
         "      looks:\n"
         "        - {instrument: rov_camera, kinds: [monopile, anodes], detail_mm: 20,\n"
         "           incidence_deg: 70, done_at: 0}\n"
         "      water: {visibility_m: 10}\n" +
         (rays > 0 ? "      rays_per_look: " + std::to_string(rays) + "\n" : std::string());
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::size_t triangles_of(const Scenario& mission) {
  const Surround ready = shared_by_flights(mission, tidal_water(mission));
  std::size_t count = 0;
  for (const Surface& surface : ready.inspections.begin()->second->surfaces)
    count += surface.mesh.triangles.size();
  return count;
}

void check_coverage(BenchReport& report) {
  Scenario few = pile_mission(with_coverage(0)), many = pile_mission(with_coverage(2000));
  few.duration_s = many.duration_s = 900;
  const Flown a = flown(few, 8, 2, 2), b = flown(few, 8, 2, 1), c = flown(many, 8, 2, 2);
  report.answer("two threads as one", a.covered == b.covered && a.rays == b.rays, "to the bit");
  double worst = 0;
  for (std::size_t i = 0; i < a.covered.size(); ++i)
    worst = std::max(worst, 100 * std::abs(a.covered[i] - c.covered[i]));
  char text[160];
  std::snprintf(text, sizeof text,
                "%.2f points at most in %zu flights, %.1f %% covered; %.3g rays instead of %.3g",
                worst, a.covered.size(), 100 * mean_of(c.covered), static_cast<double>(a.rays),
                static_cast<double>(c.rays));
  report.answer("coverage within 2 points of that with 2000 rays a look",
                worst <= 2 && !a.covered.empty() && mean_of(c.covered) > 0.02, text);
}

/// A part of the rehearsal: all 24 starts, 9 members of 50, without coverage and with it in turn.
void time_rehearsal(BenchReport& report) {
  const Scenario bare = pile_mission(), mission = pile_mission(with_coverage(0));
  constexpr std::size_t members = 9;
  std::vector<double> wall_s, ratio, rays;
  bool whole = true;
  for (int i = 0; i < 3; ++i) {
    const Flown without = flown(bare, all_starts, members, 2);
    const Flown with = flown(mission, all_starts, members, 2);
    whole = whole && with.none_broke && with.covered.size() == all_starts * members;
    const double part = with.flown_s / (hour_s * all_starts * all_members);
    wall_s.push_back(with.wall_s / part);
    ratio.push_back(with.cpu_s / without.cpu_s);
    rays.push_back(1e-6 * static_cast<double>(with.rays) / part);
  }
  report.answer("216 flights of an hour", whole, whole ? "all looked" : "one broke");
  const std::string note = std::to_string(triangles_of(mission)) + " triangles, " +
                           std::to_string(rays_per_look_of_many) + " rays a look";
  report.figure({"rays of 1200 flights of an hour", "million", rays, std::nullopt, note});
  report.figure({"1200 flights of an hour with coverage on 2 cores, from 216", "s", wall_s, 180,
                 "as `slackwater rehearse` flies them"});
  report.figure({"of what they cost without coverage", "times", ratio, std::nullopt, "CPU time"});
}

/// data/missions/three_at_one_pile.yaml, an hour of it.
std::filesystem::path an_hour_of_three(const std::filesystem::path& folder) {
  const auto missions = tests::source_folder() / "data/missions";
  std::filesystem::copy_file(missions / "made_up_traffic.csv", folder / "made_up_traffic.csv");
  std::ifstream from(missions / "three_at_one_pile.yaml");
  std::string text{std::istreambuf_iterator<char>(from), {}};
  const std::string was = "duration: 40min";
  const std::size_t at = text.find(was);
  if (at == std::string::npos)
    throw std::runtime_error("three_at_one_pile.yaml has another length");
  text.replace(at, was.size(), "duration: 1h");
  std::ofstream(folder / "three.yaml") << text;
  return folder / "three.yaml";
}

void time_showcase(BenchReport& report) {
  const tests::TemporaryFolder folder;
  const auto mission = an_hour_of_three(folder.path());
  const auto log = (folder.path() / "three.nc").string();
  std::vector<double> wall_s;
  ChildCost cost;
  for (int i = 0; i < 3; ++i) {
    cost = slackwater_or_throw({"rehearse", mission.string(), "--log", log});
    wall_s.push_back(cost.wall_s);
  }
  const std::string score = slackwater_or_throw({"score", log}).out;
  report.answer("three at one pile have inspected", score.find("m2 covered") != std::string::npos,
                "slackwater score");
  report.figure({"three at one pile, an hour with coverage", "s", wall_s, 6,
                 "flown, and its log: whole process"});
}

void run(BenchReport& report) {
  check_coverage(report);
  if (report.options().check_only || !report.all_right()) return;
  time_rehearsal(report);
  time_showcase(report);
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "inspect", run); }
