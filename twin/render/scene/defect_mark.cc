#include <algorithm>
#include <cmath>

#include "fields/base/numbers/random.h"
#include "fields/base/text.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {
namespace {

Triple<double> unit_of(const Triple<double>& v) { return (1 / length_of(v)) * v; }

/// Over the surface: level where it stands up, along north where it lies.
Triple<double> level_over(const Triple<double>& normal) {
  const Triple<double> level = cross({0, 0, 1}, normal);
  return length_of(level) > 0.1 ? unit_of(level)
                                : unit_of(Triple<double>{1, 0, 0} - normal.x * normal);
}

bool is_laid_by_its_sheet(DefectKind kind) {
  return kind == DefectKind::scour || kind == DefectKind::burial_loss ||
         kind == DefectKind::leading_edge_erosion || kind == DefectKind::anode_loss ||
         kind == DefectKind::chain_wear;
}

}  // namespace

bool DefectMark::holds(const Triple<double>& at_m) const noexcept {
  const Triple<double> q = at_m - centre_m;
  const double a = dot(q, along) / half_along_m, d = dot(q, down) / half_down_m;
  if (std::abs(dot(q, normal)) > half_along_m) return false;
  return kind == DefectKind::crack ? std::abs(a) <= 1 && std::abs(d) <= 1 : a * a + d * d <= 1;
}

DefectMark mark_of(const Defect& defect, std::size_t thing, const Triple<double>& centre_m,
                   const Triple<double>& normal, std::uint64_t seed) {
  constexpr double crack_width = 1.0 / 40, least_crack_m = 0.001;
  Rng rng(seed, formatted("twin/render/mark {}", defect.number));
  DefectMark mark;
  mark.defect = defect.number;
  mark.kind = defect.kind;
  mark.thing = thing;
  mark.severity = defect.severity;
  mark.centre_m = centre_m;
  mark.normal = normal;
  const Triple<double> level = level_over(normal);
  const Triple<double> across = cross(normal, level);
  const double turn = rng.uniform(0, 3.141592653589793);
  const double share = rng.uniform(0.4, 0.9);
  const bool is_turned = !is_laid_by_its_sheet(defect.kind);
  mark.along = is_turned ? std::cos(turn) * level + std::sin(turn) * across : level;
  mark.down = cross(mark.normal, mark.along);
  mark.half_along_m = 0.5 * defect.size_m;
  if (defect.kind == DefectKind::crack)
    mark.half_down_m = 0.5 * std::max(least_crack_m, crack_width * defect.size_m);
  else if (defect.kind == DefectKind::missing_fastener)
    mark.half_down_m = mark.half_along_m;
  else
    mark.half_down_m = share * mark.half_along_m;
  return mark;
}

std::vector<DefectMark> marks_of(const std::vector<Defect>& defects,
                                 const std::vector<Surface>& surfaces,
                                 const std::vector<std::size_t>& thing_of, std::uint64_t seed) {
  std::vector<DefectMark> marks;
  for (const Defect& defect : defects) {
    const Patch& patch = surfaces[defect.surface].patches[defect.patch];
    marks.push_back(mark_of(defect, thing_of[defect.surface], patch.centre_m, patch.normal, seed));
  }
  return marks;
}

}  // namespace slackwater::twin
