#pragma once
#include <memory>
#include <string>
#include <vector>

#include "fields/grid/granule.h"
#include "ingest/cf/gridded_source.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/decoded/ingested.h"

namespace slackwater::ingest {

/// One variable to decode, and the Stokes drift to take off it where the file holds that.
struct PlannedVariable {
  GranuleVariable description;
  std::unique_ptr<GriddedSource> source;
  std::unique_ptr<GriddedSource> stokes;  ///< null: nothing to subtract
};

/// Variables that share a grid.
struct PlannedGroup {
  Grid grid;
  std::vector<PlannedVariable> variables;
};

/// Finds what to take from a file: the wanted variables, their axes, cut and packing, grouped by
/// grid. Throws Error(invalid_input) where there is nothing for us, or something that cannot be
/// read correctly.
[[nodiscard]] std::vector<PlannedGroup> plan_gridded(const netcdf::File& file,
                                                     const ProductCatalogue& products,
                                                     const Product& product,
                                                     const IngestOptions& options,
                                                     std::vector<std::string>& warnings);

}  // namespace slackwater::ingest
