#include <gtest/gtest.h>

#include "tests/ingest/cf/tiny_product.h"
#include "tests/support/contains.h"

namespace slackwater::ingest::grid_decode_test {
namespace {

using slackwater::ingest::tests::decode;
using slackwater::ingest::tests::Decoded;
using slackwater::ingest::tests::refusal_of;
using slackwater::ingest::tests::TinyProduct;
using slackwater::tests::contains;

constexpr const char* east = "eastward_sea_water_velocity";

TEST(GriddedDecode, AnyDimensionOrderReadsTheSame) {
  TinyProduct product;
  const GriddedField expected = decode(product).field(east);
  for (const auto& order :
       std::vector<std::vector<std::string>>{{"depth", "time", "latitude", "longitude"},
                                             {"longitude", "latitude", "depth", "time"},
                                             {"time", "longitude", "depth", "latitude"}}) {
    product.order = order;
    const GriddedField found = decode(product).field(east);
    EXPECT_EQ(found.grid, expected.grid);
    EXPECT_EQ(found.values, expected.values);
  }
}

TEST(GriddedDecode, ValuesStandWhereTheFileHasThem) {
  const TinyProduct product;
  const GriddedField field = decode(product).field(east);
  for (std::size_t t = 0; t < 3; ++t) {
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 4; ++i) {
          EXPECT_EQ(field.values[field.grid.offset(t, k, j, i)],
                    static_cast<float>(product.value(t, k, j, i)));
        }
      }
    }
  }
}

TEST(GriddedDecode, DescendingLatitudesAreTurnedWithTheirValues) {
  TinyProduct product;
  product.latitude = {52, 51, 50};
  const GriddedField field = decode(product).field(east);
  EXPECT_EQ(field.grid.latitude_deg, (std::vector<double>{50, 51, 52}));
  EXPECT_EQ(field.values[field.grid.offset(1, 1, 0, 2)],
            static_cast<float>(product.value(1, 1, 2, 2)));
}

TEST(GriddedDecode, ElevationsBecomeDepthsDownAscending) {
  TinyProduct product;  // as the cloud-optimised stores have it: negative up, bottom first
  product.depth_name = "elevation";
  product.depth_positive = "up";
  product.depth = {-30.0, -10.0, -0.5};
  product.order = {"time", "elevation", "latitude", "longitude"};
  const Decoded decoded = decode(product);
  const GriddedField field = decoded.field(east);
  EXPECT_EQ(field.grid.vertical, VerticalKind::depth_m);
  EXPECT_EQ(field.grid.levels_m, (std::vector<double>{0.5, 10.0, 30.0}));
  EXPECT_EQ(field.values[field.grid.offset(0, 0, 1, 1)],
            static_cast<float>(product.value(0, 2, 1, 1)));
}

TEST(GriddedDecode, LevelsInAnyOrderAreSorted) {
  TinyProduct product;
  product.depth = {10.0, 0.5, 30.0};
  const GriddedField field = decode(product).field(east);
  EXPECT_EQ(field.grid.levels_m, (std::vector<double>{0.5, 10.0, 30.0}));
  EXPECT_EQ(field.values[field.grid.offset(2, 0, 1, 1)],
            static_cast<float>(product.value(2, 1, 1, 1)));
  EXPECT_EQ(field.values[field.grid.offset(2, 2, 1, 1)],
            static_cast<float>(product.value(2, 2, 1, 1)));
}

TEST(GriddedDecode, WholeNumberCoordinatesRead) {
  TinyProduct product;
  product.depth = {0, 10};
  product.depth_type = netcdf::Type::int64;
  product.time_type = netcdf::Type::int64;
  const GriddedField field = decode(product).field(east);
  EXPECT_EQ(field.grid.levels_m, (std::vector<double>{0, 10}));
  EXPECT_EQ(field.grid.time[1], TimeCell::instant(parse_utc("2024-03-01T01:00:00Z")));
}

TEST(GriddedDecode, ScalarCoordinatesBecomeAxesOfOne) {
  TinyProduct product;
  product.time = {5};
  product.depth = {3.0};
  product.latitude = {50};
  product.longitude = {1};
  product.order = {"longitude"};
  const Decoded decoded = decode(product);
  const Grid& grid = decoded.granule().grid;
  EXPECT_EQ(grid.time,
            (std::vector<TimeCell>{TimeCell::instant(parse_utc("2024-03-01T05:00:00Z"))}));
  EXPECT_EQ(grid.levels_m, std::vector<double>{3.0});
  EXPECT_EQ(grid.latitude_deg, std::vector<double>{50.0});
  EXPECT_EQ(decoded.field(east).values, std::vector<float>{0.0F});
}

TEST(GriddedDecode, LongitudesFrom0To360BecomeContinuousAcrossTheDateline) {
  TinyProduct product;
  product.longitude = {178, 179, 180, 181};
  EXPECT_EQ(decode(product).granule().grid.longitude_deg,
            (std::vector<double>{178, 179, 180, 181}));
  product.longitude = {178, 179, -180, -179};
  EXPECT_EQ(decode(product).granule().grid.longitude_deg,
            (std::vector<double>{178, 179, 180, 181}));
  product.longitude = {350, 351, 352, 353};
  EXPECT_EQ(decode(product).granule().grid.longitude_deg, (std::vector<double>{-10, -9, -8, -7}));
  product.longitude = {358, 359, 0, 1};
  EXPECT_EQ(decode(product).granule().grid.longitude_deg, (std::vector<double>{-2, -1, 0, 1}));
}

TEST(GriddedDecode, AGlobalGridIsTurnedToStartAtMinus180) {
  TinyProduct product;
  product.longitude.clear();
  for (int i = 0; i < 36; ++i) product.longitude.push_back(10.0 * i);
  const GriddedField field = decode(product).field(east);
  EXPECT_EQ(field.grid.longitude_deg.front(), -180.0);
  EXPECT_EQ(field.grid.longitude_deg.back(), 170.0);
  EXPECT_EQ(field.values[field.grid.offset(0, 0, 0, 0)],
            static_cast<float>(product.value(0, 0, 0, 18)));
  EXPECT_EQ(field.values[field.grid.offset(0, 0, 0, 18)],
            static_cast<float>(product.value(0, 0, 0, 0)));
}

TEST(GriddedDecode, ACutAcrossGreenwichAndOneAcrossTheDatelineAreContinuous) {
  TinyProduct product;
  product.longitude.clear();
  for (int i = 0; i < 36; ++i) product.longitude.push_back(10.0 * i);
  IngestOptions options;
  options.cut = BoundingBox::from_degrees(-12, 50.5, 12, 51.5);
  const GriddedField greenwich = decode(product, options).field(east);
  EXPECT_EQ(greenwich.grid.longitude_deg, (std::vector<double>{-20, -10, 0, 10, 20}));
  EXPECT_EQ(greenwich.values[greenwich.grid.offset(1, 0, 0, 1)],
            static_cast<float>(product.value(1, 0, 0, 35)));
  EXPECT_EQ(greenwich.values[greenwich.grid.offset(1, 0, 0, 2)],
            static_cast<float>(product.value(1, 0, 0, 0)));
  options.cut = BoundingBox::from_degrees(172, 50.5, -172, 51.5);
  EXPECT_EQ(decode(product, options).granule().grid.longitude_deg,
            (std::vector<double>{170, 180, 190}));
}

TEST(GriddedDecode, ACutKeepsTheCellsInsideAndOneAround) {
  TinyProduct product;
  product.latitude = {55, 54, 53, 52, 51, 50};
  IngestOptions options;
  options.cut = BoundingBox::from_degrees(2.2, 51.8, 2.4, 53.2);
  const GriddedField field = decode(product, options).field(east);
  EXPECT_EQ(field.grid.latitude_deg, (std::vector<double>{51, 52, 53, 54}));
  EXPECT_EQ(field.grid.longitude_deg, (std::vector<double>{2, 3}));
  EXPECT_EQ(field.values[field.grid.offset(1, 1, 1, 0)],
            static_cast<float>(product.value(1, 1, 3, 1)));
}

TEST(GriddedDecode, ACutThatMissesTheFileSaysWhereTheFileIs) {
  IngestOptions options;
  options.cut = BoundingBox::from_degrees(20, 50, 21, 51);
  const std::string message = refusal_of(TinyProduct{}, options);
  EXPECT_TRUE(contains(message, "invalid_input")) << message;
  EXPECT_TRUE(contains(message, "the cut selects nothing")) << message;
  EXPECT_TRUE(contains(message, "the file 1.0000 to 4.0000")) << message;
}

TEST(GriddedDecode, AxesThatAreNotMonotonicOrNotFiniteAreRefused) {
  TinyProduct product;
  product.latitude = {50, 52, 51};
  EXPECT_TRUE(contains(refusal_of(product), "latitude axis is not monotonic"));
  product.latitude = {50, std::numeric_limits<double>::quiet_NaN(), 52};
  EXPECT_TRUE(contains(refusal_of(product), "latitude 1 is nan"));
  product.latitude = {50, 51, 152};
  EXPECT_TRUE(contains(refusal_of(product), "latitude 2 is 152"));
  product = {};
  product.longitude = {1, 2, 2, 4};
  EXPECT_TRUE(contains(refusal_of(product), "longitude axis is not monotonic"));
  product = {};
  product.depth = {5, 5};
  EXPECT_TRUE(contains(refusal_of(product), "two levels lie at 5"));
}

TEST(GriddedDecode, ACurrentWithoutDepthIsRefused) {
  TinyProduct product;
  product.depth.clear();
  product.order = {"time", "latitude", "longitude"};
  const std::string message = refusal_of(product);
  EXPECT_TRUE(contains(message, "has no depth")) << message;
  EXPECT_TRUE(contains(message, "does not give it")) << message;
}

TEST(GriddedDecode, DepthsOnTheWrongSideOfTheSurfaceAreRefused) {
  TinyProduct product;
  product.depth = {-10, -20};
  EXPECT_TRUE(contains(refusal_of(product), "wrong side of the sea surface"));
}

TEST(GriddedDecode, AnUnknownDimensionIsRefusedByName) {
  TinyProduct product;
  product.depth_name = "ensemble";
  product.depth_positive.reset();
  product.depth_units.reset();
  product.order = {"time", "ensemble", "latitude", "longitude"};
  EXPECT_TRUE(contains(refusal_of(product), "dimension 'ensemble' of length 2"));
}

TEST(GriddedDecode, TerrainFollowingLevelsAreRefused) {
  TinyProduct product;
  product.more = [](netcdf::Writer& writer, int, const std::map<std::string, int>& dimensions) {
    const int s = writer.variable("s_rho", netcdf::Type::float64, {dimensions.at("depth")});
    writer.attribute(s, "standard_name", "ocean_s_coordinate_g2");
    return nullptr;
  };
  EXPECT_TRUE(contains(refusal_of(product), "terrain-following (s) vertical coordinate"));
}

TEST(GriddedDecode, CurvilinearGridsAreRefused) {
  TinyProduct product;
  product.more = [](netcdf::Writer& writer, int variable,
                    const std::map<std::string, int>& dimensions) {
    writer.variable("nav_lat", netcdf::Type::float64,
                    {dimensions.at("latitude"), dimensions.at("longitude")});
    writer.attribute(variable, "coordinates", "nav_lat");
    return nullptr;
  };
  EXPECT_TRUE(contains(refusal_of(product), "curvilinear grid (nav_lat has 2 dimensions)"));
}

TEST(GriddedDecode, ABathymetryOfHeightsBecomesDepthsAndItsLandMissing) {
  TinyProduct product;
  product.time.clear();
  product.depth.clear();
  product.order = {"latitude", "longitude"};
  product.name = "deptho";
  product.standard_name = "sea_floor_depth_below_geoid";
  product.unit = "m";
  product.value = [](std::size_t, std::size_t, std::size_t j, std::size_t i) {
    return j == 1 ? 5.0 : -20.0 - static_cast<double>(i);
  };
  product.more = [](netcdf::Writer& writer, int variable, const std::map<std::string, int>&) {
    writer.attribute(variable, "positive", "up");
    return nullptr;
  };
  const Decoded decoded = decode(product);
  EXPECT_TRUE(decoded.granule().grid.time.empty());
  const GriddedField field = decoded.field("sea_floor_depth_below_geoid");
  EXPECT_EQ(field.values[field.grid.offset(0, 0, 0, 3)], 23.0F);
  EXPECT_TRUE(std::isnan(field.values[field.grid.offset(0, 0, 1, 3)]));
}

}  // namespace
}  // namespace slackwater::ingest::grid_decode_test
