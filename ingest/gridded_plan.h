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
  /// Cells (level, row, column) whose exact zeros are no values (ingest/zeros_for_land.h); empty:
  /// none.
  std::vector<bool> no_values{};
};

/// Variables that share a grid; means over the members of an ensemble stand apart.
struct PlannedGroup {
  Grid grid;
  bool is_ensemble_mean = false;
  std::vector<PlannedVariable> variables;
};

/// Finds what to take from a file: the wanted variables, their axes, cut and packing, grouped by
/// grid. What is a statistic of its quantity (`statistic_in`) is left out with a warning.
/// Throws Error(invalid_input) where there is nothing for us, or something that cannot be
/// read correctly.
[[nodiscard]] std::vector<PlannedGroup> plan_gridded(const netcdf::File& file,
                                                     const ProductCatalogue& products,
                                                     const Product& product,
                                                     const IngestOptions& options,
                                                     std::vector<std::string>& warnings);

}  // namespace slackwater::ingest
