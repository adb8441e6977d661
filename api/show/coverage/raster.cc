#include "api/show/coverage/raster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slackwater::api {
namespace {

using StateAreas = std::array<double, patch_states>;

/// How much of [from, to) lies in each cell of an axis: (cell, metres).
struct Part {
  std::size_t cell = 0;
  double length_m = 0;
};
std::vector<Part> parts_of(double from_m, double to_m, double cell_m, std::size_t cells,
                           bool is_all_round) {
  std::vector<Part> parts;
  const auto first = static_cast<long>(std::floor(from_m / cell_m));
  const auto last = static_cast<long>(std::ceil(to_m / cell_m));
  const auto count = static_cast<long>(cells);
  for (long c = first; c < last; ++c) {
    const double here_m = static_cast<double>(c) * cell_m;
    const double length_m = std::min(to_m, here_m + cell_m) - std::max(from_m, here_m);
    if (length_m <= 1e-9 * cell_m || (!is_all_round && (c < 0 || c >= count))) continue;
    parts.push_back({static_cast<std::size_t>(((c % count) + count) % count), length_m});
  }
  return parts;
}

std::optional<PatchState> most_of(const StateAreas& areas, double cell_m2) {
  double all = 0;
  std::size_t most = 0;
  for (std::size_t s = 0; s < patch_states; ++s) {
    all += areas[s];
    if (areas[s] > areas[most]) most = s;
  }
  // Slivers of less than a third of a cell are its neighbours'.
  if (all < cell_m2 / 3) return std::nullopt;
  return static_cast<PatchState>(most);
}

}  // namespace

CoverageRaster raster_of(const InspectionCoverage& coverage, std::size_t most_columns,
                         std::size_t most_rows) {
  const CoverageSheet& sheet = coverage.sheet;
  CoverageRaster raster;
  const double cell_m = std::max(sheet.width_m / static_cast<double>(most_columns),
                                 sheet.height_m / static_cast<double>(most_rows));
  const auto cells_of = [&](double length_m, std::size_t most) {
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(length_m / cell_m - 1e-9)),
                                   std::min<std::size_t>(40, most), most);
  };
  raster.columns = cells_of(sheet.width_m, most_columns);
  raster.rows = cells_of(sheet.height_m, most_rows);
  raster.cell_width_m = sheet.width_m / static_cast<double>(raster.columns);
  raster.cell_height_m = sheet.height_m / static_cast<double>(raster.rows);
  std::vector<StateAreas> areas(raster.columns * raster.rows, StateAreas{});
  for (const CoveragePatch& patch : coverage.patches) {
    const auto along =
        parts_of(patch.along_m - patch.width_m / 2, patch.along_m + patch.width_m / 2,
                 raster.cell_width_m, raster.columns, sheet.is_all_round);
    const auto down = parts_of(patch.down_m - patch.height_m / 2, patch.down_m + patch.height_m / 2,
                               raster.cell_height_m, raster.rows, false);
    for (const Part& row : down)
      for (const Part& column : along)
        areas[row.cell * raster.columns + column.cell][static_cast<std::size_t>(patch.state)] +=
            row.length_m * column.length_m;
  }
  const double cell_m2 = raster.cell_width_m * raster.cell_height_m;
  for (const StateAreas& cell : areas) raster.cells.push_back(most_of(cell, cell_m2));
  return raster;
}

std::vector<CoverageRaster::Block> CoverageRaster::blocks() const {
  std::vector<Block> all;
  std::vector<bool> is_taken(cells.size(), false);
  const auto is_run = [&](const Block& run, std::size_t row) {
    for (std::size_t c = run.column; c < run.column + run.wide; ++c)
      if (is_taken[row * columns + c] || cells[row * columns + c] != run.state) return false;
    return true;
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (is_taken[i] || !cells[i]) continue;
    Block block{*cells[i], i % columns, i / columns, 1, 1};
    while (block.column + block.wide < columns && !is_taken[i + block.wide] &&
           cells[i + block.wide] == block.state)
      ++block.wide;
    while (block.row + block.high < rows && is_run(block, block.row + block.high)) ++block.high;
    for (std::size_t r = block.row; r < block.row + block.high; ++r)
      for (std::size_t c = block.column; c < block.column + block.wide; ++c)
        is_taken[r * columns + c] = true;
    all.push_back(block);
  }
  return all;
}

}  // namespace slackwater::api
