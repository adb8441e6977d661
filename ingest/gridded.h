#pragma once
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/decoded/ingested.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// Decodes a gridded product: one granule for each group of variables that share a grid and a
/// status. See `decode_file`, which opens the file and dispatches here.
[[nodiscard]] Ingested decode_gridded(const netcdf::File& file, const ProductCatalogue& products,
                                      const IngestOptions& options,
                                      const std::filesystem::path& staging_folder,
                                      const Progress& progress = {});

}  // namespace slackwater::ingest
