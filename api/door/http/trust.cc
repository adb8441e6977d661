#include "api/door/http/trust.h"

#include <cctype>

namespace slackwater::api::http {
namespace {

/// The host without its port; "" where what follows it is no port.
std::string_view name_of_host(std::string_view host) {
  const std::size_t end = host.starts_with('[') ? host.find(']') : host.find(':');
  const std::string_view name = host.substr(0, host.starts_with('[') ? end + 1 : end);
  const std::string_view port = host.substr(name.size());
  const bool is_port =
      port.empty() || (port[0] == ':' && port.find_first_not_of("0123456789", 1) == port.npos);
  return is_port ? name : std::string_view();
}

}  // namespace

bool equal_in_constant_time(std::string_view a, std::string_view b) noexcept {
  unsigned difference = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const char other = b.empty() ? '\0' : b[i % b.size()];
    difference |= static_cast<unsigned char>(a[i] ^ other);
  }
  return difference == 0;
}

bool is_loopback_host(std::string_view host) {
  const std::string_view name = name_of_host(host);
  // Only an address: the owner of a domain may well have a host called 127.0.0.1.example.org.
  const bool is_number = name.find_first_not_of("0123456789.") == std::string_view::npos;
  return name == "localhost" || name == "[::1]" || (is_number && name.starts_with("127."));
}

bool is_numeric_host(std::string_view host) {
  const std::string_view name = name_of_host(host);
  if (name.starts_with('[')) {
    return name.size() > 2 && name.ends_with(']') &&
           name.find_first_not_of("0123456789abcdefABCDEF:.", 1) == name.size() - 1;
  }
  return !name.empty() && name.find_first_not_of("0123456789.") == std::string_view::npos;
}

bool is_trusted(const std::optional<std::string>& token, const Arrival& arrival) {
  const std::string_view offered = bearer_of(arrival.request.authorization);
  if (token && !token->empty() && equal_in_constant_time(offered, *token)) return true;
  const std::string& origin = arrival.request.origin;
  const bool same_origin = origin.empty() || origin == "http://" + arrival.request.host;
  return arrival.peer_is_loopback && !arrival.is_forwarded && same_origin &&
         is_loopback_host(arrival.request.host);
}

bool is_of_own_origin(const Request& request) {
  const std::string& origin = request.origin;
  return origin.empty() || origin == "http://" + request.host ||
         origin == "https://" + request.host;
}

std::string_view bearer_of(std::string_view authorization) noexcept {
  constexpr std::string_view scheme = "bearer ";
  if (authorization.size() <= scheme.size()) return {};
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    if (std::tolower(static_cast<unsigned char>(authorization[i])) != scheme[i]) return {};
  }
  authorization.remove_prefix(scheme.size());
  authorization.remove_prefix(std::min(authorization.find_first_not_of(' '), authorization.size()));
  return authorization;
}

}  // namespace slackwater::api::http
