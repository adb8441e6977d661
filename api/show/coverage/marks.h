#pragma once
#include <string>
#include <vector>

#include "api/show/coverage/view.h"

namespace slackwater::api {

/// A finding as pictures and tables show it: what is told apart only when the truth is asked for.
struct CoverageMark {
  std::string label;  ///< "3" of what was reported, "M2" of what was missed
  const Finding* finding = nullptr;
  double along_m = 0;  ///< where it was reported to be, of what was missed where it is
  double down_m = 0;
  Vector3<Enu> place_m{0, 0, 0};
  Vector3<Enu> normal{0, 0, 0};  ///< of the surface there
  /// "reported" without the truth; with it the words of its outcome.
  std::string words;
  /// "reported", "false", "unseen", "poor", "overlooked": its shape.
  std::string shape;
};

/// The marks of one surface, of what was missed only with the truth. Labels count on from
/// `reported` and `missed`, which grow.
[[nodiscard]] std::vector<CoverageMark> marks_of(const InspectionCoverage& coverage,
                                                 bool shows_truth, std::size_t& reported,
                                                 std::size_t& missed);

/// A mark in a picture, its label beside it, at (x, y) px.
[[nodiscard]] std::string mark_svg(const CoverageMark& mark, double x, double y);
/// The shape alone, about (x, y).
[[nodiscard]] std::string shape_svg(const std::string& shape, double x, double y);

}  // namespace slackwater::api
