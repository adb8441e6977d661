#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "api/ask/render/rendered_run.h"
#include "twin/render/stage/staged_look.h"

namespace slackwater::api {

struct PixelMask;

/// What is in a row of pictures, as COCO labels it (cocodataset.org, "instances"): so that
/// `slackwater detect --score` and other people's tools read the folder as it is.
///
/// A label is a planted defect that some pixels show: its kind as category, the box about those
/// pixels, how many they are, and which (run lengths down the columns, from the left, zeros first).
/// One of fewer than `least_pixels` is marked as a crowd: found or not, it does not count, for
/// nobody could tell what it is. So is one of a look at a stage that is shorter than the least
/// detail that the inspection would make out there (quality.h), or hidden by noise: a signal to
/// noise ratio below Rose's 5 (told_from_noise.h).
class PictureLabels {
 public:
  static constexpr std::size_t least_pixels = 25;     // 5 x 5
  static constexpr double least_signal_to_noise = 5;  // Rose (1948), J. Opt. Soc. Am. 38, 196-208

  PictureLabels();
  /// @param file  of the picture, in the folder of the labels. Not of a camera: adds nothing
  void add(const RenderView& view, const std::string& file);
  /// The same of a look at a stage. Its image has a key of ours, `look`: how it came about
  /// (range_m, off_square_deg, depth_m, visibility_m, daylight, lamps, growth, water), the surface
  /// in view (seen_m2), the camera matrix, where the camera was and how it was turned (x east, y
  /// north, z up), and `planted`: each defect, seen or not, with kind, size_m, width_m, range_m,
  /// detail_m (null: not seen), contrast, light, centre_px, pixels and signal_to_noise.
  void add(const twin::StagedLook& look, const std::string& file);
  [[nodiscard]] const nlohmann::json& coco() const noexcept { return set_; }

 private:
  nlohmann::json& add_image(const twin::TruthFrame& truth, const std::string& file);
  nlohmann::json& add_annotation(twin::DefectKind kind, const PixelMask& mask,
                                 const twin::TruthFrame& truth, std::uint32_t number);

  nlohmann::json set_;
};

}  // namespace slackwater::api
