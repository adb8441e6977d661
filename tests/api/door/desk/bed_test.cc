// Depth contours around a site: of a plane straight lines, where the formula has them.
#include <gtest/gtest.h>

#include "tests/api/door/desk/desk_served.h"
#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"

namespace slackwater::tests::desk_bed_test {
namespace {

using nlohmann::json;

class DeskBed : public DeskServed {};

TEST_F(DeskBed, IsAPlanesLinesAndNoneAlongLand) {
  const HttpReply none = reply("/sites/farm/bed");
  EXPECT_EQ(none.status, 404) << none.body;
  EXPECT_TRUE(contains(none.body, "found no bathymetry around site farm")) << none.body;
  EXPECT_EQ(reply("/sites/nowhere/bed").status, 404);
  EXPECT_EQ(reply("/sites/farm/bed?depth=5").status, 400);

  ProductForTests bed = bathymetry_product();
  const auto land = bed.quantity("deptho").value;
  bed.quantity("deptho").value = [land](const ProductCell& cell) {
    return land(cell) - WaterForTests::depth_m + 12 + 50 * (cell.latitude_deg - 53.8);
  };
  made_->ingest(write_product(made_->file("bed.nc"), bed));
  const json lines = got("/sites/farm/bed");
  EXPECT_EQ(lines.at("type"), "FeatureCollection");
  EXPECT_EQ(lines.at("product"), "NWSHELF_ANALYSISFORECAST_PHY_004_013");
  EXPECT_EQ(lines.at("datum"), "geoid (mean sea level)");
  EXPECT_FALSE(lines.at("attribution").get<std::string>().empty());
  // From 12 m at 53.8 N to 32 m at 54.2 N: 20 m and 30 m, and no other.
  const std::pair<double, double> all[] = {{20, 53.96}, {30, 54.16}};
  ASSERT_EQ(lines.at("features").size(), std::size(all)) << lines;
  for (std::size_t i = 0; i < std::size(all); ++i) {
    const json& feature = lines.at("features")[i];
    EXPECT_EQ(feature.at("type"), "Feature");
    EXPECT_EQ(feature.at("properties").at("depth_m"), all[i].first);
    EXPECT_EQ(feature.at("properties").at("product"), lines.at("product"));
    EXPECT_EQ(feature.at("properties").at("datum"), lines.at("datum"));
    EXPECT_EQ(feature.at("geometry").at("type"), "MultiLineString");
    ASSERT_EQ(feature.at("geometry").at("coordinates").size(), 1U);
    const json& line = feature.at("geometry").at("coordinates")[0];
    double west = 180, east = -180;
    for (const json& point : line) {
      EXPECT_NEAR(point.at(1).get<double>(), all[i].second, 5.1e-6) << "told to a metre";
      west = std::min(west, point.at(0).get<double>());
      east = std::max(east, point.at(0).get<double>());
    }
    EXPECT_NEAR(west, 6.3, 1e-6);
    EXPECT_NEAR(east, 6.6, 1e-6) << "the node at 6.7 is land";
  }
}

}  // namespace
}  // namespace slackwater::tests::desk_bed_test
