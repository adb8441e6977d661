#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "twin/render/frame/pinhole.h"

namespace slackwater::twin {

/// What floats or flies before a lens, all alike: flakes in water, drops in air.
struct Specks {
  double per_m3 = 0;
  double diameter_m = 0.002;
  double nearest_m = 0.1;  ///< along the camera's axis: nearer ones are out of focus
  double reach_m = 3;      ///< farther ones are too small to be told apart
};

/// One in view.
struct Speck {
  double u = 0;        ///< pixels from the left edge
  double v = 0;        ///< from the upper edge
  double depth_m = 0;  ///< along the axis
};

/// The volume in view between two depths, w h/(f_u f_v) (far^3 - near^3)/3, m3.
[[nodiscard]] double volume_in_view_m3(const Pinhole& camera, double near_m, double far_m) noexcept;

/// Those of a picture: a Poisson number with the mean per_m3 times the volume in view, evenly over
/// it. By stream and seed alone; specks of two pictures have nothing to do with each other.
[[nodiscard]] std::vector<Speck> specks_in_view(const Specks& specks, const Pinhole& camera,
                                                std::uint64_t seed, const char* stream);

/// A speck as a picture shows it: a disc of pixels with an edge of a pixel, no smaller than one.
/// One that is smaller covers but a share of them.
class SpeckDisc {
 public:
  SpeckDisc(const Pinhole& camera, const Speck& speck, double diameter_m);

  [[nodiscard]] double radius_px() const noexcept { return drawn_px_; }
  /// Calls `see(column, row, share)` for each pixel of the picture that it covers, 0 < share <= 1:
  /// over all, off the picture too, the shares sum to its area, pi (f diameter/2z)^2.
  template <typename See>
  void for_pixels(See see) const {
    for (int row = std::max(0, row_ - reach_); row <= std::min(high_ - 1, row_ + reach_); ++row)
      for (int i = std::max(0, column_ - reach_); i <= std::min(wide_ - 1, column_ + reach_); ++i)
        if (const double share = scale_ * covered(i, row); share > 0) see(i, row, share);
  }

 private:
  [[nodiscard]] double covered(int column, int row) const noexcept {
    return std::clamp(drawn_px_ + 0.5 - std::hypot(column + 0.5 - u_, row + 0.5 - v_), 0.0, 1.0);
  }

  int wide_, high_, column_, row_, reach_;
  double u_, v_, drawn_px_, scale_;
};

}  // namespace slackwater::twin
