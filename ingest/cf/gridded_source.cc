#include "ingest/cf/gridded_source.h"

#include <algorithm>

#include "fields/base/check.h"

namespace slackwater::ingest {

/// A box that is contiguous in the file, and where it goes in the block.
struct GriddedSource::Part {
  std::size_t first_time = 0, times = 1;
  AxisOrder::Run level, row, column;
  std::size_t block_first_row = 0, block_rows = 1;
};

GriddedSource::GriddedSource(const netcdf::File& file, const BoundVariable& bound, AxisOrder levels,
                             AxisOrder rows, AxisOrder columns, const Packing& packing)
    : file_(&file),
      variable_(bound.variable),
      time_dimension_(bound.time.dimension),
      level_dimension_(bound.vertical.dimension),
      row_dimension_(bound.latitude.dimension),
      column_dimension_(bound.longitude.dimension),
      levels_(std::move(levels)),
      rows_(std::move(rows)),
      columns_(std::move(columns)),
      packing_(packing) {
  // A surface quantity on a lone level, or a named height: that level is the first place of its
  // dimension.
  if (levels_.source.empty()) levels_ = {{0.0}, {0}};
}

void GriddedSource::read(std::size_t first_time, std::size_t times, std::size_t first_row,
                         std::size_t rows, std::span<float> out, DecodeCounts& counts) {
  expects(out.size() == times * levels() * rows * columns_.values.size(), "read: a whole block");
  for (const AxisOrder::Run& level : levels_.runs(0, levels_.values.size())) {
    for (const AxisOrder::Run& row : rows_.runs(first_row, rows)) {
      for (const AxisOrder::Run& column : columns_.runs(0, columns_.values.size())) {
        read_part({first_time, times, level, row, column, first_row, rows}, out, counts);
      }
    }
  }
}

void GriddedSource::read_raw(std::span<const std::size_t> start, std::span<const std::size_t> count,
                             std::span<float> out, DecodeCounts& counts) {
  if (packing_.is_wide()) {
    wide_.resize(out.size());
    file_->read(*variable_, start, count, std::span<double>(wide_));
    packing_.decode(wide_, out, counts);
  } else {
    file_->read(*variable_, start, count, out);
    packing_.decode(std::span<const float>(out), out, counts);
  }
}

void GriddedSource::read_part(const Part& part, std::span<float> out, DecodeCounts& counts) {
  const std::size_t rank = variable_->shape.size();
  std::vector<std::size_t> start(rank, 0);
  std::vector<std::size_t> count(rank, 1);
  const auto select = [&](const std::optional<std::size_t>& dimension, std::size_t first,
                          std::size_t n) {
    if (!dimension) return;
    start[*dimension] = first;
    count[*dimension] = n;
  };
  select(time_dimension_, part.first_time, part.times);
  select(level_dimension_, part.level.source_first, part.level.count);
  select(row_dimension_, part.row.source_first, part.row.count);
  select(column_dimension_, part.column.source_first, part.column.count);

  std::vector<std::size_t> stride(rank, 1);
  for (std::size_t d = rank; d-- > 1;) stride[d - 1] = stride[d] * count[d];
  const auto stride_of = [&](const std::optional<std::size_t>& dimension) {
    return dimension ? stride[*dimension] : 0;
  };
  const std::size_t values = part.times * part.level.count * part.row.count * part.column.count;
  const std::size_t columns = columns_.values.size();

  const bool in_order =
      (!time_dimension_ || !level_dimension_ || *time_dimension_ < *level_dimension_) &&
      stride_of(column_dimension_) <= 1 &&
      (!row_dimension_ || !column_dimension_ || *row_dimension_ < *column_dimension_) &&
      (!level_dimension_ || !row_dimension_ || *level_dimension_ < *row_dimension_) &&
      (!time_dimension_ || !row_dimension_ || *time_dimension_ < *row_dimension_);
  const bool straight = !part.level.reversed && !part.row.reversed && !part.column.reversed;
  if (in_order && straight && values == out.size()) {
    read_raw(start, count, out, counts);
    return;
  }
  piece_.resize(values);
  read_raw(start, count, piece_, counts);
  const auto place = [](const AxisOrder::Run& run, std::size_t i) {
    return run.reversed ? run.count - 1 - i : i;
  };
  for (std::size_t t = 0; t < part.times; ++t) {
    for (std::size_t k = 0; k < part.level.count; ++k) {
      for (std::size_t j = 0; j < part.row.count; ++j) {
        const std::size_t from = t * stride_of(time_dimension_) +
                                 place(part.level, k) * stride_of(level_dimension_) +
                                 place(part.row, j) * stride_of(row_dimension_);
        float* to = out.data() +
                    ((t * levels() + part.level.first + k) * part.block_rows + part.row.first + j -
                     part.block_first_row) *
                        columns +
                    part.column.first;
        const std::size_t step = stride_of(column_dimension_);
        for (std::size_t i = 0; i < part.column.count; ++i)
          to[i] = piece_[from + place(part.column, i) * step];
      }
    }
  }
}

}  // namespace slackwater::ingest
