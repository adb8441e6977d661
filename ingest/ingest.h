#pragma once
#include <filesystem>

#include "ingest/decoded/ingested.h"

namespace slackwater::ingest {

/// Decodes one product file (NetCDF by content, GRIB by its magic) into canonical granules. Peak
/// memory is bounded (< 256 MB) whatever the file size. Refuses (Error invalid_input) what it
/// cannot read correctly, saying what was found, what was expected and what to do.
[[nodiscard]] Ingested decode_file(const std::filesystem::path& file,
                                   const ProductCatalogue& products, const IngestOptions& options,
                                   const std::filesystem::path& staging_folder,
                                   const Progress& progress = {});

}  // namespace slackwater::ingest
