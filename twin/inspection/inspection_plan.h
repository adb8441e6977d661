#pragma once
#include <optional>
#include <string>
#include <vector>

#include "twin/inspection/defect/defect_plan.h"
#include "twin/inspection/instrument/look.h"
#include "twin/inspection/surface/planned_surface.h"

namespace slackwater::twin {

/// One instrument that inspects some of the surfaces, when a place is covered by it, and of how
/// many places that has to be so for the surfaces to count as seen.
struct InspectionLine {
  std::string instrument;          ///< of data/instruments, or a path
  std::vector<SurfaceKind> kinds;  ///< of the surfaces that it inspects
  double detail_m = 0;             ///< that has to be made out
  double most_incidence_rad = 0;   ///< off the normal
  std::uint32_t looks = 1;         ///< that a place is seen at least: overlap
  double seen_at = 0.9;            ///< share of these surfaces that is asked for; 0: nothing is
  bool operator==(const InspectionLine&) const = default;
};

/// What a vehicle is to inspect, and with what, as its description says.
struct InspectionPlan {
  std::vector<PlannedSurface> surfaces;
  std::vector<InspectionLine> lines;
  Clarity water;
  Clarity air;
  DefectPlan defects;                          ///< that nobody is told of
  std::string defect_facts = "offshore_wind";  ///< of data/defects
  std::vector<std::string> detection;          ///< of data/detection
  std::optional<double> patch_m;               ///< absent: from footprint and rays
  std::optional<std::size_t> rays_per_look;    ///< absent: the run's
  bool operator==(const InspectionPlan&) const = default;
};

/// `inspection` of a vehicle's conduct:
///
///     inspection:
///       surfaces: [{kind: monopile, ...}, ...]          # planned_surface.h
///       looks:
///         - {instrument: rov_camera, kinds: [monopile], detail_mm: 3, incidence_deg: 60,
///            looks: 1, seen_at: 0.9}
///       water: {beam_attenuation_per_m: 0.6}            # clarity.h
///       air: {visibility_m: 8000}                       # absent: clear
///       defects: [{kind: crack, count: 5}, ...]         # absent: none; defect_plan.h
///       defect_facts: offshore_wind                     # of data/defects
///       detection: [close_visual, ...]                  # of data/detection: how they are found
///       patch_m, rays_per_look: absent: as the run has them
///
/// `done_at`, as `seen_at` was called before, is read as that.
/// @throws Error(invalid_input) for a plan without surfaces or looks, a look at a kind of surface
///         that is not there, ...
[[nodiscard]] InspectionPlan read_inspection(const Config& config);
/// The same where the surfaces are values already.
[[nodiscard]] InspectionPlan read_inspection(const Config& config,
                                             std::vector<PlannedSurface> surfaces);

}  // namespace slackwater::twin
