#pragma once
#include <functional>

#include "api/perception/average_precision.h"
#include "api/perception/detector.h"
#include "api/perception/labelled_pictures.h"

namespace slackwater::api {

/// A detector held against labels.
struct DetectorScore {
  std::vector<KindScore> kinds;          ///< what both know, in the detector's order
  std::vector<std::string> only_labels;  ///< kinds that the labels alone know
  std::vector<std::string> only_finds;   ///< kinds that the detector alone knows
  std::vector<ScoredPicture> pictures;   ///< in the set's order
};

/// Every picture of the set, looked at.
/// @param on_picture  after each, how many are done; may be empty
/// @throws as `read_picture`; Error(invalid_input) for a picture of another size than its labels
///         state, and where detector and labels have no kind in common
[[nodiscard]] DetectorScore score_detector(Detector& detector, const LabelledPictures& set,
                                           const std::function<void(std::size_t)>& on_picture = {});

}  // namespace slackwater::api
