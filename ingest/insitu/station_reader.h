#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ingest/copernicus/product_catalogue.h"
#include "ingest/insitu/series_granule.h"
#include "ingest/insitu/station.h"

namespace slackwater::ingest {

/// A variable that we take, as the quantity it is.
struct Wanted {
  const netcdf::Variable* variable;
  std::string standard_name;
  const Quantity* quantity;  ///< null for a speed or a direction
};

/// The variables over time that hold a quantity of the vocabulary, or the speed or direction of a
/// vector. What is a statistic of it (`statistic_in`) goes to `left_out`, by name and reason.
[[nodiscard]] std::vector<Wanted> wanted_in(const netcdf::File& file, const StationAxes& axes,
                                            const ProductCatalogue& products,
                                            const Product& product,
                                            std::vector<std::string>& left_out);

/// Reads what is wanted at one station, makes vectors of speeds and directions and finds the levels
/// of each.
[[nodiscard]] std::vector<PlacedSeries> read_station(
    const netcdf::File& file, const StationAxes& axes, const ProductCatalogue& products,
    const std::vector<Wanted>& wanted, std::size_t station,
    const std::optional<double>& water_depth_m, std::vector<std::string>& warnings);

}  // namespace slackwater::ingest
