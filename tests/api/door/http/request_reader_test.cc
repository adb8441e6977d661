#include "api/door/http/request_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

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

std::string outcome_of(const std::string& bytes, std::size_t cut = std::string::npos) {
  const Limits limits;
  RequestReader reader(limits);
  Progress progress = feed(reader, std::string_view(bytes).substr(0, cut));
  if (progress == Progress::needs_more && cut < bytes.size())
    progress = feed(reader, std::string_view(bytes).substr(cut));
  if (progress == Progress::refused) return std::to_string(reader.refusal().status);
  if (progress == Progress::needs_more) return "more";
  return reader.take().request.body + (reader.has_bytes() ? " and more" : "");
}

// RFC 9112: what two readers could take for different requests is no request at all.
TEST(RequestReader, ALengthThatIsDoubtfulIsRefusedWithItsStatus) {
  struct Doubtful {
    const char* head;
    const char* outcome;
  };
  const std::vector<Doubtful> all{
      {"POST / HTTP/1.1\r\nTransfer-Encoding: chunked, gzip\r\n\r\n", "501"},
      {"POST / HTTP/1.1\r\nTransfer-Encoding: gzip, chunked\r\n\r\n", "501"},
      {"POST / HTTP/1.1\r\nTransfer-Encoding: chunked, chunked\r\n\r\n", "400"},
      {"POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n\r\n",
       "400"},
      {"POST / HTTP/1.1\r\nTransfer-Encoding: chunked,\r\n\r\n", "400"},
      {"POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\nContent-Length: 5\r\n\r\n", "400"},
      {"POST / HTTP/1.1\r\nContent-Length: 5\r\nContent-Length: 5\r\n\r\nhello", "400"},
      {"POST / HTTP/1.1\r\nContent-Length: 5, 5\r\n\r\nhello", "400"},
      {"POST / HTTP/1.1\r\nContent-Length: +5\r\n\r\nhello", "400"},
      {"POST / HTTP/1.0\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n", "400"},
      {"CONNECT h:80 HTTP/1.1\r\nHost: h\r\n\r\nGET / HTTP/1.1\r\n\r\n", "501"},
      {"CONNECT / HTTP/1.1\r\nHost: h\r\n\r\nGET / HTTP/1.1\r\n\r\n", "501"},
      {"GET /\xc3\xa4 HTTP/1.1\r\n", "400"},
      {"GET a HTTP/1.1\r\n\r\n", "400"},
      {"GET http://h:1/a HTTP/1.1\r\n\r\n", ""},
      {"GET / HTTP/1.1\r\nA: b\r\n c\r\n\r\n", "400"},
      {"GET / HTTP/1.1\r\nA: b\nC: d\r\n\r\n", "400"},
      {"GET / HTTP/1.1\r\nA: b\rC: d\r\n\r\n", "400"},
      {"HEAD / HTTP/1.1\r\nContent-Length: 5\r\n\r\nGET /HEAD / HTTP/1.1\r\n\r\n",
       "GET / and more"},
  };
  for (const Doubtful& one : all) EXPECT_EQ(outcome_of(one.head), one.outcome) << one.head;
}

TEST(RequestReader, ChunksAreReadInOneWayOnly) {
  struct Doubtful {
    const char* body;
    const char* outcome;
  };
  const std::string head = "POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n";
  const std::vector<Doubtful> all{
      {"5\r\nhello\r\n0\r\n\r\n", "hello"},
      {"00005;a=b\r\nhello\r\n0\r\n\r\nGET ", "hello and more"},
      {"5\nhello\n0\n\n", "400"},
      {"5 \r\nhello\r\n0\r\n\r\n", "400"},
      {"0x5\r\nhello\r\n0\r\n\r\n", "400"},
      {"-5\r\n", "400"},
      {"h", "400"},
      {"5\r\nhellox\r\n", "400"},
      {"ffffffffffffffff\r\n", "413"},
      {"00000000000000005\r\n", "400"},
      {"0\r\nA b\r\n", "400"},
      {"0\r\n\n", "400"},
  };
  for (const Doubtful& one : all)
    for (std::size_t cut = head.size(); cut <= head.size() + 3; ++cut)
      EXPECT_EQ(outcome_of(head + one.body, cut), one.outcome) << one.body << ", cut at " << cut;
  EXPECT_EQ(outcome_of(head + "5;" + std::string(9000, 'x')), "431");
}

TEST(RequestReader, ARefusalSaysWhatWasFoundAndWhatIsExpected) {
  const std::string chunked = "POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n";
  const std::vector<std::pair<std::string, std::string>> all{
      {"POST / HTTP/1.1\r\nContent-Length: 5x\r\n\r\n",
       "Content-Length is no number here, or is there twice; it is one whole number."},
      {"POST / HTTP/1.1\r\nContent-Length: 5\r\nContent-Length: 5\r\n\r\n",
       "Content-Length is there 2 times; send it once."},
      {"GET here HTTP/1.1\r\n\r\n",
       "The target of this request is 'here'; it begins with '/', or with a scheme and '://'."},
      {"GET /\xe4 HTTP/1.1\r\n", "The first line holds the byte 0xe4; write it percent-encoded."},
      {"GET / HTTP/1.1\r\nA: b\n",
       "Found the byte 0x0a at the end of a line of the header; lines end with CR LF."},
      {chunked + "h",
       "Found the byte 0x68 in the size of a chunk; that is hexadecimal digits, and "
       "then ';' or CR LF."},
      {chunked + "0\r\nA b",
       "Found the byte 0x20 in the name of a trailer; that is a name, ':' and "
       "a value, on one line."}};
  for (const auto& [bytes, detail] : all) {
    const Limits limits;
    RequestReader reader(limits);
    ASSERT_EQ(feed(reader, bytes), Progress::refused) << bytes;
    EXPECT_EQ(reader.refusal().detail, detail);
  }
}

// Behind the body a sender may not say who it is, or what it accepts.
TEST(RequestReader, TrailersSayNothing) {
  const Limits limits;
  RequestReader reader(limits);
  ASSERT_EQ(feed(reader,
                 "POST / HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n"
                 "Authorization: Bearer t\r\nHost: evil\r\nConnection: close\r\n\r\n"),
            Progress::complete);
  const Arrival arrival = reader.take();
  EXPECT_EQ(arrival.request.authorization, "");
  EXPECT_EQ(arrival.request.host, "h");
  EXPECT_EQ(arrival.host_fields, 1U);
  EXPECT_TRUE(arrival.keep_alive);
}

TEST(RequestReader, OneFieldIsNotTooLong) {
  const std::string head = "GET / HTTP/1.1\r\nX: ";
  EXPECT_EQ(outcome_of(head + std::string(16 * 1024 - 1, 'x') + "\r\n\r\n"), "");
  EXPECT_EQ(outcome_of(head + std::string(16 * 1024, 'x') + "\r\n\r\n"), "431");
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
