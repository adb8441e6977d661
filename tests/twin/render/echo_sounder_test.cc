#include "twin/render/ranging/echo_sounder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "tests/twin/render/ranging_for_tests.h"

namespace slackwater::twin::echo_sounder_test {
namespace {

constexpr double far_m = 60;

EchoSounderSheet quiet(double beam_deg) {
  EchoSounderSheet sheet;
  sheet.beam_rad = beam_deg * constants::degree;
  sheet.noise_sd_m = 0;
  sheet.noise_per_range = 0;
  sheet.step_m = 0;
  sheet.noise_floor = 0;
  sheet.absorption_db_m = 0.04;
  return sheet;
}

EchoSounding ping_of(const Cast& cast, const EchoSounderSheet& sheet, std::uint64_t seed = 3,
                     double least_m = 0.5, double most_m = far_m, int threads = 1) {
  return echo_sounded(cast.scene, cast.caster, sheet, looking_down(), least_m, most_m, seed,
                      threads);
}

/// The footprint's range and its echo over a bed of depth h + s y, by squares of the bed: another
/// way round than rays. An area dA is met at r under the cosine of i, and throws back mu cos^2(i)
/// b^2 10^(-2ar/10) / r^4 dA.
struct Footprint {
  double range_m = 0;
  double echo = 0;
};
Footprint by_squares(const EchoSounderSheet& sheet, double depth_m, double fall) {
  constexpr double square_m = 0.05, reach_m = 30;
  const double slant = std::sqrt(1 + fall * fall);
  double sum = 0, moment = 0;
  for (double x = 0.5 * square_m - reach_m; x < reach_m; x += square_m)
    for (double y = 0.5 * square_m - reach_m; y < reach_m; y += square_m) {
      const double z = depth_m + fall * y, r = std::sqrt(x * x + y * y + z * z);
      const double off = std::acos(z / r);
      if (off > 1.5 * sheet.beam_rad || r > far_m) continue;
      const double squareness = std::abs(z - fall * y) / slant / r;
      const double share = 2 * off / sheet.beam_rad;
      const double echo = std::pow(10.0, -2.7) * squareness * squareness *
                          std::exp(-2 * std::log(2.0) * share * share) *
                          std::pow(10.0, -2 * sheet.absorption_db_m * r / 10) / std::pow(r, 4) *
                          square_m * square_m * slant;
      sum += echo;
      moment += echo * r;
    }
  return {moment / sum, sum};
}

TEST(EchoSounder, TellsTheMeanOfItsFootprintOverALevelAndASlopingBed) {
  for (const double beam_deg : {8.0, 25.0})
    for (const double fall : {0.0, 0.25}) {
      const EchoSounderSheet sheet = quiet(beam_deg);
      const EchoSounding told = ping_of(Cast(sloping_mesh(15, fall)), sheet);
      const Footprint expected = by_squares(sheet, 15, fall);
      EXPECT_NEAR(told.range_m, expected.range_m, 5e-4 * expected.range_m) << beam_deg;
      EXPECT_EQ(told.range_m, told.footprint_range_m);
      double sum = 0;
      for (const float bin : told.mean) sum += static_cast<double>(bin);
      EXPECT_NEAR(sum / expected.echo, 1, 5e-3) << beam_deg << " degrees, " << fall;
      EXPECT_NEAR(told.axis_range_m, 15, 1e-4);
      // The nearest place of a slope lies square to it, where the beam reaches that far.
      const double square_off = std::atan(fall);
      const double nearest_m =
          square_off < 0.5 * sheet.beam_rad
              ? 15 * std::cos(square_off)
              : 15 / (std::cos(0.5 * sheet.beam_rad) + fall * std::sin(0.5 * sheet.beam_rad));
      EXPECT_NEAR(told.nearest_range_m, nearest_m, 0.02) << beam_deg << " degrees, " << fall;
    }
}

// <t^2>/2 over a level bed: sin(t) b^2 of a narrow beam w has <t^2> = w^2 / (8 ln 2).
TEST(EchoSounder, AWideBeamTellsMoreThanWhatLiesBelowIt) {
  const EchoSounderSheet sheet = quiet(10);
  const EchoSounding told = ping_of(Cast(sloping_mesh(15, 0)), sheet);
  const double more = sheet.beam_rad * sheet.beam_rad / (16 * std::log(2.0));
  EXPECT_NEAR(told.range_m / 15 - 1, more, 0.05 * more);
}

TEST(EchoSounder, ItsNoiseIsAsStated) {
  EchoSounderSheet sheet = quiet(10);
  sheet.rings = 8;
  sheet.round = 8;
  sheet.noise_sd_m = 0.05;
  sheet.noise_per_range = 0.01;
  const Cast cast(sloping_mesh(15, 0));
  constexpr int pings = 2000;
  double squares = 0, sum = 0;
  for (std::uint64_t seed = 0; seed < pings; ++seed) {
    const EchoSounding told = ping_of(cast, sheet, seed);
    const double off = (told.range_m - told.footprint_range_m) /
                       (0.05 + 0.01 * static_cast<double>(told.footprint_range_m));
    squares += off * off / pings;
    sum += off / pings;
  }
  EXPECT_NEAR(sum, 0, 4 / std::sqrt(pings));
  EXPECT_NEAR(squares, 1, 4 * std::sqrt(2.0 / pings));
}

TEST(EchoSounder, WithoutABottomWithinTheGateNothingIsTold) {
  EchoSounderSheet sheet = quiet(10);
  const Cast cast(sloping_mesh(15, 0));
  for (const EchoSounding& told :
       {ping_of(cast, sheet, 3, 0.5, 14), ping_of(cast, sheet, 3, 30, 60)}) {
    EXPECT_TRUE(std::isnan(told.range_m));
    EXPECT_TRUE(std::isnan(told.footprint_range_m));
    EXPECT_TRUE(std::isnan(told.axis_range_m));
    EXPECT_EQ(told.instance, 0);
  }
  // An echo under the noise: there, and not told.
  const EchoSounding heard = ping_of(cast, sheet);
  const float peak = *std::max_element(heard.mean.begin(), heard.mean.end());
  sheet.noise_floor = 1.001 * static_cast<double>(peak) / 10;
  EXPECT_TRUE(std::isnan(ping_of(cast, sheet).range_m));
  EXPECT_FALSE(std::isnan(ping_of(cast, sheet).footprint_range_m));
  sheet.noise_floor = 0.999 * static_cast<double>(peak) / 10;
  EXPECT_FALSE(std::isnan(ping_of(cast, sheet).range_m));
}

TEST(EchoSounder, IsTheSameOnAnyNumberOfThreads) {
  const EchoSounderSheet sheet = quiet(25);
  const Cast cast(sloping_mesh(15, 0.2));
  const EchoSounding one = ping_of(cast, sheet), two = ping_of(cast, sheet, 3, 0.5, far_m, 2);
  EXPECT_EQ(one.intensity, two.intensity);
  EXPECT_EQ(one.range_m, two.range_m);
}

}  // namespace
}  // namespace slackwater::twin::echo_sounder_test
