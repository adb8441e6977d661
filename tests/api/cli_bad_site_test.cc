// Bad site files and bad places: refused with the line and the key, or with the reason why there is
// no water.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/contains.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_bad_site_test {
namespace {

using namespace std::chrono;

constexpr UtcDay day = sys_days{2025y / March / 6};

class BadSite : public ::testing::Test {
 protected:
  BadSite() { store_.ingest_days(day, 2); }

  ProgramResult forecast(const std::filesystem::path& site) {
    return store_.run({"forecast", "--site", site.string(), "--at", "2025-03-08T05:00:00Z"});
  }

  void expect_refused(const std::string& yaml, const std::vector<std::string>& words,
                      int exit_code = 3) {
    const auto file = store_.file("spoilt.yaml");
    write_bytes(file, yaml);
    const auto digests = store_.digests();
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"forecast", "--site", file.string(), "--at",
                                   "2025-03-08T05:00:00Z"},
          {"site", "check", file.string()}}) {
      const ProgramResult result = store_.run(command);
      EXPECT_EQ(result.exit_code, exit_code) << command[0] << ": " << result.out << result.err;
      EXPECT_TRUE(contains(result.err, "spoilt.yaml")) << result.err;
      for (const std::string& word : words)
        EXPECT_TRUE(contains(result.err, word)) << word << " in: " << result.err;
    }
    EXPECT_EQ(store_.digests(), digests);
  }

  StoreForTests store_;
};

TEST_F(BadSite, UnknownKeyIsRefusedWithItsLineAndTheNearestKnownKey) {
  expect_refused("id: a\nlatitude_deg: 54\nlongitude_deg: 6.5\nwater_dept_m: 30\n",
                 {"water_dept_m", "water_depth_m", "4"});
}

TEST_F(BadSite, AnAbsentSiteListsTheKnownOnes) {
  const ProgramResult result = forecast("nowhere");
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_TRUE(contains(result.err, "nowhere") && contains(result.err, "saint_brieuc"))
      << result.err;
  const ProgramResult file = forecast(store_.file("absent.yaml"));
  EXPECT_EQ(file.exit_code, 4);
  EXPECT_TRUE(contains(file.err, "absent.yaml")) << file.err;
}

TEST_F(BadSite, OnLandIsToldAsLand) {
  const auto digests = store_.digests();
  const ProgramResult result = forecast(write_site(store_.file("dry.yaml"), "", 54.0, 6.7));
  EXPECT_EQ(result.exit_code, 4) << result.out;
  EXPECT_TRUE(contains(result.err, "land") && contains(result.err, "test_site")) << result.err;
  EXPECT_EQ(store_.digests(), digests);
}

TEST_F(BadSite, OutsideTheGridIsToldWithWhatTheGridCovers) {
  const auto digests = store_.digests();
  // Half a cell (0.05 degrees) beyond the outermost centre still counts as inside.
  EXPECT_EQ(forecast(write_site(store_.file("edge.yaml"), "", 54.24, 6.5)).exit_code, 0);
  const auto with_the_edge = store_.digests();
  const ProgramResult near = forecast(write_site(store_.file("near.yaml"), "", 54.4, 6.5));
  EXPECT_EQ(near.exit_code, 4) << near.out;
  EXPECT_TRUE(contains(near.err, "outside") && contains(near.err, "54.250")) << near.err;
  const ProgramResult far = forecast(write_site(store_.file("far.yaml"), "", -20, 100));
  EXPECT_EQ(far.exit_code, 4) << far.out;
  EXPECT_TRUE(contains(far.err, "ingest")) << "what to do: " << far.err;
  EXPECT_EQ(store_.digests(), with_the_edge);
}

}  // namespace
}  // namespace slackwater::tests::cli_bad_site_test
