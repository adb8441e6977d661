#include "api/perception/jpeg.h"

#include <turbojpeg.h>

#include <memory>
#include <string>

#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::api {

std::vector<std::uint8_t> jpeg_of(const twin::Picture& picture, int quality) {
  expects(picture.wide > 0 && picture.high > 0 &&
              picture.rgb.size() == std::size_t{3} * static_cast<std::size_t>(picture.wide) *
                                        static_cast<std::size_t>(picture.high),
          "a picture has three bytes a pixel");
  const std::unique_ptr<void, int (*)(void*)> encoder(tjInitCompress(), tjDestroy);
  unsigned char* made = nullptr;
  unsigned long size = 0;  // NOLINT: as its interface has it
  const bool is_made =
      encoder != nullptr &&
      tjCompress2(encoder.get(), picture.rgb.data(), picture.wide, 0, picture.high, TJPF_RGB, &made,
                  &size, TJSAMP_420, quality, TJFLAG_ACCURATEDCT) == 0;
  const std::unique_ptr<unsigned char, void (*)(unsigned char*)> bytes(made, tjFree);
  if (!is_made)
    throw Error(ErrorKind::internal, std::string("a picture could not be made a JPEG: ") +
                                         tjGetErrorStr2(encoder.get()));
  return {bytes.get(), bytes.get() + size};
}

}  // namespace slackwater::api
