#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <type_traits>

#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/frame.h"
#include "fields/base/numbers/random.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::basics_test {
namespace {

TEST(Sha256Digest, MatchesThePublishedVectors) {
  // FIPS 180-4 examples, as printed in NIST's "SHA-256 example values".
  EXPECT_EQ(sha256_of_text("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_text(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256Digest, OfAFileIsThatOfItsBytes) {
  const tests::TemporaryFolder folder;
  const std::string text(3'000'000, 'x');  // more than one read
  std::ofstream(folder / "file") << text;
  EXPECT_EQ(sha256_of_file(folder / "file"), sha256_of_text(text));
  EXPECT_THROW(static_cast<void>(sha256_of_file(folder / "none")), Error);
}

TEST(Directions, FollowTheConventionsOfWindAndCurrent) {
  // Reference check: 10 m/s from 240 degrees is u = +8.660254, v = +5.000000.
  const Horizontal wind = vector_from_direction(10, 240);
  EXPECT_NEAR(wind.real(), 8.660254, 1e-6);
  EXPECT_NEAR(wind.imag(), 5.0, 1e-6);
  EXPECT_NEAR(from_direction_deg(wind), 240, 1e-12);
  EXPECT_NEAR(to_direction_deg(wind), 60, 1e-12);
  EXPECT_EQ(to_direction_deg({0, 1}), 0);
  EXPECT_EQ(to_direction_deg({1, 0}), 90);
}

template <typename A, typename B>
concept Addable = requires(A a, B b) {
  a + b;
};
template <typename A, typename B>
concept Subtractable = requires(A a, B b) {
  a - b;
};

TEST(Frames, TwoOfThemAreNotAdded) {
  static_assert(Addable<Vector3<Enu>, Vector3<Enu>> && Addable<Vector3<Ned>, Vector3<Ned>>);
  static_assert(!Addable<Vector3<Enu>, Vector3<Ned>> && !Subtractable<Vector3<Ned>, Vector3<Enu>>);
  static_assert(!std::is_convertible_v<Vector3<Enu>, Vector3<Ned>>);
  static_assert(!std::is_constructible_v<Vector3<Ned>, Vector3<Enu>>);
}

TEST(Frames, EnuAndNedAreEachOthersInverse) {
  const Vector3<Enu> east_north_up(1, 2, 3);
  const Vector3<Ned> ned = to_ned(east_north_up);
  EXPECT_EQ(ned.eigen(), Eigen::Vector3d(2, 1, -3));
  EXPECT_EQ(to_enu(ned).eigen(), east_north_up.eigen());
}

TEST(RandomStreams, AreRepeatableAndIndependentOfEachOther) {
  Rng a(7, "twin/wave_phases");
  Rng b(7, "twin/wave_phases");
  Rng other(7, "twin/gusts");
  EXPECT_EQ(a.bits(), b.bits());
  EXPECT_NE(a.bits(), other.bits());
}

TEST(RandomStreams, NormalsHaveTheMomentsOfANormal) {
  Rng random(1, "test");
  double sum = 0;
  double squares = 0;
  double fourths = 0;
  constexpr int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
  }
  // Standard errors of the three moments: 1, sqrt 2 and sqrt 96 over sqrt n; five of them.
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourths / n, 3, 5 * std::sqrt(96.0 / n));
}

TEST(ErrorContext, StandsInFrontOfTheMessage) {
  try {
    with_context("reading wind.nc", [] { throw Error(ErrorKind::invalid_input, "unit 'K'"); });
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.message(), "reading wind.nc: unit 'K'");
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
  }
}

}  // namespace
}  // namespace slackwater::basics_test
