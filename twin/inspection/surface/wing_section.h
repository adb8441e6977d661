#pragma once
#include <vector>

namespace slackwater::twin {

/// A place on a section of unit chord: `x` from the leading edge to the trailing one, `y` towards
/// the suction side.
struct SectionPoint {
  double x = 0;
  double y = 0;
};

/// A NACA 4-digit section with a sharp trailing edge, as a line from there over the pressure side,
/// the leading edge and the suction side back to it.
///
///   y_t = 5 t (0.2969 x^(1/2) - 0.1260 x - 0.3516 x^2 + 0.2843 x^3 - 0.1036 x^4)
///   y_c = m (2 p x - x^2) / p^2 before p, m (1 - 2p + 2 p x - x^2) / (1 - p)^2 behind
///
/// Thickness is put at right angles to the chord, not to the camber line: so the area within is
/// that of the symmetrical section, whatever the camber: `wing_section_area`.
/// Source: Jacobs, Ward & Pinkerton (1933), NACA report 460; the last coefficient is the usual one
/// that closes the edge (-0.1015 there).
class WingSection {
 public:
  /// @param thickness  t: of the chord, above 0
  /// @param camber     m: of the chord, at p = 0.4
  WingSection(double thickness, double camber);

  [[nodiscard]] double girth() const noexcept { return length_.back(); }  ///< of the chord
  /// @param share  0 to 1, of the girth
  [[nodiscard]] SectionPoint at(double share) const;

 private:
  std::vector<SectionPoint> points_;
  std::vector<double> length_;  ///< from the trailing edge to each point
};

/// Of unit chord: 2 integral of y_t
///   = 10 t (0.2969 2/3 - 0.1260/2 - 0.3516/3 + 0.2843/4 - 0.1036/5).
[[nodiscard]] constexpr double wing_section_area(double thickness) noexcept {
  return 10 * thickness * (0.2969 * 2 / 3 - 0.1260 / 2 - 0.3516 / 3 + 0.2843 / 4 - 0.1036 / 5);
}

}  // namespace slackwater::twin
