// What a sensor sees of 400 000 triangles, on two threads: truth, a lit picture, a turn of a lidar,
// a ping of a sonar. Before any time: the pixels against rays one by one and all triangles, the
// same bits on one thread and on SSE2 alone.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/bench_report.h"
#include "tests/twin/inspection/brute_force_caster.h"
#include "tests/twin/inspection/meshes_for_tests.h"
#include "tests/twin/render/render_for_tests.h"
#include "twin/render/frame/truth_frame.h"
#include "twin/render/lens/forward_scatter.h"
#include "twin/render/lens/picture.h"
#include "twin/render/lens/shutter.h"
#include "twin/render/light/infrared_frame.h"
#include "twin/render/light/light_frame.h"
#include "twin/render/ranging/imaging_sonar.h"
#include "twin/render/ranging/lidar.h"
#include "twin/render/ranging/side_scan.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;
using namespace slackwater::twin;

constexpr double most_range_m = 120;
constexpr int threads = 2;
constexpr int repeats = 7;

/// A pile of 8 m in 40 m of water, the bed about it, and a mark on the pile.
RenderScene foundation(bool few) {
  RenderScene scene;
  scene.surface_m = -10;
  const std::uint32_t round = few ? 60 : 500, high = few ? 30 : 360, squares = few ? 20 : 142;
  scene.things.push_back({"pile", SeenClass::monopile, Material::steel,
                          cylinder_mesh({0, 0, -10}, 4, 50, round, high)});
  scene.things.push_back({"bed", SeenClass::bed, Material::sand,
                          level_mesh({-35.5, -35.5, 40}, 71.0 / squares, squares, squares)});
  DefectMark mark;
  mark.kind = DefectKind::corrosion;
  mark.centre_m = {4, 0, 24};
  mark.normal = {1, 0, 0};
  mark.along = {0, 1, 0};
  mark.down = {0, 0, 1};
  mark.half_along_m = 0.5;
  mark.half_down_m = 0.3;
  scene.marks.push_back(mark);
  return scene;
}

std::vector<TriangleMesh> meshes_of(const RenderScene& scene) {
  std::vector<TriangleMesh> meshes;
  for (const SeenThing& thing : scene.things) meshes.push_back(thing.mesh);
  return meshes;
}

template <typename Work>
Figure rate_of(const std::string& name, const std::string& unit, double at_least,
               const std::string& note, const Work& work) {
  Figure figure;
  figure.name = name;
  figure.unit = unit;
  figure.at_least = at_least;
  figure.note = note;
  for (int i = 0; i < repeats; ++i) {
    const auto from = std::chrono::steady_clock::now();
    work();
    figure.samples.push_back(
        1 / std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count());
  }
  return figure;
}

/// Pixels that are not those of rays one by one, of every `step`-th.
std::size_t unlike(const FrameHits& hits, const Pinhole& camera, std::size_t step,
                   const std::function<std::optional<CastHit>(const Ray&)>& cast) {
  std::size_t wrong = 0;
  for (std::size_t at = 0; at < hits.pixels(); at += step) {
    const auto wide = static_cast<std::size_t>(hits.wide);
    const auto hit = cast(camera.ray(static_cast<int>(at % wide), static_cast<int>(at / wide)));
    const bool is_same = hit ? hits.is_hit(at) && hits.mesh[at] == hit->mesh &&
                                   hits.triangle[at] == hit->triangle &&
                                   hits.range_m[at] == hit->range_m
                             : !hits.is_hit(at);
    wrong += is_same ? 0 : 1;
  }
  return wrong;
}

void run(BenchReport& report) {
  const bool few = report.options().check_only;
  const RenderScene scene = foundation(few);
  const std::vector<TriangleMesh> meshes = meshes_of(scene);
  std::size_t triangles = 0;
  for (const TriangleMesh& mesh : meshes) triangles += mesh.triangles.size();
  const Pose pose = looking({10, 2, 22}, {0, 0, 25});
  const Pinhole wide(pose, few ? frame_of(128, 72, 64) : frame_of(1280, 720, 64));
  const Pinhole small(pose, few ? frame_of(64, 36, 64) : frame_of(640, 360, 64));
  const auto caster = std::make_shared<const RayCaster>(meshes);
  const RayCaster narrow(meshes, "isa=sse2");

  FrameHits hits, again;
  const TruthFrame truth = truth_of(scene, wide, most_range_m, threads, hits);
  (void)truth_of(scene, wide, most_range_m, 1, again);
  report.answer("the same bits on one thread", hits == again, "and on two");
  const std::size_t step = few ? 7 : 101;
  report.answer(
      "pixels as all triangles one by one",
      unlike(hits, wide, few ? 37 : 9973,
             [&](const Ray& ray) { return by_brute_force(meshes, ray, most_range_m); }) == 0,
      std::to_string(triangles) + " triangles");
  report.answer("pixels as rays on SSE2 alone",
                unlike(hits, wide, step,
                       [&](const Ray& ray) { return narrow.first_hit(ray, most_range_m); }) == 0,
                "every " + std::to_string(step) + "th");
  report.answer("the planted mark is seen",
                std::count(truth.defect.begin(), truth.defect.end(), 1) > 10, "pixels of it");

  Lighting lighting;
  lighting.water = coloured({0.4, 1, 0.1, 0.006}, {"coastal 3", {0.33, 0.19, 0.39}, "", ""});
  lighting.lamps = {{pose.position_m + 0.2 * pose.right, pose.axis, 2, 1.2}};
  lighting.shadows = {caster, nullptr};
  FrameHits seen;
  (void)truth_of(scene, small, most_range_m, threads, seen);
  const LightFrame light = light_of(scene, lighting, small, seen, threads);
  report.answer("the same light on one thread",
                light.light == light_of(scene, lighting, small, seen, 1).light, "and on two");
  ImagingSonarSheet sonar;
  LidarSheet lidar;
  if (few) {
    sonar.beams = 32;
    lidar.columns = 64;
  }
  const SonarImage ping = pinged(scene, *caster, sonar, pose, 0.2, 30, 1, threads);
  report.answer("the same ping on SSE2 alone",
                ping.intensity == pinged(scene, narrow, sonar, pose, 0.2, 30, 1, 1).intensity,
                "and one thread");
  SideScanSheet side_scan;
  if (few) side_scan.rays = 64;
  const Pose past = looking({10, 2, 32}, {10, 3, 32});
  report.answer("the same side-scan ping on SSE2 alone",
                side_scanned(scene, *caster, side_scan, past, 1, 50, 1, threads).intensity ==
                    side_scanned(scene, narrow, side_scan, past, 1, 50, 1, 1).intensity,
                "and one thread");
  if (few) return;

  const std::string note = std::to_string(triangles) + " triangles, 2 threads";
  report.figure(rate_of("depth, segmentation, normals, 1280 x 720", "frames/s", 8, note,
                        [&] { (void)truth_of(scene, wide, most_range_m, threads, hits); }));
  report.figure(
      rate_of("colours by one lamp, scatter and day, 640 x 360", "frames/s", 5, note, [&] {
        (void)truth_of(scene, small, most_range_m, threads, seen);
        (void)developed(light_of(scene, lighting, small, seen, threads), {}, 1, threads);
      }));
  Pose going = pose;
  going.velocity_m_s = {0.1, 0.4, 0};
  report.figure(
      rate_of("smear, rolling shutter, forward scatter, 640 x 360", "frames/s", 1, note, [&] {
        const LightFrame scattered =
            scattered_forwards(light, {0.7, 0.007}, small, seen, 0.4, threads);
        (void)through_shutter(scattered, {0.01, 2.8e-5}, small, going, seen, threads);
      }));
  const Warmth warmth;
  report.figure(rate_of("heat, 640 x 360", "frames/s", 5, note, [&] {
    (void)truth_of(scene, small, most_range_m, threads, seen);
    (void)infrared_of(scene, {warmth, lighting.sky, 0, false, 0, lighting.shadows}, {}, small, seen,
                      1, threads);
  }));
  const Pose above = looking({14, 3, -8}, {0, 0, -8});
  report.figure(rate_of("lidar, 64 x 2048", "turns/s", 40, note, [&] {
    (void)scanned(scene, *caster, lidar, above, 0.5, most_range_m, 0, 1, threads);
  }));
  report.figure(rate_of("imaging sonar, 512 beams of 256 rays", "pings/s", 30, note,
                        [&] { (void)pinged(scene, *caster, sonar, pose, 0.2, 30, 1, threads); }));
  report.figure(rate_of("side-scan, 2 sides of 3 slices of 2048 rays", "pings/s", 50, note, [&] {
    (void)side_scanned(scene, *caster, side_scan, past, 1, 50, 1, threads);
  }));
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "render", run); }
