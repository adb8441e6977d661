#include "api/show/coverage/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "api/show/coverage/tangents.h"
#include "ingest/cf/trajectory_file.h"
#include "tests/api/show/coverage/made_up_inspection.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::view_test {
namespace {

using namespace api;
using ingest::TrajectoryFile;

TEST(CoverageView, ReadsWhatALogHoldsBackFromItsFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "run.nc";
  ingest::write_trajectories(made_up_inspection(), file);
  const std::vector<InspectionCoverage> pairs = coverage_in(ingest::read_trajectories(file));
  ASSERT_EQ(pairs.size(), 2U);
  const InspectionCoverage& pile = pairs[0];
  EXPECT_EQ(pile.name(), "A01/monopile, ROV camera");
  EXPECT_EQ(pile.vehicle, "rov");
  EXPECT_EQ(pile.patches.size(), 72U * 70);
  EXPECT_EQ(pile.findings.size(), 6U);
  EXPECT_FALSE(pile.is_done());
  EXPECT_NEAR(pile.shares()[0], 0.6, 1e-9);
  EXPECT_NEAR(pile.shares()[1], 0.2, 1e-9);
  EXPECT_NEAR(pile.shares()[2], 0.2, 1e-9);
  double covered_m2 = 0;
  for (const CoveragePatch& patch : pile.patches) {
    if (patch.state == PatchState::covered) covered_m2 += patch.area_m2;
    EXPECT_EQ(std::isnan(patch.detail_m), patch.state == PatchState::unseen);
  }
  EXPECT_NEAR(covered_m2, pile.covered_m2, 1e-6);
  EXPECT_FALSE(pairs[1].median_detail_m) << "null is no number";
}

TEST(CoverageView, ALogWithoutInspectionHasNone) {
  TrajectoryFile log = made_up_inspection();
  std::erase_if(log.attributes, [](const auto& a) { return a.first == "inspection"; });
  EXPECT_TRUE(coverage_in(log).empty());
}

TEST(CoverageView, WithoutFindingsItsTableIsNotThere) {
  TrajectoryFile log = made_up_inspection();
  log.tables.pop_back();
  EXPECT_TRUE(coverage_in(log)[0].findings.empty());
}

TEST(CoverageView, BearingsRunClockwiseFromTheFirstOne) {
  CoverageSheet sheet;
  sheet.width_m = 20;
  sheet.first_bearing_deg = 270;
  EXPECT_DOUBLE_EQ(sheet.bearing_deg(0), 270);
  EXPECT_DOUBLE_EQ(sheet.bearing_deg(5), 0);
  EXPECT_DOUBLE_EQ(sheet.bearing_deg(15), 180);
}

TEST(CoverageView, WhatWasReportedBesideTheSurfaceHasItsBearingAndDepthOnTheSheet) {
  const InspectionCoverage pile = coverage_in(made_up_inspection())[0];
  for (double bearing_deg = 1; bearing_deg < 360; bearing_deg += 13.7) {
    const double bearing = bearing_deg / 57.29577951308232;
    // Half a metre off a pile of 3 m radius.
    const SheetPlace place =
        sheet_place(pile, {3.5 * std::sin(bearing), 3.5 * std::cos(bearing), -10.1});
    // Half a metre off, by the tangent of a patch 10 degrees wide: at most 5 x 0.5/3 degrees out.
    EXPECT_NEAR(pile.sheet.bearing_deg(place.along_m), bearing_deg, 0.84);
    EXPECT_NEAR(place.down_m, 10.1, 1e-6);
    EXPECT_GT(place.normal.x() * std::sin(bearing) + place.normal.y() * std::cos(bearing), 0.99);
  }
}

struct Damage {
  const char* what;
  std::function<void(TrajectoryFile&)> harm;
  const char* says;
};

double& cell(TrajectoryFile& log, std::size_t table, const char* name) {
  for (auto& column : log.tables[table].columns)
    if (column.name == name) return column.values[0];
  throw std::out_of_range(name);
}

std::string& inspection(TrajectoryFile& log) { return log.attributes.back().second; }

TEST(CoverageView, ADamagedInspectionIsOneClearError) {
  const double nan = std::nan("");
  const Damage damages[] = {
      {"no JSON", [](auto& log) { inspection(log) = "[{"; }, "no JSON list"},
      {"a key less", [](auto& log) { inspection(log).replace(3, 7, "vessels"); }, "'vehicle'"},
      {"a vehicle too many", [](auto& log) { log.names.clear(); }, "'vehicle': 0"},
      {"no patches", [](auto& log) { log.tables.erase(log.tables.begin()); }, "inspected_patches"},
      {"no column", [](auto& log) { log.tables[0].columns.pop_back(); }, "'covered'"},
      {"a short column", [](auto& log) { log.tables[0].columns.back().values.pop_back(); },
       "whole column"},
      {"a pair too many", [](auto& log) { cell(log, 0, "pair") = 2; }, "column 'pair'"},
      {"half a pair", [](auto& log) { cell(log, 0, "pair") = 0.5; }, "0.5 in row 1"},
      {"no place", [nan](auto& log) { cell(log, 0, "x") = nan; }, "column 'x'"},
      {"seen at no detail", [nan](auto& log) { cell(log, 0, "detail") = nan; }, "detail nan"},
      {"covered, not seen", [](auto& log) { cell(log, 0, "looks") = 0; }, "without a look"},
      {"an unknown kind", [](auto& log) { cell(log, 1, "kind") = 9; }, "below 9"},
      {"an unknown outcome", [](auto& log) { cell(log, 1, "outcome") = 5; }, "below 5"},
      {"found at no time", [nan](auto& log) { cell(log, 1, "time") = nan; }, "column 'time'"},
  };
  for (const Damage& damage : damages) {
    TrajectoryFile log = made_up_inspection();
    damage.harm(log);
    const std::string error = error_of([&] { return coverage_in(log); });
    EXPECT_NE(error.find("the inspection in the log is damaged"), std::string::npos)
        << damage.what << ": " << error;
    EXPECT_NE(error.find(damage.says), std::string::npos) << damage.what << ": " << error;
  }
}

}  // namespace
}  // namespace slackwater::tests::view_test
