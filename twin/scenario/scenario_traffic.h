#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "twin/traffic/alarms.h"
#include "twin/traffic/traffic_picture.h"

namespace slackwater {
class Config;
}

namespace slackwater::twin {

/// A log of AIS by its file, and how it is laid on the run.
struct AisLog {
  std::string file;  ///< counts from the folder of the scenario
  /// The instant of the log that is the start of the run: puts an old day's traffic beside today's
  /// vehicles.
  std::optional<UtcTime> starts;    ///< absent: the start of the run itself
  std::vector<std::uint32_t> mmsi;  ///< these vessels alone; none: all
  /// From the origin: what a vessel of 30 m/s covers within the alarm's ten minutes.
  double reach_m = 20e3;
  bool is_around = true;  ///< false: its tracks are followed, its vessels are not met
  bool operator==(const AisLog&) const = default;
};

/// A vessel made up by hand, and how it goes: `laid_track`.
struct MadeUpVessel {
  std::uint32_t mmsi = 0;
  std::string name;  ///< may be empty
  double begins_s = 0;
  std::vector<Triple<double>> places_m;  ///< NED; one: at anchor there
  double speed_m_s = 0;
  bool operator==(const MadeUpVessel&) const = default;
};
/// @param duration_s  of the run: one at anchor is there until its end
[[nodiscard]] TrafficVessel vessel_of(const MadeUpVessel& vessel, double duration_s);

/// Which other vessels are around, and when they are a danger.
struct ScenarioTraffic {
  std::vector<AisLog> logs;
  std::vector<MadeUpVessel> vessels;
  /// The reference sheets name no limits. 500 m is as far as safety zones around installations
  /// reach (UNCLOS, article 60); ten minutes are an estimate.
  AlarmLimits alarm{500, 600};
  bool operator==(const ScenarioTraffic&) const = default;
};

/// Whose track a vehicle follows.
struct TrackToFollow {
  std::uint32_t mmsi = 0;
  std::optional<AisLog> log;  ///< absent: one of the traffic
  /// How near counts as on the track: what AIS calls a position of high accuracy (ITU-R M.1371-5,
  /// table 48).
  double within_m = 10;
  std::string name;                    ///< of the vessel, once found
  std::shared_ptr<const Track> track;  ///< once found
  bool operator==(const TrackToFollow&) const = default;
};

/// `traffic` of a scenario; none where the key is absent.
[[nodiscard]] ScenarioTraffic read_traffic(const Config& scenario);
/// The keys of a task `follow_track`.
[[nodiscard]] TrackToFollow read_track_to_follow(const Config& task);

}  // namespace slackwater::twin
