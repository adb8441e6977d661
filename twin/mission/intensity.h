#pragma once
#include <vector>

#include "fields/base/config.h"

namespace slackwater::twin {

/// In which order the passes of a pattern are flown.
enum class PassOrder {
  as_laid,         ///< one beside the other
  coarse_to_fine,  ///< every other one on the way out, those between on the way back
};
/// as_laid, coarse_to_fine.
[[nodiscard]] const char* name_of(PassOrder order) noexcept;

/// How closely work looks at a surface, and in which order: rings, bearings, faces of a blade,
/// lines over a cable, passes of a tool are its passes (work_pattern.h).
struct Intensity {
  double density = 1;  ///< share of the task's passes, in (0, 1]
  PassOrder order = PassOrder::as_laid;
  bool operator==(const Intensity&) const = default;
};

/// `intensity` of an agent in a mission, by role:
///
///     agents: {surveyor: {intensity: {density: 0.5, order: coarse_to_fine}}}
///
/// Both keys are optional. A task says how far apart its passes are, and has no such key.
/// @throws Error(invalid_input)
[[nodiscard]] Intensity read_intensity(const Config& config);
/// What it reads as the same, the density to a millionth.
[[nodiscard]] YamlValue value_of(const Intensity& intensity);

/// What is left of an intensity where it is thinned by another: densities are multiplied, and the
/// order is the other's, unless that leaves all as it is (density 1).
[[nodiscard]] Intensity thinned(const Intensity& own, const Intensity& by) noexcept;

/// How many of `passes` are flown at a density: the least number that is no smaller a share.
/// Rises with the density; at least 1.
[[nodiscard]] int passes_at(int passes, double density) noexcept;

/// The numbers 0 to `passes` - 1 in the order in which they are flown. Coarse to fine, of six:
/// 0 2 4 5 3 1. After half of them no two neighbours are both missing, and the last is beside the
/// first, so that the way home is as short as its beginning was.
[[nodiscard]] std::vector<int> flown_order(int passes, PassOrder order);

}  // namespace slackwater::twin
