#pragma once
#include <utility>
#include <vector>

#include "fields/base/numbers/random.h"
#include "twin/inspection/instrument/look.h"
#include "twin/inspection/surface/surface.h"

namespace slackwater::twin {

/// Draws patches of surfaces, each square metre as likely.
class DrawnPatch {
 public:
  void add(std::size_t surface, const Surface& made);
  /// Of surfaces with patches: surface and patch, by their places.
  [[nodiscard]] std::pair<std::size_t, std::size_t> drawn(Rng& rng) const;

 private:
  std::vector<double> up_to_m2_;
  std::vector<std::pair<std::size_t, std::size_t>> patch_;
};

/// A camera that looks at a place from `off_rad` off its normal, upright but for its roll.
/// @param round_rad  to which side of the normal
[[nodiscard]] Pose pose_looking_at(const Triple<double>& place_m, const Triple<double>& normal,
                                   double range_m, double off_rad, double round_rad,
                                   double roll_rad) noexcept;

}  // namespace slackwater::twin
