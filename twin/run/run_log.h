#pragma once
#include <span>
#include <string>
#include <vector>

#include "twin/agent/agent.h"

namespace slackwater::twin {

/// One quantity of a log, ENU at the site's origin (fields/docs/conventions.md), SI.
struct LogVariable {
  const char* name;
  const char* standard_name;  ///< of CF; empty: it has none
  const char* units;
  const char* long_name;
  std::size_t per = 1;  ///< values of a vehicle at a time
};
[[nodiscard]] std::span<const LogVariable> log_variables() noexcept;
/// Numbers in a row: all columns, one after the other.
[[nodiscard]] std::size_t log_row_size() noexcept;

/// What a run leaves behind: a row for each vehicle at each of the log's times, whether it moves or
/// has halted; one without a number for each time before it joined the run.
struct RunLog {
  std::vector<double> t_s;
  std::vector<std::vector<double>> rows;  ///< of each vehicle: times x numbers of a row

  /// Room for what is to come, so that a step allocates nothing.
  void reserve(std::size_t vehicles, std::size_t times);
  void append(double time_s, std::span<const Agent> agents, std::span<const AgentState> states);
  /// Gives those that joined the run a row without a number for each time so far.
  void let_join(std::size_t vehicles);
  /// The first time at which a vehicle was there, by its place in `t_s`; past them all: at none.
  [[nodiscard]] std::size_t first_time(std::size_t vehicle) const;
  /// A column of one vehicle, times x per.
  [[nodiscard]] std::vector<double> column(std::size_t vehicle, std::string_view name) const;
};

/// The format of a log: its columns and what they mean. 2: what is not there is missing where 1
/// had zeros; `speed_through_water`, `electrical_energy`, depth error in a hold, two more halts. 3:
/// the tables `approach` and `clearance` beside them. 4: `tether_top`. 5: what was done to the
/// vehicles from outside, in the tables `client`, `command`, `content` and `refusal`, and the
/// attribute `stopped_at_step` of a run that was ended from outside; none of them where nobody did
/// anything. 6: all of the account of a run (twin/account) in the tables `fate`, `befell`,
/// `cleaned`, `inspected` and `defect_kind`.
inline constexpr int log_format = 6;

/// The row of a vehicle at a time of the run. Water, surface and wind are those at the vehicle
/// then, of the field and the waves that move it; no number for what it does not meet or nobody
/// knows. @param out  `log_row_size()` numbers
void write_row(const Agent& agent, const AgentState& state, double time_s, std::span<double> out);

}  // namespace slackwater::twin
