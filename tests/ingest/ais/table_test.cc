#include "ingest/ais/table.h"

#include <gtest/gtest.h>

namespace slackwater::tests::table_test {
namespace {

using namespace ingest;

const std::string header =
    R"("MMSI","BaseDateTime","LAT","LON","SOG","COG","Heading","VesselName",)"
    R"("IMO","CallSign","VesselType","Status","Length","Width","Draft","Cargo","TransceiverClass")";

TEST(AisTable, TheHeaderIsKnownByItsNames) {
  EXPECT_TRUE(AisTable::is_header(header));
  EXPECT_TRUE(AisTable::is_header("LON,LAT,MMSI,BaseDateTime"));
  EXPECT_FALSE(AisTable::is_header("MMSI,LAT,LON"));
  EXPECT_FALSE(AisTable::is_header("!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C"));
  EXPECT_FALSE(AisTable::is_header(""));
}

TEST(AisTable, ARowIsAReportInSiUnits) {
  const AisTable reader(header);
  const auto report = reader.report_of(
      R"(338125067,"2022-01-03T00:00:09",37.86818,-122.43749,18.2,123.4,511,"RUM ""LASS"", II",)"
      R"("IMO9134270","WDA1",37,NA,13,4,NA,NA,"B")");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->mmsi, 338125067U);
  EXPECT_EQ(report->time, parse_utc("2022-01-03T00:00:09Z"));
  EXPECT_EQ(report->speaker, AisClass::b);
  EXPECT_DOUBLE_EQ(report->position->latitude_deg(), 37.86818);
  EXPECT_DOUBLE_EQ(report->position->longitude_deg(), -122.43749);
  EXPECT_DOUBLE_EQ(*report->speed_over_ground_m_s, 18.2 * 1852 / 3600);
  EXPECT_NEAR(report->course_over_ground->degrees(), 123.4, 1e-12);
  EXPECT_FALSE(report->heading);
  EXPECT_EQ(report->identity.name, "RUM \"LASS\", II");
  EXPECT_EQ(report->identity.imo, 9134270U);
  EXPECT_EQ(report->identity.ship_type, 37);
  EXPECT_EQ(report->identity.length_m, 13);
  EXPECT_EQ(report->identity.beam_m, 4);
  EXPECT_FALSE(report->utc_second);
}

TEST(AisTable, AbsentAndImpossibleValuesAreAbsent) {
  const AisTable reader("MMSI,BaseDateTime,LAT,LON,SOG,COG,Heading,Length");
  const auto report = reader.report_of("338125067,2022-01-03 00:00:09,91,181,102.3,360,511,NA");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->time, parse_utc("2022-01-03T00:00:09Z"));
  EXPECT_FALSE(report->position || report->speed_over_ground_m_s || report->course_over_ground ||
               report->heading);
  EXPECT_FALSE(report->identity.length_m);
  EXPECT_EQ(report->speaker, AisClass::a);
  const auto odd = reader.report_of("338125067,2022-01-03T00:00:09,nan,1,-0.1,-5,inf,-3");
  ASSERT_TRUE(odd);
  EXPECT_FALSE(odd->position || odd->speed_over_ground_m_s || odd->course_over_ground ||
               odd->heading);
  EXPECT_FALSE(odd->identity.length_m);
}

TEST(AisTable, RowsThatAreNoneAreRefused) {
  const AisTable reader("MMSI,BaseDateTime,LAT,LON");
  for (const char* row :
       {"", "338125067", "x,2022-01-03T00:00:09,1,2", "0,2022-01-03T00:00:09,1,2",
        "1000000000,2022-01-03T00:00:09,1,2", "338125067,yesterday,1,2",
        "338125067,2022-02-30T00:00:09,1,2", "338125067,2022-01-03T00:00:09,1,2,3",
        "338125067,\"2022-01-03T00:00:09,1,2"}) {
    EXPECT_FALSE(reader.report_of(row)) << row;
  }
}

}  // namespace
}  // namespace slackwater::tests::table_test
