#include "fields/base/encode/sha1.h"

#include <openssl/evp.h>

#include <array>
#include <span>

#include "fields/base/encode/base64.h"
#include "fields/base/error.h"

namespace slackwater {

std::string sha1_base64(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &length, EVP_sha1(), nullptr) != 1) {
    throw Error(ErrorKind::internal, "SHA-1 is refused by the cryptographic library");
  }
  return base64_of(std::span(digest).first(length));
}

}  // namespace slackwater
