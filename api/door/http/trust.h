#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "api/door/http/exchange.h"

namespace slackwater::api::http {

/// Whether the request may write: it carries the token; or it comes from this machine, was not
/// passed on by a proxy, and no web page of another origin made the browser send it (a page may
/// post to http://127.0.0.1 without asking, and DNS may name it as its own host: both Host and
/// Origin are looked at).
[[nodiscard]] bool is_trusted(const std::optional<std::string>& token, const Arrival& arrival);

/// A page of this server, or what is no page: no script of another origin made a browser ask.
[[nodiscard]] bool is_of_own_origin(const Request& request);

/// The token of "Bearer TOKEN"; "" of anything else.
[[nodiscard]] std::string_view bearer_of(std::string_view authorization) noexcept;

/// "localhost", "127.0.0.1", "[::1]", with or without a port.
[[nodiscard]] bool is_loopback_host(std::string_view host);

/// An address in numbers, with or without a port: what DNS cannot point elsewhere.
[[nodiscard]] bool is_numeric_host(std::string_view host);

/// Equality whose time does not tell where two strings differ.
[[nodiscard]] bool equal_in_constant_time(std::string_view a, std::string_view b) noexcept;

}  // namespace slackwater::api::http
