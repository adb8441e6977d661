#include "api/door/http/request_reader.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slackwater::tests::request_reader_test {
namespace {

using namespace slackwater::api::http;
using Progress = RequestReader::Progress;

Progress feed(RequestReader& reader, std::string_view bytes) {
  Progress progress = Progress::needs_more;
  while (!bytes.empty() && progress == Progress::needs_more) {
    const auto room = reader.room();
    const std::size_t n = std::min(room.size(), bytes.size());
    std::copy_n(bytes.begin(), n, room.begin());
    reader.received(n);
    bytes.remove_prefix(n);
    progress = reader.advance();
  }
  return progress;
}

const std::string request =
    "POST /a%20b?c=d?e HTTP/1.1\r\nHost: h:1\r\nAccept: x/y\r\nAccept: z\r\nOrigin: o\r\n"
    "If-None-Match: \"t\"\r\nAccept-Encoding: gzip\r\nAuthorization: Bearer s\r\n"
    "Transfer-Encoding: chunked\r\n\r\n4\r\nwind\r\n3\r\nsea\r\n0\r\n\r\n";

void expect_the_request(const Arrival& arrival) {
  EXPECT_EQ(arrival.request.method, "POST");
  EXPECT_EQ(arrival.request.path, "/a%20b");
  EXPECT_EQ(arrival.request.query, "c=d?e");
  EXPECT_EQ(arrival.request.host, "h:1");
  EXPECT_EQ(arrival.request.accept, "x/y, z");
  EXPECT_EQ(arrival.request.body, "windsea");
  EXPECT_EQ(arrival.request.origin, "o");
  EXPECT_EQ(arrival.if_none_match, "\"t\"");
  EXPECT_EQ(arrival.accept_encoding, "gzip");
  EXPECT_EQ(arrival.request.authorization, "Bearer s");
  EXPECT_FALSE(arrival.is_forwarded);
  EXPECT_TRUE(arrival.keep_alive);
}

TEST(RequestReader, WhereTheBytesAreCutDoesNotMatter) {
  const Limits limits;
  for (std::size_t cut = 1; cut < request.size(); ++cut) {
    RequestReader reader(limits);
    ASSERT_EQ(feed(reader, request.substr(0, cut)), Progress::needs_more) << cut;
    ASSERT_EQ(feed(reader, request.substr(cut)), Progress::complete) << cut;
    expect_the_request(reader.take());
    EXPECT_FALSE(reader.has_bytes());
  }
}

TEST(RequestReader, RequestsOneAfterTheOtherAreThoseSentAlone) {
  const Limits limits;
  RequestReader reader(limits);
  ASSERT_EQ(feed(reader, request + request + "GET / HTTP/1.0\r\n\r\n"), Progress::complete);
  expect_the_request(reader.take());
  ASSERT_TRUE(reader.has_bytes());
  ASSERT_EQ(reader.advance(), Progress::complete);
  expect_the_request(reader.take());
  ASSERT_EQ(reader.advance(), Progress::complete);
  const Arrival last = reader.take();
  EXPECT_EQ(last.request.path, "/");
  EXPECT_EQ(last.host_fields, 0U);
  EXPECT_FALSE(last.is_http_1_1);
  EXPECT_FALSE(last.keep_alive);
}

TEST(RequestReader, LimitsHoldToTheByte) {
  Limits limits;
  limits.url_bytes = 10;
  limits.body_bytes = 5;
  const auto outcome = [&](const std::string& bytes) {
    RequestReader reader(limits);
    return feed(reader, bytes) == Progress::refused ? reader.refusal().status : 200;
  };
  EXPECT_EQ(outcome("GET /123456789 HTTP/1.1\r\n\r\n"), 200);
  EXPECT_EQ(outcome("GET /1234567890 HTTP/1.1\r\n\r\n"), 414);
  EXPECT_EQ(outcome("POST / HTTP/1.1\r\nContent-Length: 5\r\n\r\n12345"), 200);
  EXPECT_EQ(outcome("POST / HTTP/1.1\r\nContent-Length: 6\r\n\r\n"), 413) << "before it is sent";
}

TEST(RequestReader, AsksForTheBodyOnceWhereTheSenderWaits) {
  const Limits limits;
  RequestReader reader(limits);
  EXPECT_FALSE(reader.wants_continue());
  const std::string head = "POST / HTTP/1.1\r\nExpect: 100-Continue\r\nContent-Length: 2\r\n\r\n";
  ASSERT_EQ(feed(reader, head), Progress::needs_more);
  EXPECT_TRUE(reader.wants_continue());
  EXPECT_FALSE(reader.wants_continue());
  ASSERT_EQ(feed(reader, "hi"), Progress::complete);
  EXPECT_EQ(reader.take().request.body, "hi");
}

}  // namespace
}  // namespace slackwater::tests::request_reader_test
