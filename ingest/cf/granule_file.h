#pragma once
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fields/grid/granule.h"

namespace slackwater::ingest {

/// Writes the canonical content file of a granule, block by block: NetCDF-4, CF-1.8, dims (time,
/// level, latitude, longitude) with absent dims left out, float values in canonical units, NaN
/// written as _FillValue. Memory is bounded by the block, not by the granule.
class GranuleWriter {
 public:
  /// How many times and rows a block should hold so that each chunk of the file is written once,
  /// whole.
  struct Block {
    std::size_t times = 1;
    std::size_t rows = 1;
  };

  GranuleWriter(const std::filesystem::path& file, const Granule& granule);
  ~GranuleWriter();
  [[nodiscard]] Block block() const noexcept;
  /// Values of `variable` (index into granule.variables) for times [first_time, first_time + n),
  /// all levels, rows [first_row, first_row + rows) and all columns. Chunks of nothing but NaN are
  /// not written at all: readers get the fill value, and the file stays small where a product is
  /// mostly land.
  void put(std::size_t variable, std::size_t first_time, std::size_t times, std::size_t first_row,
           std::size_t rows, std::span<const float> values);
  /// Status of all levels, rows and columns of these times; for variables with `has_status`.
  void put_status(std::size_t variable, std::size_t first_time, std::size_t times,
                  std::span<const SampleStatus> status);
  /// Flushes, fsyncs and closes.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads a content file back. The round trip is exact for values (float), axes and metadata.
class GranuleFile {
 public:
  [[nodiscard]] static GranuleFile open(const std::filesystem::path& file);
  ~GranuleFile();
  GranuleFile(GranuleFile&&) noexcept;

  [[nodiscard]] const Granule& granule() const noexcept;
  /// A block, with its status where the variable has one: times [first_time, first_time + times),
  /// all levels, rows and columns as given.
  [[nodiscard]] GriddedField read(std::string_view standard_name, std::size_t first_time,
                                  std::size_t times, std::size_t first_row, std::size_t rows,
                                  std::size_t first_column, std::size_t columns) const;

 private:
  struct State;
  explicit GranuleFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace slackwater::ingest
