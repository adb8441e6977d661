#pragma once
#include <string>
#include <string_view>

namespace slackwater {

/// SHA-1 (FIPS 180-4) of a text, in base64: the answer to a WebSocket's key, as RFC 6455 §4.2.2
/// prescribes it. It protects nothing; what names files is `Sha256`.
[[nodiscard]] std::string sha1_base64(std::string_view text);

}  // namespace slackwater
