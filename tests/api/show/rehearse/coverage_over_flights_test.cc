#include "api/show/rehearse/coverage_over_flights.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "twin/agent/conduct.h"

namespace slackwater::tests::coverage_over_flights_test {
namespace {

using namespace api;
using nlohmann::json;

/// A board of four patches of 1, 2, 3 and 4 m2, from left to right, that faces south.
std::shared_ptr<twin::Inspection> board() {
  auto what = std::make_shared<twin::Inspection>();
  what->inspector = "eye";
  twin::InspectionLine line;
  line.detail_m = 0.01;
  line.most_incidence_rad = 1;
  what->plan.lines.push_back(line);
  twin::Instrument camera;
  camera.name = "camera";
  what->instruments.push_back(camera);
  twin::Surface surface;
  surface.name = "T1/board";
  surface.sheet.width_m = 4;
  surface.sheet.height_m = 4;
  surface.sheet.along = "east";
  surface.sheet.down = "downwards";
  for (int i = 0; i < 4; ++i) {
    twin::Patch patch;
    patch.centre_m = {7, static_cast<double>(i), 5};
    patch.normal = {-1, 0, 0};
    patch.area_m2 = i + 1;
    patch.along_m = i + 0.5;
    patch.down_m = 2;
    patch.width_m = 1;
    patch.height_m = 4;
    surface.patches.push_back(patch);
  }
  what->surfaces.push_back(surface);
  what->pairs.push_back({0, 0, 1});
  return what;
}

/// @param covered  of each patch
twin::Flight flight(std::size_t member, const std::vector<bool>& covered, float current_m_s) {
  twin::Flight out;
  out.flown.member = member;
  twin::VehicleAccount eye, other;
  eye.name = "eye";
  other.name = "other";
  twin::InspectionOutcome::Part part;
  part.surface = "T1/board";
  part.instrument = "camera";
  part.area_m2 = 10;
  part.covered = covered;
  for (std::size_t i = 0; i < covered.size(); ++i)
    part.covered_m2 += covered[i] ? static_cast<double>(i + 1) : 0;
  eye.inspection.emplace();
  eye.inspection->parts.push_back(part);
  out.vehicles = {other, eye};
  twin::FlightSample way, work;
  way.current_m_s = 9;
  work.phase = static_cast<std::uint8_t>(twin::Phase::work);
  work.current_m_s = current_m_s - 0.1F;
  out.samples = {{way}, {way, work, work}};
  out.samples[1][2].current_m_s = current_m_s + 0.1F;
  return out;
}

/// Ten futures: the first patch in all of them, the second in nine, the third in five, the last in
/// one.
StartOutcome ten_futures() {
  StartOutcome start;
  for (std::size_t i = 0; i < 10; ++i)
    start.flights.push_back(
        flight(i, {true, i != 3, i % 2 == 0, i == 7}, 0.2F + 0.01F * static_cast<float>(i)));
  return start;
}

TEST(CoverageOverFlights, APatchHasTheStateOfHowManyFuturesCoverIt) {
  const auto what = board();
  const auto coverages = coverage_over_flights(ten_futures(), 1, what.get());
  ASSERT_EQ(coverages.size(), 1U);
  const InspectionCoverage& coverage = coverages[0];
  ASSERT_EQ(coverage.patches.size(), 4U);
  const PatchState expected[] = {PatchState::covered, PatchState::covered, PatchState::seen_poorly,
                                 PatchState::unseen};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(coverage.patches[i].state, expected[i]) << i;
  EXPECT_DOUBLE_EQ(coverage.area_m2, 10);
  EXPECT_DOUBLE_EQ(coverage.shares()[0], 0.3);
  EXPECT_DOUBLE_EQ(coverage.shares()[1], 0.3);
  EXPECT_DOUBLE_EQ(coverage.shares()[2], 0.4);
  // NED of the run as ENU.
  EXPECT_EQ((coverage.patches[2].centre_m - Vector3<Enu>(2, 7, -5)).norm(), 0);
  EXPECT_EQ((coverage.patches[2].normal - Vector3<Enu>(0, -1, 0)).norm(), 0);
}

TEST(CoverageOverFlights, NothingIsSaidOfOneThatInspectsNothing) {
  const auto what = board();
  EXPECT_TRUE(coverage_over_flights(ten_futures(), 0, what.get()).empty());
  EXPECT_TRUE(coverage_over_flights(ten_futures(), 1, nullptr).empty());
  EXPECT_TRUE(coverage_over_flights({}, 1, what.get()).empty());
  EXPECT_EQ(rehearsed_coverage_html(ten_futures(), {}), "");
  EXPECT_EQ(rehearsed_coverage_html({}, {{"eye", what}}), "");
  EXPECT_TRUE(covered_against_flow_json(ten_futures(), 0).is_null());
}

TEST(CoverageOverFlights, ThePicturesSayInWordsWhatTheyShow) {
  const std::string html = rehearsed_coverage_html(ten_futures(), {{"eye", board()}});
  EXPECT_NE(html.find("What is covered, over all futures"), std::string::npos) << html;
  EXPECT_NE(html.find("covered in at least 9 of 10 futures 30 %"), std::string::npos) << html;
  EXPECT_NE(html.find("in some 30 %"), std::string::npos) << html;
  EXPECT_NE(html.find("in fewer than 1 of 10 40 %"), std::string::npos) << html;
  EXPECT_NE(html.find("<svg role=\"img\" aria-label=\"Sheet of T1/board, camera"),
            std::string::npos)
      << html;
}

TEST(CoverageOverFlights, ThePointsAreTheCurrentAtWorkAndTheShareCovered) {
  const json flow = covered_against_flow_json(ten_futures(), 1);
  EXPECT_EQ(flow.at("in"), "current");
  const json points = flow.at("points");
  ASSERT_EQ(points.size(), 10U);
  EXPECT_NEAR(points[4][0].get<double>(), 0.24, 1e-6);  // not the 9 m/s on its way
  EXPECT_NEAR(points[4][1].get<double>(), 60, 1e-9);    // 1 + 2 + 3 of 10
  EXPECT_EQ(points[4][2], 4);
  StartOutcome never_at_work = ten_futures();
  never_at_work.flights[0].samples[1].resize(1);
  EXPECT_TRUE(covered_against_flow_json(never_at_work, 1).at("points")[0][0].is_null());
}

TEST(CoverageOverFlights, InTheAirItIsTheWind) {
  StartOutcome start = ten_futures();
  for (twin::Flight& flight : start.flights)
    for (twin::FlightSample& sample : flight.samples[1]) {
      sample.down_m = -60;
      sample.wind_m_s = 7;
    }
  const json flow = covered_against_flow_json(start, 1);
  EXPECT_EQ(flow.at("in"), "wind");
  EXPECT_NEAR(flow.at("points")[0][0].get<double>(), 7, 1e-6);
}

}  // namespace
}  // namespace slackwater::tests::coverage_over_flights_test
