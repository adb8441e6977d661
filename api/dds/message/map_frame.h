#pragma once
#include <string>

namespace slackwater::dds {

/// That what a client gives is in the world frame, which is also meant where it names none.
/// @param what  "the path"
/// @throws Error(invalid_input) for another frame
void expect_map(const char* what, const std::string& frame_id);

}  // namespace slackwater::dds
