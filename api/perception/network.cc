#include "api/perception/network.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

#include "api/perception/network_file.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

constexpr std::size_t most_found = 300;
constexpr double unsure_from = 0.05;
/// Some hundred bytes a pixel are between the layers.
constexpr std::size_t most_pixels_at_once = 50'000'000;
constexpr double most_difference = 1e-4;

/// Why, without where in its sources.
std::string in_one_line(const cv::Exception& problem) {
  std::string why = problem.err;
  std::replace_if(
      why.begin(), why.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return std::string(trimmed(why));
}

double sigmoid(double logit) noexcept { return 1 / (1 + std::exp(-logit)); }

/// How the pixels of the input lie on the picture's: picture = input x scale.
struct Fitted {
  cv::Mat blob;
  double scale = 1;
};

class Network : public Detector {
 public:
  Network(NetworkFile model, const cv::dnn::Net& net, std::string name)
      : model_(std::move(model)), net_(net), name_(std::move(name)) {
    net_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    net_.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
    for (const HeadGrid& grid : model_.grids) outputs_.push_back(grid.output);
    if (model_.rows) outputs_.push_back(model_.rows->output);
  }

  [[nodiscard]] const std::vector<std::string>& kinds() const noexcept override {
    return model_.kinds;
  }

  [[nodiscard]] std::vector<Detection> find(const twin::Picture& picture) override {
    return found_in(picture, model_.least_confidence);
  }
  [[nodiscard]] std::vector<Detection> find_unsure_too(const twin::Picture& picture) override {
    return found_in(picture, std::min(unsure_from, model_.least_confidence));
  }
  [[nodiscard]] double least_confidence() const noexcept override {
    return model_.least_confidence;
  }

  /// @throws Error(invalid_input) where it does not say what its file says that it must
  void prove() {
    twin::Picture picture{model_.proof.wide, model_.proof.high, {}};
    picture.rgb.resize(3 * static_cast<std::size_t>(picture.wide) *
                       static_cast<std::size_t>(picture.high));
    for (std::size_t k = 0; k < picture.rgb.size(); ++k)
      picture.rgb[k] =
          static_cast<std::uint8_t>((2654435761U * (static_cast<std::uint32_t>(k) + 1U) +
                                     40503U * static_cast<std::uint32_t>(model_.proof.seed)) >>
                                    24U);
    const std::vector<cv::Mat> heads = forward(fit(picture).blob);
    for (const HeadSays& said : model_.proof.heads) {
      const auto nth = std::find(outputs_.begin(), outputs_.end(), said.output);
      if (nth == outputs_.end())
        refuse(name_ + ": test: found the head " + said.output +
               ", which is none of those decoded");
      const cv::Mat& head = heads[static_cast<std::size_t>(nth - outputs_.begin())];
      for (std::size_t i = 0; i < said.at.size(); ++i) {
        if (!(said.at[i] < static_cast<double>(head.total())))
          refuse(formatted("{}: test: found number {} of the head {}, which has {}", name_,
                           said.at[i], said.output, head.total()));
        const double is = head.ptr<float>()[static_cast<std::size_t>(said.at[i])];
        if (!(std::abs(is - said.is[i]) <= most_difference))
          refuse(
              formatted("{}: its test is not passed: head {} says {:g} at {}, expected {:g} within "
                        "{:g}: OpenCV does not compute this network as it was trained; export it "
                        "again with plainer operations",
                        name_, said.output, is, said.at[i], said.is[i], most_difference));
      }
    }
  }

 private:
  [[nodiscard]] std::vector<Detection> found_in(const twin::Picture& picture, double least) {
    if (!model_.input.fitted &&
        static_cast<std::size_t>(picture.wide) * static_cast<std::size_t>(picture.high) >
            most_pixels_at_once)
      refuse(
          formatted("found a picture of {} x {} pixels, expected at most {} for a network that "
                    "looks at all of them: cut it into parts, or scale it down",
                    picture.wide, picture.high, most_pixels_at_once));
    const Fitted fitted = fit(picture);
    std::vector<Detection> found;
    const std::vector<cv::Mat> heads = forward(fitted.blob);
    for (std::size_t i = 0; i < model_.grids.size(); ++i)
      decode_grid(model_.grids[i], heads[i], fitted.blob, least, found);
    if (model_.rows) decode_rows(*model_.rows, heads.front(), least, found);
    for (Detection& one : found) {
      PixelBox& box = one.box;
      box.left = std::clamp(box.left * fitted.scale, 0.0, double(picture.wide));
      box.right = std::clamp(box.right * fitted.scale, 0.0, double(picture.wide));
      box.top = std::clamp(box.top * fitted.scale, 0.0, double(picture.high));
      box.bottom = std::clamp(box.bottom * fitted.scale, 0.0, double(picture.high));
    }
    std::erase_if(found, [](const Detection& one) { return !(one.box.area() > 0); });
    return without_doubles(std::move(found), model_.most_overlap, most_found);
  }

  [[nodiscard]] Fitted fit(const twin::Picture& picture) const {
    const cv::Mat rgb(picture.high, picture.wide, CV_8UC3,
                      const_cast<std::uint8_t*>(picture.rgb.data()));  // NOLINT: only read
    cv::Mat small = rgb;
    double scale = 1;
    int wide = 0, high = 0;
    if (model_.input.fitted) {
      wide = (*model_.input.fitted)[0];
      high = (*model_.input.fitted)[1];
      scale = std::max(double(picture.wide) / wide, double(picture.high) / high);
      cv::resize(rgb, small,
                 {std::clamp(int(std::lround(picture.wide / scale)), 1, wide),
                  std::clamp(int(std::lround(picture.high / scale)), 1, high)},
                 0, 0, scale > 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
    } else {
      const int of = model_.input.multiple_of;
      wide = (picture.wide + of - 1) / of * of;
      high = (picture.high + of - 1) / of * of;
    }
    const std::array<int, 4> shape{1, 3, high, wide};
    cv::Mat blob(4, shape.data(), CV_32F, cv::Scalar(0));
    for (int plane = 0; plane < 3; ++plane) {
      const auto c = static_cast<std::size_t>(plane);
      for (int row = 0; row < small.rows; ++row) {
        const std::uint8_t* from = small.ptr<std::uint8_t>(row) + plane;
        float* to = blob.ptr<float>(0, plane) + static_cast<std::ptrdiff_t>(row) * wide;
        for (int column = 0; column < small.cols; ++column)
          to[column] =
              static_cast<float>((from[std::ptrdiff_t{3} * column] / 255.0 - model_.input.mean[c]) /
                                 model_.input.sd[c]);
      }
    }
    return {blob, scale};
  }

  [[nodiscard]] std::vector<cv::Mat> forward(const cv::Mat& blob) {
    std::vector<cv::Mat> heads;
    try {
      net_.setInput(blob);
      net_.forward(heads, outputs_);
    } catch (const cv::Exception& problem) {
      refuse(name_ + ": OpenCV cannot compute it (" + in_one_line(problem) +
             "): export it with plainer operations");
    }
    for (std::size_t i = 0; i < heads.size(); ++i)
      if (heads[i].type() != CV_32F || !heads[i].isContinuous())
        refuse(name_ + ": found the output " + outputs_[i] + " not in single precision");
    return heads;
  }

  void decode_grid(const HeadGrid& grid, const cv::Mat& head, const cv::Mat& blob, double least,
                   std::vector<Detection>& found) const {
    const auto kinds = static_cast<int>(model_.kinds.size());
    const int high = blob.size[2] / grid.stride_px, wide = blob.size[3] / grid.stride_px;
    if (head.dims != 4 || head.size[0] != 1 || head.size[1] != kinds + 4 || head.size[2] != high ||
        head.size[3] != wide)
      refuse(formatted(
          "{}: found {} in the output {}, expected 1 x {} x {} x {}: {} kinds and four "
          "sides, stride {}",
          name_, shape_of(head), grid.output, kinds + 4, high, wide, kinds, grid.stride_px));
    const auto number = [&](int plane, int row, int column) {
      return static_cast<double>(
          head.ptr<float>(0, plane)[static_cast<std::ptrdiff_t>(row) * wide + column]);
    };
    for (int kind = 0; kind < kinds; ++kind) {
      for (int row = 0; row < high; ++row) {
        for (int column = 0; column < wide; ++column) {
          const double confidence = sigmoid(number(kind, row, column));
          if (!(confidence >= least)) continue;
          const auto side = [&](int nth) {
            return grid.stride_px * std::exp(std::min(8.0, number(kinds + nth, row, column)));
          };
          const double x = grid.stride_px * (column + 0.5), y = grid.stride_px * (row + 0.5);
          found.push_back({model_.kinds[static_cast<std::size_t>(kind)],
                           confidence,
                           {x - side(0), y - side(1), x + side(2), y + side(3)}});
        }
      }
    }
  }

  void decode_rows(const HeadRows& rows, const cv::Mat& head, double least,
                   std::vector<Detection>& found) const {
    const std::size_t kinds = model_.kinds.size();
    const auto width = static_cast<int>(kinds + (rows.has_objectness ? 5 : 4));
    const int many = head.dims == 3 ? head.size[rows.is_transposed ? 2 : 1] : 0;
    if (head.dims != 3 || head.size[0] != 1 || head.size[rows.is_transposed ? 1 : 2] != width)
      refuse(formatted("{}: found {} in the output {}, expected {} numbers a row{}: {} kinds",
                       name_, shape_of(head), rows.output, width,
                       rows.is_transposed ? " (transposed)" : "", kinds));
    const auto number = [&](int row, std::size_t nth) {
      const auto at = rows.is_transposed
                          ? nth * static_cast<std::size_t>(many) + static_cast<std::size_t>(row)
                          : static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + nth;
      return static_cast<double>(head.ptr<float>()[at]);
    };
    for (int row = 0; row < many; ++row) {
      const double of_any = rows.has_objectness ? number(row, 4) : 1;
      for (std::size_t kind = 0; kind < kinds; ++kind) {
        const double confidence = of_any * number(row, kind + (rows.has_objectness ? 5 : 4));
        if (!(confidence >= least)) continue;
        const double x = number(row, 0), y = number(row, 1);
        const double half_wide = number(row, 2) / 2, half_high = number(row, 3) / 2;
        found.push_back({model_.kinds[kind],
                         std::min(1.0, confidence),
                         {x - half_wide, y - half_high, x + half_wide, y + half_high}});
      }
    }
  }

  static std::string shape_of(const cv::Mat& head) {
    std::vector<std::string> sides;
    sides.reserve(static_cast<std::size_t>(head.dims));
    for (int i = 0; i < head.dims; ++i) sides.push_back(std::to_string(head.size[i]));
    return joined(sides, " x ");
  }

  NetworkFile model_;
  cv::dnn::Net net_;
  std::string name_;
  std::vector<cv::String> outputs_;
};

}  // namespace

std::unique_ptr<Detector> read_network(const Config& config, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / config.text("file");
  const std::string stated = config.text("sha256");
  NetworkFile model = read_network_file(config);
  if (!std::filesystem::is_regular_file(file))
    config.refuse("file", "found no file " + file.string());
  if (const std::string is = sha256_of_file(file, {}); is != stated)
    config.refuse("sha256", "found " + stated + ", but the file's is " + is +
                                ": one of the two is of another model");
  // What it has to say comes back as an error of ours; it would print it as well.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::dnn::Net net;
  try {
    net = cv::dnn::readNetFromONNX(file.string());
  } catch (const cv::Exception& problem) {
    config.refuse("file", "OpenCV cannot read it (" + in_one_line(problem) +
                              "): expected ONNX of operators 11 to 15");
  }
  if (net.empty()) config.refuse("file", "OpenCV reads no network in it");
  auto network = std::make_unique<Network>(std::move(model), std::move(net), file.string());
  network->prove();
  return network;
}

}  // namespace slackwater::api
