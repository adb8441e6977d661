#include "api/door/dds/intake/intake.h"

#include "tests/api/door/dds/forged_rtps.h"

// What is let in of what comes, by whom, and how it is told. The clock is the test's.

namespace slackwater::dds::intake_test {
namespace {

using namespace std::chrono_literals;
using tests::Fields;
using tests::ForgedRtps;
using tests::of_a_topic;
using tests::publications;

Prefix participant(unsigned number) {
  return {1,
          15,
          0,
          0,
          0,
          0,
          0,
          0,
          0,
          static_cast<std::uint8_t>(number >> 16U),
          static_cast<std::uint8_t>(number >> 8U),
          static_cast<std::uint8_t>(number)};
}

class IntakeTest : public testing::Test {
 protected:
  /// @return whether it is let in
  bool comes(const Bytes& bytes) { return !let_in(bytes).empty(); }
  Bytes let_in(const Bytes& bytes) {
    Bytes changed;
    const Payload in = intake_.admit(
        bytes, [] { return "10.0.0.9"; }, changed, now_);
    return {in.begin(), in.end()};
  }
  /// Announces itself, and is found by the library where that is let in.
  bool joins(unsigned number) {
    if (!comes(ForgedRtps(participant(number)).announce(participant(number)).bytes())) return false;
    intake_.found(participant(number));
    return true;
  }
  static Bytes heartbeat(unsigned number) {
    return ForgedRtps(participant(number)).heartbeat(of_a_topic, 1, 5).bytes();
  }
  [[nodiscard]] bool is_told(const std::string& words) const {
    return std::any_of(told_.begin(), told_.end(), [&](const std::string& text) {
      return text.find(words) != std::string::npos;
    });
  }

  std::vector<std::string> told_;
  Intake intake_{[this](const std::string& text) { told_.push_back(text); }};
  Intake::Time now_{1h};
};

TEST_F(IntakeTest, LetsInWhatPeersSayAsTheySaidIt) {
  ASSERT_TRUE(joins(1));
  for (const Bytes& bytes :
       {heartbeat(1), ForgedRtps(participant(1)).data(of_a_topic, 1, Bytes(64)).bytes(),
        ForgedRtps(participant(1)).announce(participant(1), {7, 100}).bytes()})
    EXPECT_EQ(let_in(bytes), bytes);
  EXPECT_EQ(told_, std::vector<std::string>{});
}

TEST_F(IntakeTest, HearsNobodyWhoIsNotThere) {
  EXPECT_FALSE(comes(heartbeat(1)));
  ASSERT_TRUE(joins(1));
  EXPECT_TRUE(comes(heartbeat(1)));
  intake_.lost(participant(1));
  EXPECT_FALSE(comes(heartbeat(1)));
  EXPECT_EQ(told_, std::vector<std::string>{}) << "which happens whenever one joins or leaves";
  for (int i = 0; i < 10'000; ++i) EXPECT_FALSE(comes(heartbeat(2)));
  EXPECT_TRUE(is_told("from participants that are not heard"));
}

TEST_F(IntakeTest, TakesItsOwnEchoForNothing) {
  intake_.be(participant(1));
  EXPECT_FALSE(joins(1));
  EXPECT_FALSE(comes(heartbeat(1)));
  intake_.tell_rest();
  EXPECT_EQ(told_, std::vector<std::string>{});
}

TEST_F(IntakeTest, NamesWhatIsNoRtpsAtOnceAndThenEverMoreRarely) {
  EXPECT_FALSE(comes({'x'}));
  ASSERT_EQ(told_.size(), 1U);
  EXPECT_TRUE(is_told("1 datagram shed so far, as one from 10.0.0.9: it does not begin as RTPS"));
  EXPECT_TRUE(is_told("a firewall")) << "says what to do";
  // A day of them.
  for (int minute = 0; minute < 24 * 60; ++minute, now_ += 60s)
    for (int i = 0; i < 5; ++i) EXPECT_FALSE(comes({'x'}));
  EXPECT_GT(told_.size(), 8U);
  EXPECT_LT(told_.size(), 20U);
  const std::size_t before = told_.size();
  intake_.tell_rest();
  ASSERT_EQ(told_.size(), before + 1);
  EXPECT_NE(told_.back().find("7201 datagrams"), std::string::npos) << told_.back();
  intake_.tell_rest();
  EXPECT_EQ(told_.size(), before + 1) << "once";
}

TEST_F(IntakeTest, HearsSoManyParticipantsAndTheOthersWhenSomeHaveLeft) {
  for (unsigned i = 0; i < Intake::most_participants; ++i) ASSERT_TRUE(joins(i)) << i;
  EXPECT_FALSE(joins(1000));
  EXPECT_TRUE(is_told("256 participants are heard, and no more")) << told_.size();
  EXPECT_TRUE(comes(heartbeat(7))) << "who is there stays";
  intake_.lost(participant(7));
  EXPECT_TRUE(joins(1000));
}

TEST_F(IntakeTest, LooksAtSoManyNewcomersASecond) {
  // That come and go, or that the library has not found yet.
  unsigned number = 0, in = 0;
  const auto announced = [&] {
    const Prefix who = participant(++number);
    return ForgedRtps(who).announce(who).bytes();
  };
  for (int i = 0; i < 1000; ++i) in += comes(announced()) ? 1U : 0U;
  EXPECT_EQ(in, 512U);
  EXPECT_TRUE(is_told("heard later"));
  now_ += 1s;
  in = 0;
  for (int i = 0; i < 1000; ++i) in += comes(announced()) ? 1U : 0U;
  EXPECT_EQ(in, 32U);
}

TEST_F(IntakeTest, MakesLongLeasesShort) {
  const auto announced = [](std::uint32_t lease_s) {
    return ForgedRtps(participant(1)).announce(participant(1), {7, lease_s}).bytes();
  };
  EXPECT_EQ(let_in(announced(100)), announced(100));
  EXPECT_EQ(let_in(announced(101)), announced(100));
  EXPECT_EQ(let_in(announced(0x7FFFFFFF)), announced(100)) << "for ever";
  EXPECT_EQ(let_in(announced(0xFFFFFFFF)), announced(100));
  // And of one that tells it the other way round.
  const auto big = [](std::uint8_t high, std::uint8_t low) {
    const Bytes list{0, 2, 0, 0, 0, 2, 0, 8, high, 0, 0, low, 0, 0, 0, 0, 0, 1, 0, 0};
    return ForgedRtps(participant(1)).data(tests::participants, 1, list).bytes();
  };
  EXPECT_EQ(let_in(big(0, 20)), big(0, 20));
  EXPECT_EQ(let_in(big(1, 20)), big(0, 100));
}

TEST_F(IntakeTest, CountsNoMoreLostSamplesThanItHasTimeFor) {
  ASSERT_TRUE(joins(1));
  std::int64_t skipped = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t from = 1 + 1000LL * i;
    if (comes(ForgedRtps(participant(1)).gap(of_a_topic, from, from + 900).bytes())) skipped += 900;
  }
  EXPECT_GT(skipped, 250'000);
  EXPECT_LE(skipped, 1 << 18);
  EXPECT_TRUE(is_told("more samples are lost"));
  EXPECT_TRUE(comes(heartbeat(1))) << "all else is heard";
  now_ += 1s;
  EXPECT_TRUE(comes(ForgedRtps(participant(1)).gap(of_a_topic, 1, 901).bytes()));
}

TEST_F(IntakeTest, HasRoomForSoManyReadersAndWriters) {
  ASSERT_TRUE(joins(1));
  const Bytes sample = Fields()
                           .raw(std::array<std::uint8_t, 4>{0, 3, 0, 0})
                           .parameter(0x05, Fields().zeros(300))
                           .end()
                           .bytes();
  int in = 0;
  while (in < 100'000 &&
         comes(ForgedRtps(participant(1)).data(publications, in + 1, sample).bytes()))
    ++in;
  EXPECT_GT(in, 256 * 100) << "a hundred of each participant";
  EXPECT_LT(in, 40'000);
  EXPECT_TRUE(is_told("readers and writers"));
  EXPECT_TRUE(comes(ForgedRtps(participant(1)).data(of_a_topic, 1, sample).bytes()));
}

TEST_F(IntakeTest, BelievesOnlyPiecesThatAgree) {
  ASSERT_TRUE(joins(1));
  const auto piece = [](const ForgedRtps::PieceOf& of) {
    return ForgedRtps(participant(1)).piece(of_a_topic, of).bytes();
  };
  EXPECT_TRUE(comes(piece({5, 2, 1, 1024, 1 << 20, 1024})));
  EXPECT_TRUE(comes(piece({5, 1, 1, 1024, 1 << 20, 1024})));
  // The library would copy as much as the first of them said, from a datagram that has less.
  EXPECT_FALSE(comes(piece({5, 1, 16, 256, 4096, 4096})));
  EXPECT_TRUE(is_told("contradict each other"));
  EXPECT_TRUE(comes(piece({6, 1, 16, 256, 4096, 4096}))) << "of another sample";
  intake_.lost(participant(1));
  ASSERT_TRUE(joins(1));
  EXPECT_TRUE(comes(piece({5, 1, 16, 256, 4096, 4096}))) << "the library forgot it too";
}

TEST_F(IntakeTest, MakesRoomForSoManySamplesInPieces) {
  ASSERT_TRUE(joins(1));
  const auto begins = [&](std::int64_t number) {
    const ForgedRtps::PieceOf of{number, 1, 1, 1024, most_sample_bytes, 1024};
    return comes(ForgedRtps(participant(1)).piece(of_a_topic, of).bytes());
  };
  int begun = 0;
  for (int i = 1; i <= 60; ++i) begun += begins(i) ? 1 : 0;
  EXPECT_EQ(begun, 15) << "of 4 MiB each: 64 MB";
  EXPECT_FALSE(begins(20)) << "nor with a second piece of what was refused";
  EXPECT_TRUE(begins(7)) << "more of what has begun";
  now_ += 60s;
  EXPECT_TRUE(begins(61));
}

}  // namespace
}  // namespace slackwater::dds::intake_test
