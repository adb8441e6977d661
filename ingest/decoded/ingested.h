#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fields/grid/granule.h"

namespace slackwater::ingest {

class ProductCatalogue;  // ingest/copernicus/product_catalogue.h: the descriptors of data/products
struct Product;          // ingest/copernicus/product.h: one of them

/// The dataset of a granule that holds the mean over an ensemble's members: it is never taken for
/// the control or for a member.
inline constexpr const char* ensemble_mean_dataset = "ensemble_mean";

/// What the operator said about a file; what the file says itself yields to it.
struct IngestOptions {
  std::optional<BoundingBox> cut;  ///< keep only cells inside, and one cell around
  std::optional<DataStatus> as;    ///< `--as analysis|forecast`
  std::optional<UtcTime> issued;   ///< `--issued T`
  /// `--product FILE`: what the files are; null: the catalogue's choice. What a file says itself
  /// must not contradict it.
  std::shared_ptr<const Product> product{};
};

/// A granule decoded to its content file, which lies in the staging folder, written and fsynced.
struct DecodedGranule {
  Granule granule;
  std::filesystem::path content_file;
};

/// A file's granules with the warnings that an operator should read. Nothing is kept if an Error is
/// thrown.
struct Ingested {
  std::vector<DecodedGranule> granules;
  std::vector<std::string> warnings;
  /// When the provider published the file, where it says so (ingest/publication.h).
  std::optional<UtcTime> published{};
};

/// Called with a share of the work done in [0, 1].
using Progress = std::function<void(double)>;

}  // namespace slackwater::ingest
