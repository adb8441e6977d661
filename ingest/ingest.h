#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fields/grid/granule.h"

namespace slackwater::ingest {

class ProductCatalogue;  // ingest/copernicus/product_catalogue.h: the descriptors of data/products

/// What the operator said about a file; what the file says itself yields to it.
struct IngestOptions {
  std::optional<BoundingBox> cut;  ///< keep only cells inside, and one cell around
  std::optional<DataStatus> as;    ///< `--as analysis|forecast`
  std::optional<UtcTime> issued;   ///< `--issued T`
};

/// A granule decoded to its content file, which lies in the staging folder, written and fsynced.
struct DecodedGranule {
  Granule granule;
  std::filesystem::path content_file;
};

/// A file's granules with the warnings that an operator should read. Nothing is kept if an Error is thrown.
struct Ingested {
  std::vector<DecodedGranule> granules;
  std::vector<std::string> warnings;
};

/// Called with a share of the work done in [0, 1].
using Progress = std::function<void(double)>;

/// Decodes one product file (NetCDF by content, GRIB by its magic) into canonical granules. Peak memory is bounded
/// (< 256 MB) whatever the file size. Refuses (Error invalid_input) what it cannot read correctly, saying what was
/// found, what was expected and what to do.
[[nodiscard]] Ingested decode_file(const std::filesystem::path& file,
                                   const ProductCatalogue& products, const IngestOptions& options,
                                   const std::filesystem::path& staging_folder,
                                   const Progress& progress = {});

}  // namespace slackwater::ingest
