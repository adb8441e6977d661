#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "data/store/store.h"
#include "fields/grid/gridded_field.h"

namespace slackwater::api {

/// Where a piece of data came from, as far as choosing between pieces needs it.
struct Origin {
  std::vector<std::int64_t> granules;  ///< one, or two where U and V came in separate files
  DataStatus status = DataStatus::analysis;
  std::optional<UtcTime> reference_time;  ///< of a provider's forecast
  std::string dataset;  ///< product/dataset/levels: pieces of one dataset may be joined
  std::string product_id;
  std::string attribution;
  std::vector<std::string> sources;  ///< sha256 of the product files
  int ensemble_member = 0;           ///< of a weather model; 0 is the control
  std::string station;               ///< platform of a point series
  bool contains_stokes = false;
  bool is_point_series = false;
  std::optional<double> water_depth_m;  ///< where the file of a point series states it
};

/// The two components of a vector on one grid, cut around a place.
struct VectorPiece {
  Origin origin;
  GriddedField east;
  GriddedField north;
};

/// A scalar on one grid, cut around a place.
struct ScalarPiece {
  Origin origin;
  GriddedField field;
};

/// The window of time and space that a command looks at.
struct Window {
  std::optional<UtcTime> from;  ///< absent for static fields
  std::optional<UtcTime> to;
  BoundingBox box;
};

/// Reads every stored piece of a vector (two CF standard names) that touches the window, in
/// catalogue order. Files are cut to the cells around the box; U and V of one product in separate
/// files are paired by their times and grid. Current series of one mooring come as one piece
/// (mooring.h).
[[nodiscard]] std::vector<VectorPiece> read_vector_pieces(store::Store& store,
                                                          const std::string& east_name,
                                                          const std::string& north_name,
                                                          const Window& window);

/// The same for scalars: pieces per name, each file opened once for all of them.
[[nodiscard]] std::vector<std::vector<ScalarPiece>> read_scalar_pieces(
    store::Store& store, const std::vector<std::string>& wanted, const Window& window);

}  // namespace slackwater::api
