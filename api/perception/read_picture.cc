#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>

#include "api/perception/picture.h"
#include "api/perception/picture_size.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

constexpr std::uintmax_t most_file_bytes = 200'000'000;

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw Error(ErrorKind::not_found, "found no file " + file.string());
  if (!std::filesystem::is_regular_file(file))
    refuse("found " + file.string() + ", which is no regular file, expected a PNG or JPEG picture");
  if (const auto size = std::filesystem::file_size(file); size > most_file_bytes)
    refuse(formatted("found {} bytes in {}, expected a picture of at most {}", size, file.string(),
                     most_file_bytes));
  std::ifstream stream(file, std::ios::binary);
  std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.good() && !stream.eof())
    throw Error(ErrorKind::unavailable, "could not read " + file.string());
  return bytes;
}

}  // namespace

Picture read_picture(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = bytes_of(file);
  const auto size = stated_size(bytes);
  if (!size)
    refuse("found " + file.string() + ", which is neither PNG nor JPEG, expected one of them");
  if (size->wide == 0 || size->high == 0 || std::uint64_t{size->wide} * size->high > most_pixels)
    refuse(formatted("found a picture of {} x {} pixels in {}, expected 1 to {} pixels", size->wide,
                     size->high, file.string(), most_pixels));
  cv::Mat decoded;
  try {
    decoded = cv::imdecode(bytes, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    decoded.release();
  }
  if (decoded.empty() || decoded.type() != CV_8UC3 || !decoded.isContinuous() ||
      static_cast<std::uint32_t>(decoded.cols) != size->wide ||
      static_cast<std::uint32_t>(decoded.rows) != size->high)
    refuse("found a damaged picture in " + file.string() + ": copy it again from where it came");
  Picture picture{decoded.cols, decoded.rows, {}};
  picture.rgb.resize(3 * decoded.total());
  const std::uint8_t* bgr = decoded.data;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    picture.rgb[i] = bgr[i + 2];
    picture.rgb[i + 1] = bgr[i + 1];
    picture.rgb[i + 2] = bgr[i];
  }
  return picture;
}

}  // namespace slackwater::api
