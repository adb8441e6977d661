// bbox, distances, resolutions and reference systems.
#include "api/door/edr/read/bbox.h"
#include "api/door/edr/read/crs.h"
#include "api/door/edr/read/distance.h"
#include "api/door/edr/read/resolution.h"
#include "tests/api/door/edr/refusal.h"

namespace slackwater::api::edr::area_parameters_test {
namespace {

using tests::contains;
using tests::refusal_of;

TEST(Bbox, FourOrSixNumbersAreRead) {
  EXPECT_EQ(parse_bbox("2.3,57.2,2.5,57.3").box, (Box{2.3, 57.2, 2.5, 57.3}));
  EXPECT_EQ(parse_bbox("-180, -90, 180, 90").box, (Box{-180, -90, 180, 90}));
  const auto deep = parse_bbox("2,57,-10,3,58,40.5");
  EXPECT_EQ(deep.box, (Box{2, 57, 3, 58}));
  EXPECT_EQ(deep.levels, (LevelRange{-10, 40.5}));
}

TEST(Bbox, ABoxAcrossTheAntimeridianEndsEastOf180) {
  const Box box = parse_bbox("175,-20,-175,-10").box;
  EXPECT_EQ(box, (Box{175, -20, 185, -10}));
  EXPECT_TRUE(contains(box, -179, -15));
  EXPECT_FALSE(contains(box, 0, -15));
}

TEST(Bbox, ABoxAcrossGreenwichMayBeWrittenFrom0To360) {
  EXPECT_EQ(parse_bbox("350,50,10,60").box, (Box{-10, 50, 10, 60}));
  EXPECT_EQ(parse_bbox("360,0,-180,1").box, (Box{0, 0, 180, 1}));
  EXPECT_EQ(parse_bbox("190,0,-175,1").box, (Box{-170, 0, 185, 1}));
}

TEST(Bbox, WhatIsNoBoxIsRefused) {
  for (const char* text :
       {"", "1,2,3", "1,2,3,4,5", "1,2,3,4,5,6,7", "1,2,3,", ",1,2,3", "a,b,c,d", "nan,0,1,1",
        "0,0,inf,1", "0 0 1 1", "0,0,1,1 ", "0x1,0,1,1", "0,60,1,50", "0,-91,1,1", "0,0,361,1",
        "-181,0,1,1", "0,0,5,1,1,4", "57,2.3,57.3,91"}) {
    EXPECT_TRUE(contains(refusal_of([&] { (void)parse_bbox(text); }), "bbox: found '")) << text;
  }
  EXPECT_TRUE(contains(refusal_of([] { (void)parse_bbox(std::string(9999, ',')); }), "bytes"));
}

TEST(Distance, UnitsAreTheirDefinedLengths) {
  const auto metres = [](std::string_view value, std::string_view units) {
    return parse_distance_m("within", value, "within-units", units);
  };
  EXPECT_EQ(metres("250", "m"), 250);
  EXPECT_EQ(metres("1.5", "KM"), 1500);
  EXPECT_EQ(metres("2", "miles"), 3218.688);
  EXPECT_EQ(metres("10", "nmi"), 18520);
  EXPECT_EQ(metres("10", "NM"), 18520);
  EXPECT_EQ(metres("100", "ft"), 100 * 0.3048);
  for (const std::string_view unit : distance_units()) EXPECT_GT(metres("1", unit), 0) << unit;
}

TEST(Distance, WhatIsNoDistanceIsRefused) {
  const auto refusal = [](std::string_view value, std::string_view units) {
    return refusal_of(
        [&] { (void)parse_distance_m("corridor-width", value, "width-units", units); });
  };
  for (const char* value : {"", "0", "-1", "nan", "inf", "ten", "1km", "0x1", "1e999", "1,2"}) {
    EXPECT_TRUE(contains(refusal(value, "km"), "corridor-width: found '")) << value;
  }
  EXPECT_TRUE(contains(refusal("20041", "km"), "half the way round"));
  for (const char* units : {"", "hPa", "parsec", "deg"}) {
    EXPECT_TRUE(contains(refusal("1", units), "width-units: found '")) << units;
    EXPECT_TRUE(contains(refusal("1", units), "m, km, mi, nmi, ft, yd")) << units;
  }
  EXPECT_TRUE(contains(refusal(std::string(100'000, '1'), "km"), "at most 64 bytes"));
}

TEST(Resolution, ZeroIsTheStoredOne) {
  EXPECT_EQ(parse_resolution("resolution-x", "10"), 10U);
  EXPECT_EQ(parse_resolution("resolution-x", "0"), std::nullopt);
  for (const char* text : {"", "-1", "1.5", "1e3", "1001", "ten", "99999999999999999999", "1,2"}) {
    EXPECT_TRUE(contains(refusal_of([&] { (void)parse_resolution("resolution-z", text); }),
                         "resolution-z: found '"))
        << text;
  }
}

TEST(Crs, Wgs84IsKnownByItsNames) {
  for (const char* text :
       {"CRS84", "crs84", "OGC:CRS84", "EPSG:4326", "epsg:4326",
        "http://www.opengis.net/def/crs/OGC/1.3/CRS84", "urn:ogc:def:crs:EPSG::4326",
        "https://www.opengis.net/def/crs/EPSG/0/4326"}) {
    EXPECT_NO_THROW(expect_supported_crs(text)) << text;
  }
  for (const char* text : {"", "EPSG:3857", "native", "EPSG:43260", "NaN"}) {
    EXPECT_TRUE(contains(refusal_of([&] { expect_supported_crs(text); }), "CRS84 (http://"))
        << text;
  }
}

}  // namespace
}  // namespace slackwater::api::edr::area_parameters_test
