// A bound on the height of waves that goes by their period and by where they come from.
#include "twin/mission/height_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "twin/mission/limit.h"

namespace slackwater::tests::height_table_test {
namespace {

constexpr double degree = constants::degree;
const double unknown = std::nan("");

twin::Limit limit_of(const std::string& yaml) {
  return twin::read_limits(Config::parse("limits: [" + yaml + "]", "table.yaml")).front();
}
twin::HeightTable table_of(const std::string& yaml) {
  return limit_of("{significant_wave_height_m: {" + yaml + "}}").table.value();
}
double at(const twin::HeightTable& table, double period_s, double off_deg) {
  return table.limit_at(period_s, off_deg * degree).at_most_m;
}
void expect_refused(const std::string& limits, const std::string& words) {
  try {
    const Config config = Config::parse("limits: [" + limits + "]", "table.yaml");
    static_cast<void>(twin::read_limits(config));
    config.expect_all_read();
    ADD_FAILURE() << limits << " was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("table.yaml:1"), std::string::npos) << error.what();
  }
}
void expect_table_refused(const std::string& table, const std::string& words) {
  expect_refused("{significant_wave_height_m: {" + table + "}}", words);
}

constexpr const char* two_by_two =
    "peak_period_s: [4, 8], rows: [{from_bow_deg: 0, at_most: [1.8, 1.4]}, {from_bow_deg: 90, "
    "at_most: [1.2, 0.8]}]";
constexpr const char* three_by_three =
    "peak_period_s: [4, 6, 10], rows: [{from_bow_deg: 0, at_most: [1.8, 1.9, 1.2]}, "
    "{from_bow_deg: 60, at_most: [1.5, 0.9, 1.0]}, {from_bow_deg: 180, at_most: [1.1, 1.3, 0.7]}]";

TEST(HeightTable, IsItsNumbersAtTheNodes) {
  const twin::HeightTable table = table_of(three_by_three);
  EXPECT_EQ(at(table, 4, 0), 1.8);
  EXPECT_EQ(at(table, 6, 60), 0.9);
  EXPECT_EQ(at(table, 10, 180), 0.7);
  EXPECT_EQ(table.least_m(), 0.7);
  EXPECT_EQ(table.greatest_m(), 1.9);
}

/// By hand: at 6 s and 45 degrees the mean of the four; at 5 s the rows are 1.7 and 1.1 m, of which
/// 30 of 90 degrees make 1.5 m.
TEST(HeightTable, IsLinearBetweenTheNodesOfBothAxes) {
  const twin::HeightTable table = table_of(two_by_two);
  EXPECT_NEAR(at(table, 6, 45), 1.3, 1e-15);
  EXPECT_NEAR(at(table, 5, 30), 1.5, 1e-15);
}

TEST(HeightTable, HasTwoSidesAlikeWhateverTheTurns) {
  const twin::HeightTable table = table_of(three_by_three);
  Rng random(5, "height table");
  for (int i = 0; i < 300; ++i) {
    const double period_s = 3 + 9 * random.uniform(), off_deg = 180 * random.uniform();
    for (const double turned : {-off_deg, off_deg - 360, 360 - off_deg, off_deg + 720})
      EXPECT_NEAR(at(table, period_s, turned), at(table, period_s, off_deg), 1e-12);
  }
}

/// Along each axis alone, within a cell, the middle is the mean of both sides; nowhere is it beyond
/// the nodes of its cell.
TEST(HeightTable, NeverLeavesTheNodesOfItsCell) {
  const twin::HeightTable table = table_of(three_by_three);
  for (std::size_t p = 0; p + 1 < table.peak_period_s.size(); ++p)
    for (std::size_t a = 0; a + 1 < table.off_bow_rad.size(); ++a) {
      const double t0 = table.peak_period_s[p], t1 = table.peak_period_s[p + 1];
      const double a0 = table.off_bow_rad[a] / degree, a1 = table.off_bow_rad[a + 1] / degree;
      const auto nodes = {at(table, t0, a0), at(table, t0, a1), at(table, t1, a0),
                          at(table, t1, a1)};
      for (double share = 0.05; share < 1; share += 0.1) {
        const double t = t0 + share * (t1 - t0), off = a0 + share * (a1 - a0);
        EXPECT_NEAR(at(table, t, off),
                    (1 - share) * at(table, t0, off) + share * at(table, t1, off), 1e-12);
        EXPECT_NEAR(at(table, t, off), (1 - share) * at(table, t, a0) + share * at(table, t, a1),
                    1e-12);
        EXPECT_GE(at(table, t, off), std::min(nodes) - 1e-12);
        EXPECT_LE(at(table, t, off), std::max(nodes) + 1e-12);
      }
    }
}

TEST(HeightTable, IsHeldAtItsEndsAndSaysSo) {
  const twin::HeightTable table = table_of(
      "peak_period_s: [5, 9], rows: [{from_bow_deg: 30, at_most: [1.8, 1.4]}, {from_bow_deg: 120, "
      "at_most: [1.2, 0.8]}]");
  EXPECT_EQ(at(table, 3, 30), 1.8);
  EXPECT_EQ(at(table, 15, 120), 0.8);
  EXPECT_EQ(at(table, 9, 10), 1.4);
  EXPECT_EQ(at(table, 9, 170), 0.8);
  const auto told = [&](double period_s, double off_deg) {
    return text_of(table, table.limit_at(period_s, off_deg * degree));
  };
  EXPECT_EQ(told(9, 120), "0.8 m at a peak period of 9 s, waves 120 degrees off the bow");
  EXPECT_EQ(told(15, 170),
            "0.8 m at a peak period of 15 s (the table ends at 9 s), waves 170 degrees off the bow "
            "(the table ends at 120)");
  EXPECT_EQ(told(3, -10),
            "1.8 m at a peak period of 3 s (the table begins at 5 s), waves 10 degrees off the bow "
            "(the table begins at 30)");
}

/// The oracle looks along the whole axis.
TEST(HeightTable, WhatNobodyKnowsCountsAsItsWorstAndSaysSo) {
  const twin::HeightTable table = table_of(three_by_three);
  const auto least_over_periods = [&](double off_deg) {
    double least = 99;
    for (double period_s = 2; period_s < 14; period_s += 0.125)
      least = std::min(least, at(table, period_s, off_deg));
    return least;
  };
  const auto least_over_angles = [&](double period_s) {
    double least = 99;
    for (double off_deg = 0; off_deg <= 180; off_deg += 0.5)
      least = std::min(least, at(table, period_s, off_deg));
    return least;
  };
  for (const double off_deg : {0.0, 20.0, 60.0, 75.0, 180.0})
    for (const double period_s : {unknown, 0.0, -1.0})
      EXPECT_NEAR(at(table, period_s, off_deg), least_over_periods(off_deg), 1e-12) << off_deg;
  for (const double period_s : {3.0, 4.5, 6.0, 7.0, 12.0})
    EXPECT_NEAR(at(table, period_s, unknown), least_over_angles(period_s), 1e-12) << period_s;
  EXPECT_EQ(at(table, unknown, unknown), 0.7);
  EXPECT_EQ(text_of(table, table.limit_at(unknown, unknown)),
            "0.7 m at the worst period, since none is known, the worst heading, since that of the "
            "bow or of the waves is not known");
}

/// 0 are head seas: the waves come from where the bow points.
TEST(HeightTable, CountsTheAngleFromTheBowToWhereTheWavesComeFrom) {
  const twin::HeightTable table =
      table_of("rows: [{from_bow_deg: 0, at_most: 2}, {from_bow_deg: 180, at_most: 1}]");
  const double north_rad = 0, west_rad = 270 * degree;
  EXPECT_EQ(table.limit_at(SeaState{1, 6, 0}, north_rad).at_most_m, 2);
  EXPECT_EQ(table.limit_at(SeaState{1, 6, 180}, north_rad).at_most_m, 1);
  EXPECT_NEAR(table.limit_at(SeaState{1, 6, 270}, west_rad).at_most_m, 2, 1e-12);
  EXPECT_NEAR(table.limit_at(SeaState{1, 6, 0}, west_rad).at_most_m, 1.5, 1e-12);
  EXPECT_EQ(table.limit_at(SeaState{1, 6, unknown}, north_rad).at_most_m, 1);
  EXPECT_EQ(table.limit_at(SeaState{1, 6, 0}, unknown).at_most_m, 1) << "nobody knows the bow";
  const twin::Limit fixed = limit_of(
      "{significant_wave_height_m: {rows: [{from_bow_deg: 0, at_most: 2}, {from_bow_deg: 180, "
      "at_most: 1}]}, heading_deg: 180}");
  EXPECT_EQ(fixed.table->limit_at(SeaState{1, 6, 0}, north_rad).at_most_m, 1);
  EXPECT_FALSE(fixed.goes_by_heading());
  EXPECT_EQ(fixed.bound, 1);
}

TEST(HeightTable, MayGoByOneAxisAlone) {
  const twin::HeightTable period = table_of("peak_period_s: [4, 8], at_most: [1.5, 0.5]");
  for (const double off_deg : {0.0, 90.0, unknown}) EXPECT_EQ(at(period, 6, off_deg), 1);
  EXPECT_FALSE(period.goes_by_heading());
  const twin::HeightTable angle =
      table_of("rows: [{from_bow_deg: 0, at_most: 1.5}, {from_bow_deg: 90, at_most: 1.1}]");
  for (const double period_s : {2.0, 20.0, unknown})
    EXPECT_NEAR(at(angle, period_s, 45), 1.3, 1e-12);
}

TEST(HeightTable, IsToldWithItsLimit) {
  EXPECT_EQ(text_of(limit_of(std::string("{significant_wave_height_m: {") + two_by_two +
                             "}, heading_deg: 210}")),
            "significant wave height at most 0.8 to 1.8 m by peak period (4 to 8 s) and angle off "
            "the bow (0 to 90 degrees, heading 210)");
  EXPECT_EQ(text_of(limit_of("{significant_wave_height_m: {peak_period_s: [4, 8], at_most: [1.5, "
                             "1.1]}}")),
            "significant wave height at most 1.1 to 1.5 m by peak period (4 to 8 s)");
}

TEST(HeightTable, RefusesWhatIsNone) {
  expect_table_refused("peak_period_s: [8, 4], at_most: [1, 1]", "do not ascend");
  expect_table_refused("peak_period_s: [4, 4], at_most: [1, 1]", "do not ascend");
  expect_table_refused("peak_period_s: [4, .nan], at_most: [1, 1]",
                       "expected a value from 1 to 30");
  expect_table_refused("peak_period_s: [4, 8], at_most: [1, .nan]",
                       "expected a value from 0.05 to 20");
  expect_table_refused("peak_period_s: [4, 8], at_most: [1, 0]",
                       "expected a value from 0.05 to 20");
  expect_table_refused("peak_period_s: [4, 8], at_most: [1, -1]",
                       "expected a value from 0.05 to 20");
  expect_table_refused("peak_period_s: [4, 8], at_most: [1, 1, 1]", "found 3 numbers, expected 2");
  expect_table_refused("peak_period_s: [4, 8], at_most: 1", "expected a list of 2 numbers");
  expect_table_refused("at_most: [1, 1]", "without peak_period_s");
  expect_table_refused("at_most: 1", "fewer than two bounds");
  expect_table_refused("peak_period_s: [4], at_most: [1]", "fewer than two bounds");
  expect_table_refused("rows: [{from_bow_deg: 0, at_most: 1}]", "fewer than two bounds");
  expect_table_refused("peak_period_s: [4, 8]", "either at_most, bounds by peak period, or rows");
  expect_table_refused("peak_period_s: [4, 8], at_most: [1, 1], rows: []", "either at_most");
  expect_table_refused("rows: [{from_bow_deg: 90, at_most: 1}, {from_bow_deg: 0, at_most: 1}]",
                       "do not ascend");
  expect_table_refused("rows: [{from_bow_deg: 0, at_most: 1}, {from_bow_deg: 200, at_most: 1}]",
                       "from_bow_deg");
  expect_table_refused("rows: [{from_bow_deg: 0, at_most: [1, 2]}, {from_bow_deg: 90, at_most: 1}]",
                       "without peak_period_s");
  expect_table_refused("peak_period: [4, 8], at_most: [1, 1]", "");
  expect_refused("{least_significant_wave_height_m: {peak_period_s: [4, 8], at_most: [1, 1]}}",
                 "where a number was expected");
  expect_refused("{wave_peak_period_s: {peak_period_s: [4, 8], at_most: [1, 1]}}",
                 "where a number was expected");
  expect_refused(
      "{significant_wave_height_m: {peak_period_s: [4, 8], at_most: [1, 1]}, "
      "heading_deg: 10}",
      "without rows by from_bow_deg");
  expect_refused(
      "{significant_wave_height_m: {peak_period_s: [4, 8], at_most: [1, 1]}, "
      "from_bow_deg: [0, 90]}",
      "found beside a table");
  expect_refused(
      "{significant_wave_height_m: {peak_period_s: [4, 8], at_most: [1, 1]}, "
      "current_speed_m_s: 1}",
      "give each limit an entry of its own");
  expect_refused(
      "{significant_wave_height_m: {peak_period_s: [4, 8], at_most: [1, 2]}}, "
      "{least_significant_wave_height_m: 3}",
      "impossible");
}

}  // namespace
}  // namespace slackwater::tests::height_table_test
