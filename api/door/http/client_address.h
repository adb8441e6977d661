#pragma once
#include <sys/socket.h>

#include <string>

namespace slackwater::api::http {

/// Whose a connection is, where clients share: its address, as bytes. Of IPv6 the network (/64):
/// who has one has all its addresses.
[[nodiscard]] std::string client_address(const sockaddr_storage& peer);

}  // namespace slackwater::api::http
