#pragma once
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "ingest/copernicus/product.h"
#include "ingest/copernicus/vocabulary.h"

namespace slackwater::ingest {

/// The vocabulary and the product descriptors of `data/products`. Immutable once loaded.
class ProductCatalogue {
 public:
  /// Reads `variables.yaml` and every other `*.yaml` of the folder. Throws Error(not_found) without
  /// the folder, Error(invalid_input) for an unknown key, a value out of range, a product named
  /// twice.
  /// @param more  folders of further descriptors, e.g. the user's; among descriptors of one
  ///              `match_order` theirs are tried first
  [[nodiscard]] static ProductCatalogue load(const std::filesystem::path& products_folder,
                                             std::span<const std::filesystem::path> more = {});
  /// Reads one descriptor that is not in the catalogue, under the same rules.
  [[nodiscard]] Product describe(const std::filesystem::path& file) const;

  [[nodiscard]] const Vocabulary& vocabulary() const noexcept { return vocabulary_; }
  /// The descriptors in the order they are tried; the last one is "cf", which matches any file.
  [[nodiscard]] const std::vector<Product>& products() const noexcept { return products_; }
  /// The first descriptor that matches.
  [[nodiscard]] const Product& product_of(const netcdf::File& file) const;
  /// By id, null if unknown.
  [[nodiscard]] const Product* find(std::string_view id) const noexcept;
  /// The quantity that a variable of this product holds, or null. The product's own table decides,
  /// then the file's standard name; the vocabulary's short names count only where the file gives no
  /// standard name, so that a known short name never hides a foreign quantity.
  [[nodiscard]] const Quantity* quantity_of(const netcdf::Variable& variable,
                                            const Product& product) const;
  /// Every dataset worth downloading, smallest priority first.
  [[nodiscard]] std::vector<Download> downloads() const;

 private:
  Vocabulary vocabulary_;
  std::vector<Product> products_;
};

}  // namespace slackwater::ingest
