// `slackwater ais`: the vessels of a log, for people and for programs.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::cli_ais_test {
namespace {

using nlohmann::json;

// Published messages (gpsd's AIVDM.txt and test/sample.aivdm) under tag blocks of ours.
const std::string log_text =
    "\\c:1635731889*54\\!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C\n"
    "\\c:1635731889*54\\!AIVDM,2,1,1,A,55?MbV02;H;s<HtKR20EHE:0@T4@"
    "Dn2222222216L961O5Gf0NSQEp6ClRp8,0*1C\n"
    "!AIVDM,2,2,1,A,88888888880,2*25\n"
    "\\c:1635731889*54\\!AIVDM,1,1,,B,C5N3SRgPEnJGEBT>NhWAwwo862PaLELTBJ:V00000000S0D:R220,0*0B\n"
    "!AIVDM,1,1,,B,177K,0*00\n";

class AisCommand : public testing::Test {
 protected:
  void SetUp() override {
    log_ = (folder_ / "log.nmea").string();
    std::ofstream(log_) << log_text;
  }
  TemporaryFolder folder_;
  std::string log_;
};

TEST_F(AisCommand, ListsTheVesselsAsJson) {
  const ProgramResult result = run_program({"ais", log_, "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json file = json::parse(result.out).at("files").at(0);
  EXPECT_EQ(file.at("file"), log_);
  EXPECT_EQ(file.at("messages"), 3);
  EXPECT_EQ(file.at("lines"), 5);
  EXPECT_EQ(file.at("reports_by_type"), (json{{"1", 1}, {"5", 1}, {"19", 1}}));
  EXPECT_EQ(file.at("warnings").size(), 1U);
  const json& vessels = file.at("vessels");
  ASSERT_EQ(vessels.size(), 3U);  // by MMSI
  EXPECT_EQ(vessels[0].at("name"), "EVER DIADEM");
  EXPECT_EQ(vessels[0].at("length_m"), 295);
  EXPECT_TRUE(vessels[0].at("first").is_null() && vessels[0].at("bbox").is_null());
  EXPECT_EQ(vessels[1].at("mmsi"), 367059850);
  EXPECT_EQ(vessels[1].at("class"), "B");
  EXPECT_EQ(vessels[1].at("first"), "2021-11-01T01:57:46Z") << "its second is 46, heard at :09";
  EXPECT_NEAR(vessels[1].at("mean_speed_m_s").get<double>(), 8.7 * 1852 / 3600, 1e-9);
  EXPECT_NEAR(vessels[1].at("bbox").at(0).get<double>(), -88.810392, 2e-6);
  EXPECT_NEAR(vessels[1].at("bbox").at(3).get<double>(), 29.543695, 2e-6);
  EXPECT_TRUE(vessels[2].at("name").is_null());
}

TEST_F(AisCommand, ListsTheVesselsAsALineEachWithTroubleApart) {
  const ProgramResult result = run_program({"ais", log_});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("367059850  CAPT.J.RIMES"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("3 vessels in 3 messages of 5 lines"), std::string::npos) << result.out;
  EXPECT_NE(result.err.find(
                "1 lines are malformed (the first is line 5: a sentence with a wrong checksum)"),
            std::string::npos)
      << result.err;
}

/// Logs of other receivers, types that are rarely seen, and tables of authorities.
TEST_F(AisCommand, LogsAndTablesOfOthersAreReadWithTheirTimes) {
  SLACKWATER_NEEDS_SHARED(shared);
  for (const char* name : {"ais_prefixes/iso_prefix.nmea", "ais_prefixes/epoch_prefix.nmea",
                           "ais_prefixes/ais_catcher.nmea", "silent_nothing/type27_whole.nmea",
                           "silent_nothing/type9_sar.nmea", "usual_downloads/csv2.csv",
                           "usual_downloads/csv2.csv.zst", "usual_downloads/dma.csv"}) {
    SCOPED_TRACE(name);
    const auto file = shared / "data" / "cases" / name;
    ASSERT_TRUE(std::filesystem::exists(file));
    const ProgramResult result = run_program({"ais", file.string(), "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json read = json::parse(result.out).at("files").at(0);
    EXPECT_GE(read.at("messages"), 5);
    ASSERT_EQ(read.at("vessels").size(), 1U);
    EXPECT_EQ(read.at("vessels")[0].at("positions"), read.at("messages"));
    EXPECT_FALSE(read.at("vessels")[0].at("first").is_null());
  }
}

TEST_F(AisCommand, ABoxKeepsWhoIsInside) {
  const ProgramResult result = run_program({"ais", log_, "--bbox", "-90,29,-88,30", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(json::parse(result.out).at("files").at(0).at("vessels").size(), 1U);
}

TEST_F(AisCommand, TroubleHasItsExitCode) {
  EXPECT_EQ(run_program({"ais", (folder_ / "absent").string()}).exit_code, 4);
  std::ofstream(folder_ / "text") << "no AIS here\n";
  EXPECT_EQ(run_program({"ais", (folder_ / "text").string()}).exit_code, 3);
  const ProgramResult missing = run_program({"ais", log_}, {{"PATH", folder_.path().string()}});
  EXPECT_EQ(missing.exit_code, 5);
  EXPECT_NE(missing.err.find("apt install gpsd-clients"), std::string::npos) << missing.err;
}

}  // namespace
}  // namespace slackwater::tests::cli_ais_test
