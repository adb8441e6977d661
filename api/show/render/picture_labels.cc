#include "api/show/render/picture_labels.h"

#include <algorithm>
#include <map>

#include "fields/base/time.h"
#include "twin/inspection/defect/defect_kind.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// The pixels of one defect, walked down the columns from the left.
struct Mask {
  std::vector<std::size_t> runs;  ///< without, with, without ...
  std::size_t next = 0;           ///< the place behind the last run
  std::size_t pixels = 0;
  int left = 0, top = 0, right = 0, bottom = 0;

  void take(std::size_t place, int column, int row) {
    if (pixels == 0) {
      left = column;
      top = row;
    }
    if (pixels == 0 || place != next) {
      runs.push_back(place - next);
      runs.push_back(0);
    }
    ++runs.back();
    next = place + 1;
    ++pixels;
    top = std::min(top, row);
    right = column + 1;
    bottom = std::max(bottom, row + 1);
  }
};

std::map<std::uint16_t, Mask> masks_of(const twin::TruthFrame& truth) {
  std::map<std::uint16_t, Mask> masks;
  const auto wide = static_cast<std::size_t>(truth.wide);
  std::size_t place = 0;
  for (int column = 0; column < truth.wide; ++column) {
    for (int row = 0; row < truth.high; ++row, ++place) {
      const std::uint16_t defect =
          truth.defect[static_cast<std::size_t>(row) * wide + static_cast<std::size_t>(column)];
      if (defect > 0) masks[defect].take(place, column, row);
    }
  }
  for (auto& [defect, mask] : masks)
    if (mask.next < place) mask.runs.push_back(place - mask.next);
  return masks;
}

/// COCO's numbers of kinds: from 1, in the order of `all_defect_kinds`.
std::size_t category_of(twin::DefectKind kind) {
  const auto& kinds = twin::all_defect_kinds();
  return 1 + static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
}

}  // namespace

PictureLabels::PictureLabels() {
  set_ = {{"info", {{"description", "rendered by slackwater; labels are what was planted"}}},
          {"categories", json::array()},
          {"images", json::array()},
          {"annotations", json::array()}};
  for (const twin::DefectKind kind : twin::all_defect_kinds())
    set_["categories"].push_back({{"id", category_of(kind)}, {"name", twin::name_of(kind)}});
}

void PictureLabels::add(const RenderView& view, const std::string& file) {
  const auto* camera = std::get_if<CameraView>(&view.seen);
  if (camera == nullptr) return;
  const twin::TruthFrame& truth = camera->truth;
  json& images = set_["images"];
  json& annotations = set_["annotations"];
  const std::size_t image = images.size() + 1;
  images.push_back({{"id", image},
                    {"file_name", file},
                    {"width", truth.wide},
                    {"height", truth.high},
                    {"date_captured", format_utc(view.time)}});
  for (const auto& [number, mask] : masks_of(truth)) {
    const SeenDefect& defect = view.defects.at(number - 1U);
    annotations.push_back(
        {{"id", annotations.size() + 1},
         {"image_id", image},
         {"category_id", category_of(defect.kind)},
         {"bbox", {mask.left, mask.top, mask.right - mask.left, mask.bottom - mask.top}},
         {"area", mask.pixels},
         {"segmentation", {{"size", {truth.high, truth.wide}}, {"counts", mask.runs}}},
         {"iscrowd", mask.pixels < least_pixels ? 1 : 0},
         {"planted_number", defect.number}});
  }
}

}  // namespace slackwater::api
