#include "api/door/edr/read/wkt.h"

#include <chrono>

#include "tests/api/door/edr/refusal.h"

namespace slackwater::api::edr::wkt_test {
namespace {

using tests::contains;
using tests::long_text;
using tests::refusal_of;

std::string refusal(std::string_view text) {
  return refusal_of([&] { (void)parse_wkt("coords", text); });
}

struct Form {
  const char* text;
  GeometryType type;
  std::size_t parts, paths, vertices;  ///< in all
};

TEST(Wkt, EveryFormIsRead) {
  const Form forms[] = {
      {"POINT(2.45 57.25)", GeometryType::point, 1, 1, 1},
      {"\tPoint\n(2.45\r\n57.25) ", GeometryType::point, 1, 1, 1},
      {"MULTIPOINT((1 2),(3 4))", GeometryType::multi_point, 1, 1, 2},
      {"MULTIPOINT(1 2, 3 4 ,5 6)", GeometryType::multi_point, 1, 1, 3},
      {"MULTIPOINT((1 2),3 4)", GeometryType::multi_point, 1, 1, 2},
      {"LINESTRING(-2.87 51.14 , -2.98 51.36,-3.15 51.03 )", GeometryType::line_string, 1, 1, 3},
      {"MULTILINESTRING((1 2,3 4),(5 6,7 8,9 10))", GeometryType::multi_line_string, 2, 2, 5},
      {"POLYGON((0 0,10 0,10 10,0 10,0 0),(4 4,6 4,6 6,4 4))", GeometryType::polygon, 1, 2, 9},
      {"MULTIPOLYGON(((0 0,1 0,1 1,0 0)),((5 5,6 5,6 6,5 5),(5.4 5.1,5.6 5.1,5.6 5.2,5.4 5.1)))",
       GeometryType::multi_polygon, 2, 3, 12},
      {"POINT(1e1 -5.5E-1)", GeometryType::point, 1, 1, 1},
      {"POINT(+1 .5)", GeometryType::point, 1, 1, 1},
  };
  for (const Form& form : forms) {
    const Geometry read = parse_wkt("coords", form.text);
    std::size_t paths = 0;
    std::size_t vertices = 0;
    for (const Part& part : read.parts) {
      paths += part.size();
      for (const Path& path : part) vertices += path.size();
    }
    EXPECT_EQ(read.type, form.type) << form.text;
    EXPECT_EQ(read.parts.size(), form.parts) << form.text;
    EXPECT_EQ(paths, form.paths) << form.text;
    EXPECT_EQ(vertices, form.vertices) << form.text;
    EXPECT_FALSE(read.has_vertical || read.has_time) << form.text;
  }
}

TEST(Wkt, LongitudeStandsBeforeLatitude) {
  const Geometry read = parse_wkt("coords", "POINT(-122.5 45.25)");
  EXPECT_EQ(read.parts[0][0][0].longitude_deg, -122.5);
  EXPECT_EQ(read.parts[0][0][0].latitude_deg, 45.25);
}

TEST(Wkt, ZAndMAreReadHoweverTheyAreAttached) {
  for (const char* text : {"LINESTRINGZM(2 57 10 1741500000,3 58 -20.5 1741503600.25)",
                           "LINESTRING ZM (2 57 10 1741500000, 3 58 -20.5 1741503600.25)",
                           "linestring zm(2 57 10 1741500000,3 58 -20.5 1741503600.25)"}) {
    const Geometry read = parse_wkt("coords", text);
    EXPECT_TRUE(read.has_vertical && read.has_time);
    const Vertex& last = read.parts[0][0][1];
    EXPECT_EQ(last.vertical, -20.5);
    EXPECT_EQ(format_utc(last.time), "2025-03-09T07:00:00.250Z");
  }
  const Geometry timed = parse_wkt("coords", "LINESTRINGM(2 57 0,3 58 0)");
  EXPECT_TRUE(timed.has_time && !timed.has_vertical);
  const Geometry deep = parse_wkt("coords", "POINT Z (2 57 12)");
  EXPECT_TRUE(!deep.has_time && deep.has_vertical);
  EXPECT_EQ(deep.parts[0][0][0].vertical, 12);
}

TEST(Wkt, WhatIsWrongIsNamedWithItsPlace) {
  const std::pair<const char*, const char*> wrong[] = {
      {"", "POINT or MULTIPOINT"},
      {"2 57", "POINT or MULTIPOINT"},
      {"CIRCLE(2 57)", "POINT or MULTIPOINT"},
      {"SRID=4326;POINT(2 57)", "POINT or MULTIPOINT"},
      {"POINT EMPTY", "not EMPTY"},
      {"POINTQ(2 57)", "nothing, Z, M or ZM"},
      {"POINTZZ(2 57 1)", "nothing, Z, M or ZM"},
      {"POINT Z M(2 57 1 1)", "'('"},
      {"POINT 2 57", "'('"},
      {"POINT(2)", "a latitude in [-90, 90] at character 8"},
      {"POINT(2 57 3)", "',' or ')' at character 12"},
      {"POINT Z(2 57)", "a Z in metres"},
      {"POINT M(2 57)", "an M in seconds"},
      {"POINT(2 57", "',' or ')' at character 11"},
      {"POINT(2 57))", "the end of the geometry at character 12"},
      {"POINT(2 57) garbage", "the end of the geometry"},
      {"POINT(2 57,3 58)", "one vertex, not 2"},
      {"POINT(2,57)", "a latitude"},
      {"POINT(361 57)", "a longitude in [-180, 360]"},
      {"POINT(-180.0001 57)", "a longitude in [-180, 360]"},
      {"POINT(57 90.5)", "a latitude in [-90, 90]"},
      {"POINT(nan 57)", "a longitude"},
      {"POINT(2 NaN)", "a latitude"},
      {"POINT(inf 57)", "a longitude"},
      {"POINT(2 -Infinity)", "a latitude"},
      {"POINT(0x10 57)", "a longitude"},
      {"POINT(2d 57)", "a longitude"},
      {"POINT(1e999999999 57)", "a longitude"},
      {"POINT(--2 57)", "a longitude"},
      {"POINT(+-2 57)", "a longitude"},
      {"POINT(. 57)", "a longitude"},
      {"POINT Z(2 57 1e30)", "a Z in metres"},
      {"POINT M(2 57 1e300)", "an M in seconds"},
      {"LINESTRING(2 57)", "2 vertices, not 1"},
      {"LINESTRINGM(2 57 100,3 58 99)", "times (M) that do not go back"},
      {"MULTILINESTRING(2 57,3 58)", "'('"},
      {"POLYGON((2 57,3 57,2 57))", "4 vertices, not 3"},
      {"POLYGON((2 57,3 57,3 58,2 58))", "a ring whose last vertex repeats its first"},
      {"POLYGON(2 57,3 57,3 58,2 57)", "'('"},
      {"POLYGON((2 57,3 57,3 58,2 57),)", "'('"},
      {"MULTIPOLYGON((2 57,3 57,3 58,2 57))", "'('"},
      {"MULTIPOINT()", "a longitude"},
      {"MULTIPOINT((1 2),)", "a longitude"},
      {"MULTIPOINT((1 2)", "',' or ')'"},
      {"MULTIPOINT((1 2", "')'"},
      {"GEOMETRYCOLLECTION(POINT(2 57))", "POINT or MULTIPOINT"},
  };
  for (const auto& [text, reason] : wrong) {
    const std::string message = refusal(text);
    EXPECT_TRUE(contains(message, reason)) << text;
    EXPECT_TRUE(message.starts_with("coords: found '")) << message;
  }
}

TEST(Wkt, ATypeThatTheQueryDoesNotTakeIsRefusedWithThoseItTakes) {
  const auto refuse = [](std::string_view text) {
    return refusal_of([&] {
      (void)parse_wkt("coords", text, {GeometryType::polygon, GeometryType::multi_polygon});
    });
  };
  EXPECT_TRUE(contains(refuse("POINT(2 57)"), "expected POLYGON or MULTIPOLYGON at character 1"));
  EXPECT_EQ(parse_wkt("coords", "POINT(2 57)", {GeometryType::point}).type, GeometryType::point);
}

TEST(Wkt, HostileTextIsRefusedAtOnce) {
  std::string million = "MULTIPOINT(";
  for (int i = 0; i < 1'000'000; ++i) million += "(2 57),";
  const std::string hostile[] = {
      million,
      std::string(100'000, '('),
      long_text("POLYGON", 60'000, '('),
      long_text(long_text("MULTIPOLYGON", 60'000, '('), 5'000, ')'),
      std::string(60'000, 'M'),
      long_text("POINT", 60'000, ' '),
      long_text("POINT(", 60'000, '9') + " 57)",
      long_text("POINT(0.", 60'000, '0') + "1e99999 57)",
      std::string("POINT(2 57)\0", 12),
      std::string("PO\0INT(2 57)", 12),
      std::string(1'000, '\xff'),
      "POINT(\xe2\x88\x92"
      "2 57)",
  };
  const auto start = std::chrono::steady_clock::now();
  for (const std::string& text : hostile) EXPECT_NE(refusal(text), "");
  // A linear pass takes milliseconds, under sanitizers too; a quadratic one over 60 kB, seconds.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  EXPECT_TRUE(contains(refusal(million), "at most 65536 bytes"));
}

TEST(Wkt, TheLimitOfVerticesIsExact) {
  const auto points = [](std::size_t count) {
    std::string text = "MULTIPOINT(";
    for (std::size_t i = 0; i < count; ++i) text += i == 0 ? "1 2" : ",1 2";
    return text + ")";
  };
  EXPECT_EQ(parse_wkt("coords", points(max_wkt_vertices)).parts[0][0].size(), max_wkt_vertices);
  EXPECT_TRUE(contains(refusal(points(max_wkt_vertices + 1)), "no more than 10000 vertices"));
}

}  // namespace
}  // namespace slackwater::api::edr::wkt_test
