// Rays at a foundation of 50 000 triangles, as a camera that circles it casts them: 2000 a look, at
// the middles of what is about the height it looks at. Before any time: the hits against going
// through all triangles, the same bits on two instruction sets, no allocation.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "fields/base/parallel.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/counted_allocations.h"
#include "tests/twin/inspection/brute_force_caster.h"
#include "tests/twin/inspection/meshes_for_tests.h"
#include "twin/inspection/cast/ray_caster.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;
using namespace slackwater::twin;

constexpr double target_million_rays_s = 5;  // on two threads
constexpr double most_range_m = 60;
constexpr std::size_t rays_of_look = 2000;
constexpr int threads = 2;
constexpr int repeats = 7;

/// A pile of 8 m, 40 m of water and 10 m of air, and the bed about it.
std::vector<TriangleMesh> foundation() {
  return {cylinder_mesh({0, 0, -10}, 4, 50, 176, 140), level_mesh({-12, -12, 40}, 1, 24, 24)};
}

std::size_t triangles_of(const std::vector<TriangleMesh>& meshes) {
  return std::accumulate(
      meshes.begin(), meshes.end(), std::size_t{0},
      [](std::size_t sum, const TriangleMesh& mesh) { return sum + mesh.triangles.size(); });
}

std::vector<Ray> rays_of_looks(std::size_t looks) {
  Rng rng(17, "bench/cast");
  std::vector<Ray> rays;
  rays.reserve(looks * rays_of_look);
  for (std::size_t look = 0; look < looks; ++look) {
    const double bearing = rng.uniform(0, 2 * constants::pi);
    const double off_m = rng.uniform(6, 16);
    const Triple<double> from{off_m * std::cos(bearing), off_m * std::sin(bearing),
                              rng.uniform(-8, 38)};
    for (std::size_t i = 0; i < rays_of_look; ++i) {
      const double round = bearing + rng.uniform(-0.9, 0.9);
      const Triple<double> at{4 * std::cos(round), 4 * std::sin(round),
                              from.z + rng.uniform(-4, 4)};
      rays.push_back({from, unit(at - from)});
    }
  }
  return rays;
}

double seconds_since(std::chrono::steady_clock::time_point from) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

/// Millions a second of work on all rays, cut into looks.
template <typename Work>
Figure rate_of(const std::string& name, std::size_t rays, int on_threads, const Work& work) {
  Figure figure;
  figure.name = name;
  figure.unit = "million rays/s";
  for (int i = 0; i < repeats; ++i) {
    const auto from = std::chrono::steady_clock::now();
    for_all(rays / rays_of_look, on_threads, work);
    figure.samples.push_back(1e-6 * static_cast<double>(rays) / seconds_since(from));
  }
  return figure;
}

void run(BenchReport& report) {
  const bool few = report.options().check_only;
  const auto meshes = foundation();
  const RayCaster caster(meshes);
  const auto rays = rays_of_looks(few ? 2 : 500);
  std::vector<std::optional<CastHit>> hits(rays.size());
  caster.first_hits(rays, most_range_m, hits);

  std::size_t wrong = 0;
  const std::size_t step = std::max<std::size_t>(1, rays.size() / (few ? 50 : 500));
  for (std::size_t i = 0; i < rays.size(); i += step)
    wrong += hits[i] == by_brute_force(meshes, rays[i], most_range_m) ? 0 : 1;
  const auto met = std::count_if(hits.begin(), hits.end(), [](const auto& h) { return !!h; });
  report.answer("hits as by going through all triangles", wrong == 0 && met > 0,
                std::to_string(met) + " of " + std::to_string(rays.size()) + " rays hit one of " +
                    std::to_string(triangles_of(meshes)) + " triangles");

  std::vector<std::optional<CastHit>> again(rays.size());
  RayCaster(meshes, "isa=sse2").first_hits(rays, most_range_m, again);
  report.answer("the same bits on SSE2 alone", again == hits, "compared to the machine's best");
  const std::size_t before = allocations();
  caster.first_hits(rays, most_range_m, again);
  report.answer("no allocation", allocations() == before, "in first_hits");
  if (few) return;

  const std::string note = std::to_string(rays.size()) + " rays at " +
                           std::to_string(triangles_of(meshes)) + " triangles, " +
                           std::to_string(rays_of_look) + " a look";
  const auto cast = [&](std::size_t look) {
    const std::size_t first = look * rays_of_look;
    caster.first_hits(std::span(rays).subspan(first, rays_of_look), most_range_m,
                      std::span(hits).subspan(first, rays_of_look));
  };
  Figure two = rate_of("first hits on 2 threads", rays.size(), threads, cast);
  two.at_least = target_million_rays_s;
  two.note = note;
  report.figure(two);
  Figure one = rate_of("first hits on 1 thread", rays.size(), 1, cast);
  one.note = note;
  report.figure(one);
  std::vector<unsigned char> blocked(rays.size());
  Figure hidden =
      rate_of("whether blocked, on 2 threads", rays.size(), threads, [&](std::size_t look) {
        for (std::size_t i = look * rays_of_look; i < (look + 1) * rays_of_look; ++i)
          blocked[i] = caster.is_blocked(rays[i], most_range_m) ? 1 : 0;
      });
  hidden.note = note;
  report.figure(hidden);
  const RayCaster narrow(meshes, "isa=sse2");
  Figure pinned =
      rate_of("first hits on 2 threads, SSE2 alone", rays.size(), threads, [&](std::size_t look) {
        const std::size_t first = look * rays_of_look;
        narrow.first_hits(std::span(rays).subspan(first, rays_of_look), most_range_m,
                          std::span(hits).subspan(first, rays_of_look));
      });
  pinned.note = note;
  report.figure(pinned);
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "cast", run); }
