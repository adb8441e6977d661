#include "api/perception/corrosion_by_colour.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "api/perception/pieces.h"

namespace slackwater::api {
namespace {

struct Colours {
  std::string of;
  double least_hue_deg = 0;
  double most_hue_deg = 0;
  double least_saturation = 0;
  double least_a = 0;
  double least_b = 0;
  double full_chroma = 0;
  double least_area_px = 0;
};

class ColourDetector : public Detector {
 public:
  explicit ColourDetector(Colours colours) : colours_(std::move(colours)), kinds_{colours_.of} {}
  [[nodiscard]] const std::vector<std::string>& kinds() const noexcept override { return kinds_; }

  [[nodiscard]] std::vector<Detection> find(const twin::Picture& picture) override {
    // The view is read only, for which OpenCV has no type.
    const cv::Mat rgb(picture.high, picture.wide, CV_8UC3,
                      const_cast<std::uint8_t*>(picture.rgb.data()));  // NOLINT
    cv::Mat real, hsv, lab;
    rgb.convertTo(real, CV_32FC3, 1.0 / 255);
    cv::cvtColor(real, hsv, cv::COLOR_RGB2HSV);
    cv::cvtColor(real, lab, cv::COLOR_RGB2Lab);
    std::vector<std::uint8_t> mask(real.total());
    std::vector<float> chroma(real.total());
    for (std::size_t i = 0; i < mask.size(); ++i) {
      const cv::Vec3f& h = hsv.at<cv::Vec3f>(static_cast<int>(i));
      const cv::Vec3f& l = lab.at<cv::Vec3f>(static_cast<int>(i));
      mask[i] = is_rust(h, l) ? 1 : 0;
      chroma[i] = std::hypot(l[1], l[2]);
    }
    std::vector<Detection> found;
    const double least_chroma = std::hypot(colours_.least_a, colours_.least_b);
    for (const Piece& piece : pieces_of(mask, chroma, picture.wide, picture.high)) {
      const auto area = static_cast<double>(piece.area_px);
      if (area < colours_.least_area_px) continue;
      const double vivid = (piece.sum / area - least_chroma) / colours_.full_chroma;
      found.push_back(
          {colours_.of, area / piece.box.area() * std::clamp(vivid, 0.0, 1.0), piece.box});
    }
    return surest_first(std::move(found));
  }

 private:
  [[nodiscard]] bool is_rust(const cv::Vec3f& hsv, const cv::Vec3f& lab) const noexcept {
    const double hue_deg = hsv[0];
    return hue_deg >= colours_.least_hue_deg && hue_deg <= colours_.most_hue_deg &&
           hsv[1] >= colours_.least_saturation && lab[1] >= colours_.least_a &&
           lab[2] >= colours_.least_b;
  }

  Colours colours_;
  std::vector<std::string> kinds_;
};

}  // namespace

std::unique_ptr<Detector> read_colour_detector(const Config& config) {
  const std::vector<double> hue = config.numbers("hue_deg", {0, 360});
  if (hue.size() != 2 || hue[0] > hue[1])
    config.refuse("hue_deg", "expected [least, most], from 0 to 360");
  return std::make_unique<ColourDetector>(
      Colours{config.text("of"), hue[0], hue[1], config.number("least_saturation", {0, 1}),
              config.number("least_a", {-128, 127}), config.number("least_b", {-128, 127}),
              config.number("full_chroma", {1, 200}), config.number("least_area_px", {1, 1e6})});
}

}  // namespace slackwater::api
