#pragma once
#include <span>
#include <vector>

#include "twin/run/run_log.h"

namespace slackwater::twin {

/// What the vehicles' instruments showed, at the times of the run's log: how far off they took
/// themselves to be, and, where the scenario asks for it, the readings themselves. Columns only for
/// instruments that one of the vehicles has that the run begins with; NaN where a vehicle has none
/// or it gave nothing, and before it joined.
///
/// GNSS, DVL, depth, compass and IMU are those that the vehicle navigates by, as they stood. Sonar
/// and ADCP look when a row is written, an ADCP once a minute; the noise of each look is that of
/// (seed, vehicle, instrument, row), so that nothing has to be remembered between rows.
class SensorLog {
 public:
  SensorLog() = default;
  SensorLog(std::span<const Agent> agents, bool with_readings, std::uint64_t seed);

  void reserve(std::size_t times);
  void append(double time_s, std::span<const Agent> agents, std::span<const AgentState> states);

  /// As `RunLog::let_join`.
  void let_join(std::size_t vehicles);

  [[nodiscard]] std::span<const LogVariable> columns() const noexcept { return columns_; }
  /// A column of one vehicle, times x per. @throws ContractViolation for one that is not there
  [[nodiscard]] std::vector<double> column(std::size_t vehicle, std::string_view name) const;

  /// Of each vehicle: times x numbers of a row. Public for a checkpoint, which stores and puts back
  /// all of it.
  std::vector<std::vector<double>> rows;
  std::size_t times = 0;
  double last_s = -1;  ///< time of the last row

 private:
  struct Needs {
    bool error = false, gnss = false, dvl = false, depth = false, compass = false, imu = false,
         sonar = false;
    std::size_t adcp_bins = 0;
  };
  void add_columns();
  void write(double time_s, const Agent& agent, const AgentState& state, std::span<double> out);

  Needs needs_;
  std::uint64_t seed_ = 0;
  std::vector<LogVariable> columns_;
  std::size_t row_size_ = 0;
};

}  // namespace slackwater::twin
