#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "fields/base/time.h"
#include "ingest/cf/trajectory_table.h"

namespace slackwater::ingest {

/// Tracks of several things over one axis of time, as CF has them (featureType trajectory).
struct TrajectoryFile {
  struct Variable {
    std::string name;
    std::string standard_name;  ///< empty: CF has none
    std::string units;
    std::string long_name;
    std::size_t per = 1;         ///< values of each thing at each time, e.g. of its thrusters
    std::vector<double> values;  ///< thing x time x per; NaN: none
  };
  std::vector<std::string> names;  ///< of the things
  UtcTime epoch;
  std::vector<double> t_s;  ///< since the epoch, ascending
  std::vector<Variable> variables;
  std::vector<TrajectoryTable>
      tables;  ///< lists beside the tracks; one without rows is not written
  std::vector<std::pair<std::string, std::string>> attributes;  ///< of the file, in their order

  /// Nothing where the file does not say.
  [[nodiscard]] std::string attribute(std::string_view name) const;
  [[nodiscard]] const Variable* find(std::string_view name) const noexcept;
  [[nodiscard]] const TrajectoryTable* find_table(std::string_view name) const noexcept;
};

/// Writes netCDF-4; the same content is the same bytes, whenever and wherever it is written. The
/// name of the file is not in it.
/// @throws Error(unavailable) where it cannot be written; ContractViolation for arrays of another
/// length
void write_trajectories(const TrajectoryFile& tracks, const std::filesystem::path& file);

/// Reads what `write_trajectories` wrote. @throws Error(not_found), Error(invalid_input)
[[nodiscard]] TrajectoryFile read_trajectories(const std::filesystem::path& file);

}  // namespace slackwater::ingest
