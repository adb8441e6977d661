// Who speaks between the columns.
#include "fields/service/column_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "fields/base/numbers/random.h"

namespace slackwater::column_layout_test {
namespace {

GeoPoint at(double longitude, double latitude) {
  return GeoPoint::from_degrees(latitude, longitude);
}

/// The weighted mean of a value per column.
template <typename Value>
double mean(const ColumnStencil& stencil, const std::vector<GeoPoint>& columns, Value value) {
  double sum = 0;
  for (std::uint32_t c = 0; c < stencil.count; ++c)
    sum += stencil.weight[c] * value(columns[stencil.column[c]]);
  return sum;
}

std::vector<GeoPoint> grid(double west, double south, int columns, int rows, double step) {
  std::vector<GeoPoint> points;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) points.push_back(at(west + i * step, south + j * step));
  }
  return points;
}

TEST(ColumnLayout, OnAGridAPlaneComesBackExactly) {
  const auto columns = grid(1.0, 52.0, 7, 5, 0.03);
  const ColumnLayout layout(columns);
  ASSERT_TRUE(layout.is_grid());
  const auto plane = [](const GeoPoint& p) {
    return 3 + 2 * p.longitude_deg() - 7 * p.latitude_deg() +
           11 * p.longitude_deg() * p.latitude_deg();  // bilinear is exact for the product too
  };
  Rng random(3, "tests/column_layout");
  for (int i = 0; i < 1000; ++i) {
    const GeoPoint p = at(random.uniform(1.0, 1.18), random.uniform(52.0, 52.12));
    const ColumnStencil stencil = layout.at(p.longitude_deg(), p.latitude_deg());
    ASSERT_TRUE(stencil.is_inside);
    // Within a thousandth of a cell of a centre the centre's value is given: 11*52*3e-5.
    EXPECT_NEAR(mean(stencil, columns, plane), plane(p), 0.04) << i;
    double sum = 0;
    for (std::uint32_t c = 0; c < stencil.count; ++c) sum += stencil.weight[c];
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(ColumnLayout, HalfACellBeyondTheOutermostCentresIsInsideAndNotMore) {
  const ColumnLayout layout(grid(1.0, 52.0, 4, 4, 0.1));
  EXPECT_TRUE(layout.at(0.951, 52.1).is_inside);
  EXPECT_FALSE(layout.at(0.949, 52.1).is_inside);
  EXPECT_TRUE(layout.at(1.1, 52.349).is_inside);
  EXPECT_FALSE(layout.at(1.1, 52.351).is_inside);
  EXPECT_FALSE(layout.at(std::nan(""), 52.1).is_inside);
  EXPECT_FALSE(layout.at(1.1, INFINITY).is_inside);
  // A whole turn is the same place.
  EXPECT_TRUE(layout.at(361.1, 52.1).is_inside);
}

TEST(ColumnLayout, OneColumnSpeaksForFiveKilometres) {
  const ColumnLayout layout(std::vector{at(-2.5, 48.8)});
  EXPECT_EQ(layout.at(-2.5, 48.8 + 4.9 / 111.2).count, 1U);
  EXPECT_FALSE(layout.at(-2.5, 48.8 + 5.1 / 111.2).is_inside);
  const double east = 1 / (111.2 * std::cos(48.8 * 3.14159265 / 180));
  EXPECT_TRUE(layout.at(-2.5 + 4.9 * east, 48.8).is_inside);
  EXPECT_FALSE(layout.at(-2.5 + 5.1 * east, 48.8).is_inside);
}

TEST(ColumnLayout, LandHasNoSayAndAPlaceAmongLandAloneIsLand) {
  auto columns = grid(0, 50, 4, 4, 0.1);
  // The south-western block of four is land.
  std::erase_if(columns, [](const GeoPoint& p) {
    return p.longitude_deg() < 0.15 && p.latitude_deg() < 50.15;
  });
  const ColumnLayout layout(columns);
  ASSERT_TRUE(layout.is_grid());
  const ColumnStencil land = layout.at(0.05, 50.05);
  EXPECT_TRUE(land.is_inside);
  EXPECT_EQ(land.count, 0U);
  const ColumnStencil shore = layout.at(0.15, 50.05);
  EXPECT_EQ(shore.count, 2U);
  EXPECT_NEAR(mean(shore, columns, [](const GeoPoint& p) { return p.longitude_deg(); }), 0.2, 1e-12)
      << "only the wet side speaks";
}

TEST(ColumnLayout, TheAntimeridianCutsNoGrid) {
  std::vector<GeoPoint> columns;
  for (const double longitude : {179.8, 179.9, -180.0, -179.9})
    for (const double latitude : {-17.0, -16.9}) columns.push_back(at(longitude, latitude));
  const ColumnLayout layout(columns);
  ASSERT_TRUE(layout.is_grid());
  const ColumnStencil across = layout.at(179.95, -16.95);
  ASSERT_EQ(across.count, 4U);
  EXPECT_NEAR(
      mean(across, columns,
           [](const GeoPoint& p) { return p.longitude_deg() + (p.longitude_deg() < 0 ? 360 : 0); }),
      179.95, 1e-9);
  EXPECT_TRUE(layout.box().contains(at(-179.95, -16.95)));
  EXPECT_FALSE(layout.box().contains(at(0, -16.95)));
}

std::vector<GeoPoint> scattered(Rng& random, int count) {
  std::vector<GeoPoint> columns;
  for (int i = 0; i < count; ++i)
    columns.push_back(at(random.uniform(2.0, 2.2), random.uniform(51.5, 51.6)));
  return columns;
}

TEST(ColumnLayout, ScatteredColumnsGiveTheirOwnValueAtTheirOwnPlaceAndAConstantEverywhere) {
  Rng random(8, "tests/column_layout");
  const auto columns = scattered(random, 40);
  const ColumnLayout layout(columns);
  ASSERT_FALSE(layout.is_grid());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto stencil = layout.at(columns[i].longitude_deg(), columns[i].latitude_deg());
    EXPECT_EQ(stencil.column[0], i);
    EXPECT_EQ(stencil.count, 1U);
  }
  for (int i = 0; i < 500; ++i) {
    const auto stencil = layout.at(random.uniform(2.0, 2.2), random.uniform(51.5, 51.6));
    EXPECT_NEAR(mean(stencil, columns, [](const GeoPoint&) { return 4.0; }), 4.0, 1e-12);
  }
  EXPECT_FALSE(layout.at(2.5, 51.55).is_inside);
}

TEST(ColumnLayout, BetweenScatteredColumnsNothingJumps) {
  Rng random(9, "tests/column_layout");
  const auto columns = scattered(random, 30);
  const ColumnLayout layout(columns);
  std::vector<double> value;
  for (std::size_t i = 0; i < columns.size(); ++i) value.push_back(random.normal());
  const auto at_step = [&](int i) {
    const auto stencil = layout.at(2.02 + 1.6e-6 * i, 51.52 + 0.6e-6 * i);
    double sum = 0;
    for (std::uint32_t c = 0; c < stencil.count; ++c)
      sum += stencil.weight[c] * value[stencil.column[c]];
    return sum;
  };
  // A path of 13 km in steps of 13 cm: the value of a metre's disc about a column apart, no step is
  // seen.
  double last = at_step(0);
  double largest = 0;
  for (int i = 1; i < 100000; ++i) {
    const double now = at_step(i);
    largest = std::max(largest, std::abs(now - last));
    last = now;
  }
  EXPECT_LT(largest, 2e-2);
}

TEST(ColumnLayout, TwoColumnsAnywhereAreNoGridWithLandBetweenThem) {
  const std::vector columns{at(2.0, 51.50), at(2.02, 51.51)};
  const ColumnLayout layout(columns);
  EXPECT_FALSE(layout.is_grid());
  for (const GeoPoint& p : {at(2.02, 51.50), at(2.0, 51.51), at(2.01, 51.505)}) {
    const ColumnStencil stencil = layout.at(p.longitude_deg(), p.latitude_deg());
    EXPECT_TRUE(stencil.is_inside);
    EXPECT_EQ(stencil.count, 2U) << "no land where nobody said so";
  }
  EXPECT_TRUE(ColumnLayout(std::vector{at(2.0, 51.5), at(2.02, 51.5)}).is_grid()) << "one row";
}

TEST(ColumnLayout, NothingLiesBeyondAPole) {
  const ColumnLayout layout(std::vector{at(10, 89.99)});
  EXPECT_TRUE(layout.at(10, 90).is_inside);
  EXPECT_FALSE(layout.at(10, 90.001).is_inside);
  EXPECT_FALSE(ColumnLayout(std::vector{at(10, -89.99)}).at(10, -90.001).is_inside);
  EXPECT_LE(layout.box().north_deg, 90);
}

TEST(ColumnLayout, ColumnsTwiceInOnePlaceAreOne) {
  const std::vector columns{at(2.0, 51.5), at(2.0, 51.5), at(2.000019, 51.5), at(2.1, 51.5)};
  const ColumnLayout layout(columns);
  const ColumnStencil stencil = layout.at(2.05, 51.5);
  ASSERT_EQ(stencil.count, 2U);
  EXPECT_NEAR(stencil.weight[0] + stencil.weight[1], 1, 1e-12);
}

TEST(ColumnLayout, ColumnsNearlyInOnePlaceStayWithinTheGrid) {
  // Steps about the width at which longitudes count as the same: every rounding of it.
  Rng random(10, "tests/column_layout");
  for (int i = 0; i < 20000; ++i) {
    const double first = random.uniform(-180, 179);
    const double step = 2e-5 * (1 + 1e-9 * random.normal());
    const std::vector columns{at(first, 51.5), at(first + step, 51.5)};
    const ColumnStencil stencil = ColumnLayout(columns).at(first, 51.5);
    ASSERT_TRUE(stencil.is_inside);
    ASSERT_LT(stencil.column[0], 2U);
  }
}

}  // namespace
}  // namespace slackwater::column_layout_test
