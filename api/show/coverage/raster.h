#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "api/show/coverage/view.h"

namespace slackwater::api {

/// A sheet in cells, so that a picture of it is no larger for a million patches than for a
/// thousand: a cell has the state of most of the area that lies in it.
struct CoverageRaster {
  std::size_t columns = 0;
  std::size_t rows = 0;
  double cell_width_m = 0;
  double cell_height_m = 0;
  std::vector<std::optional<PatchState>> cells;  ///< row by row; nothing: no surface there

  /// A rectangle of cells of one state.
  struct Block {
    PatchState state{};
    std::size_t column = 0;
    std::size_t row = 0;
    std::size_t wide = 0;
    std::size_t high = 0;
  };
  /// All that is there, in blocks: runs of a row, grown down as far as the rows below have the
  /// same.
  [[nodiscard]] std::vector<Block> blocks() const;
};

/// About square cells, at most so many along and down. Patches that stick out over an edge of a
/// sheet that goes all round come in again at the other. Cost: patches and the cells under them.
[[nodiscard]] CoverageRaster raster_of(const InspectionCoverage& coverage, std::size_t most_columns,
                                       std::size_t most_rows);

}  // namespace slackwater::api
