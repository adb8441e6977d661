#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/frame.h"
#include "ingest/cf/trajectory_file.h"
#include "twin/inspection/defect/defect_kind.h"

// What instruments saw of surfaces, as a log holds it: what pages and files of findings draw from.

namespace slackwater::api {

/// A surface laid flat: `along` to the right, `down` downwards.
struct CoverageSheet {
  double width_m = 0;
  double height_m = 0;
  bool is_all_round = false;  ///< its left and right edges are one
  std::string along;          ///< in words, for people: "clockwise from north"
  std::string down;           ///< "downwards": of depth, from `top_depth_m` on
  double first_bearing_deg = 0;
  double top_depth_m = 0;  ///< below mean sea level, of the upper edge; negative: above it

  /// Whether `down` is downwards in the water, so that it can be told as depth.
  [[nodiscard]] bool has_depth() const noexcept { return down.starts_with("down"); }
  /// Clockwise from north, [0, 360), of a place on a sheet that goes all round.
  [[nodiscard]] double bearing_deg(double along_m) const noexcept;
};

enum class PatchState { covered, seen_poorly, unseen };
inline constexpr std::size_t patch_states = 3;
/// What the states stand for, in the order of PatchState.
using StateWords = std::array<const char*, patch_states>;
inline constexpr StateWords words_of_a_run{"covered", "seen, not well enough", "not seen"};

struct CoveragePatch {
  double along_m = 0;  ///< of its centre on the sheet
  double down_m = 0;
  double width_m = 0;
  double height_m = 0;
  Vector3<Enu> centre_m{0, 0, 0};
  Vector3<Enu> normal{0, 0, 0};  ///< unit, outward
  double area_m2 = 0;
  // Of the best look; NaN where it was not seen.
  double detail_m = 0;
  double incidence_deg = 0;
  double range_m = 0;
  double t_s = 0;  ///< since the epoch of the log
  PatchState state = PatchState::unseen;
};

enum class FindingOutcome { found, false_alarm, never_seen, seen_too_poorly, overlooked };

/// A defect that was reported, one that was not, or a report of what is not there.
struct Finding {
  twin::DefectKind kind{};
  FindingOutcome outcome{};
  double along_m = 0;  ///< where it is on the sheet; of a false alarm, where it was reported
  double down_m = 0;
  // As reported; NaN where it was missed.
  Vector3<Enu> reported_m{0, 0, 0};
  double size_m = 0;
  double severity = 0;  ///< in its kind's unit (`severity_unit_of`)
  double t_s = 0;
  double detail_m = 0;
  // As it is; NaN of a false alarm.
  Vector3<Enu> true_m{0, 0, 0};
  double true_size_m = 0;
  double true_severity = 0;

  /// Whoever flies is told of it, true or not.
  [[nodiscard]] bool is_reported() const noexcept {
    return outcome == FindingOutcome::found || outcome == FindingOutcome::false_alarm;
  }
};
/// "found", "false alarm", "missed: never seen", ...
[[nodiscard]] const char* words_of(FindingOutcome outcome) noexcept;
/// "leading edge erosion"
[[nodiscard]] std::string words_of(twin::DefectKind kind);

/// One surface under one instrument of one vehicle.
struct InspectionCoverage {
  std::string vehicle;
  std::string surface;  ///< "A01/monopile"
  std::string kind;     ///< of the surface
  std::string instrument;
  double asked_detail_m = 0;  ///< at most, for a patch to be covered
  double asked_incidence_deg = 0;
  int asked_looks = 1;  ///< at least
  double done_at = 0;   ///< share of the area
  StateWords words = words_of_a_run;
  CoverageSheet sheet;
  double area_m2 = 0;
  double seen_m2 = 0;  ///< covered or not
  double covered_m2 = 0;
  std::optional<double> least_detail_m;
  std::optional<double> median_detail_m;
  std::vector<CoveragePatch> patches;
  std::vector<Finding> findings;

  /// Of the area, in the order of PatchState; they sum to 1.
  [[nodiscard]] std::array<double, patch_states> shares() const noexcept;
  [[nodiscard]] bool is_done() const noexcept { return covered_m2 >= done_at * area_m2; }
  [[nodiscard]] std::string name() const { return surface + ", " + instrument; }
  /// The patch whose centre lies nearest: where on the sheet what was reported there belongs.
  /// Null where there is none.
  [[nodiscard]] const CoveragePatch* nearest_patch(const Vector3<Enu>& place_m) const noexcept;
};

/// Of a log; empty where nothing was inspected.
/// @throws Error(invalid_input) for a log whose inspection is damaged, with what is wrong
[[nodiscard]] std::vector<InspectionCoverage> coverage_in(const ingest::TrajectoryFile& log);

}  // namespace slackwater::api
