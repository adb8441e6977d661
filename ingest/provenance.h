#pragma once
#include <optional>
#include <string>

#include "fields/base/time.h"
#include "ingest/copernicus/product.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// The reference (issue) time that a file states: a scalar forecast_reference_time, else the first
/// of the product's trusted global attributes that holds a date. Nothing where it states none.
[[nodiscard]] std::optional<UtcTime> stated_reference_time(const netcdf::File& file,
                                                           const Product& product);

/// The Copernicus dataset id a file names anywhere in its global attributes ("cmems_mod_...");
/// empty if none.
[[nodiscard]] std::string stated_dataset_id(const netcdf::File& file);

}  // namespace slackwater::ingest
