#pragma once
#include <optional>
#include <vector>

#include "calibration/fuse/fusion_settings.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// How an instrument's tide lies against the product's.
struct TideAgreement {
  /// Turned by this, or late by that, the instrument's tide is most like the product's.
  double turned_deg = 0;  ///< clockwise, (-180, 180]
  double late_h = 0;      ///< positive: the instrument's comes after the product's
  /// Which of the two explains it: one, or both alike for a tide that turns in a circle, and for
  /// half of M2 against a wrong sign.
  bool is_turned = false;
  bool is_late = false;
};

/// Holds the tide of an instrument against the product's, and finds a frame, a sign or a clock that
/// is plainly wrong; nothing where the two agree, or where it cannot be told.
///
/// With p and o the depth means of product and instrument less their running means over 25 h, and
///
///   c(T) = sum conj(p(t)) o(t + T) / sqrt(sum |p|^2 (sum |o|^2 - noise))
///
/// 1 - |c|^2 is what is left unexplained when the instrument is taken to be late by T and turned by
/// arg c. A clock and a frame turn the two rotary parts of a tide apart, or together. A good
/// instrument beside a product whose tide is wrong by up to 1.5 h and 20 degrees (M2: 43 degrees of
/// phase; a coast that the product does not resolve turns currents, too) must be able to explain
/// the data; it is called wrong where the likelihood is e^4.5 greater (three standard deviations)
/// under a frame or a clock beyond that (one of the two: both together can make any tide of one
/// line from any other), independent values being `2 quick_memory_h` apart.
///
/// Cannot be told: without 48 h of common values (beyond half a running mean at either end);
/// where the product moves by less than 5 cm/s, or is of means over 6 h and more; where more than
/// a fifth is unexplained at best, or either half of the time says otherwise; and for motion in
/// circles (inertial motion, whose phase a product need not know) without ten days of it. The last
/// fortnight is looked at, spring and neap.
///
/// @param noise_m_s  of a sample of `observed`, per level; may be empty
[[nodiscard]] std::optional<TideAgreement> tide_disagreement(const VectorColumn& product,
                                                             const VectorColumn& observed,
                                                             const std::vector<double>& noise_m_s,
                                                             const FusionSettings& settings = {});

}  // namespace slackwater::calibration
