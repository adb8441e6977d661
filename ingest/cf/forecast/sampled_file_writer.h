#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::ingest {

/// A data variable of a coverage.
struct CoverageVariable {
  std::string name;  ///< made fit for CF: other characters than letters, digits, _ become _
  std::string standard_name;  ///< "": none
  std::string long_name;
  std::string units;           ///< UDUNITS, "m s-1"
  std::vector<double> values;  ///< NaN: missing
};

/// How the points of a coverage lie, and with it the dimensions of its variables.
enum class CoverageLayout {
  stations,     ///< (station, time, depth or altitude): places that share times and levels
  grid,         ///< (time, depth, latitude, longitude)
  trajectories  ///< (obs), the vertices of one after those of the other
};

/// What a query has found, ready for a CF file. An empty `time` or `vertical_m`: no such axis.
struct SampledFile {
  CoverageLayout layout = CoverageLayout::stations;
  /// Stations: one each per station. Grid: its axes. Trajectories: one each per vertex.
  std::vector<double> longitude_deg;
  std::vector<double> latitude_deg;
  std::vector<double> vertical_m;    ///< trajectories: per vertex
  bool is_depth = true;              ///< vertical_m counts down from mean sea level, else up
  std::vector<UtcTime> time;         ///< trajectories: per vertex
  std::vector<std::string> names;    ///< of stations or trajectories, one each
  std::vector<std::size_t> lengths;  ///< of trajectories, in vertices
  std::vector<CoverageVariable> variables;
  std::optional<UtcTime> reference_time;  ///< forecast_reference_time
  /// Beside Conventions and featureType.
  std::vector<std::pair<std::string, std::string>> global_attributes;
};

/// Writes netCDF-4 after CF-1.8, discrete sampling geometries (chapter 9): timeSeriesProfile or
/// timeSeries for stations (a single one without the station dimension, H.18), contiguous ragged
/// arrays for trajectories (H.14). Stations without times are points or profiles without a time, of
/// which CF knows no feature type. Broken sizes are ContractViolations; Error(unavailable) where
/// the disk refuses.
void write_coverage(const std::filesystem::path& file, const SampledFile& coverage);

}  // namespace slackwater::ingest
