#include "api/door/dds/network_card.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <sys/socket.h>

#include <memory>

#include "fields/base/error.h"

namespace slackwater::dds {

void expect_network_card(const std::string& address) {
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0)
    throw Error(ErrorKind::unavailable, "the network cards of this machine cannot be listed");
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> all(first, &::freeifaddrs);
  std::string found;
  for (const ifaddrs* card = first; card != nullptr; card = card->ifa_next) {
    if (card->ifa_addr == nullptr || card->ifa_addr->sa_family != AF_INET) continue;
    const auto* const at = reinterpret_cast<const sockaddr_in*>(card->ifa_addr);
    char text[INET_ADDRSTRLEN] = {};
    ::inet_ntop(AF_INET, &at->sin_addr, text, sizeof text);
    if (address == text) return;
    found += (found.empty() ? "" : ", ") + std::string(text) + " (" + card->ifa_name + ")";
  }
  throw Error(ErrorKind::invalid_input, "no network card of this machine has the address '" +
                                            address + "': found " + found +
                                            "; give --interface one of these addresses");
}

}  // namespace slackwater::dds
