#include "twin/render/stage/staged_look.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "fields/base/text.h"
#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/instrument/quality.h"
#include "twin/inspection/surface/make_surface.h"
#include "twin/render/frame/seen_area.h"
#include "twin/render/sheet/camera_instrument.h"
#include "twin/render/sheet/camera_light.h"
#include "twin/render/stage/drawn_place.h"
#include "twin/render/stage/told_from_noise.h"

namespace slackwater::twin {
namespace {

constexpr double stage_patch_m = 0.5;
constexpr int most_draws = 1000;

double even(Rng& rng, const Range& range) { return rng.uniform(range.low, range.high); }
double even_log(Rng& rng, const Range& range) {
  return range.low * std::pow(range.high / range.low, rng.uniform());
}

/// And those beside them, whose edge shows a little.
std::vector<std::size_t> pixels_of_marks(const TruthFrame& truth) {
  const auto wide = static_cast<std::size_t>(truth.wide), all = truth.defect.size();
  std::vector<std::size_t> pixels;
  for (std::size_t at = 0; at < all; ++at) {
    const bool is_near = truth.defect[at] > 0 || (at > 0 && truth.defect[at - 1] > 0) ||
                         (at + 1 < all && truth.defect[at + 1] > 0) ||
                         (at >= wide && truth.defect[at - wide] > 0) ||
                         (at + wide < all && truth.defect[at + wide] > 0);
    if (is_near) pixels.push_back(at);
  }
  return pixels;
}

}  // namespace

struct Stage::Parts {
  LookStage sheet;
  std::vector<Surface> surfaces;
  RenderScene bare;  ///< without a mark
  std::shared_ptr<const RayCaster> caster;
  DrawnPatch area;

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
      look.pose = pose_looking_at(patch.centre_m, patch.normal, look.range_m, look.off_square_rad,
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
  find_hits_of(scene, camera, sheet.sensor.most_range_m, threads, hits);
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
  const Carriage hull = hull_that_has(sheet.sensor, look.pose);
  for (const MountedLamp& mounted : sheet_camera.lamps) {
    lighting.lamps.push_back(lamp_of(mounted, hull));
    lighting.lamps.back().range_m *= look.lamps;
  }
  lighting.shadows.still = parts.caster;
  const CameraThere there{sheet_camera, scene, lighting, look.pose, own_seed, threads};
  LightFrame of_scene = light_of(scene, lighting, camera, hits, threads);
  const LightFrame light = light_behind_lens(of_scene, there, camera, hits).frame;
  look.picture = developed(light, sheet_camera.sensor, own_seed, threads);

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
  if (!scene.marks.empty()) {
    light_again(of_scene, pixels_of_marks(look.truth), parts.bare, lighting, camera, hits, threads);
    const LightFrame bare = light_behind_lens(std::move(of_scene), there, camera, hits).frame;
    const auto told = told_from_noise(light, bare, look.truth, sheet_camera.sensor,
                                      look.picture.gain, look.defects.size());
    for (std::size_t i = 0; i < look.defects.size(); ++i) look.defects[i].signal_to_noise = told[i];
  }
  look.seen_m2 = seen_area_m2(look.truth, camera);
  return look;
}

}  // namespace slackwater::twin
