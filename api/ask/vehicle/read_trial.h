#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "twin/handling/trial.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::api {

/// What a column of a trial's file is, where its own name does not say it.
struct TrialColumnName {
  std::string column;  ///< as the file has it
  std::string name;    ///< as we know it; `none`: it is left out
};
/// "stern_plane_rad=elevator_rad", "battery_v=none".
/// @throws Error(usage) for what has no name on both sides of one =
[[nodiscard]] TrialColumnName parse_trial_column(const std::string& text);

struct TrialOptions {
  std::vector<TrialColumnName> columns;
  twin::Triple<double> current_m_s;  ///< of the water over the ground, NED
  std::optional<double> first_depth_m;
};

inline constexpr std::size_t most_trial_rows = 1'000'000;

/// Reads a trial of a vehicle from comma-separated values (RFC 4180), the first line of which names
/// the columns. Empty lines and lines that begin with # are passed over.
///
///   t_s,left_propeller_rad_s,right_propeller_rad_s,yaw_deg,u_m_s
///   0,80,60,0,0
///   0.2,80,60,0.1,0.04
///
/// | column                        | what                                                   |
/// |-------------------------------|--------------------------------------------------------|
/// | `t_s` or `time_s`             | seconds, rising, from any moment                       |
/// | a quantity (trial_quantity.h) | measured; a cell without a value is empty or NaN       |
/// | a channel of the vehicle and  | commanded until the next row; an empty cell: as in the |
/// | its unit (command_name.h)     | row before                                             |
///
/// Any other column has to be named or left out by `columns`. A file of ../shared/data/fossen is a
/// trial as it is, but for `stern_plane_rad=elevator_rad` of the REMUS.
///
/// @throws Error(invalid_input) that begins with FILE:LINE, for a column that it does not know, two
/// of one kind, no time, no command, nothing measured, what is no number, times that do not rise,
/// a command beyond the limits of its channel, fewer than two rows or more than `most_trial_rows`;
/// Error(not_found) where there is no file
[[nodiscard]] twin::Trial read_trial(const std::filesystem::path& file,
                                     const twin::Vehicle& vehicle,
                                     const TrialOptions& options = {});
/// The same of a text. @param name  stands for the file
[[nodiscard]] twin::Trial trial_of(std::string_view text, const std::string& name,
                                   const twin::Vehicle& vehicle, const TrialOptions& options = {});

}  // namespace slackwater::api
