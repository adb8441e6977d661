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

TEST(BegunSamples, AreKnownByWriterAndNumber) {
  BegunSamples begun;
  EXPECT_EQ(begun.look(piece(1, 3, 7)), Found::begun);
  EXPECT_EQ(begun.look(piece(1, 3, 7)), Found::known);
  EXPECT_EQ(begun.look(piece(1, 3, 8)), Found::begun);
  EXPECT_EQ(begun.look(piece(1, 4, 7)), Found::begun);
  EXPECT_EQ(begun.look(piece(2, 3, 7)), Found::begun);
}

TEST(BegunSamples, AreRefusedWhereTheyContradictTheirFirstPiece) {
  BegunSamples begun;
  EXPECT_EQ(begun.look(piece(1, 3, 7)), Found::begun);
  Piece other = piece(1, 3, 7);
  other.piece_bytes = 512;
  EXPECT_EQ(begun.look(other), Found::refused);
  other = piece(1, 3, 7);
  other.sample_bytes = 9000;
  EXPECT_EQ(begun.look(other), Found::refused);
  EXPECT_EQ(begun.look(piece(1, 3, 7)), Found::known);
}

/// Else a piece of one that was forgotten could say another thing than the library remembers.
TEST(BegunSamples, ThatWereForgottenAreRefused) {
  BegunSamples begun;
  EXPECT_EQ(begun.look(piece(1, 3, 5)), Found::begun);
  for (std::int64_t number = 10; number < 73; ++number)
    EXPECT_EQ(begun.look(piece(1, 3, number)), Found::begun);
  EXPECT_EQ(begun.look(piece(1, 3, 5)), Found::known);
  EXPECT_EQ(begun.look(piece(1, 3, 4)), Found::refused) << "older than all of them";
  EXPECT_EQ(begun.look(piece(1, 3, 73)), Found::begun);
  EXPECT_EQ(begun.look(piece(1, 3, 5)), Found::refused);
  EXPECT_EQ(begun.look(piece(1, 3, 6)), Found::refused) << "older than all of them";
  EXPECT_EQ(begun.look(piece(1, 4, 5)), Found::begun) << "another writer's";
}

TEST(BegunSamples, GoWithTheirParticipant) {
  BegunSamples begun;
  EXPECT_EQ(begun.look(piece(1, 3, 5)), Found::begun);
  EXPECT_EQ(begun.look(piece(1, 9, 5)), Found::begun);
  EXPECT_EQ(begun.look(piece(2, 3, 5)), Found::begun);
  begun.forget(piece(1, 0, 0).from);
  EXPECT_EQ(begun.look(piece(1, 3, 5)), Found::begun);
  EXPECT_EQ(begun.look(piece(1, 9, 5)), Found::begun);
  EXPECT_EQ(begun.look(piece(2, 3, 5)), Found::known);
}

TEST(BegunSamples, AreSoManyInAll) {
  BegunSamples begun;
  int in = 0;
  for (std::uint32_t writer = 1; writer < 1000; ++writer)
    for (std::int64_t number = 1; number <= 64; ++number)
      in += begun.look(piece(1, writer, number)) == Found::begun ? 1 : 0;
  EXPECT_EQ(in, 16'384);
  begun.forget(piece(1, 0, 0).from);
  EXPECT_EQ(begun.look(piece(1, 3, 5)), Found::begun);
}

}  // namespace
}  // namespace slackwater::dds::begun_samples_test
