#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "data/store/session_action.h"

namespace slackwater::api {

/// A stretch of a run, s since its start.
struct Stretch {
  double from_s = 0;
  double to_s = 0;
};

/// A turn of a seat at the helm of a vehicle. Latencies are of the clock of the wall; one is not
/// there where the clock was set back meanwhile.
struct HelmTurn {
  unsigned seat = 0;
  std::string vehicle;
  UtcTime had_at;
  bool was_asked_for = false;  ///< else a supervisor took it over
  bool was_taken = false;      ///< from another, who had not given it
  std::optional<double> asked_to_had_s;
  bool has_command = false;
  std::optional<double> had_to_command_s;  ///< of a turn that was asked for
  std::vector<Stretch> there;              ///< but while its station was cut off
};

/// Who had which helm when, by the record of a session.
struct HelmHistory {
  using SeatAtVehicle = std::pair<unsigned, std::string>;
  std::vector<HelmTurn> turns;  ///< as they began
  std::map<SeatAtVehicle, std::size_t> asked_in_vain;
  std::map<SeatAtVehicle, std::size_t> links_lost;
};

/// @param actions  in order
/// @param ran_s    when the run was over: what is open then ends
[[nodiscard]] HelmHistory helm_history_of(std::span<const store::SessionAction> actions,
                                          double ran_s);

/// A row that is a command to a vehicle, taken or refused, and not a word about its helm.
[[nodiscard]] bool is_command(const store::SessionAction& action) noexcept;

}  // namespace slackwater::api
