#pragma once
#include <string>
#include <string_view>

namespace slackwater::api::edr {

/// What a '+' means: in a query it stands for a blank (the form encoding), in a path for itself.
enum class Plus { is_blank, is_plus };

/// The bytes behind a percent-encoded text (RFC 3986, 2.1), e.g. "POINT%280%2051%29" -> "POINT(0 51)".
/// Throws Error(usage) for '%' without two hexadecimal digits and for an encoded NUL, naming `name`.
[[nodiscard]] std::string percent_decoded(std::string_view name, std::string_view text, Plus plus);

/// All but the unreserved characters of RFC 3986 encoded: fit for a path segment, a query value or a
/// header.
[[nodiscard]] std::string percent_encoded(std::string_view text);

}  // namespace slackwater::api::edr
