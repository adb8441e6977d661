#pragma once
#include <optional>
#include <span>

#include "ingest/cf/trajectory_file.h"

namespace slackwater::api {

struct VehicleSummary;

inline constexpr const char* inspection_attribute = "inspection";

/// Puts what the vehicles inspected into a log; nothing where none inspects.
///
/// * Attribute `inspection`, JSON: an entry for each pair of instrument and surface, with the sheet
///   that the surface is laid flat on.
/// * Table `inspected_patches`: each patch of each pair, where it is, and how well it was seen at
///   best; no numbers where it was not.
/// * Table `findings`: what was reported, and what was there and was not; positions ENU.
void add_inspections(std::span<const VehicleSummary> vehicles, ingest::TrajectoryFile& log);

/// What a log says of a vehicle's inspection.
struct LoggedInspection {
  double area_m2 = 0;
  double covered_m2 = 0;
  std::size_t found = 0;
  std::size_t missed = 0;
  std::size_t false_alarms = 0;

  [[nodiscard]] double share() const noexcept { return area_m2 > 0 ? covered_m2 / area_m2 : 0; }
};
/// Nothing where it inspected nothing, or the log does not say.
[[nodiscard]] std::optional<LoggedInspection> inspection_in(const ingest::TrajectoryFile& log,
                                                            std::size_t vehicle);

}  // namespace slackwater::api
