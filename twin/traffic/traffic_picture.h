#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "twin/traffic/alarms.h"
#include "twin/traffic/track.h"

namespace slackwater::twin {

/// A vessel whose way is known beforehand.
struct TrafficVessel {
  std::uint32_t id = 0;  ///< its MMSI
  std::string name;      ///< may be empty
  std::optional<double> length_m;
  std::optional<double> beam_m;
  Track track;
  bool is_around = true;  ///< false: it is not met, only its track is of use
};

/// The name of a vessel, where it is known; else empty.
[[nodiscard]] std::string name_of_vessel(std::span<const TrafficVessel> vessels,
                                         std::uint32_t mmsi);

/// Who is around at one moment. Values that are filled anew at each moment: after the first few,
/// without allocation.
struct TrafficPicture {
  /// Whose place is known, in the order of the vessels.
  std::vector<Contact> contacts;
  /// Heard before and after, but silent too long to be placed now.
  std::vector<std::uint32_t> unheard;
};

/// Fills the picture of time t_s with the vessels that are around. Those before their first and
/// after their last report are not in it.
void populate(const std::vector<TrafficVessel>& vessels, double t_s, const TrackRule& rule,
              TrafficPicture& picture);

}  // namespace slackwater::twin
