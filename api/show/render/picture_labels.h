#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "api/ask/render/rendered_run.h"

namespace slackwater::api {

/// What is in a row of pictures, as COCO labels it (cocodataset.org, "instances"): so that
/// `slackwater detect --score` and other people's tools read the folder as it is.
///
/// A label is a planted defect that some pixels show: its kind as category, the box about those
/// pixels, how many they are, and which (run lengths down the columns, from the left, zeros first).
/// One of fewer than `least_pixels` is marked as a crowd: found or not, it does not count, for
/// nobody could tell what it is.
class PictureLabels {
 public:
  static constexpr std::size_t least_pixels = 25;  // 5 x 5

  PictureLabels();
  /// @param file  of the picture, in the folder of the labels. Not of a camera: adds nothing
  void add(const RenderView& view, const std::string& file);
  [[nodiscard]] const nlohmann::json& coco() const noexcept { return set_; }

 private:
  nlohmann::json set_;
};

}  // namespace slackwater::api
