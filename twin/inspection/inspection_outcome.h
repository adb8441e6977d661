#pragma once
#include <optional>
#include <string>
#include <vector>

#include "twin/inspection/defect/detection_score.h"
#include "twin/inspection/inspection.h"

namespace slackwater::twin {

/// How it went.
struct InspectionOutcome {
  /// One surface by one instrument.
  struct Part {
    std::string surface;
    std::string instrument;
    SurfaceKind kind{};
    double area_m2 = 0;
    double seen_m2 = 0;          ///< however well
    double covered_m2 = 0;       ///< as well as asked
    double asked = 0;            ///< share that its line asks for; 0: nothing
    double least_detail_m = 0;   ///< of what was seen: the best
    double median_detail_m = 0;  ///< by area; infinite: less than half was seen
    std::vector<bool> covered;   ///< of each patch

    [[nodiscard]] double share() const noexcept { return area_m2 > 0 ? covered_m2 / area_m2 : 0; }
    friend bool operator==(const Part&, const Part&) = default;
  };
  std::vector<Part> parts;  ///< of each pair
  DetectionScore score;
  std::uint64_t looks = 0;
  std::uint64_t rays = 0;
  double worked_s = 0;
  std::string left;  ///< in words, the first line that covered less than it asks; empty: none

  /// Whether each line covered the share that it asks for; nothing where none asks. A flight may be
  /// done and have seen nothing.
  [[nodiscard]] std::optional<bool> is_seen() const noexcept;

  /// Of all parts together.
  [[nodiscard]] double area_m2() const noexcept;
  [[nodiscard]] double covered_m2() const noexcept;
  [[nodiscard]] double share() const noexcept;
  friend bool operator==(const InspectionOutcome&, const InspectionOutcome&) = default;
};

/// Whether a place is covered.
[[nodiscard]] bool is_covered(const InspectionLine& line, const BestLook& best) noexcept;

/// What is there to be found, and what was found of it: all that `InspectionOutcome::score` counts.
struct InspectionFindings {
  std::vector<Defect> planted;
  Findings findings;
};
[[nodiscard]] InspectionFindings inspection_findings(const Inspection& inspection,
                                                     const InspectionState& state);

[[nodiscard]] InspectionOutcome inspection_outcome(const Inspection& inspection,
                                                   const InspectionState& state);

}  // namespace slackwater::twin
