#include "api/door/dds/intake/datagram.h"

#include "fields/base/numbers/random.h"
#include "tests/api/door/dds/forged_rtps.h"

// What a datagram claims, and that one that claims what cannot be is named. The field orders are
// those of OMG DDSI-RTPS 2.3; one datagram is Cyclone DDS's.

namespace slackwater::dds::datagram_test {
namespace {

using tests::Ends;
using tests::Fields;
using tests::ForgedRtps;
using tests::of_a_topic;
using tests::participants;
using tests::publications;

const Prefix us{1, 15, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
const Prefix them{1, 16, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9};

ForgedRtps said() { return ForgedRtps(us); }
/// A list of one parameter, as a sample of discovery.
Bytes list_of(const Fields& parameters) {
  return Fields().raw(std::array<std::uint8_t, 4>{0, 3, 0, 0}).raw(parameters.bytes()).bytes();
}
Fields guid_of(const Prefix& whose) { return Fields().raw(whose).entity(0x00000103); }

struct Case {
  const char* what;
  Bytes bytes;
  std::string_view fault;  ///< a part of it; empty: it is sound
};

std::vector<Case> sound_datagrams() {
  const Bytes sample(40, 7);
  const std::array<std::uint8_t, 32> set{};
  return {
      {"an announcement", said().announce(us).bytes(), ""},
      {"it twice, as Fast DDS says it", said().announce(us).announce(us).bytes(), ""},
      {"a sample", said().to(them).data(of_a_topic, 1, sample).bytes(), ""},
      {"the last of many samples", said().data(of_a_topic, most_samples, sample).bytes(), ""},
      {"a farewell, as a key", said().data(participants, 2, sample, 16, 9).bytes(), ""},
      {"a sample behind a list",
       said()
           .data(of_a_topic, 1, Fields().parameter(0x71, Fields().zeros(4)).end().zeros(8).bytes(),
                 16, 7)
           .bytes(),
       ""},
      {"a longer head, of a later version", said().data(of_a_topic, 1, sample, 20).bytes(), ""},
      {"a first heartbeat", said().heartbeat(publications, 1, 0).bytes(), ""},
      {"a heartbeat", said().heartbeat(of_a_topic, 5, 1000).bytes(), ""},
      {"a gap", said().gap(of_a_topic, 3, 9, 256, 8).bytes(), ""},
      {"a first acknowledgement", said().acknack(publications, 0, 0, {}).bytes(), ""},
      {"an acknowledgement", said().acknack(publications, 1, 256, set).bytes(), ""},
      {"a piece", said().piece(of_a_topic, {}).bytes(), ""},
      {"the last piece", said().piece(of_a_topic, {1, 4, 1, 1024, 3080, 8}).bytes(), ""},
      {"all pieces", said().piece(of_a_topic, {1, 1, 4, 1024, 3080, 3080}).bytes(), ""},
      {"a kind that nobody knows", said().part(0xA0, 1, Fields().zeros(12)).bytes(), ""},
      {"statistics", said().heartbeat(of_a_topic, 1, 1).part(0x80, 1, Fields().zeros(56)).bytes(),
       ""},
      {"a part to the end",
       said().part(0x07, 1, Fields().zeros(8).number(1).number(1).put(1U), 0).bytes(), ""},
  };
}

std::vector<Case> faulty_datagrams() {
  const Bytes sample(40, 7);
  const Bytes set(36);
  const Ends& topic = of_a_topic;
  const auto piece = [&](const ForgedRtps::PieceOf& of) { return said().piece(topic, of).bytes(); };
  const char* const no_number = "number of a sample";
  return {
      {"nothing", {}, "begin as RTPS"},
      {"words", {'H', 'e', 'l', 'l', 'o'}, "begin as RTPS"},
      {"half a header", {'R', 'T', 'P', 'S', 2, 3, 1, 15, 1, 2}, "begin as RTPS"},
      {"a header alone", said().bytes(), "says nothing"},
      {"a part of 64 kB in a small one", said().part(0x07, 1, Fields().zeros(28), 0xFFFF).bytes(),
       "longer than the rest"},
      {"half a head", said().part(0x15, 5, Fields(), 0).bytes(), "too short"},
      {"who speaks for another", said().part(0x0C, 1, Fields().zeros(20)).bytes(), "another"},
      {"what is secured", said().part(0x30, 1, Fields().zeros(20)).bytes(), "Security"},
      {"statistics first", said().part(0x80, 1, Fields().zeros(56)).heartbeat(topic, 1, 1).bytes(),
       "not the last"},
      {"announcements without end",
       said().announce(us).announce(us).announce(us).announce(us).announce(us).bytes(),
       "without end"},
      {"another's announcement", said().announce(them).bytes(), "another participant"},
      {"another's writer",
       said().data(publications, 1, list_of(Fields().parameter(0x5A, guid_of(them)).end())).bytes(),
       "another participant"},
      {"a list without an end",
       said().data(publications, 1, list_of(Fields().parameter(5, Fields().zeros(8)))).bytes(),
       "without an end"},
      {"a parameter of 64 kB",
       said()
           .data(publications, 1,
                 list_of(Fields().put(std::uint16_t{5}).put(std::uint16_t{0xFFFC}).zeros(8).end()))
           .bytes(),
       "without an end"},
      {"a parameter of three",
       said()
           .data(publications, 1,
                 list_of(Fields().put(std::uint16_t{5}).put(std::uint16_t{3}).zeros(3).end()))
           .bytes(),
       "without an end"},
      {"inline a list without an end", said().data(topic, 1, Bytes(8, 9), 16, 7).bytes(),
       "without an end"},
      // Behind it there is room, as a length that is below zero needs.
      {"a head that is longer than its part",
       said().data(topic, 1, Bytes(8), 200).part(0x01, 1, Fields().zeros(400)).bytes(),
       "too short"},
      {"a head that overlaps itself", said().data(topic, 1, sample, 8).bytes(), "overlaps"},
      {"a head that begins before itself", said().data(topic, 1, sample, 0xFFF8).bytes(), "short"},
      {"a sample and a key", said().data(topic, 1, sample, 16, 13).bytes(), "as well"},
      {"a sample of nothing", said().data(topic, 1, {}, 16, 5).bytes(), "of nothing"},
      {"sample 0", said().data(topic, 0, sample).bytes(), no_number},
      {"sample -1", said().data(topic, -1, sample).bytes(), no_number},
      {"sample 2^62", said().data(topic, 1LL << 62, sample).bytes(), no_number},
      {"as many writers", said().data(publications, most_discovery_samples + 1, sample).bytes(),
       no_number},
      {"a heartbeat of 2^33", said().heartbeat(topic, 1LL << 33, 1LL << 33).bytes(), no_number},
      {"a heartbeat from 0", said().heartbeat(topic, 0, 5).bytes(), no_number},
      {"a heartbeat backwards", said().heartbeat(topic, 9, 5).bytes(), no_number},
      {"a gap without an end", said().gap(topic, 1, 1LL << 40).bytes(), no_number},
      {"a gap backwards", said().gap(topic, 9, 5).bytes(), no_number},
      {"a set of 257", said().gap(topic, 1, 2, 257, 9).bytes(), "more than 256"},
      {"a set of which half came", said().gap(topic, 1, 2, 256, 4).bytes(), "without them"},
      {"an acknowledgement of 4 billion", said().acknack(topic, 1, 0xFFFFFFFF, set).bytes(),
       "more than 256"},
      {"an acknowledgement below 0", said().acknack(topic, -5, 0, {}).bytes(), no_number},
      {"a sample of 4 GB", piece({1, 1, 1, 0xFFFF, 0xFFFFFFFF, 100}), "more than there is room"},
      {"a sample of no octet", piece({1, 1, 1, 1024, 0, 100}), "more than there is room"},
      {"pieces of one octet", piece({1, 1, 1, 1, 4096, 100}), "crumbs"},
      {"pieces of none", piece({1, 1, 1, 0, 4096, 100}), "crumbs"},
      {"piece 0", piece({1, 0, 1, 1024, 4096, 1024}), "no sample"},
      {"the fifth of four", piece({1, 5, 1, 1024, 4096, 1024}), "no sample"},
      {"the last four billionth", piece({1, 0xFFFFFFFF, 2, 1024, 4096, 2048}), "no sample"},
      {"65535 of four", piece({1, 1, 0xFFFF, 1024, 4096, 1024}), "no sample"},
      {"less of it than it says", piece({1, 1, 4, 1024, 4096, 1024}), "less of a sample"},
  };
}

TEST(Datagrams, OfPeersAreSound) {
  for (const Case& sound : sound_datagrams())
    EXPECT_EQ(read_datagram(sound.bytes).fault, "") << sound.what;
}

TEST(Datagrams, ThatClaimWhatCannotBeAreNamed) {
  for (const Case& faulty : faulty_datagrams()) {
    const std::string_view fault = read_datagram(faulty.bytes).fault;
    EXPECT_FALSE(fault.empty()) << faulty.what;
    EXPECT_NE(fault.find(faulty.fault), std::string_view::npos) << faulty.what << ": " << fault;
  }
}

/// Whatever is left of one, nothing behind it is read: AddressSanitizer sees the end of each.
TEST(Datagrams, CutAnywhereAreReadToTheirEndAndNoFurther) {
  std::size_t faults = 0, cuts = 0;
  for (const auto& cases : {sound_datagrams(), faulty_datagrams()})
    for (const Case& whole : cases)
      for (std::size_t size = 0; size < whole.bytes.size(); ++size, ++cuts) {
        const Bytes cut(whole.bytes.begin(), whole.bytes.begin() + static_cast<long>(size));
        const Datagram read = read_datagram(cut);
        faults += read.fault.empty() ? 0U : 1U;
        for (std::size_t k = 0; k < read.leases; ++k) EXPECT_LE(read.lease[k].at + 4, size);
      }
  EXPECT_GT(faults, cuts * 9 / 10) << "of " << cuts;
}

TEST(Datagrams, InWhichAnythingIsChangedAreReadToTheirEndAndNoFurther) {
  constexpr std::uint64_t seed = 3;
  Rng random(seed, "tests/dds/datagrams");
  const auto cases = sound_datagrams();
  for (int i = 0; i < 20'000; ++i) {
    Bytes bytes = cases[random.bits() % cases.size()].bytes;
    for (std::size_t n = 1 + random.bits() % 4; n > 0; --n)
      bytes[random.bits() % bytes.size()] = static_cast<std::uint8_t>(random.bits());
    const Datagram read = read_datagram(bytes);
    std::size_t pieces = 0;
    if (read.fault.empty())
      for_each_piece(bytes, [&](const Piece& piece) {
        ++pieces;
        ASSERT_LE(piece.sample_bytes, most_sample_bytes) << "change " << i << " of seed " << seed;
        ASSERT_GE(piece.piece_bytes, least_piece_bytes);
      });
    ASSERT_EQ(pieces > 0, read.has_pieces) << "change " << i << " of seed " << seed;
    ASSERT_LE(read.discovery_bytes, 64 * bytes.size());
  }
}

TEST(Datagrams, AnnounceOnlyWhereTheySayNothingElse) {
  const auto announces = [](const Bytes& bytes) { return read_datagram(bytes).is_announcement; };
  EXPECT_TRUE(announces(said().to(them).announce(us).bytes()));
  EXPECT_TRUE(announces(said().data(participants, 2, Bytes(16), 16, 9).bytes())) << "a farewell";
  EXPECT_TRUE(announces(said().part(0x00, 1, Fields().zeros(8)).announce(us).bytes()))
      << "behind a header of RTPS 2.5";
  EXPECT_FALSE(announces(said().announce(us).heartbeat(of_a_topic, 1, 1).bytes()));
  EXPECT_FALSE(announces(said().announce(us).data(of_a_topic, 1, Bytes(8)).bytes()));
  EXPECT_FALSE(announces(said().to(them).bytes()));
}

TEST(Datagrams, OfOtherVendorsHaveKindsOfTheirOwn) {
  Bytes bytes = said().part(0x80, 1, Fields().zeros(8)).heartbeat(of_a_topic, 1, 1).bytes();
  EXPECT_NE(read_datagram(bytes).fault, "");
  bytes[7] = 1;  // RTI, whose sum of all that follows it is
  EXPECT_EQ(read_datagram(bytes).fault, "");
}

TEST(Datagrams, TellWhoSpeaksWhatIsSkippedAndWhatBegins) {
  const Datagram gaps =
      read_datagram(said().gap(of_a_topic, 3, 10).gap(of_a_topic, 20, 25).bytes());
  EXPECT_EQ(gaps.from, us);
  EXPECT_EQ(gaps.skipped, 12U);
  const Bytes two = said()
                        .piece(of_a_topic, {7, 2, 1, 1024, 4096, 1024})
                        .piece(publications, {8, 1, 1, 512, 600, 512})
                        .bytes();
  EXPECT_TRUE(read_datagram(two).has_pieces);
  std::vector<Piece> found;
  for_each_piece(two, [&](const Piece& piece) { found.push_back(piece); });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].from, us);
  EXPECT_EQ(found[0].writer, of_a_topic.writer);
  EXPECT_EQ(found[0].number, 7);
  EXPECT_EQ(found[1].writer, publications.writer);
  EXPECT_EQ(found[1].piece_bytes, 512);
  EXPECT_EQ(found[1].sample_bytes, 600U);
}

/// As Cyclone DDS 11.0.1 announces a Python program; its lease of 10 s stands 80 octets in.
TEST(Datagrams, OfCycloneAnnounceItWithItsLease) {
  const Bytes bytes = tests::hex(
      "525450530205011001109812bf68f680affc786c0e010c00010fd8cdc310411e7ec2737809010800065e0d6b"
      "e2c15b751505640100001000000100c7000100c2000000000100000000030000020008000a00000000000000"
      "59005800030000000e0000005f5f50726f636573734e616d6500000007000000707974686f6e000006000000"
      "5f5f5069640000000500000032313537000000000b0000005f5f486f73746e616d65000003000000766d0000"
      "00000000150004000205000016000400011000005000100001109812bf68f680affc786c000001c158000400"
      "3ffc00000f0004004e00000031001800010000001f6900000000000000000000000000007f00000148001800"
      "0100000015690000000000000000000000000000efff000132001800010000001e6900000000000000000000"
      "000000007f000001330018000100000014690000000000000000000000000000efff00010780300000000000"
      "0000000000000000000000000000000016000000766d2f31312e302e312f4c696e75782f4c696e7578000000"
      "198004000000200001000000");
  const Datagram read = read_datagram(bytes);
  EXPECT_EQ(read.fault, "");
  EXPECT_TRUE(read.is_announcement);
  ASSERT_EQ(read.leases, 1U);
  EXPECT_TRUE(read.lease[0].is_little_endian);
  EXPECT_EQ(read.lease[0].at, 80U);
  EXPECT_EQ(bytes[read.lease[0].at], 10U);
}

}  // namespace
}  // namespace slackwater::dds::datagram_test
