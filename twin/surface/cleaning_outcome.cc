#include "twin/surface/cleaning_outcome.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

CleaningOutcome cleaning_outcome(const Cleaning& cleaning, const CleaningState& state) {
  const CleaningPlan& plan = cleaning.plan;
  const auto clean_nm = std::llround(1e6 * plan.clean_below_mm);
  CleaningOutcome out;
  out.density_kg_m3 = plan.growth.density_kg_m3;
  out.done_at = plan.done_at;
  out.worked_s = state.worked_s;
  out.passes_needed = cleaning.passes;
  for (double top_m = plan.top_m; top_m < plan.bottom_m - 1e-9; top_m += plan.band_m)
    out.bands.push_back({top_m, std::min(top_m + plan.band_m, plan.bottom_m)});
  for (std::size_t p = 0; p < cleaning.patches.size(); ++p) {
    const CylinderPatch& patch = cleaning.patches[p];
    const PatchState& own = state.patches[p];
    const double cell_m2 = patch.cell_m2();
    out.removed_m3 += 1e-9 * static_cast<double>(own.removed_nm) * cell_m2;
    for (std::size_t r = 0; r < patch.rows; ++r) {
      const double centre_m = (static_cast<double>(r) + 0.5) * patch.row_m();
      CleaningOutcome::Band& band = out.bands[std::min(
          static_cast<std::size_t>(centre_m / plan.band_m), out.bands.size() - 1)];
      std::int64_t left_nm = 0;
      double cleaned = 0;
      for (std::size_t c = 0; c < patch.columns; ++c) {
        const std::int64_t growth_nm = own.growth_nm[r * patch.columns + c];
        left_nm += growth_nm;
        cleaned += growth_nm <= clean_nm ? 1 : 0;
      }
      const std::int64_t grew_nm =
          cleaning.rows[r].grew_nm * static_cast<std::int64_t>(patch.columns);
      band.left_m3 += 1e-9 * static_cast<double>(left_nm) * cell_m2;
      band.removed_m3 += 1e-9 * static_cast<double>(grew_nm - left_nm) * cell_m2;
      // Where nothing had to be taken off nothing was cleaned.
      if (cleaning.rows[r].grew_nm <= clean_nm) continue;
      band.area_m2 += static_cast<double>(patch.columns) * cell_m2;
      band.cleaned_m2 += cleaned * cell_m2;
    }
  }
  for (const CleaningOutcome::Band& band : out.bands) {
    out.area_m2 += band.area_m2;
    out.cleaned_m2 += band.cleaned_m2;
    out.left_m3 += band.left_m3;
  }
  return out;
}

}  // namespace slackwater::twin
