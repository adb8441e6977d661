#pragma once
#include <cstddef>
#include <ctime>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slackwater::api::http {

using Fields = std::vector<std::pair<std::string, std::string>>;

/// "Sun, 06 Nov 1994 08:49:37 GMT" (RFC 9110 §5.6.7), whatever the locale.
[[nodiscard]] std::string http_date(std::time_t time);

/// Status line, the fields every answer carries, these fields, and the empty line. A field with a
/// control character in it (a handler echoed what a client sent) is a ContractViolation.
/// @param length  of the body; 204 and 304 carry none
[[nodiscard]] std::string response_head(int status, const Fields& fields, std::size_t length,
                                        bool keep_alive);

}  // namespace slackwater::api::http
