#include <png.h>
#include <turbojpeg.h>

#include <fstream>
#include <iterator>
#include <memory>

#include "api/perception/picture_size.h"
#include "api/perception/read_picture.h"
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

/// Whether a PNG was read whole, of the size that it states.
bool read_png(const std::vector<std::uint8_t>& bytes, twin::Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) return false;
  image.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(image));
  // It frees the image, whether it succeeds or not.
  if (png_image_finish_read(&image, nullptr, rgba.data(), 0, nullptr) == 0) return false;
  if (rgba.size() / 4 * 3 != picture.rgb.size()) return false;
  for (std::size_t from = 0, to = 0; from < rgba.size(); from += 4)
    for (std::size_t c = 0; c < 3; ++c) picture.rgb[to++] = rgba[from + c];
  return true;
}

/// The same of a JPEG; what it is only warned of (a file that is cut) is a damage, too.
bool read_jpeg(const std::vector<std::uint8_t>& bytes, twin::Picture& picture) {
  const std::unique_ptr<void, int (*)(void*)> decoder(tjInitDecompress(), tjDestroy);
  int wide = 0, high = 0, subsampling = 0, space = 0;
  const auto size = static_cast<unsigned long>(bytes.size());  // NOLINT: as its interface has it
  return decoder != nullptr &&
         tjDecompressHeader3(decoder.get(), bytes.data(), size, &wide, &high, &subsampling,
                             &space) == 0 &&
         wide == picture.wide && high == picture.high &&
         tjDecompress2(decoder.get(), bytes.data(), size, picture.rgb.data(), wide, 0, high,
                       TJPF_RGB, TJFLAG_ACCURATEDCT) == 0;
}

}  // namespace

twin::Picture read_picture(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = bytes_of(file);
  const auto size = stated_size(bytes);
  if (!size)
    refuse("found " + file.string() + ", which is neither PNG nor JPEG, expected one of them");
  if (size->wide == 0 || size->high == 0 || std::uint64_t{size->wide} * size->high > most_pixels)
    refuse(formatted("found a picture of {} x {} pixels in {}, expected 1 to {} pixels", size->wide,
                     size->high, file.string(), most_pixels));
  twin::Picture picture{static_cast<int>(size->wide), static_cast<int>(size->high), {}};
  picture.rgb.resize(std::size_t{3} * size->wide * size->high);
  const bool is_png = bytes.front() == 0x89;
  if (!(is_png ? read_png(bytes, picture) : read_jpeg(bytes, picture)))
    refuse("found a damaged picture in " + file.string() + ": copy it again from where it came");
  return picture;
}

}  // namespace slackwater::api
