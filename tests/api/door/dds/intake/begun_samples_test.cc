#include "api/door/dds/intake/begun_samples.h"

#include <gtest/gtest.h>

namespace slackwater::dds::begun_samples_test {
namespace {

using Found = BegunSamples::Found;

Piece piece(std::uint8_t who, std::uint32_t writer, std::int64_t number) {
  Piece made{{}, writer, number, 1024, 10'000};
  made.from.fill(who);
  return made;
}

/// As the intake does.
Found let_in(BegunSamples& begun, const Piece& of) {
  const Found found = begun.look(of);
  if (found == Found::fresh) begun.remember(of);
  return found;
}

TEST(BegunSamples, AreKnownByWriterAndNumber) {
  BegunSamples begun;
  EXPECT_EQ(let_in(begun, piece(1, 3, 7)), Found::fresh);
  EXPECT_EQ(let_in(begun, piece(1, 3, 7)), Found::known);
  EXPECT_EQ(let_in(begun, piece(1, 3, 8)), Found::fresh);
  EXPECT_EQ(let_in(begun, piece(1, 4, 7)), Found::fresh);
  EXPECT_EQ(let_in(begun, piece(2, 3, 7)), Found::fresh);
}

TEST(BegunSamples, AreRefusedWhereTheyContradictTheirFirstPiece) {
  BegunSamples begun;
  EXPECT_EQ(let_in(begun, piece(1, 3, 7)), Found::fresh);
  Piece other = piece(1, 3, 7);
  other.piece_bytes = 512;
  EXPECT_EQ(let_in(begun, other), Found::refused);
  other = piece(1, 3, 7);
  other.sample_bytes = 9000;
  EXPECT_EQ(let_in(begun, other), Found::refused);
  EXPECT_EQ(let_in(begun, piece(1, 3, 7)), Found::known);
}

/// Else a piece of one that was forgotten could say another thing than the library remembers.
TEST(BegunSamples, ThatWereForgottenAreRefused) {
  BegunSamples begun;
  EXPECT_EQ(let_in(begun, piece(1, 3, 5)), Found::fresh);
  for (std::int64_t number = 10; number < 73; ++number)
    EXPECT_EQ(let_in(begun, piece(1, 3, number)), Found::fresh);
  EXPECT_EQ(let_in(begun, piece(1, 3, 5)), Found::known);
  EXPECT_EQ(let_in(begun, piece(1, 3, 4)), Found::refused) << "older than all of them";
  EXPECT_EQ(let_in(begun, piece(1, 3, 73)), Found::fresh);
  EXPECT_EQ(let_in(begun, piece(1, 3, 5)), Found::refused);
  EXPECT_EQ(let_in(begun, piece(1, 3, 6)), Found::refused) << "older than all of them";
  EXPECT_EQ(let_in(begun, piece(1, 4, 5)), Found::fresh) << "another writer's";
}

TEST(BegunSamples, GoWithTheirParticipant) {
  BegunSamples begun;
  EXPECT_EQ(let_in(begun, piece(1, 3, 5)), Found::fresh);
  EXPECT_EQ(let_in(begun, piece(1, 9, 5)), Found::fresh);
  EXPECT_EQ(let_in(begun, piece(2, 3, 5)), Found::fresh);
  begun.forget(piece(1, 0, 0).from);
  EXPECT_EQ(let_in(begun, piece(1, 3, 5)), Found::fresh);
  EXPECT_EQ(let_in(begun, piece(1, 9, 5)), Found::fresh);
  EXPECT_EQ(let_in(begun, piece(2, 3, 5)), Found::known);
}

TEST(BegunSamples, OfAParticipantAreSoManyAndCostNobodyElseRoom) {
  BegunSamples begun;
  for (std::uint32_t writer = 1; writer < 1000; ++writer)
    for (std::int64_t number = 1; number <= 64; ++number)
      EXPECT_EQ(let_in(begun, piece(1, writer, number)),
                writer <= BegunSamples::most_of_a_participant ? Found::fresh : Found::refused);
  int known = 0;
  for (std::uint32_t writer = 1; writer < 1000; ++writer)
    for (std::int64_t number = 1; number <= 64; ++number)
      known += begun.look(piece(1, writer, number)) == Found::known ? 1 : 0;
  EXPECT_EQ(known, BegunSamples::most_of_a_participant);
  EXPECT_EQ(let_in(begun, piece(2, 3, 5)), Found::fresh) << "of another participant";
  EXPECT_EQ(let_in(begun, piece(1, 256, 65)), Found::fresh) << "the newest of a greedy one";
}

/// Of its own writers: that with most in hand makes room.
TEST(BegunSamples, WhatMadeRoomStaysRefused) {
  BegunSamples begun;
  for (std::uint32_t writer = 1; writer <= 4; ++writer)
    for (std::int64_t number = 1; number <= 64; ++number)
      EXPECT_EQ(let_in(begun, piece(1, writer, number)), Found::fresh);
  EXPECT_EQ(let_in(begun, piece(1, 5, 9)), Found::fresh);
  int refused = 0;
  for (std::uint32_t writer = 1; writer <= 4; ++writer)
    refused += begun.look(piece(1, writer, 1)) == Found::refused ? 1 : 0;
  EXPECT_EQ(refused, 1);
}

}  // namespace
}  // namespace slackwater::dds::begun_samples_test
