#include "calibration/day/given/bed_note.h"

#include <algorithm>

#include "fields/base/text.h"
#include "fields/service/bed_rule.h"

namespace slackwater::calibration {
namespace {

/// The deepest level with a value in any piece of the dataset.
std::optional<double> deepest_level_m(const ColumnData& column, const std::string& dataset) {
  std::optional<double> deepest;
  for (const PieceColumn<Horizontal>& piece : column.current.pieces) {
    if (piece.origin->dataset != dataset) continue;
    const VectorColumn& c = piece.column;
    for (std::size_t k = 0; k < c.levels_m.size(); ++k) {
      for (std::size_t t = 0; t < c.times(); ++t) {
        if (c.has(t, k)) deepest = std::max(deepest.value_or(c.levels_m[k]), c.levels_m[k]);
      }
    }
  }
  return deepest;
}

}  // namespace

std::optional<std::string> note_on_bed(const ColumnData& column, const std::string& dataset) {
  const double bed_m = column.water_depth.depth_m;
  const auto deepest_m = deepest_level_m(column, dataset);
  if (!deepest_m || column.water_depth.source == "deepest wet level") return std::nullopt;
  const bool is_shallower = *deepest_m > bed_m + depth_tolerance_m(bed_m);
  const bool is_deeper = bed_m > *deepest_m + depth_tolerance_m(*deepest_m);
  if (!is_shallower && !is_deeper) return std::nullopt;
  const std::string says = formatted("the {} gives {:.0f} m of water, but the currents ",
                                     column.water_depth.source, bed_m);
  if (is_shallower) {
    return says + formatted(
                      "go down to {:.0f} m: below {:.0f} m no current is given; check the depth of "
                      "the site",
                      *deepest_m, bed_m);
  }
  return says + formatted(
                    "end at {:.0f} m: below that the current of {:.0f} m is used down to the bed, "
                    "and marked as carried",
                    *deepest_m, *deepest_m);
}

}  // namespace slackwater::calibration
