#pragma once
#include <optional>
#include <span>

#include "api/log/inspected.h"
#include "ingest/cf/trajectory_file.h"
#include "twin/account/vehicle_account.h"

namespace slackwater::api {

inline constexpr const char* inspection_attribute = "inspection";

/// Puts what the vehicles inspected into a log; nothing where none inspects.
///
/// * Attribute `inspection`, JSON: an entry for each pair of instrument and surface, with the sheet
///   that the surface is laid flat on.
/// * Table `inspected_patches`: each patch of each pair, where it is, and how well it was seen at
///   best; no numbers where it was not.
/// * Table `findings`: what was reported, and what was there and was not; positions ENU.
/// @param vehicles  of each what it inspected, null: nothing
void add_inspections(std::span<const std::optional<Inspected>> vehicles,
                     ingest::TrajectoryFile& log);

/// What a log says of inspections, in the accounts of their vehicles: by the attribute, the patches
/// and the tables `inspected` and `defect_kind`; in logs of formats before 6, which have neither,
/// the findings are counted.
/// @throws Error(invalid_input) for an attribute that is damaged
void read_inspections(const ingest::TrajectoryFile& log, twin::RunAccount& account);

}  // namespace slackwater::api
