#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/door/dds/message/bytes.h"
#include "api/door/dds/message/site_messages.h"
#include "twin/body/attitude.h"
#include "twin/run/newcomer.h"

namespace slackwater::dds {

// Requests of services, read, and what is answered. All readers throw Error(invalid_input) for
// bytes that are no such request.

/// Of std_srvs/srv/Trigger: there is nothing in it.
void read_trigger(Payload request);
/// Of std_srvs/srv/SetBool.
[[nodiscard]] bool read_set_bool(Payload request);
/// Of Trigger, SetBool, Spawn and SetWaypoints alike: whether it was done, and in words.
[[nodiscard]] Bytes done_reply(bool success, const std::string& message);

/// Of slackwater_msgs/srv/Step.
[[nodiscard]] std::uint32_t read_step(Payload request);
[[nodiscard]] Bytes step_reply(bool success);

/// Of slackwater_msgs/srv/Spawn; of the orientation of its pose the heading.
/// @throws Error(invalid_input) also for a pose in another frame than `map`, and for an orientation
///         that is none
[[nodiscard]] twin::Newcomer read_spawn(Payload request);

/// Of slackwater_msgs/srv/SetWaypoints.
struct WaypointsAsked {
  std::vector<twin::Triple<double>> places_m;  ///< NED
  bool loop = false;
};
[[nodiscard]] WaypointsAsked read_set_waypoints(Payload request);

/// Of slackwater_msgs/srv/QueryProfile.
struct ProfileAsked {
  double latitude_deg = 0;
  double longitude_deg = 0;
  Stamp time;
};
[[nodiscard]] ProfileAsked read_query_profile(Payload request);
[[nodiscard]] Bytes profile_reply(const SiteWater& water, UtcTime time, const Stamp& stamp);
[[nodiscard]] Bytes profile_refusal(const std::string& message);

}  // namespace slackwater::dds
