#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace slackwater {

/// Why a value is, or is not, there. A missing value is a status, never a silent zero.
enum class SampleStatus : std::uint8_t {
  ok = 0,
  missing = 1,    ///< the product has no value here though it is water
  land = 2,       ///< masked at all times at the surface
  below_bed = 3,  ///< masked at all times at this depth, water above
  outside_area = 4,
  outside_time = 5,
  above_surface = 6,
  not_checked = 7,  ///< a value, but nobody has checked it (QC flag "no QC performed")
  suspect = 8,      ///< rejected: bad QC flag, gross range or spike
  carried = 9,      ///< a value of higher up, where the product has no water (see `bed_rule.h`)
};
inline constexpr std::size_t sample_status_count = 10;

/// Whether a number stands behind this status (ok, not_checked or carried).
[[nodiscard]] constexpr bool has_value(SampleStatus status) noexcept {
  return status == SampleStatus::ok || status == SampleStatus::not_checked ||
         status == SampleStatus::carried;
}
[[nodiscard]] std::string_view name_of(SampleStatus status) noexcept;

/// Where a value came from in time: "Status of a file" in fields/docs/conventions.md.
enum class DataStatus : std::uint8_t {
  analysis = 0,
  forecast = 1,  ///< a provider's forecast, with a reference time
  observation = 2,
  persisted = 3,  ///< ours: the last known value carried forward
  modelled = 4,   ///< ours: growth law or current model
};
[[nodiscard]] std::string_view name_of(DataStatus status) noexcept;
[[nodiscard]] std::optional<DataStatus> data_status_from(std::string_view name) noexcept;

}  // namespace slackwater
