#include "tests/api/perception/plates_for_tests.h"

#include <turbojpeg.h>
#include <zlib.h>

#include <fstream>
#include <string>

namespace slackwater::tests {
namespace {

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(value >> static_cast<unsigned>(shift));
  return bytes;
}

/// ISO/IEC 15948, 5.3.
std::string chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + body +
         big_endian(static_cast<std::uint32_t>(sum));
}

}  // namespace

twin::Picture plate(int wide, int high, const Colour& colour) {
  twin::Picture picture{wide, high, {}};
  picture.rgb.resize(static_cast<std::size_t>(3 * wide * high));
  paint(picture, 0, 0, wide, high, colour);
  return picture;
}

void paint(twin::Picture& picture, int left, int top, int right, int bottom, const Colour& colour) {
  for (int row = top; row < bottom; ++row)
    for (int column = left; column < right; ++column)
      for (int c = 0; c < 3; ++c)
        picture.rgb[static_cast<std::size_t>(3 * (row * picture.wide + column) + c)] =
            colour[static_cast<std::size_t>(c)];
}

void write_png(const std::filesystem::path& file, const twin::Picture& picture) {
  std::string rows;
  const auto width = static_cast<std::size_t>(3 * picture.wide);
  for (int row = 0; row < picture.high; ++row) {
    rows += '\0';  // no filter
    rows.append(reinterpret_cast<const char*>(picture.at(0, row)), width);
  }
  uLongf size = compressBound(static_cast<uLong>(rows.size()));
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(rows.data()), static_cast<uLong>(rows.size()));
  packed.resize(size);
  std::string head = big_endian(static_cast<std::uint32_t>(picture.wide)) +
                     big_endian(static_cast<std::uint32_t>(picture.high));
  head += std::string("\x08\x02\x00\x00\x00", 5);  // 8 bits, red green blue
  std::ofstream(file, std::ios::binary)
      << "\x89PNG\r\n\x1a\n"
      << chunk("IHDR", head) << chunk("IDAT", packed) << chunk("IEND", "");
}

void write_jpeg(const std::filesystem::path& file, const twin::Picture& picture) {
  const tjhandle encoder = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;  // NOLINT: as the library's interface has it
  tjCompress2(encoder, picture.rgb.data(), picture.wide, 0, picture.high, TJPF_RGB, &bytes, &size,
              TJSAMP_444, 100, 0);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  tjFree(bytes);
  tjDestroy(encoder);
}

}  // namespace slackwater::tests
