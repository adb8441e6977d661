#pragma once
#include <span>
#include <string>
#include <vector>

#include "twin/run/run_log.h"
#include "twin/traffic/deviation.h"

namespace slackwater::api {

/// How well a vehicle kept to a track in a task `follow_track`: at the times of the log while the
/// task was under way.
struct TrackFollowing {
  std::size_t vehicle = 0;  ///< of the run
  std::string vehicle_name;
  std::size_t task = 0;  ///< from 0
  std::uint32_t mmsi = 0;
  std::string name;  ///< of the vessel
  double within_m = 0;
  twin::Deviation deviation;

  /// The share of the samples nearer than `within_m` to where the track was; 0 without samples.
  [[nodiscard]] double share_within() const noexcept;
};

[[nodiscard]] std::vector<TrackFollowing> tracks_followed(std::span<const twin::Agent> agents,
                                                          const twin::RunLog& log);

/// One line: "usv followed 367120740 (NAME): across 1.2 m rms, 4.0 m at most; ...".
[[nodiscard]] std::string text_of(const TrackFollowing& followed);

}  // namespace slackwater::api
