// made_up_lit_scenes OUT: small scenes as the renderer lights them, with all that another renderer
// needs to light the same: tests/soak/lit_scenes.py. Lengths in metres, places NED; light in that
// of a place of the usual reflectance that is lit as well as is needed (light_frame.h).
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/twin/render/render_for_tests.h"
#include "twin/inspection/instrument/seen_light.h"
#include "twin/render/frame/frame_hits.h"
#include "twin/render/light/light_frame.h"

namespace slackwater::twin {
namespace {

using nlohmann::json;
using Place = Triple<double>;

constexpr int wide = 64, high = 36;
constexpr double horizontal_deg = 60, most_range_m = 60;

/// Of a material of the usual albedo all over.
SeenThing thing_of(const std::string& name, std::vector<Place> corners,
                   std::vector<std::array<std::uint32_t, 3>> triangles) {
  TriangleMesh mesh;
  for (const Place& at : corners)
    mesh.corners.push_back(
        {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
  mesh.triangles = std::move(triangles);
  return {name, SeenClass::structure, Material::none, mesh};
}

/// A square before the camera, which looks north, its upper edge tilted away from it and its right
/// edge turned away.
SeenThing wall(double ahead_m, double half_m, double tilt_deg = 0, double turn_deg = 0) {
  const double tilt = tilt_deg * constants::degree, turn = turn_deg * constants::degree;
  const Place across = {half_m * std::sin(turn), half_m * std::cos(turn), 0};
  const Place down = {-half_m * std::sin(tilt), 0, half_m * std::cos(tilt)};
  const Place centre{ahead_m, 0, 0};
  return thing_of("wall",
                  {centre - across - down, centre + across - down, centre + across + down,
                   centre - across + down},
                  {{0, 2, 1}, {0, 3, 2}});
}

/// A box along the axes, its faces outward.
SeenThing box(const Place& centre, double half_m) {
  std::vector<Place> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(centre +
                      half_m * Place{i & 1 ? 1. : -1., i & 2 ? 1. : -1., i & 4 ? 1. : -1.});
  return thing_of("box", corners,
                  {{0, 4, 6},
                   {0, 6, 2},
                   {1, 3, 7},
                   {1, 7, 5},
                   {0, 1, 5},
                   {0, 5, 4},
                   {2, 6, 7},
                   {2, 7, 3},
                   {0, 2, 3},
                   {0, 3, 1},
                   {4, 5, 7},
                   {4, 7, 6}});
}

ColouredClarity grey(double beam_per_m, double backscatter_per_m, double daylight) {
  ColouredClarity clarity;
  clarity.beam_attenuation_per_m.fill(beam_per_m);
  clarity.diffuse_attenuation_per_m.fill(0);
  clarity.backscatter_per_m = backscatter_per_m;
  clarity.daylight = daylight;
  return clarity;
}

/// Under water, by the light of lamps that look where the camera does.
Lighting lamps_in_water(double beam_per_m, double backscatter_per_m,
                        const std::vector<Place>& lamps) {
  Lighting lighting;
  lighting.water = grey(beam_per_m, backscatter_per_m, 0);
  for (const Place& at : lamps) lighting.lamps.push_back({at, {1, 0, 0}, 4});
  return lighting;
}

json triple_json(const Place& v) { return {v.x, v.y, v.z}; }

/// @param surface_m  of the sea, down: above the camera or below it
json lit(const std::string& name, std::vector<SeenThing> things_there, Lighting lighting,
         double surface_m) {
  RenderScene scene;
  scene.things = std::move(things_there);
  scene.surface_m = surface_m;
  lighting.shadows = shadows_of(scene);
  const Pinhole camera(looking({0, 0, 0}, {1, 0, 0}), frame_of(wide, high, horizontal_deg));
  std::vector<const TriangleMesh*> meshes;
  json things = json::array();
  for (const SeenThing& thing : scene.things) {
    meshes.push_back(&thing.mesh);
    json corners = json::array(), triangles = json::array();
    for (const auto& at : thing.mesh.corners) corners.push_back(at);
    for (const auto& of : thing.mesh.triangles) triangles.push_back(of);
    things.push_back({{"corners", corners}, {"triangles", triangles}});
  }
  FrameHits hits;
  find_first_hits(camera, meshes, most_range_m, 2, hits);
  const LightFrame frame = light_of(scene, lighting, camera, hits, 2);
  json light = json::array();
  for (const auto& bands : frame.light) light.push_back(bands[green]);
  json lamps = json::array();
  for (const Lamp& lamp : lighting.lamps)
    lamps.push_back({{"at", triple_json(lamp.position_m)},
                     {"axis", triple_json(lamp.axis)},
                     {"range", lamp.range_m}});
  const bool is_in_water = surface_m < 0;
  const ColouredClarity& through = is_in_water ? lighting.water : lighting.air;
  return {{"name", name},
          {"things", things},
          {"lamps", lamps},
          {"attenuation", through.beam_attenuation_per_m[green]},
          {"backscatter", is_in_water ? through.backscatter_per_m : 0},
          {"daylight", through.daylight},
          {"to_sun", triple_json(lighting.sky.to_sun)},
          {"beam", lighting.sky.beam},
          {"light", light}};
}

json scenes() {
  const Place beside{0, 0.4, -0.3}, below{0.2, -0.5, 0.4};
  json all = json::array();
  all.push_back(lit("a wall in clear water", {wall(3, 6)}, lamps_in_water(0, 0, {beside}), -20));
  all.push_back(lit("a wall askew in water that absorbs", {wall(2.5, 6, 35, 20)},
                    lamps_in_water(0.4, 0, {beside, below}), -20));
  all.push_back(lit("the shadow of a box", {wall(4, 8), box({2.4, -0.2, 0.1}, 0.35)},
                    lamps_in_water(0.2, 0, {{0, 1.2, -0.8}}), -20));
  all.push_back(
      lit("a lamp's own veil", {wall(12, 40)}, lamps_in_water(0.3, 0.02, {{0, 0.5, 0}}), -20));
  all.push_back(lit("a wall behind the veil of two lamps", {wall(2.5, 6, -25, 0)},
                    lamps_in_water(0.5, 0.03, {beside, below}), -20));
  Lighting day;
  day.air = grey(0, 0, 0.8);
  const double elevation = 50 * constants::degree, azimuth = 200 * constants::degree;
  day.sky.to_sun = {std::cos(elevation) * std::cos(azimuth),
                    std::cos(elevation) * std::sin(azimuth), -std::sin(elevation)};
  day.sky.beam = 0.7;
  all.push_back(lit("a roof in the sun", {wall(3, 8, 40, 0)}, day, 20));
  return {{"wide", wide},
          {"high", high},
          {"horizontal_deg", horizontal_deg},
          {"albedo", usual_reflectance},
          {"scenes", all}};
}

}  // namespace
}  // namespace slackwater::twin

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "made_up_lit_scenes OUT\n");
    return 2;
  }
  std::ofstream(argv[1]) << slackwater::twin::scenes().dump() << "\n";
  return 0;
}
