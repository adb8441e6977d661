#pragma once
#include <span>
#include <vector>

#include "ingest/cf/trajectory_table.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// Writes tables into a file of tracks: the variables when it is made, the numbers once the
/// definitions are over.
class TableWriter {
 public:
  /// @throws ContractViolation for columns of different length
  TableWriter(std::span<const TrajectoryTable> tables, netcdf::Writer& out);
  void write(netcdf::Writer& out) const;

 private:
  std::span<const TrajectoryTable> tables_;
  std::vector<int> ids_;  ///< in the order of the columns, texts behind
};

/// Whether a variable is a column of a table: over a dimension that is neither of tracks nor of
/// time.
[[nodiscard]] bool is_of_a_table(const netcdf::Variable& variable) noexcept;
/// Reads such a variable into its table, a new one where there is none yet.
void read_into(std::vector<TrajectoryTable>& tables, const netcdf::File& file,
               const netcdf::Variable& variable);

}  // namespace slackwater::ingest
