#include "fields/interpolate/column_of_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "fields/interpolate/stencil.h"

namespace slackwater::column_of_field_test {
namespace {

using std::chrono::hours;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// A field on 3 times x 2 levels x the given axes.
GriddedField field(
    std::vector<double> latitude, std::vector<double> longitude,
    const std::function<float(std::size_t t, std::size_t k, double lat, double lon)>& value) {
  GriddedField f;
  f.standard_name = "eastward_sea_water_velocity";
  f.unit = "m s-1";
  f.grid.latitude_deg = std::move(latitude);
  f.grid.longitude_deg = std::move(longitude);
  f.grid.vertical = VerticalKind::depth_m;
  f.grid.levels_m = {1, 20};
  for (int t = 0; t < 3; ++t) f.grid.time.push_back(TimeCell::instant(UtcTime(hours(t))));
  for (std::size_t t = 0; t < 3; ++t) {
    for (std::size_t k = 0; k < 2; ++k) {
      for (const double lat : f.grid.latitude_deg) {
        for (const double lon : f.grid.longitude_deg) f.values.push_back(value(t, k, lat, lon));
      }
    }
  }
  return f;
}

float plane(std::size_t t, std::size_t k, double lat, double lon) {
  return static_cast<float>(2 * lat + 3 * lon + 10.0 * static_cast<double>(t) +
                            100.0 * static_cast<double>(k));
}

TEST(ColumnOfField, ReproducesABilinearFieldExactly) {
  const GriddedField f = field({50, 50.5, 51}, {1, 1.5, 2}, plane);
  const auto column = column_of(f, GeoPoint::from_degrees(50.2, 1.8), DataStatus::analysis);
  for (std::size_t t = 0; t < 3; ++t) {
    for (std::size_t k = 0; k < 2; ++k) {
      ASSERT_EQ(column.status[column.offset(t, k)], SampleStatus::ok);
      EXPECT_NEAR(column.value[column.offset(t, k)], plane(t, k, 50.2, 1.8),
                  2e-5);  // float storage
    }
  }
}

TEST(ColumnOfField, AtACellCentreIsThatCell) {
  const GriddedField f = field({50, 50.5, 51}, {1, 1.5, 2}, plane);
  const auto column = column_of(f, GeoPoint::from_degrees(50.5, 1.5), DataStatus::analysis);
  EXPECT_EQ(column.value[0], static_cast<double>(plane(0, 0, 50.5, 1.5)));
}

TEST(ColumnOfField, NeverAveragesAMaskedCellIn) {
  // The north-east cell is land: its weight goes to the others, and the answer stays within their
  // range.
  const GriddedField f =
      field({50, 51}, {1, 2}, [](std::size_t, std::size_t, double lat, double lon) {
        return lat > 50.5 && lon > 1.5 ? nan : 0.25F;
      });
  const auto column = column_of(f, GeoPoint::from_degrees(50.7, 1.7), DataStatus::analysis);
  EXPECT_EQ(column.status[0], SampleStatus::ok);
  EXPECT_DOUBLE_EQ(column.value[0], 0.25);
}

TEST(ColumnOfField, TellsLandFromBed) {
  const auto land =
      column_of(field({50, 51}, {1, 2}, [](auto, auto, double, double) { return nan; }),
                GeoPoint::from_degrees(50.5, 1.5), DataStatus::analysis);
  EXPECT_EQ(land.status[0], SampleStatus::land);
  const auto shallow =
      column_of(field({50, 51}, {1, 2},
                      [](auto, std::size_t k, double, double) { return k == 1 ? nan : 0.1F; }),
                GeoPoint::from_degrees(50.5, 1.5), DataStatus::analysis);
  EXPECT_EQ(shallow.status[0], SampleStatus::ok);
  EXPECT_EQ(shallow.status[1], SampleStatus::below_bed);
}

TEST(ColumnOfField, AValueMissingAtOneTimeIsMissingThere) {
  const auto column = column_of(field({50, 51}, {1, 2},
                                      [](std::size_t t, auto, double lat, double) {
                                        return t == 1 && lat > 50.5 ? nan : 1.0F;
                                      }),
                                GeoPoint::from_degrees(50.5, 1.5), DataStatus::analysis);
  EXPECT_EQ(column.status[column.offset(0, 0)], SampleStatus::ok);
  EXPECT_EQ(column.status[column.offset(1, 0)], SampleStatus::missing);
  EXPECT_EQ(column.status[column.offset(2, 0)], SampleStatus::ok);
}

TEST(ColumnOfField, OutsideByMoreThanHalfACellIsOutside) {
  const GriddedField f = field({50, 50.5}, {1, 1.5}, plane);
  const auto at = [&](double lat, double lon) {
    return column_of(f, GeoPoint::from_degrees(lat, lon), DataStatus::analysis).status[0];
  };
  EXPECT_EQ(at(49.76, 1), SampleStatus::ok);
  EXPECT_EQ(at(49.74, 1), SampleStatus::outside_area);
  EXPECT_EQ(at(50, 1.74), SampleStatus::ok);
  EXPECT_EQ(at(50, 1.76), SampleStatus::outside_area);
}

TEST(ColumnOfField, ALoneCellReachesFiveKilometres) {
  const GriddedField f = field({46.83}, {-6.08}, plane);
  const auto north_by = [&](double km) {
    return column_of(f, GeoPoint::from_degrees(46.83 + km / 111.195, -6.08), DataStatus::analysis)
        .status[0];
  };
  EXPECT_EQ(north_by(4.9), SampleStatus::ok);
  EXPECT_EQ(north_by(5.1), SampleStatus::outside_area);
}

TEST(ColumnOfField, WorksAcrossTheAntimeridianAndFrom0To360) {
  // A grid from 179 E to 181 E holds its longitudes as 179, 180, 181; points come as -179.5 or
  // 180.5.
  const GriddedField f = field({-20, -19}, {179, 180, 181}, plane);
  for (const double longitude : {-179.5, 180.5}) {
    const auto column =
        column_of(f, GeoPoint::from_degrees(-19.5, longitude), DataStatus::analysis);
    ASSERT_EQ(column.status[0], SampleStatus::ok);
    EXPECT_NEAR(column.value[0], plane(0, 0, -19.5, 180.5), 1e-4);
  }
}

TEST(ColumnOfField, DirectionsPassThroughUnitVectors) {
  GriddedField f = field(
      {50, 51}, {1, 2}, [](auto, auto, double lat, double) { return lat < 50.5 ? 350.0F : 10.0F; });
  f.standard_name = "sea_surface_wave_from_direction";
  f.unit = "degree";
  const auto column = column_of(f, GeoPoint::from_degrees(50.5, 1.5), DataStatus::analysis);
  const double north = std::remainder(column.value[0], 360.0);
  EXPECT_NEAR(north, 0, 1e-9) << "350 and 10 degrees average to north, not to 180";
}

TEST(ColumnOfField, OpposedDirectionsHaveNoMean) {
  GriddedField f = field(
      {50, 51}, {1, 2}, [](auto, auto, double lat, double) { return lat < 50.5 ? 90.0F : 270.0F; });
  f.unit = "degree";
  EXPECT_EQ(column_of(f, GeoPoint::from_degrees(50.5, 1.5), DataStatus::analysis).status[0],
            SampleStatus::missing);
}

TEST(ColumnOfField, AVectorNeedsBothComponents) {
  const GriddedField east =
      field({50, 51}, {1, 2}, [](auto, auto, double, double) { return 0.3F; });
  const GriddedField north = field(
      {50, 51}, {1, 2}, [](auto, auto, double lat, double) { return lat < 50.5 ? nan : 0.4F; });
  const auto column =
      column_of(east, north, GeoPoint::from_degrees(50.5, 1.5), DataStatus::forecast);
  EXPECT_EQ(column.status[0], SampleStatus::ok);
  EXPECT_NEAR(std::abs(column.value[0]), 0.5, 1e-7);
  EXPECT_EQ(column.source[0], DataStatus::forecast);
}

TEST(BilinearStencil, WeightsSumToOne) {
  const GriddedField f = field({50, 50.3, 51}, {1, 1.2, 2}, plane);
  for (double lat = 49.9; lat < 51.1; lat += 0.037) {
    for (double lon = 0.95; lon < 2.2; lon += 0.041) {
      const auto stencil = bilinear_stencil(f.grid, GeoPoint::from_degrees(lat, lon));
      ASSERT_TRUE(stencil);
      double sum = 0;
      for (std::size_t c = 0; c < stencil->count; ++c) sum += stencil->corners[c].weight;
      EXPECT_NEAR(sum, 1, 1e-12);
    }
  }
}

}  // namespace
}  // namespace slackwater::column_of_field_test
