#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/door/people/run_desk.h"

namespace slackwater::people {

/// Where a person is in the scene, and looks to.
struct Look {
  twin::Triple<double> from_m;                    ///< NED
  double heading_deg = 0;                         ///< clockwise from north
  double tilt_deg = 0;                            ///< up
  std::optional<twin::Triple<double>> pointed_m;  ///< NED, what is pointed at
};

/// Words that somebody has put at a place.
struct Note {
  unsigned number = 0;  ///< from 1, never used twice
  unsigned seat = 0;
  std::string who, text;
  twin::Triple<double> at_m;  ///< NED
};

/// What people of a session show each other beside the run: where they look, notes at places, and
/// which alarms somebody has seen to. Nothing of it changes the run. Not thread-safe.
class Gathering {
 public:
  static constexpr std::size_t most_notes = 100;

  /// `look`: for all roles; without a place, somebody is not there any more. It leaves no row in
  /// the record.
  /// @throws Error(invalid_input) for a message that cannot be read; so do the others
  void look(const Seat& seat, const StationSays& says);
  /// Whether a message is one of those below.
  [[nodiscard]] static bool knows(const std::string& what) noexcept;
  /// `note`, `unnote`, `acknowledge`: for operators and supervisors. An operator takes away only
  /// notes of the same seat.
  [[nodiscard]] Said handle(const Seat& seat, const StationSays& says, const RunNow& run);
  /// Forgets where somebody looks who is not there any more. The notes stay.
  void gone(unsigned seat) { looks_.erase(seat); }
  /// Writes into the alarms who has seen to them; forgets it of those that are over.
  void mind(RunNow& run);

  [[nodiscard]] nlohmann::json looks_json() const;
  [[nodiscard]] nlohmann::json notes_json() const;

 private:
  using AlarmKey = std::pair<std::size_t, std::uint32_t>;  ///< vehicle, MMSI
  [[nodiscard]] Said note(const Seat& seat, const StationSays& says);
  [[nodiscard]] Said unnote(const Seat& seat, const StationSays& says);
  [[nodiscard]] Said acknowledge(const Seat& seat, const StationSays& says, const RunNow& run);

  std::map<unsigned, Look> looks_;  ///< by seat
  std::vector<Note> notes_;
  unsigned next_note_ = 1;
  std::map<AlarmKey, std::string> acknowledged_by_;
};

}  // namespace slackwater::people
