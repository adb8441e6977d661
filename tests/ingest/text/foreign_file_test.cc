#include "ingest/text/foreign_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "fields/base/error.h"
#include "ingest/ais/read_ais.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/history/read_history.h"
#include "ingest/ingest.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::foreign_file_test {
namespace {

using namespace ingest;

class ForeignFiles : public testing::Test {
 protected:
  std::filesystem::path write(std::string_view bytes) {
    std::ofstream(folder_ / "a", std::ios::binary) << bytes;
    return folder_ / "a";
  }
  template <typename Read>
  static std::string refusal_of(const Read& read) {
    try {
      read();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      return error.message();
    }
    return "nothing was refused";
  }
  std::string ingest(const std::filesystem::path& file) {
    return refusal_of([&] {
      static_cast<void>(decode_file(file, ProductCatalogue{}, IngestOptions{}, folder_.path()));
    });
  }
  std::string history(const std::filesystem::path& file) {
    const Vocabulary words =
        Vocabulary::load(source_folder() / "data" / "products" / "variables.yaml");
    return refusal_of(
        [&] { static_cast<void>(read_history(file, {"wind_speed"}, HistoryOptions{}, words)); });
  }
  static std::string ais(const std::filesystem::path& file) {
    return refusal_of([&] { (void)read_ais(file, [](const AisReport&) {}); });
  }
  TemporaryFolder folder_;
};

TEST_F(ForeignFiles, APageOfAServerIsNoDataWhoeverReadsIt) {
  const auto file = write("\n<!DOCTYPE HTML><html><title>401 Unauthorized</title></html>\n");
  for (const std::string& refusal : {ingest(file), history(file), ais(file)}) {
    EXPECT_TRUE(contains(refusal, "found a web page")) << refusal;
    EXPECT_TRUE(contains(refusal, "wants a login"));
  }
}

TEST_F(ForeignFiles, PackedFilesAreNamedWithWhatUnpacksThem) {
  const auto file = write(std::string_view("PK\x03\x04\0\0\0\0", 8));
  for (const std::string& refusal : {ingest(file), history(file), ais(file)}) {
    EXPECT_TRUE(contains(refusal, "found a zip archive")) << refusal;
    EXPECT_TRUE(contains(refusal, "`unzip`"));
  }
}

TEST_F(ForeignFiles, RecordingsAndMessagesOfServersAreNamed) {
  EXPECT_TRUE(contains(history(write("\x89MCAP0\r\n")), "found an MCAP recording"));
  EXPECT_TRUE(contains(history(write("SQLite format 3")), "found an SQLite database"));
  EXPECT_TRUE(contains(ingest(write("Error {\n    code = 404;")), "an OPeNDAP error"));
  EXPECT_TRUE(contains(ingest(write("{\"detail\": \"token expired\"}")), "found JSON"));
}

TEST_F(ForeignFiles, ATableGivenToIngestIsSentToWhoReadsIt) {
  EXPECT_TRUE(contains(ingest(write("time,wind_speed\n2025-01-01T00:00Z,3\n")),
                       "found text, expected NetCDF or GRIB; a table of one place is read by "
                       "`slackwater workability`"));
  EXPECT_TRUE(
      contains(ingest(write("1741392000 !AIVDM,1,1,,A,139>Ji@01@O,0*5F\n")), "found a log of AIS"));
}

TEST_F(ForeignFiles, DataAreNotForeign) {
  EXPECT_FALSE(foreign_file(write("time,wind_speed\n")));
  EXPECT_FALSE(foreign_file(write("CDF\x01")));
  EXPECT_FALSE(foreign_file(write("GRIB")));
  EXPECT_FALSE(foreign_file(write("")));
  EXPECT_FALSE(foreign_file(folder_ / "none"));
}

}  // namespace
}  // namespace slackwater::tests::foreign_file_test
