#pragma once
#include <memory>

#include "api/perception/detector.h"
#include "fields/base/config.h"

namespace slackwater::api {

/// Cracks by their form: dark, and long for their width.
///
/// Looked at are pixels that are darker than the mean about them by a least contrast and have a
/// steep edge beside them (Prewitt's gradient). From each of them a region percolates: the darkest
/// of the pixels that touch it joins next, until one on the border of a window does. Of a region
/// with C pixels whose longer side is L,
///
///     F = 4 C / (pi L^2)
///
/// is 1 for a disc and near 0 for a line; a pixel whose F is at most `most_roundness` is of a
/// crack. Pixels that touch are one crack. Its confidence is 1 - F, the mean over its pixels, times
/// its length on a scale of `full_length_px`.
///
/// A seam of weld, a cable and a shadow's edge are long and dark, too: a yardstick beside a
/// detector that learned.
/// Source: Yamaguchi and Hashimoto (2010), Fast crack detection method for large-size concrete
/// surface images using percolation-based image processing, Machine Vision and Applications 21,
/// 797-809; Prewitt (1970), Object enhancement and extraction. The numbers in data/detectors are
/// our own.
///
///     by: percolation
///     of: crack
///     window_px: 41            # odd: side of the window
///     least_darker: 18         # grey levels of 255, below the mean of the window
///     least_edge: 20           # grey levels over two pixels
///     most_roundness: 0.25
///     least_length_px: 20
///     full_length_px: 120
[[nodiscard]] std::unique_ptr<Detector> read_percolation_detector(const Config& config);

}  // namespace slackwater::api
