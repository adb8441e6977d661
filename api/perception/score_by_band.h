#pragma once
#include <string>
#include <vector>

#include "api/perception/score_detector.h"

namespace slackwater::api {

/// A third of the looks, by what was drawn of them.
struct BandScore {
  std::string by;  ///< "range_m", "visibility_m"
  double from = 0;
  double to = 0;  ///< of this third: its least and its most
  std::size_t pictures = 0;
  std::vector<KindScore> kinds;
};

/// A detector's score by how far and in how clear water it looked: each kind in the near, middle
/// and far third of the pictures, then in the murkiest, middle and clearest. Empty where a picture
/// is of no stage, or there are fewer than 30.
[[nodiscard]] std::vector<BandScore> score_by_band(const DetectorScore& score,
                                                   const LabelledPictures& set);

}  // namespace slackwater::api
