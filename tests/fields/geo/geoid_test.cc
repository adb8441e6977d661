// The height of the geoid, beside the test values that NGA publishes with EGM96.
#include "fields/geo/geoid.h"

#include <gtest/gtest.h>

namespace slackwater::tests::geoid_test {
namespace {

/// NGA, EGM96 (1998), test points of the program F477: latitude, longitude, undulation in m. The
/// program interpolates otherwise (splines), which makes some centimetres.
TEST(Geoid, IsThatOfThePublishedTestPoints) {
  struct Point {
    double latitude_deg, longitude_deg, height_m;
  };
  for (const auto& [latitude_deg, longitude_deg, height_m] :
       {Point{38.6281550, 269.7791550, -31.628}, Point{-14.6212170, 305.0211140, -2.969},
        Point{46.8743190, 102.4487290, -43.575}, Point{-23.6174460, 133.8747120, 15.871},
        Point{38.6254730, 359.9995000, 50.066}, Point{-0.4667440, 0.0023000, 17.329}}) {
    const GeoPoint at = GeoPoint::from_degrees(latitude_deg, longitude_deg);
    EXPECT_NEAR(geoid_height_m(at), height_m, 0.3) << latitude_deg;
  }
}

TEST(Geoid, GoesRoundTheDateline) {
  EXPECT_NEAR(geoid_height_m(GeoPoint::from_degrees(10, 180)),
              geoid_height_m(GeoPoint::from_degrees(10, -180)), 1e-9);
}

}  // namespace
}  // namespace slackwater::tests::geoid_test
