#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fields/grid/gridded_field.h"
#include "ingest/cf/axis_order.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

enum class AxisKind { time, vertical, latitude, longitude, other };

/// What a coordinate variable counts: its standard name decides, then its units, its axis
/// attribute, its name.
[[nodiscard]] AxisKind axis_kind(const netcdf::Variable& coordinate, const Product& product);

/// One axis of a data variable: a coordinate variable, and the place of its dimension (none for a
/// scalar coordinate).
struct BoundAxis {
  const netcdf::Variable* coordinate = nullptr;
  std::optional<std::size_t> dimension;
};

/// A data variable with its axes found.
struct BoundVariable {
  const netcdf::Variable* variable = nullptr;
  const Quantity* quantity = nullptr;
  BoundAxis time;      ///< no coordinate: static
  BoundAxis vertical;  ///< no coordinate: see `AxesOf`
  BoundAxis latitude;
  BoundAxis longitude;
};

/// Finds the axes of a variable, in any dimension order, scalar coordinates included. Dimensions of
/// length 1 without meaning are passed over. Throws Error(invalid_input) where the grid is not one
/// of latitude and longitude (curvilinear, projected, rotated), where a dimension has no
/// coordinate, or is one we do not know.
[[nodiscard]] BoundVariable bind_axes(const netcdf::File& file, const netcdf::Variable& variable,
                                      const Quantity& quantity, const Product& product);

/// Refuses a file on terrain-following levels, naming them.
void refuse_terrain_following(const netcdf::File& file);

/// The levels of a bound variable: kind, metres (ascending, depth positive down, height positive
/// up) and their places.
struct LevelAxis {
  VerticalKind kind = VerticalKind::none;
  AxisOrder order;  ///< empty for VerticalKind::none
};
[[nodiscard]] LevelAxis levels_of(const netcdf::File& file, const BoundVariable& bound,
                                  const Product& product, std::vector<std::string>& warnings);

/// The numbers of a coordinate variable, unpacked, in `unit`; missing ones are NaN.
[[nodiscard]] std::vector<double> coordinate_values(const netcdf::File& file,
                                                    const netcdf::Variable& coordinate,
                                                    const Product& product, std::string_view unit);

}  // namespace slackwater::ingest
