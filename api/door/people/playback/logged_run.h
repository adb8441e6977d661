#pragma once
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "api/door/people/playback/helm_story.h"
#include "api/door/people/playback/logged_track.h"
#include "api/door/people/vehicle_now.h"
#include "fields/geo/geo_point.h"
#include "twin/account/mission_event.h"
#include "twin/scene/structure.h"

namespace slackwater::people {

/// That it was near a vessel, from a time to another one.
struct LoggedAlarm {
  std::uint32_t mmsi = 0;
  std::string name;  ///< of the vessel; may be empty
  double begin_s = 0, end_s = 0;
};

/// Where its camera looked, from a time on.
struct LoggedCamera {
  double from_s = 0;
  twin::CameraPointing pointing;
};

struct LoggedVehicle {
  twin::Agent agent;  ///< what is known of it before it moves: name, model, conduct, tether
  twin::Triple<double> home_m;
  std::size_t tasks = 0;
  std::vector<LoggedRow> rows;  ///< as many as the log has times
  std::vector<LoggedHelm> helms;
  std::vector<twin::MissionStretch> stretches;
  std::vector<LoggedAlarm> alarms;
  std::vector<LoggedCamera> cameras;  ///< by the commands that it took; before: straight ahead
};

/// All of the log of a run that is shown when it is watched again.
struct LoggedRun {
  std::string title;
  UtcTime start;
  std::optional<GeoPoint> origin;
  double step_s = 0;        ///< 0: the log does not tell
  std::vector<double> t_s;  ///< of the rows, ascending
  std::vector<LoggedVehicle> vehicles;
  std::vector<twin::Structure> structures;
  std::vector<Action> actions;
  std::vector<std::string> warnings;  ///< of what could not be had, and is left out

  [[nodiscard]] double from_s() const { return t_s.front(); }
  [[nodiscard]] double to_s() const { return t_s.back(); }
  /// When an action is told: those after the last row with that one.
  [[nodiscard]] double told_at_s(const Action& action) const {
    return std::clamp(action.time_s, from_s(), to_s());
  }
  /// How many actions there were by then.
  [[nodiscard]] std::size_t actions_by(double at_s) const;
};

/// By which what is told of a vehicle is known to be the same as before.
struct StatusPlace {
  /// 0: none of them yet; else its place and 1.
  std::size_t helm = 0, stretch = 0, task = 0, camera = 0;
  twin::Halt halt = twin::Halt::none;
  std::vector<std::size_t> alarms;  ///< that stand, by their places
  bool operator==(const StatusPlace&) const = default;
};
[[nodiscard]] StatusPlace status_place(const LoggedVehicle& vehicle, const Moment& moment,
                                       double at_s);
/// What the log has of a vehicle beside its pose. Its words last as long as the vehicle does.
[[nodiscard]] VehicleNow vehicle_then(const LoggedVehicle& vehicle, const StatusPlace& place);

/// Reads a log that `slackwater simulate` or `live` wrote.
/// @param data_folder  where its models are found, for their kind and size
/// @throws Error(not_found); Error(invalid_input) for what is no log, one without positions, one
/// that is damaged
[[nodiscard]] LoggedRun read_logged_run(const std::filesystem::path& log,
                                        const std::filesystem::path& data_folder);

}  // namespace slackwater::people
