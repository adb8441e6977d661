#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "api/pipeline/ingest/ingest_counts.h"
#include "data/store/store.h"
#include "fields/base/time.h"
#include "ingest/ingest.h"

namespace slackwater::api {

/// What became of one file.
struct IngestReport {
  std::filesystem::path file;
  bool stored = false;    ///< false: it was in the store already
  bool repaired = false;  ///< it was, but its content there was damaged or lost, and is whole again
  std::string sha256;
  std::string product_id;
  std::size_t granules = 0;
  IngestCounts counts;
  std::vector<std::string> standard_names;
  std::string status;  ///< analysis | forecast | observation
  std::vector<std::string> warnings;
};

/// Reads one product file into the store: hashed and decoded side by side, committed wholly or not
/// at all. A file that is there already, with the same cut, is a no-op; where its content files in
/// the store are lost or damaged (their checksums tell) they are replaced.
[[nodiscard]] IngestReport ingest_file(store::Store& store,
                                       const ingest::ProductCatalogue& products,
                                       const std::filesystem::path& file,
                                       const ingest::IngestOptions& options, UtcTime now,
                                       const ingest::Progress& progress);

/// The same for a file of a stranger, which is read in a confined process of its own
/// (ingest/apart/read_apart.h): one that crashes the library that reads it, or reads for ever, or
/// wants all memory, is one Error(invalid_input) that names it. SQLite's log is left for the caller
/// to bring in: open and close the store once all files are read.
///
/// No connection to any store may be open here, and no thread alive, when this is called.
///
/// @throws what `ingest_file` throws; Error(unavailable) where the reader was ended from outside
[[nodiscard]] IngestReport ingest_file_apart(const std::filesystem::path& store_folder,
                                             const ingest::ProductCatalogue& products,
                                             const std::filesystem::path& file,
                                             const ingest::IngestOptions& options, UtcTime now,
                                             const ingest::Progress& progress);

/// The files that a command line names: a folder stands for every .nc, .grib, .grib2, .grb, .grb2
/// and .nc4 file below it, sorted, but for what is hidden. Throws Error(not_found) for a path that
/// is not there, or a folder without such files.
[[nodiscard]] std::vector<std::filesystem::path> product_files(
    const std::vector<std::filesystem::path>& paths);

}  // namespace slackwater::api
