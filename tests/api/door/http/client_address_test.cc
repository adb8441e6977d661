#include "api/door/http/client_address.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>

namespace slackwater::tests::client_address_test {
namespace {

std::string client(const char* address) {
  sockaddr_storage peer{};
  auto& v4 = reinterpret_cast<sockaddr_in&>(peer);
  auto& v6 = reinterpret_cast<sockaddr_in6&>(peer);
  peer.ss_family = AF_INET;
  if (::inet_pton(AF_INET, address, &v4.sin_addr) != 1) {
    peer.ss_family = AF_INET6;
    EXPECT_EQ(::inet_pton(AF_INET6, address, &v6.sin6_addr), 1) << address;
  }
  return api::http::client_address(peer);
}

TEST(ClientAddress, IsOneForANetworkOfIpv6) {
  EXPECT_EQ(client("2001:db8:1:2::1"), client("2001:db8:1:2:ffff:1:2:3"));
  EXPECT_NE(client("2001:db8:1:2::1"), client("2001:db8:1:3::1"));
}

TEST(ClientAddress, IsEachOneOfIpv4) {
  EXPECT_NE(client("10.0.0.1"), client("10.0.0.2"));
  EXPECT_NE(client("::ffff:10.0.0.1"), client("::ffff:10.0.0.2")) << "as IPv6 has it";
  EXPECT_EQ(client("127.0.0.1"), client("127.0.0.1"));
  EXPECT_NE(client("::1"), client("::2"));
}

}  // namespace
}  // namespace slackwater::tests::client_address_test
