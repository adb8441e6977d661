// The frames of a station: what is in them, and how many.
#include "api/door/people/wire/frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "session/session_generated.h"

namespace slackwater::tests::frame_test {
namespace {

using people::FrameFlow;
using people::FrameHead;
using people::Pose;

const slackwater::session::Frame* read(const std::string& bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  flatbuffers::Verifier verifier(data, bytes.size());
  EXPECT_TRUE(slackwater::session::VerifyFrameBuffer(verifier));
  EXPECT_TRUE(slackwater::session::FrameBufferHasIdentifier(data));
  return slackwater::session::GetFrame(data);
}

std::vector<Pose> poses(std::size_t count) {
  std::vector<Pose> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    all[i].vehicle = static_cast<std::uint16_t>(i);
    all[i].east_m = static_cast<float>(i);
    all[i].charge = std::nanf("");
  }
  return all;
}

FrameHead at(std::uint64_t clock_ms) {
  FrameHead head;
  head.clock_ms = clock_ms;
  return head;
}

TEST(SessionFrames, CarryEachNumberOfAPose) {
  Pose pose{1, 2, -3, 0.1F, 0.2F, 0.3F, 4, 5, 6, 7, 8, 9, 0.75F, 12, true};
  const std::string bytes =
      people::encode_frame({3, 1ULL << 40U, 12.5, 1ULL << 41U, true, 7}, {&pose, 1});
  const auto* frame = read(bytes);
  EXPECT_EQ(frame->number(), 3U);
  EXPECT_EQ(frame->step(), 1ULL << 40U);
  EXPECT_EQ(frame->time_s(), 12.5);
  EXPECT_EQ(frame->clock_ms(), 1ULL << 41U);
  EXPECT_EQ(frame->left_out(), 7U);
  const auto* p = frame->poses()->Get(0);
  EXPECT_EQ(p->vehicle(), 12);
  EXPECT_TRUE(p->halted());
  const float got[] = {p->east_m(),
                       p->north_m(),
                       p->up_m(),
                       p->roll_rad(),
                       p->pitch_rad(),
                       p->heading_rad(),
                       p->east_m_s(),
                       p->north_m_s(),
                       p->up_m_s(),
                       p->current_east_m_s(),
                       p->current_north_m_s(),
                       p->bed_m(),
                       p->charge()};
  const float want[] = {1, 2, -3, 0.1F, 0.2F, 0.3F, 4, 5, 6, 7, 8, 9, 0.75F};
  for (int i = 0; i < 13; ++i) EXPECT_EQ(got[i], want[i]) << i;
}

TEST(SessionFrames, AreWholeAtFirstThenWhatHasChanged) {
  FrameFlow flow;
  std::vector<Pose> now = poses(20);
  EXPECT_TRUE(read(flow.next(now, at(0)))->is_whole());
  now[7].east_m += 1;
  const std::string bytes = flow.next(now, at(50));
  EXPECT_FALSE(read(bytes)->is_whole());
  ASSERT_EQ(read(bytes)->poses()->size(), 1U);
  EXPECT_EQ(read(bytes)->poses()->Get(0)->vehicle(), 7);
  EXPECT_TRUE(flow.next(now, at(100)).empty()) << "nothing is new";
  EXPECT_FALSE(flow.next(now, at(250)).empty()) << "but it is there, and says so";
  // One that joins.
  now = poses(21);
  now[7].east_m += 1;
  EXPECT_EQ(read(flow.next(now, at(300)))->poses()->Get(0)->vehicle(), 20);
}

// A station that does not keep up has all that changed in the next frame, and knows what it missed.
TEST(SessionFrames, WaitForWhoDoesNotKeepUpAndLoseNothing) {
  FrameFlow flow;
  std::vector<Pose> now = poses(2);
  std::uint64_t clock = 0;
  for (std::uint32_t i = 0; i < FrameFlow::most_ahead; ++i) {
    now[0].east_m += 1;
    EXPECT_FALSE(flow.next(now, at(clock += 50)).empty());
  }
  for (int i = 0; i < 9; ++i) {
    now[i % 2].east_m += 1;
    EXPECT_TRUE(flow.next(now, at(clock += 50)).empty());
  }
  EXPECT_EQ(flow.take_left_out(), 9U);
  EXPECT_EQ(flow.take_left_out(), 0U);
  EXPECT_FALSE(flow.saw(FrameFlow::most_ahead + 1)) << "it was never sent";
  EXPECT_TRUE(flow.saw(1));
  const std::string bytes = flow.next(now, at(clock += 50));
  EXPECT_EQ(read(bytes)->left_out(), 9U);
  ASSERT_EQ(read(bytes)->poses()->size(), 2U);
  EXPECT_EQ(read(bytes)->poses()->Get(1)->east_m(), now[1].east_m);
}

// 20 kB/s for two vehicles is what a station may be sent.
TEST(SessionFrames, OfTwoVehiclesAreSmall) {
  FrameFlow flow;
  std::vector<Pose> now = poses(2);
  std::size_t bytes = 0;
  for (std::uint32_t i = 1; i <= 20; ++i) {
    for (Pose& pose : now) pose.east_m += 0.1F;
    bytes += flow.next(now, at(std::uint64_t{50} * i)).size();
    (void)flow.saw(i);
  }
  EXPECT_LT(bytes, 5'000U);
}

}  // namespace
}  // namespace slackwater::tests::frame_test
