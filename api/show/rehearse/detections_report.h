#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/log/detection_log.h"

// What detectors found in the pictures of a run, told of its log.

namespace slackwater::api {

/// Of one vehicle, a line for each detector and camera, which begins with `whose`; empty where none
/// looked.
[[nodiscard]] std::string detections_text(const std::vector<DetectorRecord>& records,
                                          std::size_t vehicle, const std::string& whose);

/// `[{of, in_view, found, false_alarms}]`.
[[nodiscard]] nlohmann::json kinds_found_json(const std::vector<KindFound>& kinds);

/// The same: `[{sensor, detector, pictures, kinds}]`.
[[nodiscard]] nlohmann::json detections_json(const std::vector<DetectorRecord>& records,
                                             std::size_t vehicle);

/// Tables of a page: how much was found, and where. Empty where no detector looked.
/// @param vehicles     names, by their number in the log
/// @param shows_truth  what was planted, and which findings are false alarms
[[nodiscard]] std::string detections_html(const std::vector<DetectorRecord>& records,
                                          const std::vector<std::string>& vehicles,
                                          bool shows_truth);

}  // namespace slackwater::api
