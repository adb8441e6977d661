#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/surface/cleaning.h"

namespace slackwater::twin {
namespace {

constexpr double nm_per_mm = 1e6;
constexpr std::size_t most_cells = 400000;

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorKind::invalid_input, "cleaning: " + what);
}

void expect_on(const CylinderPatch& patch) {
  constexpr double touch_m = 1e-6;
  const Cylinder& pile = patch.pile;
  if (patch.top_m < pile.top_m - touch_m || patch.bottom_m > pile.bottom_m + touch_m)
    refuse(
        formatted("the patch goes from {:g} to {:g} m of depth, and the foundation from {:g} to "
                  "{:g} m; move `from` and `to` onto it",
                  patch.top_m, patch.bottom_m, pile.top_m, pile.bottom_m));
}

/// How fast the way goes along the faces, m/s; of legs that lie within the tool's reach.
double speed_along(const Cleaning& cleaning, std::span<const Waypoint> way) {
  double length_m = 0, time_s = 0;
  for (const CylinderPatch& patch : cleaning.patches)
    for (std::size_t i = 1; i < way.size(); ++i) {
      const FacePlace from = face_place(patch, way[i - 1].position_m);
      const FacePlace to = face_place(patch, way[i].position_m);
      const CleaningTool& tool = cleaning.plan.tool;
      if (!is_on_patch(patch, tool, from) || !is_on_patch(patch, tool, to)) continue;
      length_m += std::hypot(std::remainder(to.along_m - from.along_m, patch.girth_m()),
                             to.down_m - from.down_m);
      time_s += length_of(way[i].position_m - way[i - 1].position_m) / way[i].speed_m_s;
    }
  return time_s > 0 ? length_m / time_s : 0;
}

std::size_t passes_of(const Cleaning& cleaning, double speed_m_s) {
  double most = 0;
  for (const Cleaning::Row& row : cleaning.rows)
    if (row.grew_nm > 0)
      most = std::max(
          most, (static_cast<double>(row.grew_nm) - nm_per_mm * cleaning.plan.clean_below_mm) *
                    speed_m_s / (row.takes_nm_per_s * cleaning.plan.tool.swath_m));
  return static_cast<std::size_t>(std::max(1.0, std::ceil(most - 1e-6)));
}

}  // namespace

Cleaning ready_cleaning(const CleaningPlan& plan, std::span<const Structure> structures,
                        std::span<const Waypoint> way) {
  Cleaning cleaning;
  cleaning.plan = plan;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Structure& structure : structures) {
    const auto* const pile = std::get_if<Cylinder>(&structure);
    if (pile == nullptr) continue;
    const CylinderPatch patch =
        cut_open(*pile, plan.from_rad, plan.arc_rad, plan.top_m, plan.bottom_m, plan.cell_m);
    bool is_near = false, is_worked = false;
    for (const Waypoint& at : way) {
      const FacePlace place = face_place(patch, at.position_m);
      nearest_m = std::min(nearest_m, place.off_m);
      is_near |= place.off_m <= plan.tool.reach_m;
      is_worked |= is_on_patch(patch, plan.tool, place);
    }
    if (is_near) expect_on(patch);
    if (!is_worked) continue;
    if (plan.tool.swath_m > 0.25 * patch.girth_m())
      refuse(
          formatted("the tool is {:g} m wide, and the foundation {:g} m thick; take a narrower "
                    "one",
                    plan.tool.swath_m, 2 * pile->radius_m));
    if (patch.cells() > most_cells)
      refuse(formatted("{} cells, expected {} at most; take a larger cell_m", patch.cells(),
                       most_cells));
    cleaning.patches.push_back(patch);
  }
  if (cleaning.patches.empty())
    refuse(nearest_m <= plan.tool.reach_m
               ? formatted(
                     "its work does not reach the patch, {:g} to {:g} m deep; move the work there",
                     plan.top_m, plan.bottom_m)
           : std::isfinite(nearest_m)
               ? formatted("its work stays {:.2f} m off the foundation, and the tool reaches {:g} "
                           "m; go nearer, or give it a longer reach_m",
                           nearest_m, plan.tool.reach_m)
               : std::string("there is no round foundation that its work leads along"));
  const CylinderPatch& first = cleaning.patches.front();
  bool grows = false;
  for (std::size_t r = 0; r < first.rows; ++r) {
    const double grew_mm =
        plan.growth.thickness_mm_at(plan.top_m + (static_cast<double>(r) + 0.5) * first.row_m());
    cleaning.rows.push_back(
        {std::llround(nm_per_mm * grew_mm), nm_per_mm * plan.tool.takes_mm_s(grew_mm)});
    grows |= grew_mm > plan.clean_below_mm;
  }
  if (!grows)
    refuse(
        formatted("found no growth to take off in the patch, {:g} to {:g} m deep; correct growth, "
                  "or the patch",
                  plan.top_m, plan.bottom_m));
  cleaning.passes = passes_of(cleaning, speed_along(cleaning, way));
  return cleaning;
}

}  // namespace slackwater::twin
