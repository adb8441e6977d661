#include "ingest/ais/sentence.h"

#include <gtest/gtest.h>

#include "fields/base/numbers/random.h"
#include "tests/ingest/ais/nmea_for_tests.h"
#include "tests/support/contains.h"

namespace slackwater::tests::sentence_test {
namespace {

using namespace ingest;

// gpsd's AIVDM.txt, "AIVDM/AIVDO Sentence Layer".
const std::string published = "!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C";

AisSentence sentence_in(const std::string& line) {
  const AisLine read = parse_ais_line(line);
  if (const auto* problem = std::get_if<MalformedLine>(&read)) ADD_FAILURE() << problem->reason;
  EXPECT_TRUE(std::holds_alternative<AisSentence>(read)) << line;
  return std::holds_alternative<AisSentence>(read) ? std::get<AisSentence>(read) : AisSentence{};
}

std::string problem_in(const std::string& line) {
  const AisLine read = parse_ais_line(line);
  const auto* problem = std::get_if<MalformedLine>(&read);
  return problem == nullptr ? std::string() : problem->reason;
}

TEST(AisSentence, ThePublishedExampleIsReadFieldByField) {
  const AisSentence sentence = sentence_in(published);
  EXPECT_EQ(sentence.total, 1);
  EXPECT_EQ(sentence.number, 1);
  EXPECT_EQ(sentence.payload, "177KQJ5000G?tO`K>RA1wUbN0TKH");
  EXPECT_EQ(sentence.fill_bits, 0);
  EXPECT_EQ(sentence.checksum, 0x5c);
  EXPECT_FALSE(sentence.is_own_ship);
  EXPECT_FALSE(sentence.time || sentence.logged_time);
}

TEST(AisSentence, AnyTalkerAndTheOwnShipAreHeard) {
  EXPECT_FALSE(sentence_in(sentence_of("--VDM,1,1,,A,802R5Ph0BkAgoP,0")).is_own_ship);
  EXPECT_TRUE(sentence_in(sentence_of("BSVDO,1,1,,B,4025bvQuaUcf<0hJ2FQ2M2A005Jp,0")).is_own_ship);
}

TEST(AisSentence, OneFlippedBitIsNoticed) {
  for (std::size_t i = 1; i + 3 < published.size(); ++i) {
    std::string damaged = published;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    EXPECT_FALSE(std::holds_alternative<AisSentence>(parse_ais_line(damaged))) << damaged;
  }
}

TEST(AisSentence, WhatMakesNoSenseIsMalformedAndSaysWhy) {
  const auto of = [](const std::string& body) { return problem_in(sentence_of(body)); };
  EXPECT_TRUE(contains(problem_in("!AIVDM,1,1,,B,177K,0"), "without a checksum"));
  EXPECT_TRUE(contains(problem_in("!AIVDM,1,1,,B,177K,0*"), "without a checksum"));
  EXPECT_TRUE(contains(problem_in("!AIVDM,1,1,,B,177K,0*ZZ"), "without a checksum"));
  EXPECT_TRUE(contains(problem_in("!AIVDM,1,1,,B,177K,0*00"), "wrong checksum"));
  for (const char* number :
       {"0,1", "1,0", "1,2", "10,1", "x,1", ",1", "1,", "-1,-1", "99999999999999999999,1"}) {
    EXPECT_TRUE(contains(of("AIVDM," + std::string(number) + ",,B,177K,0"), "fragment")) << number;
  }
  for (const char* payload : {"", "17 7", "177X", "177_", "177x", "177\x01", "177\xff"}) {
    EXPECT_TRUE(contains(of("AIVDM,1,1,,B," + std::string(payload) + ",0"), "armoured")) << payload;
  }
  for (const char* fill : {"", "6", "-1", "a", "0,0"}) {
    EXPECT_TRUE(contains(of("AIVDM,1,1,,B,177K," + std::string(fill)), "fill bits")) << fill;
  }
  EXPECT_TRUE(contains(of("AIVDM,2,1,1,B,177K,2"), "fill bits"))
      << "only the last fragment is filled";
  EXPECT_TRUE(contains(of("AIVDM,1,1"), "armoured"));
}

TEST(AisSentence, OtherLinesAreNoTrouble) {
  for (const char* line :
       {"", "# comment", "$GPGGA,1*00", "!AIABM,1", "!", "!AIVDM", "\\", "\\s:1*00\\", "hello"}) {
    EXPECT_TRUE(std::holds_alternative<OtherLine>(parse_ais_line(line))) << line;
  }
}

TEST(AisSentence, TagBlockTimesAreSecondsOrMilliseconds) {
  const UtcTime time = parse_utc("2021-11-01T01:58:09Z");  // date -u -d @1635731889
  EXPECT_EQ(sentence_in(tag_of("s:42809,c:1635731889,t:1635731965") + published).time, time);
  EXPECT_EQ(sentence_in(tag_of("c:1635731889250") + published).time, time + Duration(250));
  EXPECT_EQ(sentence_in(tag_of("c:1635731889") + tag_of("s:1") + published).time, time)
      << "two blocks";
}

TEST(AisSentence, ATagBlockThatIsNotSoundGivesNoTime) {
  EXPECT_FALSE(sentence_in("\\c:1635731889*00\\" + published).time) << "checksum";
  for (const char* time :
       {"c:0", "c:-1", "c:163573188x", "c:", "c:99999999999999999999", "c:1", "t:1635731889"}) {
    EXPECT_FALSE(sentence_in(tag_of(time) + published).time) << time;
  }
}

TEST(AisSentence, AnEpochBehindTheChecksumIsALoggersTime) {
  // Two lines of the Danish log end so.
  EXPECT_EQ(sentence_in("!AIVDM,1,1,,B,15@:Ip002k3Dr;`78KwapWp@0H5b,0*0F,1276256770").logged_time,
            parse_utc("2010-06-11T11:46:10Z"));
}

TEST(AisSentence, FragmentsOfOneMessageShareAKeyThatOthersDoNot) {
  const auto key = [](const std::string& line) { return sentence_in(line).key; };
  const std::string first = key(sentence_of("AIVDM,2,1,3,B,55P5TL0,0"));
  EXPECT_EQ(first, key(sentence_of("AIVDM,2,2,3,B,1CP0000,2")));
  for (const char* other : {"BSVDM,2,2,3,B", "AIVDM,3,2,3,B", "AIVDM,2,2,4,B", "AIVDM,2,2,3,A"}) {
    EXPECT_NE(first, key(sentence_of(std::string(other) + ",1CP0000,0"))) << other;
  }
  const std::string group =
      key(tag_of("g:1-2-3454,s:41925,c:1635731893") + sentence_of("AIVDM,2,1,2,,57`B,0"));
  EXPECT_EQ(group, key(tag_of("g:2-2-3454") + sentence_of("AIVDM,2,2,2,,SQH8,2")));
  EXPECT_NE(group, key(tag_of("g:2-2-3455") + sentence_of("AIVDM,2,2,2,,SQH8,2")));
}

TEST(PghpStamp, IsReadToTheMillisecondWithTheChecksumOfItsSentence) {
  // The first line of the Danish log.
  const AisLine read = parse_ais_line("$PGHP,1,2010,6,11,11,46,11,390,231,45,992190934,1,2B*5B");
  const auto& stamp = std::get<PghpStamp>(read);
  EXPECT_EQ(stamp.time, parse_utc("2010-06-11T11:46:11.390Z"));
  EXPECT_EQ(stamp.checksum, 0x2b);
}

TEST(PghpStamp, TimesThatDoNotExistAreMalformed) {
  const auto of = [](const std::string& time) { return problem_in(stamp_of(time, "00")); };
  for (const char* time :
       {"2010,2,29,0,0,0,0", "2010,13,1,0,0,0,0", "2010,1,1,24,0,0,0", "2010,1,1,0,60,0,0",
        "2010,1,1,0,0,60,0", "2010,1,1,0,0,0,1000", "1970,1,1,0,0,0,0", ",,,,,,",
        "2010,1,1,0,0,0,x", "99999999999,1,1,0,0,0,0"}) {
    EXPECT_NE(of(time), "") << time;
  }
  EXPECT_EQ(of("2012,2,29,23,59,59,999"), "");
  EXPECT_TRUE(
      contains(problem_in("$PGHP,1,2010,6,11,11,46,11,390,231,45,992190934,1,2B*5C"), "checksum"));
}

TEST(AisSentence, RandomBytesNeverEndIt) {
  Rng rng(2021, "tests/ais_lines");
  const std::string alphabet("!$\\*,:-AIVDMPGHPOcgs0123456789 abw`X\xff\0", 38);
  for (int round = 0; round < 200'000; ++round) {
    std::string line = round % 2 == 0 ? published : tag_of("g:1-2-3,c:1635731889") + published;
    for (int change = 0; change < 1 + round % 7; ++change) {
      line[rng.bits() % line.size()] = alphabet[rng.bits() % alphabet.size()];
    }
    line.resize(rng.bits() % (line.size() + 1));
    (void)parse_ais_line(line);  // ASan and UBSan look on
  }
}

}  // namespace
}  // namespace slackwater::tests::sentence_test
