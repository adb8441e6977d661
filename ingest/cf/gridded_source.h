#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ingest/cf/axes.h"
#include "ingest/cf/axis_order.h"
#include "ingest/cf/packing.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// One variable of a product file, read block by block in canonical order (time, level, latitude,
/// longitude) and canonical units, whatever the order of the file.
class GriddedSource {
 public:
  /// The file must outlive the source.
  GriddedSource(const netcdf::File& file, const BoundVariable& bound, AxisOrder levels,
                AxisOrder rows, AxisOrder columns, const Packing& packing);

  [[nodiscard]] std::size_t levels() const noexcept {
    return levels_.values.empty() ? 1 : levels_.values.size();
  }
  /// Times [first_time, +times) of the file, all levels, canonical rows [first_row, +rows), all
  /// columns; NaN where missing. `out` holds times * levels * rows * columns values.
  void read(std::size_t first_time, std::size_t times, std::size_t first_row, std::size_t rows,
            std::span<float> out, DecodeCounts& counts);

 private:
  struct Part;
  void read_part(const Part& part, std::span<float> out, DecodeCounts& counts);
  void read_raw(std::span<const std::size_t> start, std::span<const std::size_t> count,
                std::span<float> out, DecodeCounts& counts);

  const netcdf::File* file_;
  const netcdf::Variable* variable_;
  std::optional<std::size_t> time_dimension_, level_dimension_, row_dimension_, column_dimension_;
  AxisOrder levels_, rows_, columns_;
  Packing packing_;
  std::vector<float> piece_;  ///< a part in the order of the file, reused
  std::vector<double> wide_;  ///< raw values that need a double, reused
};

}  // namespace slackwater::ingest
