#pragma once
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/decoded/ingested.h"
#include "ingest/netcdf/file.h"

// What a descriptor says of a file, and what the file says itself.

namespace slackwater::ingest {

/// The descriptor of a file: the operator's, else the catalogue's.
/// @throws Error(invalid_input) where the file names another product than the operator
[[nodiscard]] const Product& product_for(const netcdf::File& file, const ProductCatalogue& products,
                                         const IngestOptions& options);

/// Fills in the attributes that the file forgets and its descriptor settles, for all that reads the
/// file afterwards.
/// @throws Error(invalid_input) where the file itself says something else: another unit (the same
///         one in other words is none), direction, standard name or quantity
void settle(netcdf::File& file, const Product& product, const Vocabulary& vocabulary);

/// What to do about an attribute that is missing: the end of a refusal.
inline constexpr const char* say_so =
    "; or say it yourself: ingest --product FILE.yaml (api/docs/adding_a_product.md)";

}  // namespace slackwater::ingest
