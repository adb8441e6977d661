#include "ingest/ais/message.h"

#include <gtest/gtest.h>

#include "tests/ingest/ais/nmea_for_tests.h"

namespace slackwater::tests::message_test {
namespace {

using namespace ingest;

const std::string single = "AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0";

std::string fragment(int total, int number, int sequence, const std::string& payload,
                     int fill = 0) {
  return sentence_of("AIVDM," + std::to_string(total) + ',' + std::to_string(number) + ',' +
                     std::to_string(sequence) + ",A," + payload + ',' + std::to_string(fill));
}

std::string checksum_text(const std::string& sentence) {
  return sentence.substr(sentence.size() - 2);
}

TEST(MessageAssembler, AStampIsOfTheMessageThatBeginsNext) {
  MessageAssembler assembler;
  const std::string sentence = sentence_of(single);
  EXPECT_FALSE(assembler.take(stamp_of("2010,6,11,11,46,11,390", checksum_text(sentence))));
  const auto stamped = assembler.take(sentence);
  ASSERT_TRUE(stamped);
  EXPECT_EQ(stamped->time, parse_utc("2010-06-11T11:46:11.390Z"));
  const auto next = assembler.take(sentence);
  ASSERT_TRUE(next);
  EXPECT_FALSE(next->time) << "a stamp is used once";
}

TEST(MessageAssembler, AStampOfALostSentenceIsNotGivenToAnother) {
  MessageAssembler assembler;
  (void)assembler.take(stamp_of("2010,6,11,11,46,11,390", "01"));
  EXPECT_FALSE(assembler.take(sentence_of(single))->time);
  EXPECT_EQ(assembler.counts().mismatched_stamps, 1U);
  (void)assembler.take(stamp_of("2010,6,11,11,46,11,390", "00"));
  EXPECT_TRUE(assembler.take(sentence_of(single))->time) << "00: the logger does not say";
}

TEST(MessageAssembler, AStampDoesNotReachOverADamagedSentence) {
  MessageAssembler assembler;
  (void)assembler.take(stamp_of("2010,6,11,11,46,11,390", "00"));
  (void)assembler.take("!AIVDM,1,1,,B,177K,0*00");
  EXPECT_FALSE(assembler.take(sentence_of(single))->time);
  (void)assembler.take(stamp_of("2010,6,11,11,46,11,390", "00"));
  (void)assembler.take(stamp_of("2010,2,31,11,46,11,390", "00"));
  EXPECT_FALSE(assembler.take(sentence_of(single))->time) << "the later stamp is broken";
  EXPECT_EQ(assembler.counts().malformed, 2U);
  EXPECT_EQ(assembler.counts().first_malformed, "line 2: a sentence with a wrong checksum");
}

TEST(MessageAssembler, TheTagBlockIsBelievedBeforeStampAndSuffix) {
  MessageAssembler assembler;
  (void)assembler.take(stamp_of("2010,6,11,11,46,11,390", "00"));
  EXPECT_EQ(assembler.take(tag_of("c:1635731889") + sentence_of(single) + ",1276256770")->time,
            parse_utc("2021-11-01T01:58:09Z"));
  (void)assembler.take(stamp_of("2010,6,11,11,46,11,390", "00"));
  EXPECT_EQ(assembler.take(sentence_of(single) + ",1276256770")->time,
            parse_utc("2010-06-11T11:46:11.390Z"));
  EXPECT_EQ(assembler.take(sentence_of(single) + ",1276256770")->time,
            parse_utc("2010-06-11T11:46:10Z"));
}

TEST(MessageAssembler, MessagesThatInterleaveAreBothWhole) {
  MessageAssembler assembler;
  EXPECT_FALSE(assembler.take(tag_of("c:1635731889") + fragment(2, 1, 3, "55aaaa")));
  EXPECT_FALSE(assembler.take(tag_of("c:1635731890") + fragment(3, 1, 4, "55bb")));
  EXPECT_FALSE(assembler.take(fragment(3, 2, 4, "bb")));
  const auto first = assembler.take(fragment(2, 2, 3, "cc", 2));
  const auto second = assembler.take(fragment(3, 3, 4, "dd", 4));
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->payload, "55aaaacc");
  EXPECT_EQ(first->fill_bits, 2);
  EXPECT_EQ(first->time, parse_utc("2021-11-01T01:58:09Z"));
  EXPECT_EQ(second->payload, "55bbbbdd");
  EXPECT_EQ(second->fill_bits, 4);
  EXPECT_EQ(second->time, parse_utc("2021-11-01T01:58:10Z"));
  assembler.finish();
  EXPECT_EQ(assembler.counts().lost_fragments, 0U);
}

TEST(MessageAssembler, EachFragmentThatFindsNoMessageIsCounted) {
  MessageAssembler assembler;
  EXPECT_FALSE(assembler.take(fragment(2, 2, 1, "cc")));  // no beginning: 1
  EXPECT_FALSE(assembler.take(fragment(3, 1, 2, "aa")));  // open
  EXPECT_FALSE(assembler.take(fragment(3, 3, 2, "cc")));  // the middle is missing: 2
  EXPECT_FALSE(assembler.take(fragment(2, 1, 5, "aa")));  // its end never comes: 1
  EXPECT_FALSE(assembler.take(fragment(2, 1, 5, "bb")));  // the number used again
  EXPECT_EQ(assembler.take(fragment(2, 2, 5, "cc"))->payload, "bbcc");
  EXPECT_FALSE(assembler.take(fragment(2, 1, 6, "aa")));  // open at the end: 1
  assembler.finish();
  EXPECT_EQ(assembler.counts().lost_fragments, 5U);
}

TEST(MessageAssembler, AnOldBeginningIsNotJoinedToANewEnd) {
  const auto joined_after = [](std::size_t others) {
    MessageAssembler assembler;
    (void)assembler.take(fragment(2, 1, 1, "aa"));
    for (std::size_t i = 0; i < others; ++i) (void)assembler.take(sentence_of(single));
    return assembler.take(fragment(2, 2, 1, "cc")).has_value();
  };
  EXPECT_TRUE(joined_after(MessageAssembler::reach - 1));
  EXPECT_FALSE(joined_after(MessageAssembler::reach));
}

TEST(MessageAssembler, BeginningsWithoutEndsDoNotPileUp) {
  MessageAssembler assembler;
  for (int i = 0; i < 1000; ++i) {
    (void)assembler.take(sentence_of("AIVDM,2,1," + std::to_string(i) + ",A,55,0"));
  }
  EXPECT_EQ(assembler.counts().lost_fragments, 1000 - MessageAssembler::most_open);
}

TEST(AisMessage, ItsTypeIsTheFirstSixBits) {
  EXPECT_EQ((AisMessage{"177KQJ5", 0, false, {}}).type(), 1);
  EXPECT_EQ((AisMessage{"B52K>;h", 0, false, {}}).type(), 18);
  EXPECT_EQ((AisMessage{"H42O55i", 0, false, {}}).type(), 24);
  EXPECT_EQ((AisMessage{"Kn9`@i0", 0, false, {}}).type(), 27);
  EXPECT_EQ((AisMessage{"`", 0, false, {}}).type(), 40);
  EXPECT_EQ((AisMessage{"w", 0, false, {}}).type(), 63);
}

TEST(AisMessage, WhatItWritesIsReadBackWhateverItsLength) {
  for (std::size_t length = 1; length <= 400; ++length) {
    AisMessage message{std::string(length, 'w'), static_cast<int>(length % 6), false, {}};
    message.payload[length / 2] = '0';
    MessageAssembler assembler;
    std::optional<AisMessage> back;
    for (const std::string& sentence : message.sentences()) {
      EXPECT_LE(sentence.size() + 2, 82U) << "NMEA 0183: 82 characters with CR LF";
      EXPECT_FALSE(back);
      back = assembler.take(sentence);
    }
    ASSERT_TRUE(back) << length;
    EXPECT_EQ(back->payload, message.payload);
    EXPECT_EQ(back->fill_bits, message.fill_bits);
  }
}

}  // namespace
}  // namespace slackwater::tests::message_test
