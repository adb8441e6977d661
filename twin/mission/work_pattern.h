#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "twin/control/route.h"
#include "twin/mission/intensity.h"
#include "twin/mission/work_site.h"

namespace slackwater::twin {

/// A stretch of work: a way, and how long the vehicle stays at its end.
struct WorkLeg {
  std::vector<Waypoint> waypoints;
  double stay_s = 0;
  bool drifts = false;  ///< with whom it searches for
};

/// One `work` entry of a task, laid out at a turbine. Places are by bearing, distance from the face
/// of the foundation and depth; a level is
///
///     {depth_m: 5}  {height_m: 12}  {above_bed_m: 1.5}  {below_top_m: 2}  {below_hub_m: 10}
///
///     pattern: rings      stand_off_m, from: LEVEL, to: LEVEL, spacing_m, bearing_deg
///         round the foundation and back the other way, level by level: no line winds
///     pattern: verticals  stand_off_m, from, to, bearings: 4, stops: 0, stop_s: 0
///         up and down at even bearings, with stops on the way, and back round the same side
///     pattern: circles    radii_m: [...], at: LEVEL, turns: 1
///         about the turbine, on one level
///     pattern: blade      blade: 1, stand_off_m, faces: [...], rotor_faces_deg, rotor_azimuth_deg
///         out and back along a blade of a stopped rotor, once for each face: leading_edge,
///         trailing_edge, pressure, suction
///     pattern: cable      cable: ID or cable_role: array, lines, spacing_m, at: LEVEL, off_ends_m
///         along a cable of the site, by its id or its role (cable_of_site.h)
///     pattern: mooring    mooring: ID, stand_off_m, share: 1, sides: 1
///         along a line and back; with `sides: 2` back on its other side, over the line at the end,
///         so that a tether, which hangs from above, lies on no side of it
///     pattern: bands      stand_off_m, from, to, swath_m, rate_m2_h, overlap_m: 0, passes: 1
///         rings as far apart as a tool is wide, less an overlap, as fast as it cleans; all of them
///         as often as there are passes
///     pattern: landing    gap_m, bow_m, stay
///         bow on the boat landing
///     pattern: square     at: LEVEL, distance_m, leg_m, legs, frame: fixed
///         search by an expanding square; with `frame: drifting` about where whom the vehicle
///         searches for is thought to have drifted to
///
/// At a lower density fewer passes look at the same surface, further apart:
///
///     rings      levels, an even number of them, from the first to the last; two at the least
///     verticals  bearings, even about the foundation
///     blade      faces, as far from each other as they lie
///     cable      lines, over the same width; one alone is in its middle
///     bands      passes of the tool over all of the bands
///
/// The others have nothing to leave out and stay as they are. The way gets no longer as the density
/// falls. In either order as many rings lead round one way as the other, and verticals end at the
/// bearing at which they began, having come back the way that they went: no line winds.
/// @throws Error(invalid_input) for what the site does not have (a hub, a rotor, a cable, a line)
[[nodiscard]] std::vector<WorkLeg> lay_out(const Config& work, const WorkSite& site,
                                           const WorkTurbine& turbine,
                                           const Intensity& intensity = {});

/// z of a LEVEL at a turbine. @throws Error(invalid_input)
[[nodiscard]] double read_level(const Config& level, const WorkTurbine& turbine);

}  // namespace slackwater::twin
