#include "api/show/render/png_file.h"

#include <png.h>

#include <memory>
#include <string>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {

// libpng's simplified interface: no jumps out of our frames.
void write_png(const std::filesystem::path& file, int wide, int high, int values_of_pixel,
               std::span<const std::uint8_t> values) {
  expects(values_of_pixel == 1 || values_of_pixel == 3, "grey or colours");
  expects(values.size() == static_cast<std::size_t>(wide) * static_cast<std::size_t>(high) *
                               static_cast<std::size_t>(values_of_pixel),
          "as many values as pixels");
  write_beside(file, [&](const std::filesystem::path& partial) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(wide);
    image.height = static_cast<png_uint_32>(high);
    image.format = values_of_pixel == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
    const bool is_written =
        png_image_write_to_file(&image, partial.c_str(), 0, values.data(), 0, nullptr) != 0;
    const std::string problem = is_written ? "" : image.message;
    png_image_free(&image);
    if (!is_written)
      throw Error(ErrorKind::unavailable, "cannot write " + file.string() + ": " + problem);
  });
}

}  // namespace slackwater::api
