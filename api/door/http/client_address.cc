#include "api/door/http/client_address.h"

#include <netinet/in.h>

namespace slackwater::api::http {

std::string client_address(const sockaddr_storage& peer) {
  if (peer.ss_family != AF_INET6) {
    const in_addr& v4 = reinterpret_cast<const sockaddr_in&>(peer).sin_addr;
    return {reinterpret_cast<const char*>(&v4), sizeof v4};
  }
  const in6_addr& v6 = reinterpret_cast<const sockaddr_in6&>(peer).sin6_addr;
  const bool is_whole = IN6_IS_ADDR_V4MAPPED(&v6) || IN6_IS_ADDR_LOOPBACK(&v6);
  return {reinterpret_cast<const char*>(v6.s6_addr), is_whole ? sizeof v6 : sizeof v6 / 2};
}

}  // namespace slackwater::api::http
