#include "twin/render/scene/turning_rotor.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "twin/inspection/surface/make_surface.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {
namespace {

constexpr double tip_speed_ratio = 8, most_tip_m_s = 90;
constexpr double tower_radius_m = 3;  // of its foot; NREL, 6-1, with the rotor's radius
constexpr double shown_patch_m = 4;   // fine enough for a drone's camera from some rotors away

SeenThing thing_of(const std::string& name, decltype(PlannedSurface::sizes) sizes) {
  PlannedSurface planned;
  planned.name = name;
  planned.sizes = std::move(sizes);
  Surface made = make_surface(planned, shown_patch_m);
  return {name, class_of(made.kind), usual_material_of(made.kind), std::move(made.mesh)};
}

}  // namespace

double rotor_speed_rad_s(const Turbine& turbine, double wind_m_s) noexcept {
  const bool is_running =
      wind_m_s >= turbine.cut_in_speed_m_s && wind_m_s <= turbine.cut_out_speed_m_s;
  if (!is_running) return 0;
  return std::min(tip_speed_ratio * wind_m_s, most_tip_m_s) / (0.5 * turbine.rotor_diameter_m);
}

std::vector<SeenThing> seen_turbine(const Turbine& turbine, const RunningTurbine& running,
                                    double t_s, const std::string& name) {
  const double radius_m = 0.5 * turbine.rotor_diameter_m;
  const Triple<double> hub_m{running.north_m, running.east_m, -turbine.hub_height_m};
  const double faces_rad = std::atan2(-running.wind_east_m_s, -running.wind_north_m_s);
  const double wind_m_s = std::hypot(running.wind_north_m_s, running.wind_east_m_s);
  std::vector<SeenThing> things;
  const double tower_top_m = hub_m.z + usual::tower_below_hub_m;
  if (running.foot_m > tower_top_m) {
    TowerSizes tower;
    tower.upright = {running.north_m, running.east_m, tower_top_m, running.foot_m};
    tower.radius_m = radius_m / usual::rotor_radius_m * tower_radius_m;
    things.push_back(thing_of(name + "/tower", tower));
  }
  NacelleSizes nacelle;
  nacelle.hub_m = hub_m;
  nacelle.rotor_faces_rad = faces_rad;
  things.push_back(thing_of(name + "/nacelle", nacelle));
  BladeSizes blade;
  blade.hub_m = hub_m;
  blade.tip_m = radius_m;
  blade.rotor_faces_rad = faces_rad;
  blade.rotor_azimuth_rad =
      std::fmod(rotor_speed_rad_s(turbine, wind_m_s) * t_s, 2 * constants::pi);
  for (blade.blade = 1; blade.blade <= 3; ++blade.blade)
    things.push_back(thing_of(name + "/blade " + std::to_string(blade.blade), blade));
  return things;
}

}  // namespace slackwater::twin
