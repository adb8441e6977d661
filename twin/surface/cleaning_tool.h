#pragma once
#include <string>

#include "fields/base/config.h"

namespace slackwater::twin {

/// What takes growth off a face: it works on a square as wide as its swath, upright on the face
/// that is nearest to the vehicle, evenly over it.
///
/// Either it takes off so much growth in a time, Q (mm m2/s), whatever there is of it; each place
/// under it then loses Q/w^2 millimetres a second. Or it lays so much face bare in a time, A
/// (m2/s), however thick the growth: each place then loses A/w^2 of what grew there a second. What
/// passes under it at a speed v so loses Q/(w v), or A/(w v) of its growth.
struct CleaningTool {
  double swath_m = 0;          ///< w
  double reach_m = 0;          ///< the vehicle's centre is at most this far from the face
  double removal_mm_m2_s = 0;  ///< Q; 0: the other one is given
  double rate_m2_s = 0;        ///< A
  std::string source;
  std::string status;
  bool operator==(const CleaningTool&) const = default;

  /// What a second under it takes off a place where so much grew, mm/s.
  [[nodiscard]] double takes_mm_s(double grew_mm) const noexcept {
    const double face_m2 = swath_m * swath_m;
    return removal_mm_m2_s > 0 ? removal_mm_m2_s / face_m2 : rate_m2_s / face_m2 * grew_mm;
  }
};

/// `tool` of a cleaning:
///
///     tool: {swath_m: 0.4, reach_m: 1.2, removal_mm_m2_h: 6500, source: ..., status: ...}
///
/// or `rate_m2_h` in the place of `removal_mm_m2_h`.
/// @throws Error(invalid_input)
[[nodiscard]] CleaningTool read_cleaning_tool(const Config& config);

}  // namespace slackwater::twin
