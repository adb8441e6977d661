#pragma once
#include <string>
#include <string_view>

namespace slackwater::api::http {

/// Whether an Accept-Encoding field prefers gzip to the plain body (RFC 9110 §12.5.3): q-values
/// and "*" count, an absent or malformed field means the plain body.
[[nodiscard]] bool prefers_gzip(std::string_view accept_encoding);

/// Text of some kind, which coding makes smaller; NetCDF and images are not.
[[nodiscard]] bool is_worth_coding(std::string_view media_type, std::size_t body_bytes);

/// The body as a gzip member (RFC 1952), zlib level 4: half the time of the default level for some
/// 5 % more bytes. Thread-safe; each thread keeps one compressor.
[[nodiscard]] std::string gzip(std::string_view body);

}  // namespace slackwater::api::http
