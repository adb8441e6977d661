#include "api/show/report/skill_csv.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "api/show/report/skill_json.h"
#include "fields/base/encode/csv.h"

namespace slackwater::api::skill_csv_test {
namespace {

using nlohmann::json;

std::vector<calibration::SkillEntry> two_entries() {
  calibration::SkillEntry current;
  current.variable = calibration::current_variable;
  current.site = "bay, north";
  current.day = parse_day("2025-03-09");
  current.lead = {0, 24};
  current.band = calibration::DepthBand{0, 5, true};
  current.vector.n = 10;
  current.vector.rmse_m_s = 0.125;
  current.vector.bias_east_m_s = -0.01;
  current.vector.coverage_80 = 0.75;
  current.forecast_rmse = 0.12;
  current.interval = calibration::Interval95{0.1, 0.15};
  calibration::SkillEntry wave = current;
  wave.variable = "sea_surface_wave_significant_height";
  wave.band.reset();
  wave.scalar = calibration::ScalarScore{};
  wave.scalar->rmse = 0.5;
  return {current, wave};
}

TEST(SkillCsv, HasTheNumbersOfTheJsonUnderOneHead) {
  const auto entries = two_entries();
  const json documents = json::parse(skill_json(entries));
  std::istringstream lines(skill_csv(entries));
  std::string line;
  std::getline(lines, line);
  const auto head = csv_cells(line).value();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    ASSERT_TRUE(std::getline(lines, line));
    const auto cells = csv_cells(line).value();
    ASSERT_EQ(cells.size(), head.size()) << line;
    std::map<std::string, std::string> row;
    for (std::size_t k = 0; k < head.size(); ++k) row[head[k]] = cells[k];
    const json& document = documents[i];
    for (const char* key : {"site", "variable", "day", "origin", "method", "unit"})
      EXPECT_EQ(row.at(key), document.at(key)) << key;
    EXPECT_EQ(row.at("lead_to_h"), "24");
    EXPECT_EQ(row.at("rmse_95_high"), "0.15");
    EXPECT_EQ(row.at("forecast_rmse"), "0.12");
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(SkillCsv, WhatAnEntryHasNotIsAnEmptyCell) {
  const std::string text = skill_csv(two_entries());
  EXPECT_NE(text.find(",,,0,5,0,24,10,m s-1,0.125,0.12,0.1,0.15,,-0.01,0,0,,,"), std::string::npos)
      << text;
  EXPECT_NE(text.find(",,,,,0,24,0,m,0.5,"), std::string::npos) << text;
}

}  // namespace
}  // namespace slackwater::api::skill_csv_test
