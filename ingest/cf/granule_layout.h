#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "fields/grid/granule.h"

namespace slackwater::ingest {

/// How a granule lies in its content file: which of the four canonical dimensions exist, and the
/// chunk that one write fills.
struct GranuleLayout {
  static constexpr std::size_t chunk_bytes = std::size_t{1}
                                             << 20;  ///< a chunk is at most about this
  static constexpr std::size_t block_bytes = std::size_t{4}
                                             << 20;  ///< a block that the decoder holds

  bool has_time = false;
  bool has_level = false;
  std::size_t times = 1, levels = 1, rows = 1, columns = 1;
  std::size_t chunk_times = 1, chunk_rows = 1, chunk_columns = 1;

  [[nodiscard]] static GranuleLayout of(const Grid& grid);
  /// The four counts (time, level, row, column) without the dimensions that the file leaves out.
  [[nodiscard]] std::vector<std::size_t> present(const std::array<std::size_t, 4>& counts) const;
  [[nodiscard]] std::vector<std::size_t> chunks() const;
};

/// The names of the vertical coordinate in the file: "depth" or "height".
[[nodiscard]] std::string level_name(VerticalKind kind);

}  // namespace slackwater::ingest
