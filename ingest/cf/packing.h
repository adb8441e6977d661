#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "fields/base/constants.h"
#include "ingest/cf/units.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// What became of the values that were decoded.
struct DecodeCounts {
  std::size_t values = 0;   ///< that stand
  std::size_t missing = 0;  ///< fill, missing_value, NaN, outside valid_min/valid_max
  std::size_t gross = 0;    ///< outside the gross range of the quantity: taken as missing, and told
};

/// From the numbers in a file to canonical values: fill and missing values, valid range, unsigned
/// integers, scale and offset, unit.
///
///   value = unit.scale * (raw * scale_factor + add_offset) + unit.offset
///
/// `_FillValue` and `missing_value` both count, and the library's default fill where a file names
/// none. valid_min, valid_max and valid_range are compared in packed space unless their type says
/// that they are unpacked. Source: CF conventions 1.11, sections 2.5.1 and 8.1; NetCDF User's
/// Guide, attribute conventions.
class Packing {
 public:
  /// Throws Error(invalid_input) for a scale factor that is 0 or not finite.
  [[nodiscard]] static Packing of(const netcdf::Variable& variable,
                                  std::vector<std::string>& warnings);

  /// Puts the conversion to the canonical unit behind the unpacking.
  void convert(const UnitConversion& unit) noexcept;
  /// Values outside become missing.
  void set_gross_range(const Range& range) noexcept { gross_ = range; }
  /// Heights become depths, and only what lies below zero stays (bathymetry).
  void negate() noexcept;
  void keep_only_positive() noexcept { only_positive_ = true; }

  /// Whether raw values need a double to be read exactly.
  [[nodiscard]] bool is_wide() const noexcept { return wide_; }
  /// Raw values to canonical ones, NaN where missing; `out` may be the same memory as a float
  /// `raw`.
  void decode(std::span<const float> raw, std::span<float> out,
              DecodeCounts& counts) const noexcept;
  void decode(std::span<const double> raw, std::span<float> out,
              DecodeCounts& counts) const noexcept;
  /// One coordinate value: valid range ignored (it often describes the whole product, not the cut).
  [[nodiscard]] double coordinate(double raw) const noexcept;

 private:
  template <typename Raw>
  void decode_as(std::span<const Raw> raw, std::span<float> out,
                 DecodeCounts& counts) const noexcept;

  double scale_ = 1.0;
  double offset_ = 0.0;
  bool wide_ = false;
  double unsigned_turn_ = 0.0;  ///< added to negative raw values
  std::array<double, 3> missing_{constants::nan, constants::nan, constants::nan};
  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = std::numeric_limits<double>::infinity();
  Range gross_;
  bool only_positive_ = false;
};

}  // namespace slackwater::ingest
