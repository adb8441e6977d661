#include "api/door/edr/write/content.h"

#include <array>

#include "tests/api/door/edr/refusal.h"

namespace slackwater::api::edr::content_test {
namespace {

using tests::contains;
using tests::refusal_of;

constexpr std::array offered{Format::coverage_json, Format::geojson, Format::csv, Format::netcdf};
constexpr std::array pages{Format::json, Format::html};

TEST(Content, FNamesAFormatOrAMediaTypeInEitherCase) {
  for (const Format format : offered) {
    EXPECT_EQ(choose_format(name_of(format), "text/html", offered), format);
    EXPECT_EQ(choose_format(media_type_of(format), "", offered), format);
  }
  EXPECT_EQ(choose_format("coveragejson", "", offered), Format::coverage_json);
  EXPECT_EQ(choose_format("NETCDF", "", offered), Format::netcdf);
  EXPECT_EQ(choose_format("application/geo json", "", offered), Format::geojson);
  EXPECT_EQ(media_type_of(Format::coverage_json), "application/prs.coverage+json");
}

TEST(Content, AnFThatIsNotOfferedIsRefusedWithWhatIs) {
  for (const char* f : {"html", "json", "grib", "../etc", "CoverageJSON,CSV"}) {
    EXPECT_TRUE(contains(refusal_of([&] { (void)choose_format(f, "", offered); }),
                         "one of CoverageJSON, GeoJSON, CSV, NetCDF"))
        << f;
  }
  EXPECT_TRUE(contains(
      refusal_of([] { (void)choose_format(std::string(1 << 20, 'f'), "", offered); }), "bytes"));
}

TEST(Content, AcceptIsWeighed) {
  const auto chosen = [](std::string_view accept) { return choose_format("", accept, offered); };
  EXPECT_EQ(chosen(""), Format::coverage_json);
  EXPECT_EQ(chosen("*/*"), Format::coverage_json);
  EXPECT_EQ(chosen("text/csv"), Format::csv);
  EXPECT_EQ(chosen("text/*, application/geo+json;q=0.5"), Format::csv);
  EXPECT_EQ(chosen("text/csv;q=0.2, application/netcdf;q=0.9"), Format::netcdf);
  EXPECT_EQ(chosen("TEXT/CSV ; charset=utf-8 ; q=1.0"), Format::csv);
  // The closest range counts, not the heaviest: CoverageJSON is unwanted here.
  EXPECT_EQ(chosen("application/prs.coverage+json;q=0, */*;q=0.5"), Format::geojson);
  EXPECT_EQ(chosen("application/vnd.cov+json"), Format::coverage_json);
}

TEST(Content, WhatCannotBeServedGetsTheDefault) {
  for (const char* accept : {"image/png", "text/csv;q=nonsense", ";;;,,,", "*", "text/csv;q=0"}) {
    EXPECT_EQ(choose_format("", accept, offered), Format::coverage_json) << accept;
  }
  EXPECT_EQ(choose_format("", std::string(100'000, ','), offered), Format::coverage_json);
}

TEST(Content, ABrowserGetsThePage) {
  EXPECT_EQ(
      choose_format("", "text/html,application/xhtml+xml,application/xml;q=0.9,*/*;q=0.8", pages),
      Format::html);
  EXPECT_EQ(choose_format("", "*/*", pages), Format::json);
}

}  // namespace
}  // namespace slackwater::api::edr::content_test
