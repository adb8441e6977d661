#include "fields/base/encode/sha1.h"

#include <gtest/gtest.h>

namespace slackwater::tests::sha1_test {
namespace {

TEST(Sha1, IsThatOfTheStandard) {
  EXPECT_EQ(sha1_base64(""), "2jmj7l5rSw0yVb/vlWAYkK/YBwk=");
  EXPECT_EQ(sha1_base64("abc"), "qZk+NkcGgWq6PiVxeFDCbJzQ2J0=") << "FIPS 180-4, a9993e36...";
  EXPECT_EQ(sha1_base64("dGhlIHNhbXBsZSBub25jZQ==258EAFA5-E914-47DA-95CA-C5AB0DC85B11"),
            "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=")
      << "RFC 6455 §1.3";
}

}  // namespace
}  // namespace slackwater::tests::sha1_test
