#include "api/show/render/picture_labels.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fields/base/constants.h"
#include "fields/base/time.h"
#include "twin/inspection/defect/defect_kind.h"

namespace slackwater::api {

using nlohmann::json;

/// The pixels of one defect, walked down the columns from the left.
struct PixelMask {
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

namespace {

using constants::degree;

std::map<std::uint16_t, PixelMask> masks_of(const twin::TruthFrame& truth) {
  std::map<std::uint16_t, PixelMask> masks;
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

bool can_be_told(const twin::StagedDefect& defect) noexcept {
  return defect.size_m >= defect.quality.detail_m &&
         defect.signal_to_noise >= PictureLabels::least_signal_to_noise;
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

json& PictureLabels::add_image(const twin::TruthFrame& truth, const std::string& file) {
  json& images = set_["images"];
  images.push_back({{"id", images.size() + 1},
                    {"file_name", file},
                    {"width", truth.wide},
                    {"height", truth.high}});
  return images.back();
}

json& PictureLabels::add_annotation(twin::DefectKind kind, const PixelMask& mask,
                                    const twin::TruthFrame& truth, std::uint32_t number) {
  json& annotations = set_["annotations"];
  annotations.push_back(
      {{"id", annotations.size() + 1},
       {"image_id", set_["images"].size()},
       {"category_id", category_of(kind)},
       {"bbox", {mask.left, mask.top, mask.right - mask.left, mask.bottom - mask.top}},
       {"area", mask.pixels},
       {"segmentation", {{"size", {truth.high, truth.wide}}, {"counts", mask.runs}}},
       {"iscrowd", mask.pixels < least_pixels ? 1 : 0},
       {"planted_number", number}});
  return annotations.back();
}

void PictureLabels::add(const RenderView& view, const std::string& file) {
  const auto* camera = std::get_if<CameraView>(&view.seen);
  if (camera == nullptr) return;
  add_image(camera->truth, file)["date_captured"] = format_utc(view.time);
  for (const auto& [number, mask] : masks_of(camera->truth)) {
    const SeenDefect& defect = view.defects.at(number - 1U);
    add_annotation(defect.kind, mask, camera->truth, defect.number);
  }
}

void PictureLabels::add(const twin::StagedLook& look, const std::string& file) {
  const auto enu = [](const twin::Triple<double>& v) { return json{v.y, v.x, -v.z}; };
  json planted = json::array();
  for (const twin::StagedDefect& defect : look.defects)
    planted.push_back(
        {{"kind", twin::name_of(defect.kind)},
         {"size_m", defect.size_m},
         {"width_m", defect.width_m},
         {"range_m", defect.quality.range_m},
         {"detail_m",
          std::isfinite(defect.quality.detail_m) ? json(defect.quality.detail_m) : json()},
         {"ground_sampling_m", defect.quality.ground_sampling_m},
         {"contrast", defect.quality.contrast},
         {"light", defect.quality.light},
         {"centre_px", defect.centre_px},
         {"pixels", defect.pixels},
         {"signal_to_noise", defect.signal_to_noise}});
  add_image(look.truth, file)["look"] = {{"number", look.number},
                                         {"range_m", look.range_m},
                                         {"off_square_deg", look.off_square_rad / degree},
                                         {"depth_m", look.depth_m},
                                         {"visibility_m", look.visibility_m},
                                         {"daylight", look.daylight},
                                         {"lamps", look.lamps},
                                         {"growth", look.growth},
                                         {"water", look.water},
                                         {"seen_m2", look.seen_m2},
                                         {"camera_matrix", look.matrix},
                                         {"position_enu_m", enu(look.pose.position_m)},
                                         {"axis_enu", enu(look.pose.axis)},
                                         {"right_enu", enu(look.pose.right)},
                                         {"planted", planted}};
  for (const auto& [number, mask] : masks_of(look.truth)) {
    const twin::StagedDefect& defect = look.defects.at(number - 1U);
    json& label = add_annotation(defect.kind, mask, look.truth, number - 1U);
    if (!can_be_told(defect)) label["iscrowd"] = 1;
  }
}

}  // namespace slackwater::api
