#pragma once
#include <string>

#include "api/door/edr/sample/answer.h"

namespace slackwater::api::edr {

/// An answer as the bytes of a netCDF-4 file after CF-1.8 (`application/netcdf`): layouts of
/// merged_coverage.h and ingest/cf/forecast/sampled_file_writer.h; provenance, attribution and
/// notes as global attributes. Values keep their full precision.
///
/// Goes through a file in a private folder below the system's folder for temporary files, which is
/// gone afterwards. Throws Error(not_found) for an answer without coverages, which the format
/// cannot hold, Error(usage) as merged_coverage does, Error(unavailable) where the disk refuses.
[[nodiscard]] std::string netcdf(const Answer& answer);

}  // namespace slackwater::api::edr
