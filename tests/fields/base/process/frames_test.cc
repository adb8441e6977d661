#include "fields/base/process/frames.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace slackwater::frames_test {
namespace {

std::string frame(char kind, const std::string& bytes) {
  const std::uint64_t size = bytes.size();
  return std::string(1, kind) + std::string(reinterpret_cast<const char*>(&size), sizeof size) +
         bytes;
}

struct Heard {
  Told told;
  std::vector<double> shares;
  void take(const std::string& bytes) {
    told.take(bytes, [this](double share) { shares.push_back(share); });
  }
};

TEST(ToldFrames, AreReadHoweverTheyAreCut) {
  const std::string all = frame('s', "250") + frame('s', "1000") + frame('a', "here it is");
  for (std::size_t piece = 1; piece <= all.size(); ++piece) {
    Heard heard;
    for (std::size_t at = 0; at < all.size(); at += piece) heard.take(all.substr(at, piece));
    EXPECT_EQ(heard.shares, (std::vector<double>{0.25, 1})) << piece;
    EXPECT_TRUE(heard.told.is_answered);
    EXPECT_EQ(heard.told.answer, "here it is") << piece;
  }
}

// A child that a file has taken over says what it likes.
TEST(ToldFrames, WhatIsNoShareCountsForNothing) {
  Heard heard;
  for (const char* share : {"nan", "-1", "1001", "1e300", "inf"}) heard.take(frame('s', share));
  heard.take(frame('x', "500"));
  EXPECT_TRUE(heard.shares.empty());
  EXPECT_FALSE(heard.told.is_answered);
}

TEST(ToldFrames, TheFirstAnswerIsTheAnswer) {
  Heard heard;
  heard.take(frame('a', "one") + frame('a', "two"));
  heard.take(frame('a', "three"));
  heard.take(frame('s', "500"));
  EXPECT_EQ(heard.told.answer, "one");
  EXPECT_TRUE(heard.shares.empty());
  EXPECT_TRUE(heard.told.bytes.empty());
}

TEST(ToldFrames, ALengthThatNeverComesIsNoAnswer) {
  Heard heard;
  std::string endless = frame('a', "one");
  endless[8] = '\x7f';
  heard.take(endless);
  EXPECT_FALSE(heard.told.is_answered);
}

}  // namespace
}  // namespace slackwater::frames_test
