#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ingest/insitu/station.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// Whether a coordinate holds depths below the surface: by standard name, else by name; never where
/// it says that it counts upwards.
[[nodiscard]] bool is_depth_coordinate(const netcdf::Variable& variable);

/// Whether a coordinate counts upwards from the sea bed: its standard name, its `reference_datum`,
/// or words of its name say so.
[[nodiscard]] bool counts_from_bed(const netcdf::Variable& variable);

/// The one level that a series of one level states for itself: the vertical coordinate among those
/// in its `coordinates` that has one value, or one for each station; else a depth that the file
/// gives for each station. Null where there is none.
[[nodiscard]] const netcdf::Variable* own_vertical(const netcdf::File& file,
                                                   const StationAxes& axes,
                                                   const netcdf::Variable& variable);

/// The value of such a coordinate at a station, metres, as it counts.
[[nodiscard]] double own_level_m(const netcdf::File& file, const StationAxes& axes,
                                 const netcdf::Variable& coordinate, std::size_t station,
                                 std::vector<std::string>& warnings);

/// Depths (metres below the surface) of a current's levels from their coordinate as it stands in
/// the file. Turned where the file counts upwards from the surface, or from the bed (which needs
/// the water depth). Two slips are mended with a warning: depths that are all negative, and
/// positive heights that only the bed can be the foot of.
/// Throws Error(invalid_input) for heights above a bed of unknown depth.
[[nodiscard]] std::vector<double> depths_of(const netcdf::Variable& coordinate,
                                            std::vector<double> levels_m,
                                            const std::optional<double>& water_depth_m,
                                            std::vector<std::string>& warnings);

}  // namespace slackwater::ingest
