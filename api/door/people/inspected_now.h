#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "twin/inspection/inspection.h"

namespace slackwater::people {

/// How far the inspection of one vehicle has come, as stations are told it: which patches of each
/// surface are covered as well as the plan asks, by any of its instruments, and what it would
/// report. Takes milliseconds: on the thread of the session, without its lock. Not thread-safe.
class InspectedNow {
 public:
  InspectedNow(std::size_t vehicle, std::shared_ptr<const twin::Inspection> inspection);

  /// @return messages about what is new: `covered`, a surface each, and `findings`
  [[nodiscard]] std::vector<nlohmann::json> take(const twin::InspectionState& state);

  /// What it inspects, as in `welcome`: {vehicle, surface, name, kind, patches, seen, asked}.
  [[nodiscard]] std::vector<nlohmann::json> surfaces_json() const;
  /// All that is covered, a message for each surface with any.
  [[nodiscard]] std::vector<nlohmann::json> covered_json() const;
  [[nodiscard]] nlohmann::json findings_json() const;

 private:
  struct Part {
    std::vector<bool> is_covered;  ///< each patch of the surface
    double area_m2 = 0, covered_m2 = 0, asked = 0;
    [[nodiscard]] double seen() const noexcept { return area_m2 > 0 ? covered_m2 / area_m2 : 0; }
  };
  [[nodiscard]] nlohmann::json covered_json(std::size_t surface, nlohmann::json runs) const;

  std::size_t vehicle_;
  std::shared_ptr<const twin::Inspection> inspection_;
  std::vector<Part> parts_;  ///< of each surface
  nlohmann::json findings_ = nlohmann::json::array();
};

/// What stations have been told of one, for those who come later.
struct ToldInspection {
  std::vector<nlohmann::json> surfaces, covered;
  nlohmann::json findings;
};

/// A surface as it is drawn: {name, kind, corners: [east, north, up, ...], triangles: [a, b, c,
/// ...], patch_of: [...]}, the patch of each triangle or -1.
[[nodiscard]] nlohmann::json surface_json(const twin::Surface& surface);

}  // namespace slackwater::people
