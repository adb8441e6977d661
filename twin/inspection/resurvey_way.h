#pragma once
#include <span>
#include <vector>

#include "twin/inspection/inspection.h"

namespace slackwater::twin {

/// Where to look from once more, in an order to go there.
struct ResurveyWay {
  struct Stand {
    Triple<double> place_m;  ///< NED
    double stay_s = 0;       ///< of a probe that has to be held
  };
  std::vector<Stand> stands;
  double left_m2 = 0;        ///< that was not covered
  double poorly_m2 = 0;      ///< of it, seen but not well enough
  bool asks_slower = false;  ///< smear by motion is most of what was too coarse
};

/// The surfaces' sheets in cells of some two thirds of a footprint: a stand before each cell of
/// which a quarter or more is left, square to it, as far off as the work was; nearer, down to a
/// half, where what was seen was too coarse. Every other column of cells on the way out, those
/// between on the way back, so that no line winds about a pile.
///
/// @param is_in_water  the vehicle swims; places in the other medium are left out
/// @param clear_m      least distance from structures
[[nodiscard]] ResurveyWay resurvey_way(const Inspection& inspection, const InspectionState& state,
                                       std::span<const Structure> structures, bool is_in_water,
                                       double clear_m);

}  // namespace slackwater::twin
