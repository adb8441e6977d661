#pragma once
#include <string>

namespace slackwater::dds {

/// The world frame of all positions: east, north, up of the origin (ROS REP-105).
inline constexpr const char* map_frame = "map";

/// That what a client gives is in the world frame, which is also meant where it names none.
/// @param what  "the path"
/// @throws Error(invalid_input) for another frame
void expect_map(const char* what, const std::string& frame_id);

}  // namespace slackwater::dds
