#pragma once
#include <cstddef>
#include <filesystem>

#include "fields/service/snapshot.h"

namespace slackwater::ingest {

/// Members are kept to a multiple of this, so that they deflate: an error of at most 0.061 mm/s.
inline constexpr double member_step_m_s = 1.0 / 8192;
/// The same for the wind of members: at most 0.49 mm/s.
inline constexpr double wind_member_step_m_s = 1.0 / 1024;

/// A member's velocity as the file holds it: each component a float, rounded to a multiple of a
/// step.
[[nodiscard]] Horizontal as_filed(Horizontal member_m_s, double step_m_s) noexcept;
/// A forecast as `read_forecast` would read it back: its members rounded so.
[[nodiscard]] Snapshot as_filed(Snapshot forecast);

/// Writes an issued forecast as one CF-1.8 NetCDF-4 file, fsynced.
///
/// Exactly one variable per component has the dimensions (time, depth) — (time, depth, column) for
/// several columns — and the standard name eastward_/northward_sea_water_velocity: member 0.
/// Quantiles stand beside it as `…_p10/_p50/_p90`, members 1, 2, … as `…_member` over (time,
/// depth[, column], realization), wind and waves over (time[, column]). A single column is a CF
/// timeSeriesProfile station. Missing values are _FillValue with a status variable beside them,
/// never zero. Doubles, so that the round trip is exact, but for the members: floats rounded to
/// `member_step_m_s`, deflated.
///
/// Broken sizes (a member array that does not hold `members - 1` blocks), members without a number
/// and a snapshot without a wind policy are a ContractViolation.
void write_forecast(const std::filesystem::path& file, const Snapshot& snapshot);

/// Whether `read_forecast` brings the members along or leaves them in the file.
enum class Members { all, none };

/// Reads a file of `write_forecast` back, the same to the bit but for the members' rounding. A file
/// from before there were members is a forecast of one. Throws Error(invalid_input) for anything
/// else.
[[nodiscard]] Snapshot read_forecast(const std::filesystem::path& file,
                                     Members members = Members::all);

/// Adds the members of one column to a snapshot that was read from this file without them. Nothing
/// where the file holds none. Throws as `read_forecast` does.
void read_members(const std::filesystem::path& file, Snapshot& snapshot, std::size_t column);

}  // namespace slackwater::ingest
