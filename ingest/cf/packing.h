#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
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
  std::size_t outside = 0;  ///< of the missing ones: outside valid_min/valid_max
  std::size_t gross = 0;    ///< outside the gross range of the quantity: taken as missing, and told
};

/// "'uo': 12 of 1800 values (0.7 %) lie outside the valid range that the file states …".
[[nodiscard]] std::string lost_by_limits(const std::string& variable, const DecodeCounts& counts);

/// From the numbers in a file to canonical values: fill and missing values, valid range, unsigned
/// integers, scale and offset, unit.
///
///   value = unit.scale * (raw * scale_factor + add_offset) + unit.offset
///
/// `_FillValue` and `missing_value` both count, and the library's default fill where a file names
/// none. valid_min, valid_max and valid_range of packed data are packed too where they have the
/// type of the data, else unpacked where they are no integers; since writers get this wrong, values
/// have the last word (`settle_limits`).
/// Source: CF conventions 1.11, sections 2.5.1 and 8.1; NetCDF User's Guide, attribute conventions.
class Packing {
 public:
  /// Throws Error(invalid_input) for a scale factor that is 0 or not finite.
  [[nodiscard]] static Packing of(const netcdf::Variable& variable,
                                  std::vector<std::string>& warnings);

  /// Whether the valid range can be meant in two ways, packed or unpacked.
  [[nodiscard]] bool has_two_readings() const noexcept { return other_.has_value(); }
  /// Takes the other reading of the valid range where the usual one would drop more than half of
  /// these raw values and the other less than a tenth; says so.
  void settle_limits(std::span<const double> raw, const std::string& variable,
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
  struct Limits {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
  };
  void read_limits(const netcdf::Variable& variable, std::vector<std::string>& warnings);
  template <typename Raw>
  void decode_as(std::span<const Raw> raw, std::span<float> out,
                 DecodeCounts& counts) const noexcept;

  double scale_ = 1.0;
  double offset_ = 0.0;
  bool wide_ = false;
  double unsigned_turn_ = 0.0;  ///< added to negative raw values
  std::array<double, 3> missing_{constants::nan, constants::nan, constants::nan};
  Limits limits_;                ///< in packed space
  std::optional<Limits> other_;  ///< the other way to read them
  bool other_is_packed_ = false;
  Range gross_;
  bool only_positive_ = false;
};

}  // namespace slackwater::ingest
