#pragma once
#include <string>

#include "api/perception/measured_pod.h"

namespace slackwater::api {

/// A measured curve as a file of data/detection (detection_method.h), so that an inspection can go
/// by it: `status: estimate`, and a source that says on how many looks and by which detector.
/// @param detector  its name
/// @param pod       with a fit
[[nodiscard]] std::string detection_sheet(const MeasuredPod& pod, const std::string& detector);

}  // namespace slackwater::api
