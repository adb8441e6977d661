#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fields/service/snapshot.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/netcdf/file.h"

/// The part of a forecast file that holds its members, shared by writer and reader.
namespace slackwater::ingest {

/// One component of a quantity that has members.
struct MemberVariable {
  const char* standard_name;  ///< as that of member 0
  const char* long_name;
  std::vector<Horizontal> ForecastColumn::*values;
  bool north;
  bool on_depth;
  double step_m_s;  ///< the file holds multiples of this

  [[nodiscard]] std::string name() const { return std::string(standard_name) + "_member"; }
  [[nodiscard]] std::size_t levels(const Snapshot& s) const {
    return on_depth ? s.depth_m.size() : 1;
  }
  /// Whether the forecast says anything at this time (and depth) of the column.
  [[nodiscard]] bool is_there(const ForecastColumn& column, std::size_t cell) const {
    return !on_depth || has_value(column.current_status[cell]);
  }
};

inline constexpr std::array member_variables{
    MemberVariable{"eastward_sea_water_velocity", "eastward current, members 1 and up, Eulerian",
                   &ForecastColumn::member_m_s, false, true, member_step_m_s},
    MemberVariable{"northward_sea_water_velocity", "northward current, members 1 and up, Eulerian",
                   &ForecastColumn::member_m_s, true, true, member_step_m_s},
    MemberVariable{"eastward_wind", "eastward wind at 10 m, members 1 and up",
                   &ForecastColumn::wind_member_m_s, false, false, wind_member_step_m_s},
    MemberVariable{"northward_wind", "northward wind at 10 m, members 1 and up",
                   &ForecastColumn::wind_member_m_s, true, false, wind_member_step_m_s},
};

/// Writes the members of a snapshot into a file under definition; does nothing for a forecast
/// without an ensemble.
class MemberWriter {
 public:
  MemberWriter(netcdf::Writer& out, const Snapshot& snapshot) : out_(out), s_(snapshot) {}
  /// Dimension and coordinate `realization`, and the variables. `column` only for several columns.
  void define(int time, int depth, std::optional<int> column);
  void write();

 private:
  [[nodiscard]] bool has(const MemberVariable& variable) const;
  void define(const MemberVariable& variable, const std::vector<int>& dimensions);
  void write(const MemberVariable& variable, int id);
  [[nodiscard]] std::vector<float> block(const MemberVariable& variable, std::size_t first,
                                         std::size_t columns) const;
  /// Columns that share a chunk, which holds all their times, levels and members.
  [[nodiscard]] std::size_t columns_per_chunk(const MemberVariable& variable) const;

  void define_numbers(int realization, std::optional<int> column);
  void write_numbers();

  netcdf::Writer& out_;
  const Snapshot& s_;
  int realization_id_ = -1;
  int number_id_ = -1;  ///< of the weather ensemble's members that drive ours
  bool many_ = false;
  std::vector<std::pair<MemberVariable, int>> variables_;
};

/// Throws Error(invalid_input): what was found in the file, and what to do.
[[noreturn]] void refuse_forecast(const netcdf::File& file, const std::string& what);

/// How many members a forecast file holds, the central one among them; 1 without an ensemble.
[[nodiscard]] std::size_t count_members(const netcdf::File& file);

/// What stands for the number of a member that no weather ensemble drives.
inline constexpr int no_wind_member = -1;

/// Reads the members of `count` columns from `first` on into a snapshot that has everything else.
void read_members(const netcdf::File& file, Snapshot& snapshot, std::size_t first,
                  std::size_t count);

}  // namespace slackwater::ingest
