#pragma once
#include <array>
#include <filesystem>
#include <string_view>

#include "api/door/http/router.h"

namespace slackwater::people {

// The page on which a hand before a webcam turns a camera, and the files of its detector.

/// What its page asks for of the npm package @mediapipe/hands 0.4 (Apache-2.0), 13 of its 24 MB.
inline constexpr std::array<std::string_view, 7> hand_detector_files = {
    "hands.js",
    "hands.binarypb",
    "hands_solution_packed_assets.data",
    "hands_solution_packed_assets_loader.js",
    "hands_solution_simd_wasm_bin.js",
    "hands_solution_simd_wasm_bin.wasm",
    "hand_landmark_lite.tflite"};

/// The page /session/hands, whose scripts may compile WebAssembly, and `hand_detector_files` below
/// /session/hands/model. A file that `detector_folder` does not have is answered with 404.
void add_hands_routes(api::http::Router& router, const std::filesystem::path& detector_folder);

}  // namespace slackwater::people
