#pragma once
#include <optional>
#include <string>
#include <vector>

#include "data/store/store.h"
#include "fields/record/piece.h"

namespace slackwater::api {

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
