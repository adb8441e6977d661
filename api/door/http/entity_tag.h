#pragma once
#include <string>
#include <string_view>

namespace slackwater::api::http {

/// A strong validator of exactly these bytes, quoted: half of their SHA-256, so that two bodies
/// never share one; 128 bits.
[[nodiscard]] std::string entity_tag(std::string_view body);

/// The tag of the same entity in another coding: "a" becomes "a-gzip".
[[nodiscard]] std::string coded_tag(std::string_view tag, std::string_view coding);

/// Whether an If-None-Match field names the tag (RFC 9110 §13.1.2: "*" does, weak tags compare
/// equal to strong ones).
[[nodiscard]] bool matches_tag(std::string_view if_none_match, std::string_view tag);

}  // namespace slackwater::api::http
