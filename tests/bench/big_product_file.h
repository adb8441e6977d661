#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

#include "fields/base/time.h"

namespace slackwater::bench {

/// A large uncompressed current product: `uo` and `vo` as float over (time, depth, latitude,
/// longitude), hourly, chunks of one time and 11 levels. Each value follows from its indices, so
/// that any of them can be checked later. Some of it is land, and some levels lie below the bed.
class BigProductFile {
 public:
  struct Shape {
    std::size_t times = 24;
    std::size_t levels = 33;
    std::size_t rows = 1000;
    std::size_t columns = 960;
    std::size_t chunk_levels = 11;
    std::size_t chunk_rows = 250;
    std::size_t chunk_columns = 240;
  };

  /// Describes the file; `write` makes it.
  BigProductFile(std::filesystem::path path, const Shape& shape);

  /// Writes the whole file, chunk row by chunk row (10 MB of memory with the default shape).
  void write() const;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] const Shape& shape() const noexcept { return shape_; }
  [[nodiscard]] UtcTime time(std::size_t t) const;
  /// Whole 32nds of a degree: the same number as float and as double.
  [[nodiscard]] static double latitude_deg(std::size_t j);
  [[nodiscard]] static double longitude_deg(std::size_t i);
  [[nodiscard]] static double level_m(std::size_t k);
  /// The stored value of component 0 (east) or 1 (north), m/s; NaN where there is none.
  [[nodiscard]] float value(std::size_t component, std::size_t t, std::size_t k, std::size_t j,
                            std::size_t i) const;

 private:
  std::filesystem::path path_;
  Shape shape_;
};

}  // namespace slackwater::bench
