#pragma once
#include "api/ask/detect/run_finds.h"

namespace slackwater::api {

/// What a detector found in the pictures of a camera, as the log of the run keeps it.
/// @param vehicle  of the log, from 0
[[nodiscard]] DetectorRecord detector_record(const RunFinds& finds, std::size_t vehicle,
                                             const std::string& sensor,
                                             const std::string& detector);

}  // namespace slackwater::api
