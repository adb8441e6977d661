#include <gtest/gtest.h>

#include <filesystem>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "twin/inspection/instrument/clarity.h"

namespace slackwater::twin::read_instrument_test {
namespace {

using tests::contains;

constexpr double degree = constants::pi / 180;

Instrument read(const std::string& yaml) {
  return read_instrument(Config::parse("name: t\nsource: s\nstatus: estimate\n" + yaml, "t.yaml"));
}
std::string refusal_of(const std::string& yaml) {
  try {
    (void)read(yaml);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    return error.message();
  }
  return "read";
}

const std::string frame =
    "frame: {horizontal_deg: 60, pixels_wide: 4000, pixels_high: 3000, exposure_s: 0.002}\n";

TEST(ReadInstrument, ReadsEachThatIsBundled) {
  std::size_t count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(tests::source_folder() / "data" / "instruments")) {
    const std::string name = entry.path().stem().string();
    const Instrument i = read_named_instrument(name, tests::source_folder() / "data");
    EXPECT_FALSE(i.source.empty()) << name;
    EXPECT_FALSE(i.status.empty()) << name;
    EXPECT_LT(i.least_range_m, i.most_range_m) << name;
    EXPECT_FALSE(i.unit.empty()) << name;
    EXPECT_NEAR(length_of(i.axis), 1, 1e-12) << name;
    ++count;
  }
  EXPECT_EQ(count, 13U);
}

TEST(ReadInstrument, AnglesBecomeRadiansAndPixelsAreSquare) {
  const Instrument i = read("kind: rgb\nrange_m: [1, 30]\n" + frame + "aim: {axis: [0, 0, 0.5]}\n");
  const auto& f = std::get<FrameFootprint>(i.footprint);
  EXPECT_DOUBLE_EQ(f.horizontal_rad, 60 * degree);
  EXPECT_NEAR(std::tan(f.vertical_rad / 2) / 3000, std::tan(f.horizontal_rad / 2) / 4000, 1e-15);
  EXPECT_EQ(i.axis.z, 1);
  EXPECT_EQ(i.aim, Aim::fixed);
  EXPECT_EQ(read("kind: rgb\nrange_m: [1, 30]\naim: surface\n" + frame).aim, Aim::surface);
}

TEST(ReadInstrument, OneWithoutAFootprintIsRefused) {
  EXPECT_TRUE(contains(refusal_of("kind: rgb\nrange_m: [1, 30]\n"), "found 0 footprints"));
  EXPECT_TRUE(contains(refusal_of("kind: rgb\nrange_m: [1, 30]\nround: {detail_m: 2}\n" + frame),
                       "found 2 footprints"));
}

TEST(ReadInstrument, RangesTheWrongWayRoundAreRefused) {
  EXPECT_TRUE(contains(refusal_of("kind: rgb\nrange_m: [30, 1]\n" + frame), "the wrong way round"));
  EXPECT_TRUE(contains(refusal_of("kind: rgb\nrange_m: [30]\n" + frame), "found 1 numbers"));
  EXPECT_TRUE(contains(refusal_of("kind: rgb\n" + frame), "range_m"));
}

TEST(ReadInstrument, AnglesOutOfRangeAreRefused) {
  const std::string start = "kind: rgb\nrange_m: [1, 30]\n";
  EXPECT_TRUE(
      contains(refusal_of(start + "frame: {horizontal_deg: 190, pixels_wide: 4, pixels_high: "
                                  "3, exposure_s: 0}\n"),
               "from 0.1 to 170"));
  const std::string fan = "beam_across_deg: 1, beam_along_deg: 1, pings_per_s: 10}\n";
  EXPECT_TRUE(contains(refusal_of(start + "aim: {axis: [0, 0, 1]}\nfan: {across_deg: 400, " + fan),
                       "from 0.1 to 360"));
  EXPECT_TRUE(contains(refusal_of(start +
                                  "aim: {axis: [0, 0, 1]}\nfan: {across_deg: 90, blind_deg: "
                                  "90, " +
                                  fan),
                       "nothing is left of the fan"));
  EXPECT_TRUE(contains(refusal_of(start + "aim: {axis: [1, 0, 0]}\nfan: {across_deg: 90, " + fan),
                       "a fan stands across the hull"));
  EXPECT_TRUE(contains(refusal_of(start + frame + "aim: {axis: [0, 0, 0]}\n"), "points nowhere"));
  EXPECT_TRUE(contains(refusal_of(start + frame + "aim: nadir\n"), "found nadir"));
}

TEST(ReadInstrument, AnUnknownKindIsToldItsNearest) {
  const std::string message = refusal_of("kind: multibeem\nrange_m: [1, 30]\n" + frame);
  EXPECT_TRUE(contains(message, "did you mean 'multibeam'"));
  EXPECT_TRUE(contains(message, "side_scan"));
}

TEST(ReadInstrument, NoiseWithoutAUnitIsRefused) {
  const std::string start = "kind: rgb\nrange_m: [1, 30]\n" + frame;
  EXPECT_TRUE(contains(refusal_of(start + "noise: {sd: 0.1}\n"), "has no unit"));
  EXPECT_EQ(read(start + "noise: {sd: 0.1, unit: mm}\n").unit, "mm");
}

TEST(ReadInstrument, AnUnknownKeyOrNameIsRefused) {
  EXPECT_TRUE(contains(refusal_of("kind: rgb\nrange_m: [1, 30]\nlamp_aside_m: 0.3\n" + frame),
                       "lamp_aside_m"));
  EXPECT_TRUE(
      contains(refusal_of("kind: rgb\nrange_m: [1, 30]\nlamp_range: 3\n" + frame), "lamp_range"));
  EXPECT_THROW((void)read_named_instrument("sonar", tests::source_folder() / "data"), Error);
}

std::string refusal_of_clarity(const std::string& yaml) {
  try {
    (void)read_clarity(Config::parse(yaml, "t.yaml"));
  } catch (const Error& error) {
    return error.message();
  }
  return "read";
}

TEST(ReadClarity, AttenuationIsGivenOrComesFromABlackDisc) {
  const Clarity c = read_clarity(Config::parse(
      "{beam_attenuation_per_m: 0.6, daylight: 0.5, diffuse_attenuation_per_m: 0.1}", "t.yaml"));
  EXPECT_EQ(c.beam_attenuation_per_m, 0.6);
  EXPECT_EQ(c.daylight, 0.5);
  EXPECT_EQ(c.diffuse_attenuation_per_m, 0.1);
  const Clarity disc = read_clarity(Config::parse("{visibility_m: 8}", "t.yaml"));
  EXPECT_DOUBLE_EQ(disc.beam_attenuation_per_m, 0.6);
  EXPECT_DOUBLE_EQ(disc.diffuse_attenuation_per_m, 0.15);
  EXPECT_EQ(disc.daylight, 1);
  EXPECT_DOUBLE_EQ(disc.backscatter_per_m, 0.009);
}

TEST(ReadClarity, OfAirGoesByTheOpticalRange) {
  const auto air = [](const std::string& yaml) {
    return read_clarity(Config::parse(yaml, "t.yaml"), Medium::air);
  };
  EXPECT_DOUBLE_EQ(air("{visibility_m: 8000}").beam_attenuation_per_m,
                   beam_attenuation_of_air(8000));
  EXPECT_TRUE(contains(refusal_of_clarity("{visibility_m: 8000}"), "visibility_m"));
}

TEST(ReadClarity, NoMoreIsScatteredBackThanIsTaken) {
  EXPECT_TRUE(contains(refusal_of_clarity("{beam_attenuation_per_m: 0.5, backscatter_per_m: 0.6}"),
                       "expected at most the beam attenuation, 0.5"));
}

TEST(ReadClarity, ATurbidityWithoutUnitIsRefused) {
  EXPECT_TRUE(contains(refusal_of_clarity("{turbidity: 4}"), "beam_attenuation_per_m"));
  EXPECT_TRUE(contains(refusal_of_clarity("{turbidity_ntu: 4}"),
                       "turbidity cannot be turned into attenuation"));
  EXPECT_TRUE(contains(refusal_of_clarity("{visibility: 4}"), "write visibility_m"));
  EXPECT_TRUE(
      contains(refusal_of_clarity("{beam_attenuation: 4}"), "write beam_attenuation_per_m"));
  EXPECT_TRUE(contains(refusal_of_clarity("{daylight: 1}"), "give one of"));
  EXPECT_TRUE(
      contains(refusal_of_clarity("{beam_attenuation_per_m: 1, visibility_m: 4}"), "give one"));
}

// exp(-c (a + b)) = exp(-c a) exp(-c b); of a black disc, 1/122 is left of the beam's contrast
// where it is lost from sight; of an optical range 5 %.
TEST(Transmission, IsThatOfBeerAndLambert) {
  EXPECT_DOUBLE_EQ(transmission(0.6, 2), std::exp(-1.2));
  EXPECT_NEAR(transmission(0.6, 5), transmission(0.6, 2) * transmission(0.6, 3), 1e-16);
  EXPECT_EQ(transmission(0, 100), 1);
  EXPECT_NEAR(transmission(beam_attenuation_of_water(7), 7), 0.00823, 1e-5);
  EXPECT_NEAR(transmission(beam_attenuation_of_air(9000), 9000), 0.05, 1e-15);
}

}  // namespace
}  // namespace slackwater::twin::read_instrument_test
