#include "fields/record/choose.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "tests/support/known_series_for_tests.h"

namespace slackwater::record_at_test {
namespace {

using std::chrono::hours;
using namespace tests;

const UtcTime midnight = parse_utc("2024-06-11T00:00:00Z");

/// A lone cell at a distance to the north of a point, with the value 1.
GriddedField cell_north_of(const GeoPoint& point, double distance, const std::string& name) {
  double near = 0;
  double far = 1;
  const auto place = [&](double degrees) {
    return GeoPoint::from_degrees(point.latitude_deg() + degrees, point.longitude_deg());
  };
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (near + far);
    (distance_m(point, place(middle)) < distance ? near : far) = middle;
  }
  GriddedField field;
  field.standard_name = name;
  field.grid.time = instants(midnight, midnight + hours(1));
  field.grid.latitude_deg = {place(near).latitude_deg()};
  field.grid.longitude_deg = {point.longitude_deg()};
  field.values = {1, 1};
  return field;
}

TEST(RecordAt, ASeriesSpeaksAsFarAsItsQuantityReaches) {
  const GeoPoint site = GeoPoint::from_degrees(54.0, 6.5);
  const auto is_heard = [&](const std::string& name, double distance) {
    const GriddedField field = cell_north_of(site, distance, name);
    const std::vector<VectorPiece> pieces{{station_of("buoy"), field, field}};
    const VectorRecord record = record_at(pieces, site);
    if (record.pieces.empty()) return false;
    EXPECT_NEAR(record.pieces[0].distance_m, distance, 0.01);
    EXPECT_EQ(record.pieces[0].column.value[0], Horizontal(1, 1)) << "as it is, at its own place";
    return true;
  };
  const std::map<std::string, double> reach{{"eastward_sea_water_velocity", 10000},
                                            {"northward_sea_water_velocity", 10000},
                                            {"eastward_wind", 50000},
                                            {"northward_wind", 50000},
                                            {"sea_surface_wave_significant_height", 5000},
                                            {"sea_water_potential_temperature", 5000}};
  for (const auto& [name, metres] : reach) {
    EXPECT_EQ(series_reach_m(name), metres) << name;
    EXPECT_TRUE(is_heard(name, metres - 1)) << name;
    EXPECT_FALSE(is_heard(name, metres + 1)) << name;
  }
}

/// Four cells whose value is linear in latitude and longitude.
VectorPiece sloping_cells() {
  VectorPiece piece;
  piece.origin = analysis_of("model");
  piece.east.grid.time = instants(midnight, midnight);
  piece.east.grid.latitude_deg = {54.0, 54.5};
  piece.east.grid.longitude_deg = {6.0, 6.5};
  piece.east.values = {0.0F, 1.0F, 2.0F, 3.0F};
  piece.north = piece.east;
  return piece;
}

TEST(RecordAt, AGridAnswersWhereItIsAsked) {
  const std::vector<VectorPiece> pieces{sloping_cells()};
  const VectorRecord record = record_at(pieces, GeoPoint::from_degrees(54.25, 6.125));
  ASSERT_EQ(record.pieces.size(), 1u);
  EXPECT_EQ(record.pieces[0].distance_m, 0);
  EXPECT_EQ(record.pieces[0].origin, &pieces[0].origin);
  // 2 per half degree of latitude, 1 per half degree of longitude; doubles of small numbers.
  EXPECT_NEAR(record.pieces[0].column.value[0].real(), 1.25, 1e-12);
  EXPECT_FALSE(record.on_land);
  EXPECT_TRUE(record_at(pieces, GeoPoint::from_degrees(56.0, 6.125)).pieces.empty());
}

TEST(RecordAt, DryGroundIsToldFromBeingOutside) {
  std::vector<VectorPiece> pieces{sloping_cells()};
  pieces[0].east.values.assign(4, std::numeric_limits<float>::quiet_NaN());
  const VectorRecord dry = record_at(pieces, GeoPoint::from_degrees(54.25, 6.25));
  EXPECT_TRUE(dry.pieces.empty());
  EXPECT_TRUE(dry.on_land);
  const VectorRecord outside = record_at(pieces, GeoPoint::from_degrees(56.0, 6.25));
  EXPECT_TRUE(outside.pieces.empty());
  EXPECT_FALSE(outside.on_land);
}

TEST(RecordAt, ScalarsAndVectorsAreChosenAlike) {
  const Origin early = analysis_of("waves", 1);
  const Origin late = analysis_of("waves", 2);
  const auto cells = instants(midnight, midnight + hours(2));
  const ScalarRecord record{{scalar_piece(early, cells, [](UtcTime) { return 1.0; }),
                             scalar_piece(late, cells, [](UtcTime) { return 2.0; })}};
  EXPECT_EQ(choose(record, {}, {}).column.value, std::vector<double>(3, 2.0));
  EXPECT_TRUE(choose(record, {midnight - hours(1)}, {}).empty());
}

}  // namespace
}  // namespace slackwater::record_at_test
