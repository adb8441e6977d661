#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/grid/gridded_field.h"
#include "ingest/insitu/series_values.h"
#include "ingest/insitu/station.h"

namespace slackwater::ingest {

/// Where the levels of a series are.
struct SeriesLevels {
  VerticalKind kind = VerticalKind::none;
  std::vector<double> levels_m;  ///< one for each level of the series, in file order
  /// From which distance on a current profiler hears the bed or the surface beside its main beam;
  /// nothing where the levels are no bins of a profiler or the file does not say enough.
  std::vector<bool> side_lobe;  ///< empty, or one for each level
};

/// Finds the levels of a series, by what the file gives:
///
/// - depth, perhaps a little different each time: its median over time;
/// - height above the sea bed: the water depth that the file states, less it;
/// - height above an upward-looking sensor: the median over time of DEPTH(t) - height;
/// - distance along the axis of a profiler: sensor depth +- distance, as it looks;
/// - nothing, a single sensor: its `sensor_depth`, else the scalar coordinate that its
///   `coordinates` name, or that of its station, else the scalar or median depth of the file.
///
/// The vertical axis of a granule is fixed, so a median stands for depths that move; a warning says
/// by how much where the middle nine tenths of them span more than half a bin. A profiler whose
/// orientation would put most of its bins into the air looks the other way than it says: that is
/// corrected, with a warning. A negative sensor depth is a height (wind). Wave and other surface
/// quantities have no levels.
///
/// Side lobes: a beam tilted by the angle a hears the boundary at range R already at R cos a; the
/// stretch that one value averages (a bin and a pulse) must lie before that (Teledyne RD
/// Instruments, ADCP Principles of Operation).
///
/// Throws Error(invalid_input) where a current's depth cannot be found.
[[nodiscard]] SeriesLevels levels_of_series(const netcdf::File& file, const StationAxes& axes,
                                            const SeriesValues& series,
                                            std::string_view level_dimension, std::size_t station,
                                            const std::optional<double>& water_depth_m,
                                            const std::optional<double>& default_height_m,
                                            std::vector<std::string>& warnings);

}  // namespace slackwater::ingest
