#include "twin/render/scene/scene_of_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/config.h"
#include "fields/base/text.h"
#include "twin/inspection/defect/defect_plan.h"
#include "twin/render/scene/passing_vessel.h"
#include "twin/render/scene/sea_mesh.h"
#include "twin/render/scene/simple_mesh.h"
#include "twin/render/scene/turning_rotor.h"

namespace slackwater::twin {
namespace {

constexpr double thinner = 0.96;       // of a structure under an inspected surface
constexpr double on_it = 0.05;         // of its size: what lies so near to it is its surface
constexpr double most_of_bed_m = 400;  // from the middle
constexpr double most_of_sea_m = 3000;

/// Whether most corners of a mesh lie on a structure's face.
bool lies_on(const TriangleMesh& mesh, const Structure& structure) {
  std::size_t near = 0;
  const double size_m = std::visit(
      [](const auto& shape) {
        if constexpr (requires { shape.radius_m; })
          return shape.radius_m;
        else
          return std::min(shape.half_size_m.x, shape.half_size_m.y);
      },
      structure);
  for (std::size_t i = 0; i < mesh.corners.size(); ++i)
    near += std::abs(signed_distance_m(structure, mesh.corner_m(i))) < on_it * size_m ? 1 : 0;
  return 2 * near > mesh.corners.size();
}

Structure thinned(const Structure& structure) {
  Structure thin = structure;
  if (auto* cylinder = std::get_if<Cylinder>(&thin)) {
    cylinder->radius_m *= thinner;
  } else if (auto* box = std::get_if<Box>(&thin)) {
    box->half_size_m.x *= thinner;
    box->half_size_m.y *= thinner;
  }
  return thin;
}

void add_surfaces(const RunMoment& moment, RenderScene& scene) {
  for (const auto& inspection : moment.inspections) {
    std::vector<std::size_t> thing_of;
    for (const Surface& surface : inspection->surfaces) {
      thing_of.push_back(scene.things.size());
      scene.things.push_back(
          {surface.name, class_of(surface.kind), usual_material_of(surface.kind), surface.mesh});
    }
    const std::vector<Defect> defects =
        plant(inspection->plan.defects, inspection->surfaces, inspection->facts, moment.seed);
    const auto marks = marks_of(defects, inspection->surfaces, thing_of, moment.seed);
    scene.marks.insert(scene.marks.end(), marks.begin(), marks.end());
  }
}

void add_structures(const RunMoment& moment, RenderScene& scene) {
  const std::size_t surfaces = scene.things.size();
  std::size_t number = 0;
  for (const Structure& structure : moment.sampler.environment().structures) {
    const bool is_inspected =
        std::any_of(scene.things.begin(), scene.things.begin() + static_cast<long>(surfaces),
                    [&](const SeenThing& thing) { return lies_on(thing.mesh, structure); });
    scene.things.push_back({formatted("structure {}", ++number), SeenClass::structure,
                            Material::steel,
                            mesh_of(is_inspected ? thinned(structure) : structure)});
  }
}

void add_bed(const RunMoment& moment, RenderScene& scene) {
  const BedSample bed = moment.sampler.bed(moment.middle_m);
  if (!has_value(bed.status) || !(bed.water_depth_m > 0)) return;
  std::vector<LevelDisc> shown;
  for (const auto& inspection : moment.inspections)
    for (const Surface& surface : inspection->surfaces) {
      if (surface.kind != SurfaceKind::bed) continue;
      LevelDisc disc{surface.mesh.origin_m.x, surface.mesh.origin_m.y, 0};
      for (std::size_t i = 0; i < surface.mesh.corners.size(); ++i) {
        const Triple<double> at = surface.mesh.corner_m(i);
        disc.radius_m =
            std::max(disc.radius_m, std::hypot(at.x - disc.north_m, at.y - disc.east_m));
      }
      shown.push_back(disc);
    }
  const double reach_m = std::min(moment.reach_m, most_of_bed_m);
  scene.things.push_back({"bed", SeenClass::bed, Material::sand,
                          bed_mesh({moment.middle_m.x, moment.middle_m.y, bed.water_depth_m},
                                   reach_m, std::max(0.5, reach_m / 40), shown)});
}

double apart_m(const Triple<double>& a, const Triple<double>& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// It has been stopped for its inspection. @param foot_m  where it stands
bool is_inspected(const RunMoment& moment, const Turbine& turbine, const Triple<double>& foot_m) {
  for (const auto& inspection : moment.inspections)
    for (const Surface& surface : inspection->surfaces) {
      const bool is_of_turbine = surface.kind == SurfaceKind::tower ||
                                 surface.kind == SurfaceKind::nacelle ||
                                 surface.kind == SurfaceKind::blade;
      if (is_of_turbine && apart_m(surface.mesh.origin_m, foot_m) < 0.5 * turbine.rotor_diameter_m)
        return true;
    }
  return false;
}

/// z of the top of what stands there; the sea's level where nothing does.
double top_of_foundation_m(const RunMoment& moment, const Triple<double>& foot_m) {
  double top_m = 0;
  for (const Structure& structure : moment.sampler.environment().structures)
    if (const auto* pile = std::get_if<Cylinder>(&structure);
        pile != nullptr && apart_m({pile->north_m, pile->east_m, 0}, foot_m) < 1)
      top_m = std::min(top_m, pile->top_m);
  return top_m;
}

void add_turbines(const RunMoment& moment, RenderScene& scene) {
  const auto& turbines = moment.sampler.environment().turbines;
  if (!turbines || moment.middle_m.z > 0) return;
  const Turbine& kind = *turbines->kind;
  std::size_t number = 0;
  for (const Horizontal& at_m : turbines->at_m) {
    ++number;
    const Triple<double> foot_m{at_m.imag(), at_m.real(), 0};
    if (apart_m(foot_m, moment.middle_m) > moment.reach_m + kind.rotor_diameter_m ||
        is_inspected(moment, kind, foot_m))
      continue;
    const auto wind =
        moment.sampler.free_wind({foot_m.x, foot_m.y, -kind.hub_height_m}, moment.t_s);
    const Triple<double> blows =
        has_value(wind.status) ? wind.velocity_m_s : Triple<double>{0, 0, 0};
    const RunningTurbine running{foot_m.x, foot_m.y, top_of_foundation_m(moment, foot_m), blows.x,
                                 blows.y};
    for (SeenThing& thing :
         seen_turbine(kind, running, moment.t_s, formatted("turbine {}", number)))
      scene.things.push_back(std::move(thing));
  }
}

}  // namespace

VehicleShape read_vehicle_shape(const std::filesystem::path& file) {
  const Config config = Config::load(file);
  VehicleShape shape;
  const std::string kind = config.text("kind");
  for (const VehicleKind one : {VehicleKind::rov, VehicleKind::auv, VehicleKind::uav,
                                VehicleKind::usv, VehicleKind::vessel})
    if (kind == name_of(one)) shape.kind = one;
  const Config size = config.child("dimensions_m");
  shape.size_m = {size.number("length", {0.05, 500}), size.number("width", {0.05, 100}),
                  size.number("height", {0.02, 100})};
  std::vector<Config> hulls;
  if (config.is_list("hulls"))
    hulls = config.children("hulls");
  else if (const auto one = config.optional_child("hulls"))
    hulls.push_back(*one);
  double keel_z_m = -std::numeric_limits<double>::infinity();  // of the lowest
  for (const Config& hull : hulls)
    keel_z_m = std::max(keel_z_m, hull.number("keel_z_m", {-50, 50}));
  if (!hulls.empty()) shape.middle_m.z = keel_z_m - 0.5 * shape.size_m.z;
  return shape;
}

RenderScene scene_of_run(const RunMoment& moment) {
  RenderScene scene;
  scene.t_s = moment.t_s;
  add_surfaces(moment, scene);
  add_structures(moment, scene);
  add_bed(moment, scene);
  for (const SeenVehicle& seen : moment.vehicles)
    scene.things.push_back(
        {seen.name, SeenClass::vehicle, Material::plastic,
         hull_mesh(seen.shape.kind, seen.shape.size_m,
                   seen.position_m + seen.attitude.to_ned(seen.shape.middle_m), seen.attitude)});
  for (const SeenTether& tether : moment.tethers)
    scene.things.push_back({tether.name, SeenClass::tether, Material::rubber,
                            line_mesh(tether.at_m, tether.diameter_m)});
  SeenThing sea{"sea", SeenClass::water, Material::water,
                sea_mesh(moment.sampler.waves(), moment.middle_m,
                         std::min(moment.reach_m, most_of_sea_m), moment.t_s)};
  scene.surface_m = sea.mesh.corner_m(0).z;
  for (SeenThing& vessel : vessels_in_reach(moment.traffic, moment.t_s, moment.middle_m,
                                            moment.reach_m, scene.surface_m))
    scene.things.push_back(std::move(vessel));
  add_turbines(moment, scene);
  scene.things.push_back(std::move(sea));
  return scene;
}

}  // namespace slackwater::twin
