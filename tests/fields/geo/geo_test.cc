#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fields/base/error.h"
#include "fields/geo/geo_point.h"
#include "fields/geo/local_frame.h"

namespace slackwater::geo_test {
namespace {

TEST(LocalFrameEnu, ReproducesTheReferenceTable) {
  // fields/docs/physics.md §1, computed with PROJ 9.1.1 and the closed form; printed to a
  // micrometre.
  struct Row {
    double origin_lon, origin_lat, lon, lat, h, e, n, u;
  };
  for (const Row& row : {Row{7, 54, 7.1, 54.05, 0, 6549.713388, 5569.896835, -5.787919},
                         Row{7, 54, 7.1, 54.05, -30, 6549.682649, 5569.870633, -35.787892},
                         Row{7, 54, 6.95, 53.98, 100, -3280.411016, -2224.973209, 98.770141},
                         Row{115, -35, 115.1, -35.05, 0, 9123.255832, -5551.617469, -8.942077}}) {
    const LocalFrame frame(GeoPoint::from_degrees(row.origin_lat, row.origin_lon));
    const Vector3<Enu> found = frame.to_local(GeoPoint::from_degrees(row.lat, row.lon), row.h);
    EXPECT_NEAR(found.x(), row.e, 1e-6);
    EXPECT_NEAR(found.y(), row.n, 1e-6);
    EXPECT_NEAR(found.z(), row.u, 1e-6);
  }
}

TEST(LocalFrameEnu, GoesThereAndBack) {
  const LocalFrame frame(GeoPoint::from_degrees(54, 7));
  const auto back = frame.to_geodetic({1000, 2000, -25});
  EXPECT_NEAR(back.point.longitude_deg(), 7.0152561635, 1e-10);
  EXPECT_NEAR(back.point.latitude_deg(), 54.0179677191, 1e-10);
  EXPECT_NEAR(back.height_m, -24.6081659961, 1e-6);
  const Vector3<Enu> again = frame.to_local(back.point, back.height_m);
  EXPECT_NEAR(again.x(), 1000, 1e-6);
  EXPECT_NEAR(again.y(), 2000, 1e-6);
}

TEST(Longitudes, AreBroughtToOneTurn) {
  EXPECT_EQ(normalised_longitude_deg(180), -180);
  EXPECT_EQ(normalised_longitude_deg(-180), -180);
  EXPECT_EQ(normalised_longitude_deg(359.5), -0.5);
  EXPECT_EQ(normalised_longitude_deg(-190), 170);
  EXPECT_EQ(normalised_longitude_deg(179.25), 179.25);
}

TEST(GeoPoints, OutsideTheEarthAreRefused) {
  EXPECT_THROW(static_cast<void>(GeoPoint::from_degrees(91, 0)), Error);
  EXPECT_THROW(static_cast<void>(GeoPoint::from_degrees(0, 400)), Error);
  EXPECT_THROW(static_cast<void>(GeoPoint::from_degrees(std::nan(""), 0)), Error);
  EXPECT_THROW(static_cast<void>(GeoPoint::from_degrees(0, std::nan(""))), Error);
}

TEST(BoundingBoxes, HoldPointsAcrossTheAntimeridian) {
  const BoundingBox box = BoundingBox::from_degrees(170, -20, 190, -10);
  EXPECT_TRUE(box.contains(GeoPoint::from_degrees(-15, 175)));
  EXPECT_TRUE(box.contains(GeoPoint::from_degrees(-15, -175)));
  EXPECT_FALSE(box.contains(GeoPoint::from_degrees(-15, 0)));
  EXPECT_FALSE(box.contains(GeoPoint::from_degrees(-25, 175)));
  EXPECT_TRUE(BoundingBox::from_degrees(0, -90, 360, 90).contains(GeoPoint::from_degrees(3, -100)));
  EXPECT_THROW(static_cast<void>(BoundingBox::from_degrees(0, 10, 1, 5)), Error);
}

TEST(GeodesicDistance, MatchesAMeridianAndAParallel) {
  // One degree of latitude at 45 N and of longitude on the equator: WGS 84 tables (NIMA TR8350.2).
  EXPECT_NEAR(distance_m(GeoPoint::from_degrees(44.5, 0), GeoPoint::from_degrees(45.5, 0)),
              111131.75, 0.5);
  EXPECT_NEAR(distance_m(GeoPoint::from_degrees(0, 179.5), GeoPoint::from_degrees(0, -179.5)),
              111319.49, 0.01);
}

TEST(PositionText, NamesTheHemispheres) {
  EXPECT_EQ(position_text(GeoPoint::from_degrees(48.85, -2.55)), "48.8500 N 2.5500 W");
  EXPECT_EQ(position_text(GeoPoint::from_degrees(-17, 179.99)), "17.0000 S 179.9900 E");
}

}  // namespace
}  // namespace slackwater::geo_test
