#pragma once
#include <optional>

#include "calibration/day/column/column_calibration.h"
#include "fields/record/choose.h"

namespace slackwater::calibration {

/// From when on every value of a record holds the tide, up to the end of D: `UtcTime::min()` where
/// all do, nothing where one of D's own lacks it.
///
/// A product that is said to be detided (Rank::has_tide) lacks it but for the times of an
/// instrument that it was fused with: an instrument sees all motion, and fusion draws the product
/// to it (calibration/fuse/fusion.h). So the record of a detided product and a meter that began to
/// send ten days ago and still does holds ten days of tide; of one that stopped before D ended,
/// none that could be carried on. What nobody says anything about holds it.
[[nodiscard]] std::optional<UtcTime> tide_since(const Chosen<Horizontal>& known, UtcDay day);

/// The harmonic tide of the part of a record that holds it; none of one that is detided, with a
/// note that says so: weather sampled every six hours would be taken for tide.
[[nodiscard]] FittedTide tide_of_record(const Chosen<Horizontal>& known, UtcDay day,
                                        Angle latitude);

}  // namespace slackwater::calibration
