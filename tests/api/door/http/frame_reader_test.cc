#include "api/door/http/frame_reader.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/support/websocket_client.h"

// The frames of RFC 6455 §5.7, and all the ways to get one wrong.

namespace slackwater::tests::frame_reader_test {
namespace {

using api::http::close_frame;
using api::http::control_frame;
using api::http::frame_head;
using api::http::FrameReader;
using api::http::Incoming;
using api::http::is_utf8;
using api::http::Opcode;
using Kind = Incoming::Kind;

constexpr std::size_t most = std::size_t{64} * 1024;

/// All that a reader makes of bytes that come in pieces of that size.
std::vector<Incoming> read(const std::string& bytes, std::size_t piece = std::string::npos,
                           std::size_t message_bytes = most) {
  FrameReader reader(message_bytes);
  std::vector<Incoming> all;
  for (std::size_t from = 0; from < bytes.size();) {
    const auto room = reader.room();
    const std::size_t count = std::min({piece, room.size(), bytes.size() - from});
    std::copy_n(bytes.data() + from, count, room.data());
    reader.received(count);
    from += count;
    while (auto incoming = reader.next()) {
      all.push_back(*incoming);
      if (all.back().kind == Kind::failed) return all;
    }
  }
  return all;
}

/// The code that bytes are refused with; 0 where they are not.
int refusal(const std::string& bytes) {
  const auto all = read(bytes);
  return all.empty() || all.back().kind != Kind::failed ? 0 : all.back().code;
}

std::string masked(std::uint8_t first_byte, std::uint8_t length, const std::string& rest) {
  return {static_cast<char>(first_byte) + std::string(1, static_cast<char>(length | 0x80U)) + rest};
}

TEST(FrameReader, ReadsTheExamplesOfTheStandard) {
  const std::string hello("\x81\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58", 11);
  const auto message = read(hello);
  ASSERT_EQ(message.size(), 1U);
  EXPECT_EQ(message[0].kind, Kind::text);
  EXPECT_EQ(message[0].bytes, "Hello");
  const std::string ping("\x89\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58", 11);
  EXPECT_EQ(read(ping).at(0).kind, Kind::ping);
  EXPECT_EQ(read(ping).at(0).bytes, "Hello");
}

TEST(FrameReader, MakesTheSameOfBytesHoweverTheyAreCut) {
  const std::string bytes = client_frame(0x81, "wind") + client_frame(0x02, std::string(300, 'a')) +
                            client_frame(0x89, "are you there") +
                            client_frame(0x00, std::string(200, 'b')) +
                            client_frame(0x80, std::string(100, 'c')) + client_frame(0x8a, "") +
                            client_frame(0x82, std::string(65000, 'd')) +
                            client_frame(0x88, std::string("\x03\xe8", 2) + "bye");
  for (const std::size_t piece : {1U, 2U, 7U, 1000U, 16384U, 100000U}) {
    const auto all = read(bytes, piece);
    ASSERT_EQ(all.size(), 6U) << piece;
    EXPECT_EQ(all[0].bytes, "wind");
    EXPECT_EQ(all[1].kind, Kind::ping) << "control frames come between those of a message";
    EXPECT_EQ(all[2].kind, Kind::binary);
    EXPECT_EQ(all[2].bytes, std::string(300, 'a') + std::string(200, 'b') + std::string(100, 'c'));
    EXPECT_EQ(all[3].kind, Kind::pong);
    EXPECT_EQ(all[4].bytes, std::string(65000, 'd'));
    EXPECT_EQ(all[5].kind, Kind::close);
    EXPECT_EQ(all[5].code, 1000);
    EXPECT_EQ(all[5].bytes, "bye");
  }
}

TEST(FrameReader, AMessageMayBeAsLongAsIsSaidAndNoLonger) {
  EXPECT_EQ(read(client_frame(0x82, std::string(most, 'x'))).at(0).bytes.size(), most);
  EXPECT_EQ(refusal(client_frame(0x82, std::string(most + 1, 'x'))), 1009);
  // In two frames; and one that says so is refused before its bytes have come.
  const std::string half(most / 2 + 1, 'x');
  EXPECT_EQ(refusal(client_frame(0x02, half) + client_frame(0x80, half)), 1009);
  EXPECT_EQ(refusal(std::string("\x82\xff\x00\x00\x00\xff\x00\x00\x00\x00", 10)), 1009);
}

TEST(FrameReader, WhatBreaksTheProtocolIsRefusedWithItsCode) {
  EXPECT_EQ(refusal(client_frame(0x81, "not masked", false)), 1002);
  for (const int bit : {0x40, 0x20, 0x10}) {
    EXPECT_EQ(refusal(client_frame(static_cast<std::uint8_t>(0x81 | bit), "x")), 1002);
  }
  for (const int opcode : {3, 4, 5, 6, 7, 11, 12, 13, 14, 15}) {
    EXPECT_EQ(refusal(client_frame(static_cast<std::uint8_t>(0x80 | opcode), "x")), 1002);
  }
  EXPECT_EQ(refusal(client_frame(0x09, "ping in pieces")), 1002);
  EXPECT_EQ(refusal(client_frame(0x89, std::string(126, 'x'))), 1002);
  EXPECT_EQ(refusal(client_frame(0x80, "continues nothing")), 1002);
  EXPECT_EQ(refusal(client_frame(0x01, "a") + client_frame(0x81, "b")), 1002);
  const std::string mask(4, '\0');
  EXPECT_EQ(refusal(masked(0x82, 126, std::string("\x00\x05", 2) + mask + "short")), 1002);
  EXPECT_EQ(refusal(masked(0x82, 127, std::string(6, '\0') + "\xff\xff" + mask)), 1002);
  EXPECT_EQ(refusal(masked(0x82, 127, "\x80" + std::string(7, '\0') + mask)), 1002);
  EXPECT_EQ(refusal(client_frame(0x88, "x")), 1002) << "half a code";
  for (const int code : {0, 999, 1004, 1005, 1006, 1015, 1100, 2999, 5000}) {
    const std::string bytes{static_cast<char>(code >> 8), static_cast<char>(code)};
    EXPECT_EQ(refusal(client_frame(0x88, bytes)), 1002) << code;
  }
  EXPECT_EQ(refusal(client_frame(0x81, "\xff\xfe")), 1007);
  EXPECT_EQ(refusal(client_frame(0x88, "\x03\xe8\xc3")), 1007);
}

TEST(FrameReader, ATextMayBeCutWithinACharacter) {
  const auto all = read(client_frame(0x01, "\xc3") + client_frame(0x80, "\xa9"));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].bytes, "\u00e9");
}

TEST(FrameReader, AfterAFailureNothingIsRead) {
  FrameReader reader(most);
  const std::string bytes = client_frame(0x83, "x") + client_frame(0x81, "well-formed");
  const auto room = reader.room();
  std::copy(bytes.begin(), bytes.end(), room.data());
  reader.received(bytes.size());
  ASSERT_TRUE(reader.next());
  EXPECT_FALSE(reader.next());
}

TEST(FrameReader, NoMutatedFramesEndIt) {
  std::mt19937 random(20261105);
  const std::string valid = client_frame(0x01, "wind") + client_frame(0x89, "") +
                            client_frame(0x80, " and wave") +
                            client_frame(0x82, std::string(200, 'x')) + client_frame(0x88, "");
  std::size_t failed = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string bytes = valid;
    for (std::size_t k = 0; k <= random() % 3; ++k) {
      bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    }
    const auto all = read(bytes, 1 + random() % 64);
    EXPECT_LE(all.size(), bytes.size() / 6);
    if (!all.empty() && all.back().kind == Kind::failed) ++failed;
  }
  EXPECT_GT(failed, 1000U);
}

TEST(FrameWriter, WritesTheShortestLengths) {
  EXPECT_EQ(frame_head(Opcode::text, 5), std::string("\x81\x05", 2));
  EXPECT_EQ(frame_head(Opcode::binary, 125), std::string("\x82\x7d", 2));
  EXPECT_EQ(frame_head(Opcode::binary, 256), std::string("\x82\x7e\x01\x00", 4));
  EXPECT_EQ(frame_head(Opcode::binary, 65535), std::string("\x82\x7e\xff\xff", 4));
  EXPECT_EQ(frame_head(Opcode::binary, 65536),
            std::string("\x82\x7f\x00\x00\x00\x00\x00\x01\x00\x00", 10));
}

TEST(FrameWriter, ControlFramesAreShort) {
  EXPECT_EQ(control_frame(Opcode::pong, "Hello"), "\x8a\x05Hello");
  EXPECT_EQ(control_frame(Opcode::ping, std::string(200, 'x')).size(), 127U);
  EXPECT_EQ(close_frame(1001, "gone"), std::string("\x88\x06\x03\xe9gone", 8));
  EXPECT_EQ(close_frame(1005, "said nothing"), std::string("\x88\x00", 2));
  std::string accents;
  for (int i = 0; i < 100; ++i) accents += "\u00e9";
  const std::string cut = close_frame(1000, accents);
  EXPECT_EQ(cut.size(), 2U + 2U + 122U) << "61 characters of two bytes";
  EXPECT_TRUE(is_utf8(cut.substr(4)));
}

TEST(Utf8, IsWhatRfc3629Says) {
  for (const std::string good : {"", "wind", "\u00e9", "\u20ac", "\U0001f30a", "\xf4\x8f\xbf\xbf",
                                 "\xed\x9f\xbf", "\xee\x80\x80"}) {
    EXPECT_TRUE(is_utf8(good)) << good;
  }
  for (const std::string bad :
       {"\x80", "\xc0\x80", "\xc1\xbf", "\xc3", "\xc3\x28", "\xe0\x9f\xbf", "\xed\xa0\x80",
        "\xe2\x82", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "a\xfe"}) {
    EXPECT_FALSE(is_utf8(bad)) << bad;
  }
}

}  // namespace
}  // namespace slackwater::tests::frame_reader_test
