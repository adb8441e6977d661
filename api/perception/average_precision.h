#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "api/perception/detection.h"
#include "api/perception/labelled_pictures.h"

namespace slackwater::api {

/// What is in a picture, and what was found in it.
struct ScoredPicture {
  std::vector<Label> labels;
  std::vector<Detection> found;
  std::vector<Detection> unsure = {};  ///< that its detector would not tell (detector.h)
};

/// A share with the range in which 95 of 100 sets of as many pictures would have it.
struct ShareWithin {
  double share = 0;
  double low = 0;
  double high = 0;
};

/// How well one kind is found.
///
/// A find is right where it overlaps a label of its kind by at least `least_overlap` that no surer
/// find of the picture has taken: the one that it overlaps most. Over all pictures, surest first,
/// each find gives a recall r (labels found so far) and a precision p (finds right so far); AP is
/// the mean over r = 0, 0.01 ... 1 of the best precision at that recall or a higher one, 0 where
/// none gets so far. It is asked of all that the detector believes to see, unsure or not; all else
/// here is of what it tells. Finds of a crowd count neither way, and of a picture the surest 100.
/// This is AP50 of the COCO evaluation (Lin et al. 2014, arXiv:1405.0312; cocodataset.org), for
/// labels of any size: held equal to pycocotools by a test.
///
/// The range is by drawing the pictures 1 000 times with replacement (bootstrap, 2.5 and 97.5 %).
struct KindScore {
  std::string of;
  std::size_t labels = 0;                        ///< crowds not counted
  std::size_t found = 0;                         ///< right or wrong
  std::optional<ShareWithin> average_precision;  ///< nothing without labels
  std::optional<double> recall;                  ///< of all that it tells together
  std::optional<double> precision;               ///< nothing without finds
  /// Of pictures without a label of any kind: finds of this kind for each 100 of them.
  std::optional<double> false_alarms_per_100;
};

/// @param seed  of the drawing of pictures
[[nodiscard]] KindScore score_of_kind(std::span<const ScoredPicture> pictures,
                                      const std::string& kind, double least_overlap = 0.5,
                                      std::uint64_t seed = 1);

}  // namespace slackwater::api
