#include "fields/base/encode/base64.h"

#include <openssl/evp.h>

#include "fields/base/check.h"

namespace slackwater {

std::string base64_of(std::span<const std::uint8_t> bytes) {
  expects(bytes.size() < (std::size_t{1} << 30U), "a length that fits in an int");
  // The library ends it with a zero of its own.
  std::string coded((bytes.size() + 2) / 3 * 4 + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(coded.data()), bytes.data(),
                                     static_cast<int>(bytes.size()));
  coded.resize(static_cast<std::size_t>(length));
  return coded;
}

}  // namespace slackwater
