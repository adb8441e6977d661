#pragma once
#include <array>
#include <cstddef>

#include "twin/body/spatial.h"

namespace slackwater::twin {

inline constexpr std::size_t tether_segments = 16;
inline constexpr std::size_t tether_nodes =
    tether_segments + 1;  ///< with both ends: 0 at the top, last at the vehicle
inline constexpr std::size_t tether_inner_nodes = tether_segments - 1;

/// Segments shorter than those of such a line swing faster than a step of 0.05 s can follow: one
/// with less paid out is reckoned as this long.
inline constexpr double shortest_tether_m = 10;

/// The line between a winch, on a vessel or a structure, and a vehicle. SI.
struct Tether {
  double diameter_m = 0;
  double mass_per_m_kg = 0;
  double normal_drag_coefficient = 1.2;       ///< of the diameter, on the flow across the line
  double tangential_drag_coefficient = 0.01;  ///< of the diameter, on the flow along the line
  double axial_stiffness_n = 0;               ///< EA: tension per strain
  double breaking_load_n = 0;
  double longest_m = 0;  ///< on the drum
  double water_density_kg_m3 = 0;
  Triple<double> attachment_m;  ///< on the vehicle, body axes
  /// 1/(mass and added mass) of the vehicle, with which it yields to a pull within the step; 0: an
  /// end held fast.
  double vehicle_mobility_per_kg = 0;
};

/// Values only: they are copied into a checkpoint and back. NED from the site's origin.
template <typename Real>
struct TetherState {
  std::array<Triple<Real>, tether_inner_nodes> node_m{};
  std::array<Triple<Real>, tether_inner_nodes> velocity_m_s{};
  std::array<Real, tether_segments> tension_n{};  ///< of the last step, from the top
  Real length_m{};                                ///< paid out, unstretched
  Real whole = Real{} + 1.0;                      ///< 1, or 0 once it has parted
};

template <typename Real>
struct TetherEnds {
  Triple<Real> top_m;
  Triple<Real> top_velocity_m_s;
  Triple<Real> vehicle_m;  ///< the attachment, not the vehicle's origin
  Triple<Real> vehicle_velocity_m_s;
};

/// The water where the nodes are: the caller looks it up at their depths.
template <typename Real>
struct WaterAtNodes {
  std::array<Triple<Real>, tether_nodes> velocity_m_s{};
  Real elevation_m{};  ///< of the surface above still water; what is above it hangs in air
};

/// What the tether does during a step. Forces NED.
template <typename Real>
struct TetherPull {
  Triple<Real> on_vehicle_n;
  Triple<Real> on_top_n;
  Real top_tension_n{};
  Real vehicle_tension_n{};
  Real slack_m{};  ///< length paid out less the distance of the ends; negative when it is stretched
  Real taut{};     ///< 1 where slack is less than `taut_slack_share` of the length, else 0
  Real whole{};    ///< 1, or 0 once the breaking load has been exceeded: then it pulls no more
};

/// At this share of slack a line bows by 6 % of its length: slack = 8/3 bow^2/length, parabola.
inline constexpr double taut_slack_share = 0.01;

}  // namespace slackwater::twin
