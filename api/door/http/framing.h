#pragma once
#include <boost/beast/http/message.hpp>
#include <cstddef>
#include <optional>

#include "api/door/http/refusal.h"

namespace slackwater::api::http {

// Where a request begins and ends is read in one way only, or not at all: what two readers could
// take for different requests is refused (RFC 9112 §11.2, request smuggling).
// Only sources of this folder include this.

/// Of a header that was read: a target that is not plain text, a field that is too long, a length
/// that is stated twice or in two ways, codings that are unknown or twice there, CONNECT.
/// @param field_bytes  of one field, its name and value
[[nodiscard]] std::optional<Refusal> framing_fault(const boost::beast::http::request_header<>& head,
                                                   std::size_t field_bytes);

}  // namespace slackwater::api::http
