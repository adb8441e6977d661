#include "api/show/coverage/findings_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fields/base/encode/csv.h"
#include "fields/geo/local_frame.h"
#include "tests/api/show/coverage/made_up_inspection.h"
#include "tests/support/error_of.h"

namespace slackwater::tests::findings_file_test {
namespace {

using namespace api;
using ingest::TrajectoryFile;
using nlohmann::json;

std::vector<std::vector<std::string>> cells_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) rows.push_back(csv_cells(line).value());
  return rows;
}

TEST(FindingsFile, GeoJsonIsThatOfRfc7946) {
  const json all = json::parse(findings_geojson(made_up_inspection()));
  EXPECT_EQ(all["type"], "FeatureCollection");
  EXPECT_FALSE(all.contains("crs")) << "RFC 7946, 4: none other than WGS 84";
  ASSERT_EQ(all["features"].size(), 4U)
      << "two found and a false alarm on the pile, one on the bed";
  for (const json& feature : all["features"]) {
    EXPECT_EQ(feature["type"], "Feature");
    EXPECT_TRUE(feature["properties"].is_object());
    EXPECT_EQ(feature["geometry"]["type"], "Point");
    ASSERT_EQ(feature["geometry"]["coordinates"].size(), 2U);
    EXPECT_NEAR(feature["geometry"]["coordinates"][0].get<double>(), -2.55, 1e-3) << "longitude";
    EXPECT_NEAR(feature["geometry"]["coordinates"][1].get<double>(), 48.85, 1e-3);
  }
}

TEST(FindingsFile, APlaceIsWhereItWasReportedToTheCentimetre) {
  const json all = json::parse(findings_geojson(made_up_inspection()));
  const LocalFrame frame(GeoPoint::from_degrees(48.85, -2.55));
  for (const json& feature : all["features"]) {
    const json& at = feature["geometry"]["coordinates"];
    const json& said = feature["properties"];
    const auto place = frame.to_local(GeoPoint::from_degrees(at[1], at[0]));
    EXPECT_NEAR(place.x(), said["east_m"].get<double>(), 0.01);
    EXPECT_NEAR(place.y(), said["north_m"].get<double>(), 0.01);
  }
  const json& crack = all["features"][1]["properties"];
  EXPECT_EQ(crack["kind"], "crack");
  EXPECT_NEAR(crack["bearing_deg"].get<double>(), 212.2, 0.11) << "9.4 cm back from 214 degrees";
  EXPECT_NEAR(crack["depth_m"].get<double>(), 12.3, 1e-4);
  EXPECT_EQ(crack["size_m"], 0.05);
  EXPECT_EQ(crack["instrument"], "ROV camera");
  EXPECT_EQ(crack["time_utc"], "2025-03-10T06:17:24Z");
  EXPECT_TRUE(all["features"][3]["properties"]["bearing_deg"].is_null()) << "a bed has none";
}

TEST(FindingsFile, WithoutTheTruthAFalseAlarmLooksLikeAFinding) {
  const std::string text = findings_geojson(made_up_inspection());
  for (const char* word : {"true", "truth", "false", "missed", "defect"})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  const json all = json::parse(text);
  EXPECT_EQ(all["features"][0]["properties"].size(), all["features"][2]["properties"].size());
}

TEST(FindingsFile, TheTruthHasErrorsOfSizeAndPlaceAndWhatWasMissed) {
  const json all = json::parse(findings_geojson(made_up_inspection(), {.shows_truth = true}));
  ASSERT_EQ(all["features"].size(), 7U);
  const auto of = [&](std::size_t i) { return all["features"][i]["properties"]; };
  EXPECT_EQ(of(0)["truth"], "found");
  EXPECT_NEAR(of(0)["size_error_m"].get<double>(), 0.02, 1e-9);
  EXPECT_NEAR(of(0)["position_error_m"].get<double>(), 0.1, 1e-4) << "6 cm east, 8 cm south";
  EXPECT_EQ(of(2)["truth"], "false alarm");
  EXPECT_TRUE(of(2)["true_size_m"].is_null());
  EXPECT_EQ(of(3)["truth"], "missed: never seen");
  EXPECT_EQ(of(3)["number"], "M1");
  EXPECT_TRUE(of(3)["size_m"].is_null());
  EXPECT_TRUE(of(3)["time_utc"].is_null());
  EXPECT_EQ(of(3)["true_size_m"], 0.08);
  EXPECT_NEAR(of(3)["bearing_deg"].get<double>(), 180, 1e-9) << "where it is, not its patch";
}

TEST(FindingsFile, CsvSaysTheSameAsGeoJson) {
  for (const bool shows_truth : {false, true}) {
    const json all = json::parse(findings_geojson(made_up_inspection(), {shows_truth}));
    const auto rows = cells_of(findings_csv(made_up_inspection(), {shows_truth}));
    ASSERT_EQ(rows.size(), all["features"].size() + 1);
    EXPECT_EQ(rows[0][0], "latitude_deg");
    for (std::size_t r = 1; r < rows.size(); ++r) {
      const json& said = all["features"][r - 1]["properties"];
      ASSERT_EQ(rows[r].size(), rows[0].size());
      ASSERT_EQ(rows[r].size(), said.size() + 2);
      EXPECT_EQ(std::stod(rows[r][0]), all["features"][r - 1]["geometry"]["coordinates"][1]);
      for (std::size_t c = 2; c < rows[r].size(); ++c) {
        const json& value = said[rows[0][c]];
        if (value.is_null())
          EXPECT_EQ(rows[r][c], "") << rows[0][c];
        else if (value.is_number())
          EXPECT_EQ(std::stod(rows[r][c]), value.get<double>()) << rows[0][c];
        else
          EXPECT_EQ(rows[r][c], value.get<std::string>());
      }
    }
  }
}

TEST(FindingsFile, NothingFoundIsAListWithoutRowsAndNoInspectionAnError) {
  TrajectoryFile log = made_up_inspection();
  const std::string header = findings_csv(log).substr(0, findings_csv(log).find('\n') + 1);
  log.tables.pop_back();
  EXPECT_EQ(json::parse(findings_geojson(log))["features"].size(), 0U);
  EXPECT_EQ(findings_csv(log), header);
  std::erase_if(log.attributes, [](const auto& a) { return a.first == "inspection"; });
  EXPECT_NE(error_of([&] { return findings_csv(log); }).find("inspected nothing"),
            std::string::npos);
}

TEST(FindingsFile, AnOriginThatIsNoneIsRefused) {
  TrajectoryFile log = made_up_inspection();
  EXPECT_DOUBLE_EQ(origin_in(log).longitude_deg(), -2.55);
  for (const char* origin : {"", "here", "48.85 N, -2.55 E or so", "95 N, 0 E"}) {
    for (auto& [name, value] : log.attributes)
      if (name == "origin") value = origin;
    EXPECT_NE(error_of([&] { return origin_in(log); }), "no error") << origin;
  }
}

}  // namespace
}  // namespace slackwater::tests::findings_file_test
