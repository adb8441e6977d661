#include "api/perception/crack_by_percolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "api/perception/pieces.h"

namespace slackwater::api {
namespace {

struct Form {
  std::string of;
  int window_px = 0;
  double least_darker = 0;
  double least_edge = 0;
  double most_roundness = 0;
  double least_length_px = 0;
  double full_length_px = 0;
};

/// The region that percolates from the middle of a window: the darkest of all pixels beside it
/// joins next, until one on the window's border does.
class Percolation {
 public:
  explicit Percolation(int window_px)
      : side_(window_px), met_(static_cast<std::size_t>(window_px * window_px)) {}

  /// F of the region about a pixel. @param grey  8 bits
  double roundness(const cv::Mat& grey, int column, int row) {
    const int left = column - side_ / 2, top = row - side_ / 2;
    std::fill(met_.begin(), met_.end(), std::uint8_t{0});
    for (std::vector<int>& of_level : beside_) of_level.clear();
    box_ = {side_, side_, -1, -1};
    count_ = 0;
    int level = grey.at<std::uint8_t>(row, column);
    meet(side_ / 2, side_ / 2, level);
    while (true) {
      while (level < 256 && beside_[static_cast<std::size_t>(level)].empty()) ++level;
      if (level == 256) return shape();  // the whole picture
      const int next = beside_[static_cast<std::size_t>(level)].back();
      beside_[static_cast<std::size_t>(level)].pop_back();
      const int c = next % side_, r = next / side_;
      take(c, r);
      if (c == 0 || r == 0 || c == side_ - 1 || r == side_ - 1) return shape();
      for (int y = std::max(0, top + r - 1); y <= std::min(grey.rows - 1, top + r + 1); ++y) {
        for (int x = std::max(0, left + c - 1); x <= std::min(grey.cols - 1, left + c + 1); ++x) {
          const int of_pixel = grey.at<std::uint8_t>(y, x);
          meet(x - left, y - top, of_pixel);
          level = std::min(level, of_pixel);
        }
      }
    }
  }

 private:
  void meet(int c, int r, int level) {
    std::uint8_t& is_met = met_[static_cast<std::size_t>(r * side_ + c)];
    if (is_met == 0) beside_[static_cast<std::size_t>(level)].push_back(r * side_ + c);
    is_met = 1;
  }
  void take(int c, int r) noexcept {
    box_ = {std::min(box_[0], c), std::min(box_[1], r), std::max(box_[2], c), std::max(box_[3], r)};
    ++count_;
  }
  [[nodiscard]] double shape() const noexcept {
    const double longest = std::max(box_[2] - box_[0], box_[3] - box_[1]) + 1;
    return std::min(1.0, 4.0 * count_ / (std::numbers::pi * longest * longest));
  }

  int side_;
  std::vector<std::uint8_t> met_;
  std::array<std::vector<int>, 256> beside_;  ///< pixels that touch the region, by their level
  std::array<int, 4> box_{};                  // left, top, right, bottom
  int count_ = 0;
};

/// Prewitt's gradient, grey levels over two pixels.
cv::Mat steepness(const cv::Mat& grey) {
  const cv::Mat across = (cv::Mat_<float>(3, 3) << -1, 0, 1, -1, 0, 1, -1, 0, 1) / 3.F;
  cv::Mat x, y, both;
  cv::filter2D(grey, x, CV_32F, across);
  cv::filter2D(grey, y, CV_32F, across.t());
  cv::magnitude(x, y, both);
  return both;
}

class PercolationDetector : public Detector {
 public:
  explicit PercolationDetector(Form form)
      : form_(std::move(form)), kinds_{form_.of}, percolation_(form_.window_px) {}
  [[nodiscard]] const std::vector<std::string>& kinds() const noexcept override { return kinds_; }

  [[nodiscard]] std::vector<Detection> find(const twin::Picture& picture) override {
    const cv::Mat rgb(picture.high, picture.wide, CV_8UC3,
                      const_cast<std::uint8_t*>(picture.rgb.data()));  // NOLINT: only read
    cv::Mat grey, mean, steep;
    cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
    cv::blur(grey, mean, {form_.window_px, form_.window_px});
    cv::dilate(steepness(grey), steep, cv::Mat());
    std::vector<std::uint8_t> mask(grey.total());
    std::vector<float> longness(grey.total());
    for (int row = 0; row < grey.rows; ++row) {
      for (int column = 0; column < grey.cols; ++column) {
        const int darker = mean.at<std::uint8_t>(row, column) - grey.at<std::uint8_t>(row, column);
        if (darker < form_.least_darker ||
            static_cast<double>(steep.at<float>(row, column)) < form_.least_edge)
          continue;
        const double roundness = percolation_.roundness(grey, column, row);
        if (roundness > form_.most_roundness) continue;
        const auto at = static_cast<std::size_t>(row * grey.cols + column);
        mask[at] = 1;
        longness[at] = static_cast<float>(1 - roundness);
      }
    }
    std::vector<Detection> found;
    for (const Piece& piece : pieces_of(mask, longness, grey.cols, grey.rows)) {
      const double length_px =
          std::hypot(piece.box.right - piece.box.left, piece.box.bottom - piece.box.top);
      if (length_px < form_.least_length_px) continue;
      found.push_back({form_.of,
                       piece.sum / static_cast<double>(piece.area_px) *
                           std::min(1.0, length_px / form_.full_length_px),
                       piece.box});
    }
    return surest_first(std::move(found));
  }

 private:
  Form form_;
  std::vector<std::string> kinds_;
  Percolation percolation_;
};

}  // namespace

std::unique_ptr<Detector> read_percolation_detector(const Config& config) {
  const int window = config.integer("window_px", 5, 401);
  if (window % 2 == 0) config.refuse("window_px", "expected an odd number: a pixel is its middle");
  return std::make_unique<PercolationDetector>(
      Form{config.text("of"), window, config.number("least_darker", {1, 255}),
           config.number("least_edge", {0, 255}), config.number("most_roundness", {0, 1}),
           config.number("least_length_px", {1, 1e5}), config.number("full_length_px", {1, 1e5})});
}

}  // namespace slackwater::api
