#include "fields/grid/isolines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "fields/base/numbers/random.h"

namespace slackwater::tests::isolines_test {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

struct Sheet {
  std::vector<double> x, y;
  std::vector<float> values;
  [[nodiscard]] std::vector<Isoline> at(double level) const {
    return isolines(x, y, values, level);
  }
};

std::vector<double> axis(double first, double step, std::size_t count) {
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = first + step * static_cast<double>(i);
  return all;
}

Sheet sheet(std::vector<double> x, std::vector<double> y,
            const std::function<double(double, double)>& value) {
  Sheet made{std::move(x), std::move(y), {}};
  for (const double b : made.y)
    for (const double a : made.x) made.values.push_back(static_cast<float>(value(a, b)));
  return made;
}

bool is_closed(const Isoline& line) { return line.front() == line.back(); }

/// Twice what a closed line encloses; positive counterclockwise.
double area_of(const Isoline& line) {
  double twice = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    twice += line[i - 1][0] * line[i][1] - line[i][0] * line[i - 1][1];
  return twice / 2;
}

TEST(Isolines, OfAPlaneAreStraightAndExactlyThere) {
  // Values in eighths: no rounding anywhere.
  const Sheet plane =
      sheet(axis(-3, 0.5, 9), axis(48, 0.25, 7), [](double x, double y) { return 4 * x + 8 * y; });
  const auto lines = plane.at(383);
  ASSERT_EQ(lines.size(), 1U);
  const Isoline& line = lines.front();
  EXPECT_GT(line.size(), 8U);
  for (const auto& [x, y] : line) EXPECT_EQ(4 * x + 8 * y, 383);
  for (const std::size_t end : {std::size_t{0}, line.size() - 1}) {
    const auto [x, y] = line[end];
    EXPECT_TRUE(x == plane.x.front() || x == plane.x.back() || y == plane.y.front() ||
                y == plane.y.back())
        << "it ends at the rim";
  }
  EXPECT_TRUE(plane.at(1e4).empty());
  EXPECT_TRUE(plane.at(-1e4).empty());
}

TEST(Isolines, OfAConeAreCirclesClosedAndSecondOrderNear) {
  double most[2] = {0, 0}, mean[2] = {0, 0};
  for (const int fine : {0, 1}) {
    const double step = fine == 0 ? 0.25 : 0.125;
    const Sheet cone = sheet(axis(-8, step, static_cast<std::size_t>(16 / step) + 1),
                             axis(-8, step, static_cast<std::size_t>(16 / step) + 1),
                             [](double x, double y) { return std::hypot(x, y); });
    const auto lines = cone.at(5);
    ASSERT_EQ(lines.size(), 1U);
    ASSERT_TRUE(is_closed(lines[0]));
    for (const auto& [x, y] : lines[0]) {
      const double error = std::abs(std::hypot(x, y) - 5);
      most[fine] = std::max(most[fine], error);
      mean[fine] += error / static_cast<double>(lines[0].size());
    }
    EXPECT_LT(area_of(lines[0]), 0) << "higher values lie to the left: outside, so clockwise";
    EXPECT_NEAR(-area_of(lines[0]), 25 * std::numbers::pi, 0.2 * step);
  }
  // Linear interpolation along an edge errs by step^2 / (8 r).
  EXPECT_LT(most[0], 0.25 * 0.25 / (8 * 5.0) + 1e-6);
  EXPECT_LT(most[1], 0.125 * 0.125 / (8 * 5.0) + 1e-6);
  EXPECT_NEAR(mean[0] / mean[1], 4, 0.6) << "second order";
}

TEST(Isolines, EndAtMissingValuesAndNeverRunAlongThem) {
  // Land in the middle of a slope; the line of 2.5 meets it from both sides.
  Sheet slope = sheet(axis(0, 1, 8), axis(0, 1, 6), [](double, double y) { return y; });
  for (const std::size_t j : {2U, 3U})
    for (const std::size_t i : {3U, 4U}) slope.values[j * 8 + i] = missing;
  const auto lines = slope.at(2.5);
  ASSERT_EQ(lines.size(), 2U);
  double length = 0;
  for (const Isoline& line : lines) {
    for (const auto& [x, y] : line) {
      EXPECT_EQ(y, 2.5);
      EXPECT_TRUE(x <= 2 || x >= 5) << x << ": between wet nodes alone";
    }
    length += std::abs(line.front()[0] - line.back()[0]);
  }
  EXPECT_EQ(length, 4) << "from 0 to 2 and from 5 to 7";
  // An island in deep water draws no line of any depth that the water around does not have.
  Sheet flat = sheet(axis(0, 1, 6), axis(0, 1, 6), [](double, double) { return 40; });
  flat.values[2 * 6 + 2] = missing;
  for (const double level : {5.0, 20.0, 39.0, 50.0}) EXPECT_TRUE(flat.at(level).empty()) << level;
  EXPECT_TRUE((Sheet{axis(0, 1, 2), axis(0, 1, 2), {missing, 1, 9, 9}}).at(5).empty());
}

TEST(Isolines, OfASaddleAreTheHyperbolasOfTheBilinearSurface) {
  // (x - a)(y - b) is bilinear: its lines never cross x = a or y = b.
  const double a = 0.4, b = 0.7;
  const Sheet saddle = sheet({0, 1}, {0, 1}, [&](double x, double y) { return (x - a) * (y - b); });
  for (const double level : {-0.05, 0.05}) {
    const auto lines = saddle.at(level);
    ASSERT_EQ(lines.size(), 2U) << level;
    for (const Isoline& line : lines) {
      ASSERT_EQ(line.size(), 2U);
      EXPECT_GT((line[0][0] - a) * (line[1][0] - a), 0) << level;
      EXPECT_GT((line[0][1] - b) * (line[1][1] - b), 0) << level;
    }
  }
}

/// Where the bilinear surface is a saddle no rule can be right but one: turned and mirrored the
/// lines are the same.
TEST(Isolines, DoNotChangeWithTheWayOneLooks) {
  Rng rng(20250310, "tests/isolines");
  for (int round = 0; round < 200; ++round) {
    const Sheet given =
        sheet(axis(0, 1, 6), axis(0, 1, 5), [&](double, double) { return rng.uniform(0, 1); });
    Sheet mirrored = given, turned{given.y, given.x, {}};
    for (std::size_t j = 0; j < 5; ++j)
      for (std::size_t i = 0; i < 6; ++i) mirrored.values[j * 6 + i] = given.values[j * 6 + 5 - i];
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 5; ++j) turned.values.push_back(given.values[j * 6 + i]);
    const auto sorted = [](const std::vector<Isoline>& lines, auto back) {
      std::vector<std::array<double, 4>> pieces;
      for (const Isoline& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
          auto from = back(line[i - 1]), to = back(line[i]);
          if (to < from) std::swap(from, to);
          pieces.push_back({from[0], from[1], to[0], to[1]});
        }
      std::sort(pieces.begin(), pieces.end());
      return pieces;
    };
    using Point = std::array<double, 2>;
    const auto same = sorted(given.at(0.5), [](Point p) { return p; });
    const auto through = sorted(mirrored.at(0.5), [](Point p) { return Point{5 - p[0], p[1]}; });
    const auto across = sorted(turned.at(0.5), [](Point p) { return Point{p[1], p[0]}; });
    ASSERT_EQ(same.size(), through.size()) << round;
    ASSERT_EQ(same.size(), across.size()) << round;
    for (std::size_t i = 0; i < same.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        ASSERT_NEAR(same[i][k], through[i][k], 1e-12) << round;
        ASSERT_NEAR(same[i][k], across[i][k], 1e-12) << round;
      }
  }
}

/// Each line is whole: it is closed, or it ends at the rim, and no two ends meet.
TEST(Isolines, AreJoined) {
  Rng rng(7, "tests/isolines/joined");
  for (int round = 0; round < 100; ++round) {
    const Sheet given =
        sheet(axis(0, 1, 12), axis(0, 1, 9), [&](double, double) { return rng.uniform(0, 1); });
    for (const Isoline& line : given.at(0.4)) {
      if (is_closed(line)) continue;
      for (const auto& [x, y] : {line.front(), line.back()})
        EXPECT_TRUE(x == 0 || x == 11 || y == 0 || y == 8) << round << ": " << x << ' ' << y;
    }
  }
}

TEST(Isolines, ThroughNodesAreDrawnOnce) {
  const Sheet steps = sheet(axis(0, 1, 5), axis(0, 1, 5), [](double x, double) { return x; });
  const auto lines = steps.at(2);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].size(), 5U);
  for (const auto& point : lines[0]) EXPECT_EQ(point[0], 2);
  Sheet peak = sheet(axis(0, 1, 3), axis(0, 1, 3), [](double, double) { return 0; });
  peak.values[4] = 2;
  EXPECT_TRUE(peak.at(2).empty()) << "a point is no line";
  EXPECT_TRUE(isolines(axis(0, 1, 1), axis(0, 1, 1), std::vector<float>{3}, 3).empty());
  EXPECT_TRUE(isolines({}, {}, {}, 3).empty());
}

}  // namespace
}  // namespace slackwater::tests::isolines_test
