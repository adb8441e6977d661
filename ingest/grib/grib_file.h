#pragma once
#include <filesystem>

#include "ingest/decoded/ingested.h"

namespace slackwater::ingest {

/// Whether a file begins as GRIB does, also behind the heading of a bulletin. False where it cannot
/// be read.
[[nodiscard]] bool is_grib(const std::filesystem::path& file);

/// Decodes numerical weather prediction, GRIB 1 and 2, into canonical granules: wind at heights
/// above the ground (10u 10v, 100u 100v, 200u 200v, u v), gusts, and ECMWF wave fields (swh mwd
/// pp1d mwp).
///
///   one granule = one run x one ensemble member x one grid x one set of heights x instants or
///   means
///
/// - A run is a reference time. If it holds any step above 0 it is a forecast with that reference
/// time, its step 0
///   included. Runs of step 0 alone are analyses and share one granule (reanalysis files hold one
///   "run" per hour).
///   `--as` and `--issued` win.
/// - The mean over the members of an ensemble is a granule of its own, of dataset `ensemble_mean`.
/// Every other statistic (ingest/grib/statistic.h) is left out and named, or refused where nothing
/// else is there.
/// - Heights above the ground are heights above mean sea level: the difference at sea is the tide.
/// - Wind components relative to the grid are east and north here, since only regular grids that
/// are not rotated are
///   read.
/// - A field that a granule lacks at a time (a gust at step 0) is missing there; the file is
/// refused where one of a
///   wind's two components is there without the other.
/// - Refused: a field that is there twice, other grids, a damaged file (see MessageFile), no wanted
/// field, no value.
///
/// The file is walked twice, headers then values; memory is bounded by one message, its unpacked
/// values and a block of rows of all heights (< 256 MB). The products catalogue is for NetCDF: GRIB
/// names its parameters itself.
[[nodiscard]] Ingested decode_grib(const std::filesystem::path& file,
                                   const ProductCatalogue& products, const IngestOptions& options,
                                   const std::filesystem::path& staging_folder,
                                   const Progress& progress = {});

}  // namespace slackwater::ingest
