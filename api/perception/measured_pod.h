#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/perception/score_detector.h"
#include "twin/inspection/defect/detection_method.h"
#include "twin/inspection/defect/hit_miss_fit.h"

namespace slackwater::api {

/// How well a detector finds the planted defects of one kind in looks at a stage, as a method that
/// an inspection can go by.
struct MeasuredPod {
  twin::DefectKind kind{};
  std::size_t looked_for = 0;  ///< planted, and seen by the inspection's account
  std::size_t not_seen = 0;    ///< planted, but not seen by that account: not counted
  std::size_t found = 0;
  double at_detail_m = 0;
  std::optional<twin::HitMissFit> fit;  ///< of a_eff = a min(1, at_detail/detail), m
  std::size_t false_alarms = 0;
  double read_m2 = 0;
  double size_bias = 0;  ///< of a found one's size, as a share of the true one
  double size_sd = 0;
};

/// 0 where nothing was read.
[[nodiscard]] double false_alarms_per_100_m2(const MeasuredPod& pod) noexcept;

/// A planted defect counts as found where a find of its kind has its centre within its box, and
/// overlaps the label by at least a fifth: enough to send somebody to the place, and not the box
/// about half of the picture. One that shows on no pixel is found by nobody. A find that overlaps
/// no label of its kind by a fifth is a false alarm, but for finds on what nobody could tell (a
/// crowd, picture_labels.h): they count neither way.
///
/// `at_detail` is the detail that a tenth of the looks undercut. A better look counts as one of
/// that detail, a worse one shrinks the defect (`probability_of_detection`).
///
/// The size told is the longer side of the find's box (of a crack its diagonal) on the surface.
/// @return one for each kind that both know; nothing fitted where no curve rises (hit_miss_fit.h)
/// @throws Error(invalid_input) for pictures that are of no stage
[[nodiscard]] std::vector<MeasuredPod> measure_pod(const DetectorScore& score,
                                                   const LabelledPictures& set);

}  // namespace slackwater::api
