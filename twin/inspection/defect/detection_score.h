#pragma once
#include <array>
#include <optional>
#include <span>

#include "twin/inspection/defect/find_defects.h"

namespace slackwater::twin {

/// How well an inspection found what was there.
struct DetectionScore {
  struct OfKind {
    std::size_t planted = 0;
    std::size_t found = 0;         ///< by at least one instrument
    std::size_t false_alarms = 0;  ///< one for each that was reported
    friend bool operator==(const OfKind&, const OfKind&) = default;
  };
  std::array<OfKind, defect_kinds> kinds;  ///< in the order of all_defect_kinds
  OfKind all;
  /// Of all that was planted. Nothing where nothing was.
  std::optional<double> detection_rate;
  /// Of the area that was read. Nothing where none was.
  std::optional<double> false_alarms_per_100_m2;
  /// Root of the mean square of measured less true size, over all findings of defects. Nothing
  /// where none was found.
  std::optional<double> size_error_rms_m;
  std::optional<double> size_error_relative_rms;  ///< each by the true size

  /// Found by no instrument at all.
  [[nodiscard]] std::size_t missed() const noexcept { return all.planted - all.found; }
  friend bool operator==(const DetectionScore&, const DetectionScore&) = default;
};
[[nodiscard]] DetectionScore score_of(std::span<const Defect> defects, const Findings& findings);

}  // namespace slackwater::twin
