#pragma once
#include <filesystem>
#include <memory>

#include "api/perception/detector.h"
#include "fields/base/config.h"

namespace slackwater::api {

/// A network (ONNX) that somebody trained, run by OpenCV, its raw heads decoded here: OpenCV 4.6
/// computes some operations wrongly without a word (an uneven `split`), so that decoding inside the
/// model is not trusted, and each model brings a test of its own that it must pass at load.
///
///     by: network
///     file: plates.onnx                    # beside this file
///     sha256: 3f...                        # of that file
///     kinds: [corrosion, crack]
///     input: {mean: [0.485, 0.456, 0.406], sd: [0.229, 0.224, 0.225], multiple_of: 16}
///     # or {..., wide: 640, high: 640}: the picture is fitted in, grey beside it
///     grids:                               # one output for each stride, 1 x (kinds + 4) x h x w
///       - {output: "8", stride_px: 8}      # logits of the kinds, then left, top, right, bottom
///       - {output: "16", stride_px: 16}
///     # or rows: {output: "output0", has_objectness: false, is_transposed: true}
///     #   (4 + kinds) numbers a row: middle x, middle y, wide, high in pixels of the input; shares
///     least_confidence: 0.3                # optional, 0.25
///     most_overlap: 0.5                    # optional: of two boxes of one kind
///     test: {seed: 7, wide: 64, high: 64, heads: [{output: "8", at: [0, 17], is: [-4.1, 0.3]}]}
///
/// Grids: the cell (i, j) looks from the point s (i + 1/2, j + 1/2); its box reaches s exp(t) to
/// each side, t bounded by 8; its confidence is the sigmoid of the logit.
/// The picture goes in as (rgb / 255 - mean) / sd, planes of red, green, blue, filled up to the
/// multiple with zeros on the right and below.
/// Test: the picture whose byte k is (2654435761 (k + 1) + 40503 seed mod 2^32) / 2^24 goes in;
/// each head's number at `at` (of the flat output) must be `is` within 1e-4.
///
/// @throws Error(invalid_input) for a file whose hash is another, which OpenCV cannot read, whose
///         outputs do not have the shape that the file states, whose test is missing or not passed
[[nodiscard]] std::unique_ptr<Detector> read_network(const Config& config,
                                                     const std::filesystem::path& folder);

}  // namespace slackwater::api
