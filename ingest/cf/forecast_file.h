#pragma once
#include <filesystem>

#include "fields/service/snapshot.h"

namespace slackwater::ingest {

/// Writes an issued forecast as one CF-1.8 NetCDF-4 file, fsynced.
///
/// Exactly one variable per component has the dimensions (time, depth) — (time, depth, column) for
/// several columns — and the standard name eastward_/northward_sea_water_velocity: member 0.
/// Quantiles stand beside it as `…_p10/_p50/_p90`, wind and waves over (time[, column]). A single
/// column is a CF timeSeriesProfile station. Missing values are _FillValue with a status variable
/// beside them, never zero. Doubles, so that the round trip is exact.
void write_forecast(const std::filesystem::path& file, const Snapshot& snapshot);

/// Reads a file of `write_forecast` back, the same to the bit. Throws Error(invalid_input) for
/// anything else.
[[nodiscard]] Snapshot read_forecast(const std::filesystem::path& file);

}  // namespace slackwater::ingest
