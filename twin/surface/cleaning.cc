#include "twin/surface/cleaning.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {
namespace {

/// The stretch of a step, from 0 to 1, in which a coordinate that goes from `from` by `by` is
/// within `half` of a place.
struct Stretch {
  double begin = 0;
  double end = 1;
  void narrow(double from_m, double by_m, double half_m) noexcept {
    if (by_m == 0) {
      if (std::abs(from_m) > half_m) end = begin;
      return;
    }
    const double a = (-half_m - from_m) / by_m, b = (half_m - from_m) / by_m;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  [[nodiscard]] double share() const noexcept { return std::max(end - begin, 0.0); }
};

/// The cells whose centres lie between two places: the first, and the one after the last.
struct Cells {
  std::ptrdiff_t first = 0;
  std::ptrdiff_t end = 0;
};
Cells cells_between(double from_m, double to_m, double cell_m) noexcept {
  return {static_cast<std::ptrdiff_t>(std::ceil(std::min(from_m, to_m) / cell_m - 0.5)),
          static_cast<std::ptrdiff_t>(std::floor(std::max(from_m, to_m) / cell_m - 0.5)) + 1};
}
Cells cells_under(double from_m, double by_m, double half_m, double cell_m) noexcept {
  return cells_between(std::min(from_m, from_m + by_m) - half_m,
                       std::max(from_m, from_m + by_m) + half_m, cell_m);
}

/// Takes off what the tool takes on a straight way over a patch.
void sweep(const Cleaning& cleaning, const CylinderPatch& patch, const FacePlace& from,
           const FacePlace& to, double dt_s, PatchState& state) noexcept {
  const double half_m = 0.5 * cleaning.plan.tool.swath_m;
  const double by_m = std::remainder(to.along_m - from.along_m, patch.girth_m());
  const double sinks_m = to.down_m - from.down_m;
  // On the side of the patch's middle, so that both its edges are reached from outside.
  const double middle_m = 0.5 * patch.width_m();
  const double along_m = middle_m + std::remainder(from.along_m - middle_m, patch.girth_m());
  const auto columns = static_cast<std::ptrdiff_t>(patch.columns);
  Cells across = cells_under(along_m, by_m, half_m, patch.column_m());
  if (!patch.is_all_round())
    across = {std::max<std::ptrdiff_t>(across.first, 0), std::min(across.end, columns)};
  const Cells deep = cells_under(from.down_m, sinks_m, half_m, patch.row_m());
  const auto last_row = std::min(deep.end, static_cast<std::ptrdiff_t>(patch.rows));
  for (std::ptrdiff_t r = std::max<std::ptrdiff_t>(deep.first, 0); r < last_row; ++r) {
    const auto row = static_cast<std::size_t>(r);
    Stretch in_row;
    in_row.narrow(from.down_m - (static_cast<double>(r) + 0.5) * patch.row_m(), sinks_m, half_m);
    for (std::ptrdiff_t c = across.first; c < across.end; ++c) {
      Stretch under = in_row;
      under.narrow(along_m - (static_cast<double>(c) + 0.5) * patch.column_m(), by_m, half_m);
      const auto column = static_cast<std::size_t>((c % columns + columns) % columns);
      std::int64_t& growth_nm = state.growth_nm[row * patch.columns + column];
      const std::int64_t taken_nm = std::min<std::int64_t>(
          growth_nm, std::llround(cleaning.rows[row].takes_nm_per_s * dt_s * under.share()));
      growth_nm -= taken_nm;
      state.removed_nm += taken_nm;
    }
  }
}

}  // namespace

bool is_on_patch(const CylinderPatch& patch, const CleaningTool& tool,
                 const FacePlace& place) noexcept {
  const double half_m = 0.5 * tool.swath_m;
  return place.off_m <= tool.reach_m && place.down_m > -half_m &&
         place.down_m < patch.height_m() + half_m;
}

CleaningState begin_cleaning(const Cleaning& cleaning) {
  CleaningState state;
  for (const CylinderPatch& patch : cleaning.patches) {
    PatchState& own = state.patches.emplace_back();
    own.growth_nm.reserve(patch.cells());
    for (const Cleaning::Row& row : cleaning.rows)
      own.growth_nm.insert(own.growth_nm.end(), patch.columns, row.grew_nm);
  }
  return state;
}

void clean(const Cleaning& cleaning, bool is_at_work, const Triple<double>& vehicle_m, double dt_s,
           CleaningState& state) noexcept {
  const bool was_on = state.is_on;
  const std::size_t before = state.patch;
  const FacePlace from{state.along_m, state.down_m, 0};
  state.is_on = false;
  if (!is_at_work) return;
  for (std::size_t i = 0; i < cleaning.patches.size() && !state.is_on; ++i) {
    const FacePlace to = face_place(cleaning.patches[i], vehicle_m);
    if (!is_on_patch(cleaning.patches[i], cleaning.plan.tool, to)) continue;
    state.is_on = true;
    state.patch = i;
    state.along_m = to.along_m;
    state.down_m = to.down_m;
    if (!was_on || before != i) continue;
    state.worked_s += dt_s;
    sweep(cleaning, cleaning.patches[i], from, to, dt_s, state.patches[i]);
  }
}

}  // namespace slackwater::twin
