#include "ingest/cf/granule_layout.h"

#include <algorithm>

namespace slackwater::ingest {
namespace {

/// Chunks of about 16 cells that share the axis evenly: the last one is stored whole, cells or not.
std::size_t even_chunk(std::size_t cells) {
  constexpr std::size_t about = 16;
  const std::size_t chunks = cells <= 3 * about / 2 ? 1 : (cells + about - 1) / about;
  return (cells + chunks - 1) / chunks;
}

}  // namespace

GranuleLayout GranuleLayout::of(const Grid& grid) {
  GranuleLayout layout;
  layout.has_time = !grid.time.empty();
  layout.has_level = grid.vertical != VerticalKind::none;
  layout.times = grid.times();
  layout.levels = grid.levels();
  layout.rows = grid.rows();
  layout.columns = grid.columns();
  // A column is read for a day at a time: one chunk holds all levels of a small patch for up to 24
  // stamps.
  layout.chunk_rows = even_chunk(layout.rows);
  layout.chunk_columns = even_chunk(layout.columns);
  const std::size_t patch =
      layout.levels * layout.chunk_rows * layout.chunk_columns * sizeof(float);
  // A series at one place is small: as many stamps in a chunk as it takes.
  const std::size_t most_times = layout.rows * layout.columns == 1 ? layout.times : 24;
  layout.chunk_times =
      std::clamp<std::size_t>(chunk_bytes / patch, 1, std::min(most_times, layout.times));
  // The decoder holds whole rows of all columns: shorten the chunk in time where that would be too
  // much.
  const std::size_t row_band = layout.levels * layout.chunk_rows * layout.columns * sizeof(float);
  layout.chunk_times =
      std::min(layout.chunk_times, std::max<std::size_t>(1, block_bytes / row_band));
  return layout;
}

std::vector<std::size_t> GranuleLayout::present(const std::array<std::size_t, 4>& counts) const {
  std::vector<std::size_t> kept;
  if (has_time) kept.push_back(counts[0]);
  if (has_level) kept.push_back(counts[1]);
  kept.push_back(counts[2]);
  kept.push_back(counts[3]);
  return kept;
}

std::vector<std::size_t> GranuleLayout::chunks() const {
  return present({chunk_times, levels, chunk_rows, chunk_columns});
}

std::string level_name(VerticalKind kind) {
  return kind == VerticalKind::height_m ? "height" : "depth";
}

}  // namespace slackwater::ingest
