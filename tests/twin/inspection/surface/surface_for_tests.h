#pragma once
#include <string>

#include "twin/inspection/surface/make_surface.h"

namespace slackwater::tests {

/// Of an entry as it stands in a scenario: "kind: monopile, ...".
inline twin::Surface surface_of(const std::string& entry, double patch_m) {
  const Config config = Config::parse("{" + entry + "}", "surfaces.yaml");
  const twin::PlannedSurface planned = twin::read_surface(config);
  config.expect_all_read();
  return twin::make_surface(planned, patch_m);
}

// One of each, far enough from the run's origin for single precision to show where it is misused.
inline constexpr const char* monopile_entry =
    "kind: monopile, north_m: 1200, east_m: -800, radius_m: 3, from: {height_m: 0}, to: {depth_m: "
    "35}";
inline constexpr const char* transition_entry =
    "kind: transition_piece, north_m: 1200, east_m: -800, radius_m: 3.2, from: {height_m: 20}, to: "
    "{depth_m: 3}, landing_deg: 180";
inline constexpr const char* tower_entry =
    "kind: tower, north_m: 1200, east_m: -800, radius_m: 3, from: {height_m: 87.6}, to: "
    "{height_m: 20}";
inline constexpr const char* nacelle_entry =
    "kind: nacelle, north_m: 1200, east_m: -800, height_m: 90, rotor_faces_deg: 270";
inline constexpr const char* blade_entry =
    "kind: blade, north_m: 1200, east_m: -800, height_m: 90, rotor_faces_deg: 270, blade: 2, "
    "tip_m: 63";
inline constexpr const char* anodes_entry =
    "kind: anodes, north_m: 1200, east_m: -800, radius_m: 3, from: {depth_m: 4}, to: {depth_m: 33}";
inline constexpr const char* mooring_entry =
    "kind: mooring_line, fairlead: {north_m: 1006, east_m: 0, depth_m: 14}, anchor: {north_m: "
    "1250, east_m: 30, depth_m: 90}, radius_m: 0.2";
inline constexpr const char* cable_entry =
    "kind: cable, burial_m: 1, route: [{north_m: 0, east_m: 0, depth_m: 35}, {north_m: 60, east_m: "
    "350, depth_m: 35}, {north_m: 100, east_m: 700, depth_m: 35}]";
inline constexpr const char* bed_entry =
    "kind: bed, north_m: 1200, east_m: -800, depth_m: 35, radius_m: 3, outer_m: 20, scour: "
    "{depth_m: 2, width_m: 4}";
inline constexpr const char* water_entry =
    "kind: water, north_m: 1200, east_m: -800, radius_m: 100, inner_m: 3";

}  // namespace slackwater::tests
