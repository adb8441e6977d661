#include "api/edr/write/content.h"

#include <array>

#include "api/edr/read/parameter_names.h"
#include "tests/api/edr/refusal.h"

namespace slackwater::api::edr {
namespace {

using tests::refusal_of;
using tests::says;

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
    EXPECT_TRUE(says(refusal_of([&] { (void)choose_format(f, "", offered); }),
                     "one of CoverageJSON, GeoJSON, CSV, NetCDF"))
        << f;
  }
  EXPECT_TRUE(says(refusal_of([] { (void)choose_format(std::string(1 << 20, 'f'), "", offered); }),
                   "bytes"));
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

const std::vector<std::string> known{"eastward_sea_water_velocity", "northward_sea_water_velocity",
                                     "eastward_sea_water_velocity_p10"};

TEST(ParameterNames, KeepTheOrderAskedAndNoneTwice) {
  using Places = std::vector<std::size_t>;
  EXPECT_EQ(
      parse_parameter_names("northward_sea_water_velocity, eastward_sea_water_velocity", known),
      (Places{1, 0}));
  EXPECT_EQ(parse_parameter_names("eastward_sea_water_velocity_p10,"
                                  "eastward_sea_water_velocity_p10",
                                  known),
            (Places{2}));
}

TEST(ParameterNames, AnUnknownNameIsMetWithTheNearest) {
  const auto refusal = [](std::string_view text) {
    return refusal_of([&] { (void)parse_parameter_names(text, known); });
  };
  EXPECT_TRUE(
      says(refusal("eastward_sea_water_velocty"), "did you mean 'eastward_sea_water_velocity'?"));
  EXPECT_TRUE(says(refusal("eastward_sea_water_velocity,x"), "found 'x'"));
  EXPECT_TRUE(says(refusal("x"), "eastward_sea_water_velocity, northward_sea_water_velocity"));
  for (const char* text :
       {"", ",", "eastward_sea_water_velocity,", "EASTWARD_SEA_WATER_VELOCITY"}) {
    EXPECT_TRUE(says(refusal(text), "parameter-name: found '")) << text;
  }
  EXPECT_TRUE(says(refusal(std::string(60'000, 'e')), "parameters of this collection"));
  EXPECT_TRUE(says(refusal(std::string(60'000, ',')), "at most 1000 names"));
  EXPECT_TRUE(says(refusal(std::string(100'000, 'x')), "bytes"));
}

}  // namespace
}  // namespace slackwater::api::edr
