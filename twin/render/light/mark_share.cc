#include "twin/render/light/mark_share.h"

namespace slackwater::twin {

double share_of(const DefectMark& mark, const PixelFootprint& pixel) noexcept {
  const auto place = [&](double u, double v) {
    return pixel.middle_m + u * pixel.side_m + v * pixel.down_m;
  };
  const double reach_m =
      mark.half_along_m + mark.half_down_m + length_of(pixel.side_m) + length_of(pixel.down_m);
  if (length_of(pixel.middle_m - mark.centre_m) > reach_m) return 0;
  if (mark.holds(place(-0.5, -0.5)) && mark.holds(place(-0.5, 0.5)) &&
      mark.holds(place(0.5, -0.5)) && mark.holds(place(0.5, 0.5)))
    return 1;
  constexpr int side = 8;
  int held = 0;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      held += mark.holds(place((i + 0.5) / side - 0.5, (j + 0.5) / side - 0.5)) ? 1 : 0;
  return held / double{side * side};
}

}  // namespace slackwater::twin
