#pragma once
#include <vector>

#include "fields/wind/turbine.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// A turbine that runs, from its foundation up.
struct RunningTurbine {
  double north_m = 0;
  double east_m = 0;
  double foot_m = 0;          ///< z of the tower's foot, on its foundation
  double wind_north_m_s = 0;  ///< at its hub, where it blows to
  double wind_east_m_s = 0;
};

/// How fast its rotor turns, rad/s: a tip eight times as fast as the wind, at most 90 m/s; at rest
/// below cut-in and above cut-out. Estimates of how pitch-regulated turbines of some megawatts run.
[[nodiscard]] double rotor_speed_rad_s(const Turbine& turbine, double wind_m_s) noexcept;

/// Its nacelle, its three blades and, where its foundation ends below it, its tower. They are the
/// surfaces of an inspection (make_surface.h) in their usual sizes, the rotor upwind, as far round
/// as it would be had the wind been as it is now from t = 0 on: the wind's own changes do not show
/// in how it turns.
/// @param name  "turbine 3"
[[nodiscard]] std::vector<SeenThing> seen_turbine(const Turbine& turbine,
                                                  const RunningTurbine& running, double t_s,
                                                  const std::string& name);

}  // namespace slackwater::twin
