#include "calibration/propagate/hourly_values.h"

#include <gtest/gtest.h>

#include "fields/base/check.h"

namespace slackwater::calibration::hourly_values_test {
namespace {

const UtcTime end_of_day{std::chrono::hours(24)};

/// Instants each `step_h` over the day, both ends; the value is the hour, east, and 10 x the level.
VectorColumn day(double step_h, std::size_t levels) {
  VectorColumn column;
  for (std::size_t k = 0; k < levels; ++k) column.levels_m.push_back(static_cast<double>(k));
  for (int i = 0; i * step_h <= 24.0; ++i) {
    column.time.push_back(TimeCell::instant(add_hours(end_of_day, i * step_h - 24.0)));
    column.source.push_back(DataStatus::observation);
    for (std::size_t k = 0; k < levels; ++k) {
      column.value.emplace_back(i * step_h - 24.0, 10.0 * static_cast<double>(k));
      column.status.push_back(SampleStatus::ok);
    }
  }
  return column;
}

std::vector<Horizontal> zeros(const VectorColumn& column) {
  return std::vector<Horizontal>(column.value.size());
}

TEST(HourlyValues, AnHourlySeriesStaysAsItIs) {
  const VectorColumn column = day(1.0, 2);
  const HourlyValues values = hourly_values(column, zeros(column), end_of_day, {});
  ASSERT_EQ(values.cell.size(), 25U);
  for (std::size_t t = 0; t < 25; ++t) {
    EXPECT_EQ(values.cell[t].from_h, static_cast<double>(t) - 24.0);
    EXPECT_EQ(values.value_m_s(static_cast<Eigen::Index>(t), 1), column.value[2 * t + 1]);
  }
  EXPECT_TRUE(values.has.all());
}

TEST(HourlyValues, AFinerSeriesIsAveragedOverTheHoursBeforeTheEndOfTheDay) {
  const VectorColumn column = day(0.25, 1);
  const std::vector<double> sigma(column.value.size(), 0.04);
  const HourlyValues values = hourly_values(column, column.value, end_of_day, sigma);
  ASSERT_EQ(values.cell.size(),
            25U);  // the first instant of the day ends an hour of the day before
  EXPECT_DOUBLE_EQ(values.cell.front().from_h, -24.0);
  EXPECT_DOUBLE_EQ(values.cell.back().from_h, -0.375);  // mean of -0.75, -0.5, -0.25 and 0
  EXPECT_NEAR(values.value_m_s(24, 0).real(), -0.375, 1e-14);
  EXPECT_NEAR(values.wind_answer_m_s(24, 0).real(), -0.375, 1e-14);
  // Both components, four independent errors.
  EXPECT_NEAR(values.error_m2_s2(24, 0), 2 * 0.04 * 0.04 / 4, 1e-15);
  EXPECT_NEAR(values.error_m2_s2(0, 0), 2 * 0.04 * 0.04, 1e-15);
}

TEST(HourlyValues, AnHourIsTheMeanOfTheValuesItHas) {
  VectorColumn column = day(0.5, 1);
  column.status[column.status.size() - 2] = SampleStatus::suspect;
  column.value[column.value.size() - 2] = {1e30, 1e30};
  column.status[0] = SampleStatus::missing;
  const HourlyValues values = hourly_values(column, zeros(column), end_of_day, {});
  EXPECT_EQ(values.value_m_s(24, 0), column.value.back());
  EXPECT_FALSE(values.has(0, 0));
  EXPECT_TRUE(values.has(24, 0));
}

TEST(HourlyValues, WhatEndsAfterTheDayAndLongMeansAreLeftAlone) {
  VectorColumn column = day(1.0, 1);
  column.time.clear();
  for (int d = -3; d <= 1; ++d)
    column.time.push_back({add_hours(end_of_day, 24.0 * (d - 1)), add_hours(end_of_day, 24.0 * d)});
  column.value.resize(5);
  column.status.resize(5);
  const HourlyValues values = hourly_values(column, zeros(column), end_of_day, {});
  ASSERT_EQ(values.cell.size(), 4U);
  EXPECT_DOUBLE_EQ(values.cell.back().from_h, -24);
  EXPECT_DOUBLE_EQ(values.cell.back().to_h, 0);
}

TEST(HourlyValues, RunningMeansOfADayAreNotAveragedAgain) {
  VectorColumn column = day(24.0, 1);
  column.time[0] = {add_hours(end_of_day, -24.5), add_hours(end_of_day, -0.5)};
  column.time[1] = {add_hours(end_of_day, -24), end_of_day};
  const HourlyValues values = hourly_values(column, zeros(column), end_of_day, {});
  ASSERT_EQ(values.cell.size(), 2U);
  EXPECT_EQ(values.value_m_s(0, 0), column.value[0]);
  EXPECT_DOUBLE_EQ(values.cell[0].to_h, -0.5);
}

TEST(HourlyValues, RefusesArraysOfAnotherSize) {
  const VectorColumn column = day(1.0, 2);
  const std::vector<Horizontal> short_answer(3);
  const std::vector<double> short_sigma(3);
  EXPECT_THROW((void)hourly_values(column, short_answer, end_of_day, {}), ContractViolation);
  EXPECT_THROW((void)hourly_values(column, zeros(column), end_of_day, short_sigma),
               ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration::hourly_values_test
