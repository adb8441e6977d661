#include "api/ask/detect/run_finds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "fields/base/check.h"
#include "twin/inspection/defect/defect_kind.h"
#include "twin/render/frame/pinhole.h"
#include "twin/render/frame/pixel_footprint.h"

namespace slackwater::api {
namespace {

std::vector<ShownDefect> shown_in(const RenderView& view, const twin::TruthFrame& truth) {
  std::vector<ShownDefect> by_number(view.defects.size());
  const auto wide = static_cast<std::size_t>(truth.wide);
  for (std::size_t at = 0; at < truth.defect.size(); ++at) {
    if (truth.defect[at] == 0) continue;
    ShownDefect& one = by_number.at(truth.defect[at] - 1U);
    const auto column = static_cast<double>(at % wide), row = static_cast<double>(at / wide);
    if (one.pixels == 0) one.box = {column, row, column + 1, row + 1};
    one.box = {std::min(one.box.left, column), std::min(one.box.top, row),
               std::max(one.box.right, column + 1), std::max(one.box.bottom, row + 1)};
    ++one.pixels;
  }
  std::vector<ShownDefect> shown;
  for (std::size_t i = 0; i < by_number.size(); ++i) {
    if (by_number[i].pixels == 0) continue;
    const SeenDefect& defect = view.defects[i];
    by_number[i].number = defect.number;
    by_number[i].of = twin::name_of(defect.kind);
    by_number[i].surface = defect.surface;
    by_number[i].size_m = defect.size_m;
    shown.push_back(by_number[i]);
  }
  return shown;
}

double median_range_m(const twin::TruthFrame& truth) {
  std::vector<float> ranges_m;
  for (const float range_m : truth.range_m)
    if (std::isfinite(range_m)) ranges_m.push_back(range_m);
  if (ranges_m.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = ranges_m.begin() + static_cast<std::ptrdiff_t>(ranges_m.size() / 2);
  std::nth_element(ranges_m.begin(), middle, ranges_m.end());
  return *middle;
}

/// The side of a box, laid on the surface that its middle meets.
double size_on(const twin::PixelFootprint& pixel, const Detection& find) {
  const double wide = find.box.right - find.box.left, high = find.box.bottom - find.box.top;
  const twin::Triple<double> across = wide * pixel.side_m, down = high * pixel.down_m;
  if (find.of == twin::name_of(twin::DefectKind::crack))
    return std::sqrt(0.5 * (dot(across + down, across + down) + dot(across - down, across - down)));
  return std::max(length_of(across), length_of(down));
}

/// As it was zoomed then.
twin::FrameFootprint frame_of(const CameraView& camera) {
  twin::FrameFootprint frame;
  frame.pixels_wide = camera.truth.wide;
  frame.pixels_high = camera.truth.high;
  frame.horizontal_rad = 2 * std::atan(0.5 * frame.pixels_wide / camera.matrix[0]);
  frame.vertical_rad = 2 * std::atan(0.5 * frame.pixels_high / camera.matrix[4]);
  return frame;
}

class PlacesOfView {
 public:
  PlacesOfView(const RenderView& view, const CameraView& camera,
               const std::vector<ShownDefect>& shown)
      : view_(view), truth_(camera.truth), camera_(view.pose, frame_of(camera)), shown_(shown) {}

  [[nodiscard]] std::optional<PlacedFind> placed(const Detection& find) const {
    const auto pixel_at = [](double from, double to, int most) {
      return std::clamp(static_cast<int>(0.5 * (from + to)), 0, most - 1);
    };
    const int i = pixel_at(find.box.left, find.box.right, truth_.wide);
    const int j = pixel_at(find.box.top, find.box.bottom, truth_.high);
    const std::size_t at = static_cast<std::size_t>(j) * static_cast<std::size_t>(truth_.wide) +
                           static_cast<std::size_t>(i);
    if (truth_.instance[at] == 0) return std::nullopt;
    PlacedFind placed;
    placed.find = find;
    placed.surface = view_.things.at(truth_.instance[at] - 1U).name;
    placed.range_m = truth_.range_m[at];
    const twin::Ray ray = camera_.ray(i, j);
    placed.place_m = ray.from_m + placed.range_m * ray.direction;
    const auto& [right, down, along] = truth_.normal[at];
    const twin::Triple<double> face = static_cast<double>(right) * camera_.right() +
                                      static_cast<double>(down) * camera_.down() +
                                      static_cast<double>(along) * camera_.axis();
    placed.size_m = size_on({camera_, placed.place_m, face}, find);
    double most = 0;
    for (const ShownDefect& defect : shown_) {
      const double shared = defect.of == find.of ? overlap(find.box, defect.box) : 0;
      if (shared < least_shared_to_be_found || shared <= most) continue;
      most = shared;
      placed.defect = defect.number;
    }
    return placed;
  }

 private:
  const RenderView& view_;
  const twin::TruthFrame& truth_;
  twin::Pinhole camera_;
  const std::vector<ShownDefect>& shown_;
};

}  // namespace

RunFinds::RunFinds(std::vector<std::string> kinds) : kinds_(std::move(kinds)) {}

void RunFinds::add(const RenderView& view, const std::vector<Detection>& found) {
  const auto* camera = std::get_if<CameraView>(&view.seen);
  expects(camera != nullptr, "a picture of a camera");
  DetectedPicture picture;
  picture.t_s = view.t_s;
  picture.time = view.time;
  picture.wide = camera->picture.wide;
  picture.high = camera->picture.high;
  picture.range_m = median_range_m(camera->truth);
  picture.gain = camera->picture.gain;
  picture.shown = shown_in(view, camera->truth);
  const PlacesOfView places(view, *camera, picture.shown);
  for (const Detection& find : found)
    if (auto placed = places.placed(find)) picture.finds.push_back(std::move(*placed));
  pictures_.push_back(std::move(picture));
  for (PlacedFind& placed : pictures_.back().finds) placed.finding = join(placed);
}

std::size_t RunFinds::join(const PlacedFind& placed) {
  const std::size_t now = pictures_.size() - 1;
  RunFinding* nearest = nullptr;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (RunFinding& one : findings_) {
    if (one.of != placed.find.of || one.surface != placed.surface) continue;
    const double apart_m = length_of(one.place_m - placed.place_m);
    const double reach_m = std::max(same_place_m, 0.5 * std::max(one.size_m, placed.size_m));
    if (apart_m > reach_m || apart_m >= nearest_m) continue;
    nearest = &one;
    nearest_m = apart_m;
  }
  RunFinding mine;
  mine.of = placed.find.of;
  mine.surface = placed.surface;
  mine.place_m = placed.place_m;
  mine.size_m = placed.size_m;
  mine.range_m = placed.range_m;
  mine.confidence = placed.find.confidence;
  mine.time = pictures_.back().time;
  mine.picture = mine.last_picture = now;
  mine.pictures = 1;
  mine.defect = placed.defect;
  if (nearest == nullptr) {
    findings_.push_back(std::move(mine));
    return findings_.size() - 1;
  }
  // Two finds of one picture may lie at one place; the picture counts once.
  mine.pictures = nearest->pictures + (nearest->last_picture == now ? 0 : 1);
  if (!mine.defect) mine.defect = nearest->defect;
  if (mine.confidence <= nearest->confidence) {
    nearest->pictures = mine.pictures;
    nearest->last_picture = now;
    if (!nearest->defect) nearest->defect = mine.defect;
  } else {
    *nearest = std::move(mine);
  }
  return static_cast<std::size_t>(nearest - findings_.data());
}

std::vector<KindFound> RunFinds::score() const {
  std::vector<KindFound> out;
  for (const std::string& kind : kinds_) {
    std::set<std::uint32_t> in_view, found;
    for (const DetectedPicture& picture : pictures_) {
      for (const ShownDefect& defect : picture.shown)
        if (defect.of == kind && defect.pixels >= least_pixels) in_view.insert(defect.number);
      for (const PlacedFind& placed : picture.finds)
        if (placed.find.of == kind && placed.defect) found.insert(*placed.defect);
    }
    KindFound one;
    one.of = kind;
    one.in_view = in_view.size();
    one.found = static_cast<std::size_t>(
        std::count_if(in_view.begin(), in_view.end(),
                      [&](std::uint32_t number) { return found.contains(number); }));
    one.false_alarms = static_cast<std::size_t>(std::count_if(
        findings_.begin(), findings_.end(),
        [&](const RunFinding& finding) { return finding.of == kind && !finding.defect; }));
    out.push_back(one);
  }
  return out;
}

}  // namespace slackwater::api
