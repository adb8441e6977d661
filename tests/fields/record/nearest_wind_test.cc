#include "fields/record/nearest_wind.h"

#include <gtest/gtest.h>

#include <limits>

namespace slackwater::nearest_wind_test {
namespace {

/// Wind of one hour whose east component numbers the cells: row times 10 plus column.
VectorPiece numbered_cells(const char* product) {
  VectorPiece piece;
  piece.origin.product_id = product;
  piece.east.grid.time = {TimeCell::instant(parse_utc("2024-06-01T00:00:00Z"))};
  piece.east.grid.latitude_deg = {40.0, 40.25, 40.5};
  piece.east.grid.longitude_deg = {18.0, 18.25, 18.5};
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) piece.east.values.push_back(static_cast<float>(10 * j + i));
  piece.north = piece.east;
  return piece;
}

double cell_at(const std::vector<VectorPiece>& pieces, double latitude, double longitude) {
  const GeoPoint point = GeoPoint::from_degrees(latitude, longitude);
  const VectorRecord record = nearest_wind(record_at(pieces, point), pieces, point);
  return record.pieces.at(0).column.value.at(0).real();
}

TEST(NearestWind, IsTheCellOfTheNearestLatitudeAndTheNearestLongitude) {
  const std::vector<VectorPiece> pieces{numbered_cells("ECMWF")};
  EXPECT_EQ(cell_at(pieces, 40.05, 18.30), 1);
  EXPECT_EQ(cell_at(pieces, 40.30, 18.45), 12);
  EXPECT_EQ(cell_at(pieces, 40.55, 17.95), 20) << "half a cell beyond the outermost centres";
}

TEST(NearestWind, OfTwoEquallyNearTheFirstOfTheFileCounts) {
  // Weather centres write north to south, Copernicus Marine south to north; both west to east.
  EXPECT_EQ(cell_at({numbered_cells("ECMWF")}, 40.125, 18.125), 10);
  EXPECT_EQ(cell_at({numbered_cells("WIND_GLO_PHY_L4_NRT_012_004")}, 40.125, 18.125), 0);
}

TEST(NearestWind, AMaskedCellIsLeftToInterpolation) {
  VectorPiece piece = numbered_cells("ECMWF");
  piece.east.values[0] = std::numeric_limits<float>::quiet_NaN();
  const std::vector<VectorPiece> pieces{piece};
  EXPECT_GT(cell_at(pieces, 40.05, 18.05), 0) << "the wet neighbours speak";
}

}  // namespace
}  // namespace slackwater::nearest_wind_test
