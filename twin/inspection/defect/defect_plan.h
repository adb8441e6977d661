#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "twin/inspection/defect/defect_facts.h"

namespace slackwater::twin {

/// A place that a plan names on a surface's sheet.
struct DefectPlace {
  bool is_by_bearing = false;
  double along_m = 0;      ///< on the sheet
  double down_m = 0;       ///< on the sheet
  double bearing_rad = 0;  ///< clockwise from north, of a surface that goes round an upright axis
  double z_m = 0;          ///< NED
  bool operator==(const DefectPlace&) const = default;
};

/// One entry of a plan: so many defects of a kind, or one at a place.
struct PlannedDefects {
  DefectKind kind{};
  std::size_t count = 1;
  std::string surface;  ///< empty: wherever its kind may sit
  std::optional<DefectPlace> place;
  std::optional<Range> size_m;    ///< nothing: as data/defects has it
  std::optional<Range> severity;  ///< the same
  bool operator==(const PlannedDefects&) const = default;
};

/// The defects of a run that nobody is told of.
struct DefectPlan {
  std::vector<PlannedDefects> entries;
  bool operator==(const DefectPlan&) const = default;
};

/// `defects` of a plan:
///
///     defects:
///       - {kind: crack, count: 6}
///       - {kind: crack, count: 6, on: A01/monopile, size_m: [0.02, 0.2], severity_m: 0.003}
///       - {kind: crack, on: A01/monopile, bearing_deg: 40, depth_m: 12, size_m: 0.05}
///       - {kind: scour, on: A01/bed, along_m: 10, down_m: 5, severity_m: 1.2}
///
/// Sizes and severities between two numbers are spread evenly over their logarithms.
/// @throws Error(invalid_input)
[[nodiscard]] DefectPlan read_defect_plan(const Config& config);

/// The defects of a plan on the surfaces of a run. Where a plan names no place, each square metre
/// of the surfaces that the kind may sit on is as likely as any other. What becomes of one defect
/// rests on the seed, its kind and how many of its kind stand before it in the plan.
/// @throws Error(invalid_input) for a defect off its surface, on a surface that its kind is never
///         found on, or where no surface suits it
[[nodiscard]] std::vector<Defect> plant(const DefectPlan& plan, std::span<const Surface> surfaces,
                                        const DefectFacts& facts, std::uint64_t seed);

/// The patch whose piece of the sheet holds a place; nothing off the sheet's patches.
[[nodiscard]] std::optional<std::size_t> patch_at(const Surface& surface, double along_m,
                                                  double down_m) noexcept;

}  // namespace slackwater::twin
