#pragma once
#include <filesystem>

#include "ingest/decoded/ingested.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// Whether a file holds observations at points rather than fields on a grid: CF discrete sampling
/// geometries `timeSeries` and `timeSeriesProfile` (also as OceanSITES, Copernicus in situ, IMOS
/// and others spell them), or data over time beside a single, scalar position. Wave spectra count
/// too, so that they are refused by name.
[[nodiscard]] bool is_point_series(const netcdf::File& file);

/// Decodes buoys, platforms and current profilers into granules on a grid of 1 x 1, with a status
/// for every value.
///
/// - Quality flags become statuses (ingest/quality/flags.h); what nobody checked is `not_checked`,
///   not good. Then the range, spike and ensemble tests of ingest/quality run; what is rejected is
///   counted in the warnings and has no value.
/// - Speeds with directions become components: a current goes *to*, a wind comes *from*.
/// - A platform that swings stands at its median position, bins that heave at their median depth
/// (series_levels.h).
///   Levels out of the water or without any accepted value are left out.
/// - Variables with stamps of their own (files interleave them) get their own granule: each granule
/// has the stamps at
///   which its variables have records. Values are kept as they are, nothing is interpolated.
/// - Times are instants, unless the file states both the length of an average
/// (`instrument_average_interval`) and
///   where its middle lies (`seconds_to_middle_of_measurement`): then they are means over that
///   interval.
/// - The standard error that a file states of its currents (standard_error.h) is kept as one
/// number.
/// - Several stations become several granules. `--cut` leaves out stations outside.
/// - Status `observation`; `--as` wins (model output at points is written in the same form).
///
/// Throws Error(invalid_input) for what it cannot place in time, space or depth, and for files
/// without wanted values.
[[nodiscard]] Ingested decode_point_series(const netcdf::File& file,
                                           const ProductCatalogue& products,
                                           const IngestOptions& options,
                                           const std::filesystem::path& staging_folder);

}  // namespace slackwater::ingest
