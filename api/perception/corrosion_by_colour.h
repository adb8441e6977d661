#pragma once
#include <memory>

#include "api/perception/detector.h"
#include "fields/base/config.h"

namespace slackwater::api {

/// Rust by its colour alone: what is brown to orange is of iron oxide.
///
/// A pixel is rust where its hue H (HSV, degrees) and saturation S are in a range, and its a* and
/// b* (CIELab, D65) are above a least: red rather than green, yellow rather than blue. Pixels that
/// touch (8 neighbours) are one piece; pieces below a least area are dust. A piece's confidence is
/// the share of its box that it fills, times how far its mean chroma C* = |(a*, b*)| is above the
/// least, on a scale of `full_chroma`.
///
/// It knows nothing of form, and takes any brown thing for rust: a yardstick beside a detector that
/// learned, and blind where water takes the red away (some metres).
/// Source: HSV and CIELab thresholds for corrosion as compared by Bonnin-Pascual and Ortiz (2014),
/// Corrosion Detection for Automated Visual Inspection, in Developments in Corrosion Protection,
/// InTech, chapter 25; the numbers in data/detectors are our own.
///
///     by: colour
///     of: corrosion
///     hue_deg: [5, 45]
///     least_saturation: 0.35      # 0 to 1
///     least_a: 8                  # CIELab
///     least_b: 12
///     full_chroma: 50
///     least_area_px: 30
[[nodiscard]] std::unique_ptr<Detector> read_colour_detector(const Config& config);

}  // namespace slackwater::api
