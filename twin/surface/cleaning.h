#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "twin/control/route.h"
#include "twin/surface/cleaning_tool.h"
#include "twin/surface/cylinder_patch.h"
#include "twin/surface/marine_growth.h"

namespace slackwater::twin {

/// What a vehicle is to clean, and with what, as its description says.
struct CleaningPlan {
  double from_rad = 0;  ///< bearings of the patch, clockwise from the first
  double arc_rad = 0;
  double top_m = 0;  ///< z of its upper edge
  double bottom_m = 0;
  double cell_m = 0.1;        ///< longest side of a cell
  double band_m = 1;          ///< of depth, in which what is left is told
  double clean_below_mm = 0;  ///< a place with no more growth than this is clean
  double done_at = 0.95;      ///< share of the patch that has to be clean
  MarineGrowth growth;
  CleaningTool tool;
  bool operator==(const CleaningPlan&) const = default;
};

/// `cleaning` of a vehicle's conduct:
///
///     cleaning:
///       bearings_deg: [0, 360]            # absent: all round
///       from: {depth_m: 5.8}              # or height_m
///       to: {depth_m: 6.4}
///       cell_m: 0.1
///       band_m: 1
///       clean_below_mm: 5                 # absent: bare
///       done_at: 0.95
///       growth, tool: see there
///
/// @throws Error(invalid_input)
[[nodiscard]] CleaningPlan read_cleaning(const Config& config);

/// The same with all that is worked out once: the patch on each foundation that the work leads
/// along.
struct Cleaning {
  /// A row of cells, at one depth.
  struct Row {
    std::int64_t grew_nm = 0;   ///< on each of its cells at the start
    double takes_nm_per_s = 0;  ///< the tool
  };
  CleaningPlan plan;
  std::vector<CylinderPatch> patches;
  std::vector<Row> rows;  ///< of each patch
  /// Passes that the thickest growth, h, takes at the speed v of the way along the face:
  /// ceil(h w v/Q), or ceil(w v/A), with h less what may stay.
  std::size_t passes = 1;
};

/// Whether a tool that is carried there lies on the patch, in part at least.
[[nodiscard]] bool is_on_patch(const CylinderPatch& patch, const CleaningTool& tool,
                               const FacePlace& place) noexcept;

/// @param way  all waypoints of the vehicle's work, each with the speed towards it
/// @throws Error(invalid_input) where the work does not come within the tool's reach of a patch,
///         where that lies beyond its foundation or nothing grows in it
[[nodiscard]] Cleaning ready_cleaning(const CleaningPlan& plan,
                                      std::span<const Structure> structures,
                                      std::span<const Waypoint> way);

/// Of one patch. Growth is counted in whole nanometres, so that what was taken off and what is left
/// are together what there was, exactly.
struct PatchState {
  std::vector<std::int64_t> growth_nm;  ///< of each cell, row by row
  std::int64_t removed_nm = 0;          ///< of all cells together
};
/// How far a cleaning has come.
struct CleaningState {
  std::vector<PatchState> patches;
  double along_m = 0;  ///< where the tool was at the last look, on the face
  double down_m = 0;
  double worked_s = 0;    ///< that it worked on a face
  std::size_t patch = 0;  ///< which
  bool is_on = false;     ///< it worked then
};
[[nodiscard]] CleaningState begin_cleaning(const Cleaning& cleaning);

/// One look at the tool. Where it works now and did at the look before, the places that came under
/// it lose growth for as long as they did so, on a straight way between the two: how often one
/// looks makes no difference on a straight way. A cell goes with its centre. No allocation.
/// @param is_at_work  the vehicle does its work and has power
/// @param vehicle_m   where it is, not where it takes itself to be; NED
/// @param dt_s        since the look before
void clean(const Cleaning& cleaning, bool is_at_work, const Triple<double>& vehicle_m, double dt_s,
           CleaningState& state) noexcept;

}  // namespace slackwater::twin
