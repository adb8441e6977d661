#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "twin/inspection/defect/defect.h"
#include "twin/render/scene/seen_class.h"

namespace slackwater::twin {

/// One thing that can be seen, where it is at a moment.
struct SeenThing {
  std::string name;  ///< "A01/monopile", "rov", "sea"
  SeenClass seen_class = SeenClass::nothing;
  Material material = Material::none;
  TriangleMesh mesh;
};

/// Where a planted defect shows on a thing, and its outline: a place p of that thing with
/// q = p - centre is part of it where
///
///   (q . along / half_along)^2 + (q . down / half_down)^2 <= 1   an ellipse, or, of a crack,
///   |q . along| <= half_along and |q . down| <= half_down        a rectangle,
///
/// and |q . normal| <= half_along: seen square to the surface at its centre, no deeper than it is
/// long, so that the far side of a thin thing shows nothing.
struct DefectMark {
  std::uint32_t defect = 0;  ///< its number in the run
  DefectKind kind{};
  std::size_t thing = 0;  ///< by its place in the scene
  double severity = 0;    ///< in the unit of its kind
  Triple<double> centre_m;
  Triple<double> normal;  ///< unit, outward
  Triple<double> along;   ///< unit, over the surface
  Triple<double> down;    ///< unit, square to both
  double half_along_m = 0;
  double half_down_m = 0;

  [[nodiscard]] bool holds(const Triple<double>& at_m) const noexcept;
};

/// The mark of a planted defect. The longest side of an outline is the defect's size; how wide it
/// is and which way it lies are drawn from (seed, number) and stand for what the plan does not
/// say: a crack is 1 in 40 as wide as long (at least 1 mm), a fastener's hole round, others 0.4 to
/// 0.9 as wide as long. Erosion lies along the blade, scour and loss of burial along their sheet.
/// @param defect  its surface and patch are not looked at
/// @param thing   by its place in the scene
/// @param normal  unit, outward, at its centre
[[nodiscard]] DefectMark mark_of(const Defect& defect, std::size_t thing,
                                 const Triple<double>& centre_m, const Triple<double>& normal,
                                 std::uint64_t seed);
/// The same of many, in the middle of their patches.
/// @param thing_of  place in the scene of each of the surfaces
[[nodiscard]] std::vector<DefectMark> marks_of(const std::vector<Defect>& defects,
                                               const std::vector<Surface>& surfaces,
                                               const std::vector<std::size_t>& thing_of,
                                               std::uint64_t seed);

/// All that can be seen at one moment, NED of the run.
struct RenderScene {
  double t_s = 0;
  double surface_m = 0;           ///< z of the sea at its middle: over the camera
  std::vector<SeenThing> things;  ///< the number of a thing in pictures is its place and 1
  std::vector<DefectMark> marks;
};

}  // namespace slackwater::twin
