#include "twin/render/stage/staged_look.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/random.h"
#include "fields/base/text.h"
#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/instrument/quality.h"
#include "twin/inspection/surface/make_surface.h"
#include "twin/render/sheet/camera_light.h"

namespace slackwater::twin {
namespace {

constexpr double stage_patch_m = 0.5;
constexpr int most_draws = 1000;
constexpr double flattest_cosine = 0.17364817766693036;  // 80 degrees

double even(Rng& rng, const Range& range) { return rng.uniform(range.low, range.high); }
double even_log(Rng& rng, const Range& range) {
  return range.low * std::pow(range.high / range.low, rng.uniform());
}

/// Something to be looked at, with the area up to each of its patches.
struct AreaOf {
  std::vector<double> up_to_m2;
  std::vector<std::pair<std::size_t, std::size_t>> patch;  ///< surface, patch

  void add(std::size_t surface, const Surface& made) {
    for (std::size_t p = 0; p < made.patches.size(); ++p) {
      up_to_m2.push_back((up_to_m2.empty() ? 0 : up_to_m2.back()) + made.patches[p].area_m2);
      patch.emplace_back(surface, p);
    }
  }
  [[nodiscard]] std::pair<std::size_t, std::size_t> drawn(Rng& rng) const {
    const double at_m2 = rng.uniform() * up_to_m2.back();
    const auto next = std::upper_bound(up_to_m2.begin(), up_to_m2.end() - 1, at_m2);
    return patch[static_cast<std::size_t>(next - up_to_m2.begin())];
  }
};

/// A camera that looks at a place from off its normal, upright but for its roll.
Pose pose_at(const Triple<double>& place_m, const Triple<double>& normal, double range_m,
             double off_rad, double round_rad, double roll_rad) {
  const Triple<double> side =
      std::abs(normal.z) < 0.9 ? cross({0, 0, 1}, normal) : cross({1, 0, 0}, normal);
  const Triple<double> e1 = (1 / length_of(side)) * side;
  const Triple<double> e2 = cross(normal, e1);
  const Triple<double> way =
      std::cos(off_rad) * normal +
      std::sin(off_rad) * (std::cos(round_rad) * e1 + std::sin(round_rad) * e2);
  Pose pose;
  pose.position_m = place_m + range_m * way;
  pose.axis = -1.0 * way;
  Triple<double> right = cross({0, 0, 1}, pose.axis);
  if (length_of(right) < 1e-3) right = cross({1, 0, 0}, pose.axis);
  right = (1 / length_of(right)) * right;
  const Triple<double> down = cross(pose.axis, right);
  pose.right = std::cos(roll_rad) * right + std::sin(roll_rad) * down;
  return pose;
}

/// A hull that has the camera at its pose, level with the picture.
Carriage hull_of(const Pose& pose, const RenderSensor& sensor) {
  const Triple<double> down = cross(pose.axis, pose.right);
  const Rotation<double> turned{{pose.axis.x, pose.right.x, down.x},
                                {pose.axis.y, pose.right.y, down.y},
                                {pose.axis.z, pose.right.z, down.z}};
  return {pose.position_m - turned.to_ned(sensor.position_m), turned, {}, {}};
}

/// |n . d| of a pixel: d = (x, y, 1) through a plane a metre ahead, n in the picture's axes.
double through_pixel(const Pinhole& camera, int i, int j,
                     const std::array<float, 3>& normal) noexcept {
  const double x = (i + 0.5 - 0.5 * camera.wide()) / camera.focal_u();
  const double y = (j + 0.5 - 0.5 * camera.high()) / camera.focal_v();
  return std::abs(x * static_cast<double>(normal[0]) + y * static_cast<double>(normal[1]) +
                  static_cast<double>(normal[2]));
}

}  // namespace

Instrument instrument_of(const RenderSensor& sensor, double lamps) {
  const auto& camera = std::get<CameraSheet>(sensor.device);
  Instrument instrument;
  instrument.name = sensor.name;
  instrument.kind = InstrumentKind::rgb;
  instrument.footprint = camera.frame;
  instrument.least_range_m = sensor.least_range_m;
  instrument.most_range_m = sensor.most_range_m;
  instrument.needs_light = true;
  double square = 0, aside = 0;
  for (const MountedLamp& lamp : camera.lamps) {
    square += lamps * lamps * lamp.range_m * lamp.range_m;
    aside += length_of(lamp.position_m - sensor.position_m);
  }
  instrument.lamp_range_m = std::sqrt(square);
  if (!camera.lamps.empty())
    instrument.lamp_aside_m = std::max(0.01, aside / static_cast<double>(camera.lamps.size()));
  return instrument;
}

struct Stage::Parts {
  LookStage sheet;
  std::vector<Surface> surfaces;
  RenderScene bare;  ///< without a mark
  std::shared_ptr<const RayCaster> caster;
  AreaOf area;

  explicit Parts(LookStage given) : sheet(std::move(given)) {
    std::vector<TriangleMesh> meshes;
    for (const PlannedSurface& planned : sheet.surfaces) {
      surfaces.push_back(make_surface(planned, stage_patch_m));
      const Surface& made = surfaces.back();
      area.add(surfaces.size() - 1, made);
      meshes.push_back(made.mesh);
      bare.things.push_back(
          {made.name, class_of(made.kind), usual_material_of(made.kind), made.mesh});
    }
    caster = std::make_shared<const RayCaster>(meshes);
  }

  [[nodiscard]] bool is_in_medium(const Triple<double>& at_m) const {
    return sheet.sensor.medium == SensorMedium::both ||
           (sheet.sensor.medium == SensorMedium::water) == (at_m.z > 0);
  }

  void draw_view(Rng& rng, StagedLook& look) const {
    for (int draw = 0; draw < most_draws; ++draw) {
      const auto [surface, number] = area.drawn(rng);
      const Patch& patch = surfaces[surface].patches[number];
      look.range_m = even_log(rng, sheet.range_m);
      look.off_square_rad = even(rng, sheet.off_square_rad);
      const double round_rad = rng.uniform(0, 2 * constants::pi);
      const double roll_rad = sheet.most_roll_rad * rng.uniform(-1, 1);
      look.pose = pose_at(patch.centre_m, patch.normal, look.range_m, look.off_square_rad,
                          round_rad, roll_rad);
      look.depth_m = patch.centre_m.z;
      if (!is_in_medium(look.pose.position_m) || !is_in_medium(patch.centre_m)) continue;
      const auto hit = caster->first_hit({look.pose.position_m, look.pose.axis}, look.range_m);
      if (!hit || hit->mesh != surface || hit->range_m < 0.98 * look.range_m) continue;
      return;
    }
    throw Error(ErrorKind::invalid_input,
                formatted("stage {}: a thousand draws found no place of its surfaces that {} can "
                          "look at; widen range_m or off_square_deg, or move the surfaces into "
                          "its medium ({})",
                          sheet.name, sheet.sensor.name, name_of(sheet.sensor.medium)));
  }

  /// Marks where drawn pixels meet a surface.
  void plant_in(Rng& rng, const Pinhole& camera, const FrameHits& hits, std::uint64_t seed,
                RenderScene& scene) const {
    if (sheet.defects.empty() || rng.uniform() < sheet.share_without) return;
    const int many = 1 + static_cast<int>(rng.uniform() * sheet.most_defects);
    for (int draw = 0, planted = 0; draw < 20 * many && planted < many; ++draw) {
      const auto& staged = sheet.defects[static_cast<std::size_t>(
          rng.uniform() * static_cast<double>(sheet.defects.size()))];
      Defect defect;
      defect.kind = staged.kind;
      defect.number = static_cast<std::uint32_t>(scene.marks.size());
      defect.size_m = even_log(rng, staged.size_m);
      const int i = static_cast<int>(rng.uniform() * camera.wide());
      const int j = static_cast<int>(rng.uniform() * camera.high());
      const auto pixel = static_cast<std::size_t>(j) * static_cast<std::size_t>(camera.wide()) +
                         static_cast<std::size_t>(i);
      if (!hits.is_hit(pixel)) continue;
      const std::size_t thing = hits.mesh[pixel];
      if (!may_sit_on(defect.kind, surfaces[thing].kind)) continue;
      const Ray ray = camera.ray(i, j);
      const Triple<double> at_m = ray.from_m + hits.range_m[pixel] * ray.direction;
      const Triple<double> face = bare.things[thing].mesh.area_vector_m2(hits.triangle[pixel]);
      const bool is_free =
          std::none_of(scene.marks.begin(), scene.marks.end(), [&](const DefectMark& other) {
            return length_of(other.centre_m - at_m) < other.half_along_m + 0.5 * defect.size_m;
          });
      if (!is_free) continue;
      scene.marks.push_back(mark_of(defect, thing, at_m, (1 / length_of(face)) * face, seed));
      ++planted;
    }
  }

  [[nodiscard]] static double seen_m2(const TruthFrame& truth, const Pinhole& camera) {
    double sum_m2 = 0;
    std::size_t at = 0;
    for (int j = 0; j < camera.high(); ++j)
      for (int i = 0; i < camera.wide(); ++i, ++at) {
        if (truth.instance[at] == 0) continue;
        const double depth_m = static_cast<double>(truth.depth_m[at]);
        const double range_m = static_cast<double>(truth.range_m[at]);
        const double through = through_pixel(camera, i, j, truth.normal[at]);
        if (through * depth_m < flattest_cosine * range_m) continue;
        sum_m2 += depth_m * depth_m / (camera.focal_u() * camera.focal_v() * through);
      }
    return sum_m2;
  }
};

Stage::Stage(LookStage stage) : parts_(std::make_unique<Parts>(std::move(stage))) {}
Stage::~Stage() = default;
const LookStage& Stage::sheet() const noexcept { return parts_->sheet; }
const std::vector<SeenThing>& Stage::things() const noexcept { return parts_->bare.things; }

StagedLook Stage::look(std::uint64_t seed, std::uint64_t number, int threads) const {
  const Parts& parts = *parts_;
  const LookStage& sheet = parts.sheet;
  const auto& sheet_camera = std::get<CameraSheet>(sheet.sensor.device);
  Rng rng(seed, formatted("twin/render/stage {}", number));
  StagedLook look;
  look.number = number;
  parts.draw_view(rng, look);
  look.visibility_m = even_log(rng, sheet.visibility_m);
  look.daylight = even_log(rng, sheet.daylight);
  look.lamps = even(rng, sheet.lamps);
  look.growth = even(rng, sheet.growth);
  const WaterType& water = sheet.waters[static_cast<std::size_t>(
      rng.uniform() * static_cast<double>(sheet.waters.size()))];
  look.water = water.name;
  const std::uint64_t own_seed = rng.bits();

  const Pinhole camera(look.pose, sheet_camera.frame);
  look.matrix = camera.matrix();
  RenderScene scene = parts.bare;
  FrameHits hits;
  std::vector<const TriangleMesh*> meshes;
  for (const SeenThing& thing : scene.things) meshes.push_back(&thing.mesh);
  find_first_hits(camera, meshes, sheet.sensor.most_range_m, threads, hits);
  parts.plant_in(rng, camera, hits, own_seed, scene);
  look.truth = truth_of(scene, camera, sheet.sensor.most_range_m, threads, hits);

  Clarity clarity;
  clarity.daylight = look.daylight;
  const bool is_in_water = look.depth_m > 0;
  const Clarity through =
      seen_through(clarity, look.visibility_m, is_in_water ? Medium::water : Medium::air);
  Lighting lighting;
  lighting.water = coloured(through, water);
  lighting.air = colourless(through);
  lighting.seed = own_seed;
  lighting.growth = look.growth;
  const Carriage hull = hull_of(look.pose, sheet.sensor);
  for (const MountedLamp& mounted : sheet_camera.lamps) {
    lighting.lamps.push_back(lamp_of(mounted, hull));
    lighting.lamps.back().range_m *= look.lamps;
  }
  lighting.shadows.still = parts.caster;
  const CameraThere there{sheet_camera, scene, lighting, look.pose, own_seed, threads};
  look.picture =
      developed(light_in(there, camera, hits).frame, sheet_camera.sensor, own_seed, threads);

  const Instrument instrument = instrument_of(sheet.sensor, look.lamps);
  for (const DefectMark& mark : scene.marks) {
    StagedDefect planted;
    planted.kind = mark.kind;
    planted.thing = mark.thing;
    planted.centre_m = mark.centre_m;
    if (const auto place = camera.place_of(mark.centre_m)) planted.centre_px = {place->u, place->v};
    planted.size_m = 2 * mark.half_along_m;
    planted.width_m = 2 * std::min(mark.half_along_m, mark.half_down_m);
    planted.quality.range_m = length_of(mark.centre_m - look.pose.position_m);
    if (const auto quality = quality_of(instrument, look.pose, through, mark.centre_m, mark.normal))
      planted.quality = *quality;
    look.defects.push_back(planted);
  }
  for (const std::uint16_t defect : look.truth.defect)
    if (defect > 0) ++look.defects[defect - 1U].pixels;
  look.seen_m2 = Parts::seen_m2(look.truth, camera);
  return look;
}

}  // namespace slackwater::twin
