#include "api/door/http/outgoing_frames.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace slackwater::tests::outgoing_frames_test {
namespace {

using api::http::Frame;
using api::http::OutgoingFrames;
using api::http::Worth;

Frame frame(const std::string& name, Worth worth, std::size_t bytes = 1000) {
  return {false, name, std::make_shared<const std::vector<std::uint8_t>>(bytes), worth};
}

std::vector<std::string> names_left(OutgoingFrames& frames) {
  std::vector<std::string> names;
  while (auto next = frames.pop()) names.push_back(next->head);
  return names;
}

using Names = std::vector<std::string>;

TEST(OutgoingFrames, ComeOutInTheirOrderWhateverTheirWorth) {
  OutgoingFrames frames(1 << 20);
  const std::vector<Worth> worths{Worth::reliable, Worth::best_effort, Worth::essential};
  Names expected;
  for (std::size_t i = 0; i < 30; ++i) {
    expected.push_back(std::to_string(i));
    EXPECT_EQ(frames.push(frame(expected.back(), worths[i % 3])).dropped, 0U);
  }
  EXPECT_EQ(names_left(frames), expected);
  EXPECT_TRUE(frames.empty());
  EXPECT_EQ(frames.bytes(), 0U);
}

TEST(OutgoingFrames, FullTheyLoseTheOldestBestEffortFirst) {
  OutgoingFrames frames(5000);
  frames.push(frame("r1", Worth::reliable));
  frames.push(frame("b1", Worth::best_effort));
  frames.push(frame("b2", Worth::best_effort));
  frames.push(frame("r2", Worth::reliable));
  EXPECT_EQ(frames.push(frame("b3", Worth::best_effort)).dropped, 1U);
  EXPECT_EQ(frames.push(frame("r3", Worth::reliable)).dropped, 1U);
  EXPECT_EQ(frames.push(frame("r4", Worth::reliable)).dropped, 1U);
  EXPECT_EQ(frames.push(frame("r5", Worth::reliable)).dropped, 1U) << "the oldest reliable one";
  EXPECT_EQ(frames.push(frame("b4", Worth::best_effort)).dropped, 1U) << "itself";
  EXPECT_EQ(names_left(frames), (Names{"r2", "r3", "r4", "r5"}));
}

TEST(OutgoingFrames, NeverHoldMoreThanTheirBoundHoweverSmallTheFrames) {
  constexpr std::size_t bound = 100'000;
  OutgoingFrames frames(bound);
  std::size_t dropped = 0;
  for (int i = 0; i < 100'000; ++i) {
    dropped += frames.push(frame("", i % 2 == 0 ? Worth::best_effort : Worth::reliable, 1)).dropped;
    ASSERT_LE(frames.bytes(), bound);
  }
  const std::size_t left = names_left(frames).size();
  EXPECT_EQ(left + dropped, 100'000U) << "each is sent or counted";
  EXPECT_LT(left, 2000U) << "a frame costs more than its byte";
}

TEST(OutgoingFrames, OneLargerThanTheBoundIsTakenWhereNoOtherWaits) {
  OutgoingFrames frames(5000);
  EXPECT_EQ(frames.push(frame("image", Worth::best_effort, 50'000)).dropped, 0U);
  EXPECT_EQ(frames.push(frame("next", Worth::best_effort, 50'000)).dropped, 1U);
  EXPECT_EQ(names_left(frames), (Names{"next"}));
}

TEST(OutgoingFrames, EssentialOnesAreKeptUntilNothingHelps) {
  OutgoingFrames frames(5000);
  for (int i = 0; i < 36; ++i) {
    EXPECT_FALSE(frames.push(frame("e", Worth::essential)).is_overrun) << i;
  }
  EXPECT_EQ(frames.push(frame("b", Worth::best_effort)).dropped, 0U) << "they have their own room";
  EXPECT_TRUE(frames.push(frame("e", Worth::essential)).is_overrun);
  EXPECT_EQ(names_left(frames).size(), 37U);
}

}  // namespace
}  // namespace slackwater::tests::outgoing_frames_test
