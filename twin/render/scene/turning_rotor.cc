#include "twin/render/scene/turning_rotor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/constants.h"
#include "twin/render/scene/simple_mesh.h"

namespace slackwater::twin {
namespace {

constexpr double tip_speed_ratio = 8, most_tip_m_s = 90;
// In diameters of the rotor: NREL 5 MW, 126 m (Jonkman et al. 2009, NREL/TP-500-38060).
constexpr double tower_radius = 0.019, nacelle_length = 0.11, nacelle_width = 0.045;
constexpr double hub_before = 0.04;  // of the tower's axis
struct BladeSection {
  double share;  ///< of the radius
  double chord;  ///< in radii
  double thickness;
};
constexpr std::array<BladeSection, 4> sections{BladeSection{0.02, 0.055, 0.055},
                                               {0.22, 0.074, 0.03},
                                               {0.7, 0.044, 0.009},
                                               {1.0, 0.012, 0.002}};

/// Axes of the rotor: where it looks, upwind; up; the side to which a blade goes that stands up:
/// clockwise as seen from upwind.
struct RotorAxes {
  Triple<double> upwind, side;
  static constexpr Triple<double> up{0, 0, -1};
};

RotorAxes axes_of(const RunningTurbine& running) {
  const double speed = std::hypot(running.wind_north_m_s, running.wind_east_m_s);
  const Triple<double> upwind =
      speed > 0 ? Triple<double>{-running.wind_north_m_s / speed, -running.wind_east_m_s / speed, 0}
                : Triple<double>{1, 0, 0};
  return {upwind, {upwind.y, -upwind.x, 0}};
}

TriangleMesh blade_mesh(const Triple<double>& hub_m, const RotorAxes& axes, double radius_m,
                        double azimuth_rad) {
  const Triple<double> out =
      std::cos(azimuth_rad) * RotorAxes::up + std::sin(azimuth_rad) * axes.side;
  const Triple<double> along = cross(axes.upwind, out);  // its chord, in the rotor's plane
  std::vector<std::vector<Triple<double>>> rings;
  for (const BladeSection& section : sections) {
    std::vector<Triple<double>> ring;
    constexpr int round = 12;
    for (int i = 0; i < round; ++i) {
      const double turn = 2 * constants::pi * i / round;
      ring.push_back(radius_m *
                     (section.share * out + 0.5 * section.chord * std::cos(turn) * along +
                      0.5 * section.thickness * std::sin(turn) * axes.upwind));
    }
    rings.push_back(std::move(ring));
  }
  return closed_mesh(hub_m, rings);
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
  const double d_m = turbine.rotor_diameter_m, hub_z_m = -turbine.hub_height_m;
  const RotorAxes axes = axes_of(running);
  const Triple<double> top_m{running.north_m, running.east_m, hub_z_m};
  const Triple<double> hub_m = top_m + hub_before * d_m * axes.upwind;
  std::vector<SeenThing> things;
  things.push_back({name + "/tower", SeenClass::tower, Material::grey_paint,
                    mesh_of(Cylinder{running.north_m, running.east_m, tower_radius * d_m, hub_z_m,
                                     std::max(hub_z_m + 1, running.foot_m)})});
  const Box nacelle{
      top_m,
      {0.5 * nacelle_length * d_m, 0.5 * nacelle_width * d_m, 0.5 * nacelle_width * d_m},
      axes.upwind.x,
      axes.upwind.y};
  things.push_back({name + "/nacelle", SeenClass::nacelle, Material::grey_paint, mesh_of(nacelle)});
  const double wind_m_s = std::hypot(running.wind_north_m_s, running.wind_east_m_s);
  const double turned_rad =
      std::fmod(rotor_speed_rad_s(turbine, wind_m_s) * t_s, 2 * constants::pi);
  for (int blade = 0; blade < 3; ++blade)
    things.push_back(
        {name + "/blade " + std::to_string(blade + 1), SeenClass::blade, Material::gelcoat,
         blade_mesh(hub_m, axes, 0.5 * d_m, turned_rad + 2 * constants::pi * blade / 3)});
  return things;
}

}  // namespace slackwater::twin
