#include "twin/climate/rose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "twin/climate/known_months.h"
#include "twin/climate/scatter.h"

namespace slackwater::twin::climate_rose_test {
namespace {

constexpr double nan = constants::nan;
using Counts = std::vector<std::vector<std::size_t>>;

TEST(ClimateRose, CountsByHand) {
  const std::vector<double> speed{0.0, 0.4, 0.5, 4.0, 3.9, 8.0, 12, nan, nan, 6.0, 5.0};
  const std::vector<double> from{90, 90, 0, 90, 359, 89, 271, 10, nan, nan, 315};
  const Rose rose = rose_of(speed, from, {4, 0.5, {4, 8}});
  // Of four sectors the first is [315, 45): its left edge is its own.
  EXPECT_EQ(rose.sectors, (Counts{{2, 1, 0}, {0, 1, 1}, {0, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(rose.calm, 2U);
  EXPECT_EQ(rose.no_direction, 1U);
  EXPECT_EQ(rose.missing, 2U);
  EXPECT_EQ(rose.known(), 9U);
  EXPECT_EQ(rose.in_sector(0), 3U);
  EXPECT_EQ(rose.in_class(0), 2U);
  EXPECT_EQ(rose.known() + rose.missing, speed.size());
}

TEST(ClimateRose, AnEdgeBelongsToTheSectorThatItBegins) {
  for (const std::size_t sectors : {4U, 8U, 12U, 16U, 36U}) {
    const double width = 360.0 / static_cast<double>(sectors);
    for (std::size_t s = 0; s < sectors; ++s) {
      const double middle = width * static_cast<double>(s);
      EXPECT_EQ(sector_of(middle, sectors), s);
      EXPECT_EQ(sector_of(middle - width / 2, sectors), s);
      EXPECT_EQ(sector_of(middle + 360, sectors), s);
      EXPECT_EQ(sector_of(middle - 360, sectors), s);
      EXPECT_EQ(sector_of(std::nextafter(middle + width / 2, 0) - 1e-9, sectors), s);
    }
    EXPECT_EQ(sector_of(360, sectors), 0U);
  }
}

/// Every direction is as frequent: a current that turns evenly, seen a whole number of times.
TEST(ClimateRose, ACurrentThatTurnsEvenlyIsFlat) {
  std::vector<double> speed;
  std::vector<double> to;
  for (int i = 0; i < 7 * 360; ++i) {
    speed.push_back(0.4);
    to.push_back(i + 0.5);
  }
  for (const std::size_t sectors : {1U, 4U, 9U, 12U, 36U}) {
    const Rose rose = rose_of(speed, to, {sectors, 0.05, {}});
    for (std::size_t s = 0; s < sectors; ++s)
      EXPECT_EQ(rose.in_sector(s), speed.size() / sectors) << s << " of " << sectors;
  }
}

/// All turned by a sector, the rose is turned by a sector.
TEST(ClimateRose, TurnsWithItsDirections) {
  Rng random(5, "tests/climate_rose");
  std::vector<double> speed;
  std::vector<double> from;
  std::vector<double> turned;
  for (int i = 0; i < 2000; ++i) {
    speed.push_back(random.uniform(0, 20));
    from.push_back(std::floor(random.uniform(0, 3600)) / 8);
    turned.push_back(from.back() + 22.5);
  }
  const RoseClasses classes{16, 1, {5, 10}};
  Rose expected = rose_of(speed, from, classes);
  std::rotate(expected.sectors.rbegin(), expected.sectors.rbegin() + 1, expected.sectors.rend());
  EXPECT_EQ(rose_of(speed, turned, classes).sectors, expected.sectors);
}

TEST(ClimateRose, NothingIsNoSectorAndNoGapIsACalm) {
  const Rose rose =
      rose_of(std::vector<double>{nan, nan, 0}, std::vector<double>{0, nan, nan}, {12, 0, {1}});
  EXPECT_EQ(rose.calm, 1U);
  EXPECT_EQ(rose.missing, 2U);
  EXPECT_EQ(rose.known(), 1U);
}

TEST(ClimateScatter, CountsByHand) {
  const std::vector<double> height{0.2, 0.5, 1.2, 0.7, nan, 1.0};
  const std::vector<double> period{4, 5, 9, nan, 6, 5.5};
  const Scatter scatter = scatter_of(height, std::vector{0.5, 1.0}, period, std::vector{5.0, 8.0});
  EXPECT_EQ(scatter.counts, (Counts{{1, 0, 0}, {0, 1, 0}, {0, 1, 1}}));
  EXPECT_EQ(scatter.known, 4U);
  EXPECT_EQ(scatter.missing, 2U);
}

TEST(ClimateKnownMonths, TellWhatIsKnownOfEach) {
  // 2001-12-31 and 2002-01-01, six-hourly, and a gap.
  const std::vector<double> values{1, 1, nan, 1, 1, nan, nan, nan};
  const StepClock clock{parse_utc("2001-12-31T00:00:00Z"), std::chrono::hours(6), 8};
  const KnownMonths known = known_months(values, months_of(clock, std::nullopt));
  EXPECT_EQ(known.all.steps, 8U);
  EXPECT_EQ(known.all.known, 4U);
  EXPECT_EQ(known.by_month[11].known, 3U);
  EXPECT_EQ(known.by_month[0].steps, 4U);
  EXPECT_EQ(known.by_month[0].known, 1U);
  EXPECT_EQ(known.unknown(), (std::vector<int>{2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(known.thin(), std::vector<int>{1});
}

}  // namespace
}  // namespace slackwater::twin::climate_rose_test
