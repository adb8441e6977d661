#include "ingest/publication.h"

#include <gtest/gtest.h>

#include "ingest/ingest.h"
#include "tests/ingest/cf/tiny_product.h"
#include "tests/support/point_series_for_tests.h"

namespace slackwater::ingest::tests::publication_test {
namespace {

using slackwater::tests::TemporaryFolder;

/// What a file with these global attributes is read to, through the room's one door. Its values are
/// of 2024-03-01, 00:00 to 02:00.
Ingested read_with(const std::map<std::string, std::string>& attributes,
                   const IngestOptions& options = {}) {
  const TemporaryFolder folder;
  TinyProduct product;
  product.global = attributes;
  product.write(folder / "product.nc");
  return decode_file(folder / "product.nc", products(), options, folder.path());
}

std::optional<UtcTime> published(const std::map<std::string, std::string>& attributes,
                                 const IngestOptions& options = {}) {
  const Ingested ingested = read_with(attributes, options);
  EXPECT_TRUE(ingested.warnings.empty()) << ingested.warnings.front();
  return ingested.published;
}

UtcTime at(const char* time) { return parse_utc(time); }

TEST(Publication, IsWhatTheFileSaysOfItself) {
  for (const char* name :
       {"date_issued", "date_update", "date_modified", "date_created", "creation_date"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(published({{name, "2024-03-02T06:30:00Z"}}), at("2024-03-02T06:30:00Z"));
  }
  EXPECT_EQ(published({}), std::nullopt);
  EXPECT_EQ(published({{"date_created", " "}}), std::nullopt);
}

TEST(Publication, IsReadInEveryFormThatTheFilesHave) {
  const UtcTime expected = at("2024-03-02T06:30:00Z");
  for (const char* text : {"2024-03-02 06:30:00", "20240302-06:30:00", "20240302T063000Z",
                           "2024-03-02T08:30:00+02:00", "2024-03-02T01:00:00-0530"}) {
    SCOPED_TRACE(text);
    EXPECT_EQ(published({{"date_created", text}}), expected);
  }
}

TEST(Publication, ADayWithoutAClockIsItsEnd) {
  EXPECT_EQ(published({{"date_created", "2024-03-02"}}), at("2024-03-03T00:00:00Z"));
}

TEST(Publication, TheLastChangeCounts) {
  EXPECT_EQ(published({{"date_created", "2024-03-02T06:00:00Z"},
                       {"date_modified", "2024-03-09T06:00:00Z"},
                       {"date_issued", "2024-03-02T07:00:00Z"}}),
            at("2024-03-09T06:00:00Z"));
}

TEST(Publication, ARunIsOutByTheEndOfItsDayWhateverClockItIsGiven) {
  EXPECT_EQ(published({{"bulletin_date", "20240302"}}), at("2024-03-03T00:00:00Z"));
  EXPECT_EQ(published({{"bulletin_date", "2024-03-02 00:00:00"}}), at("2024-03-03T00:00:00Z"));
  EXPECT_EQ(published({{"bulletin_date", "2024-03-02"}, {"date_created", "2024-03-02T06:00:00Z"}}),
            at("2024-03-02T06:00:00Z"));
}

TEST(Publication, TheDownloadIsNoPublication) {
  EXPECT_EQ(published({{"subset:date", "2024-03-05T09:41:57.624Z"}}), std::nullopt);
  EXPECT_EQ(published({{"history", "2024-03-05T09:41:57Z: Creation"}}), std::nullopt);
  const std::map<std::string, std::string> dates{{"date_created", "2024-03-05T09:41:57Z"},
                                                 {"date_modified", "2024-03-05T09:41:57Z"},
                                                 {"date_issued", "2024-03-02T06:00:00Z"}};
  for (const auto& [name, text] : std::map<std::string, std::string>{
           {"subset:productId", "ANY"},
           {"copernicusmarine_version", "2.0.1"},
           {"History", "Translated to CF-1.0 Conventions by Netcdf-Java CDM"}}) {
    SCOPED_TRACE(name);
    auto attributes = dates;
    attributes[name] = text;
    attributes["comment"] = "cut of cmems_mod_any_PT1H-i";  // so that nothing is to be warned of
    EXPECT_EQ(published(attributes), at("2024-03-02T06:00:00Z"));
  }
}

TEST(Publication, ADamagedDateIsPassedOverWithANote) {
  for (const char* text : {"yesterday", "2024-13-45T00:00:00Z", "99990101"}) {
    SCOPED_TRACE(text);
    const Ingested ingested =
        read_with({{"date_modified", text}, {"date_created", "2024-03-02T06:00:00Z"}});
    EXPECT_EQ(ingested.published, at("2024-03-02T06:00:00Z"));
    ASSERT_EQ(ingested.warnings.size(), 1U);
    EXPECT_NE(ingested.warnings[0].find("date_modified says '" + std::string(text)),
              std::string::npos)
        << ingested.warnings[0];
  }
}

TEST(Publication, WhatTheOperatorSaysWinsOverAnOlderDate) {
  // A forecast run that somebody declares to be the analysis of its days is not its own publication
  // of them; who says when it was issued knows.
  const std::map<std::string, std::string> early{{"bulletin_date", "2024-02-28"}};
  EXPECT_EQ(published(early), at("2024-02-29T00:00:00Z"));
  IngestOptions options;
  options.as = DataStatus::analysis;
  EXPECT_EQ(published(early, options), std::nullopt);
  EXPECT_EQ(published({{"bulletin_date", "2024-03-01"}}, options), at("2024-03-02T00:00:00Z"));
  options.as = DataStatus::forecast;
  options.issued = at("2024-02-27T12:00:00Z");
  EXPECT_EQ(published(early, options), std::nullopt);
}

TEST(Publication, ObservationsAreNotOutBeforeTheyAreMade) {
  const TemporaryFolder folder;
  slackwater::tests::PointSeriesForTests series;
  series.time = slackwater::tests::stepping_times(parse_day("2024-03-01"), 1, 60);
  series.depth_m = {5};
  series.value = [](UtcTime, double) { return Horizontal(0.1, 0.2); };
  const auto read = [&](const char* date) {
    series.global = {{"date_update", date}};
    const auto file = slackwater::tests::write_point_series(folder / "series.nc", series);
    return decode_file(file, products(), {}, folder.path());
  };
  const Ingested later = read("2024-03-02T06:00:00Z");
  EXPECT_EQ(later.published, at("2024-03-02T06:00:00Z"));
  const Ingested earlier = read("2024-03-01T06:00:00Z");
  EXPECT_EQ(earlier.published, std::nullopt);
  ASSERT_EQ(earlier.warnings.size(), later.warnings.size() + 1);
  EXPECT_NE(earlier.warnings.back().find("before its last observation"), std::string::npos);
}

TEST(Publication, IsNeverLaterThanTheFileCameIn) {
  const auto early = std::optional(at("2024-03-02T06:00:00Z"));
  const auto late = std::optional(at("2024-03-03T06:00:00Z"));
  EXPECT_EQ(published_by(early, late), early);
  EXPECT_EQ(published_by(late, early), early);
  EXPECT_EQ(published_by(late, std::nullopt), late);
  EXPECT_EQ(published_by(std::nullopt, late), std::nullopt);
}

/// The real files, each by its own words.
TEST(Publication, OfRealFiles) {
  SLACKWATER_NEEDS_SHARED(shared);
  const TemporaryFolder folder;
  for (const auto& [file, expected] : std::map<std::string, std::optional<UtcTime>>{
           {"insitu/NO_TS_MO_FINO1_202209.nc", at("2022-10-07T05:39:40Z")},
           {"insitu/IR_201511_TS_MO_61198.nc", at("2015-11-29T03:19:00Z")},
           {"dutch_coast_2017-10/CMEMS_DutchCoast_2017-10-28.nc", at("2020-04-06T10:30:00Z")},
           {"odd_formats/paria/oce/Sea_Med_slice_20170427_Paria.nc", at("2017-05-11T00:00:00Z")},
           {"otranto_2021-10/wind/20211014.nc", std::nullopt}}) {
    SCOPED_TRACE(file);
    EXPECT_EQ(decode_file(shared / "data" / file, products(), {}, folder.path()).published,
              expected);
  }
}

}  // namespace
}  // namespace slackwater::ingest::tests::publication_test
