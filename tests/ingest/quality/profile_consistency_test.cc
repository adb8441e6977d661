#include "ingest/quality/profile_consistency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ingest/quality/gross_range.h"

namespace slackwater::ingest::profile_consistency_test {
namespace {

using enum SampleStatus;
constexpr std::size_t bins = 12;
constexpr std::size_t ensembles = 10;

struct Profiles {
  std::vector<float> east = std::vector<float>(bins * ensembles, 0.3F);
  std::vector<float> north = std::vector<float>(bins * ensembles, -0.1F);
  std::vector<SampleStatus> east_status = std::vector<SampleStatus>(bins * ensembles, not_checked);
  std::vector<SampleStatus> north_status = east_status;

  EnsembleReport test() {
    const std::vector<SampleStatus> before = east_status;
    test_speed_range(8.0, east, north, east_status, north_status);
    return test_ensembles(bins, east, north, before, east_status, north_status);
  }
  [[nodiscard]] std::ptrdiff_t rejected(std::size_t ensemble) const {
    const auto first = east_status.begin() + static_cast<std::ptrdiff_t>(ensemble * bins);
    return std::count(first, first + bins, suspect);
  }
};

TEST(EnsembleTest, AQuarterOfFailedBinsRejectsTheWholeEnsemble) {
  Profiles profiles;
  for (std::size_t k = 0; k < 3; ++k) profiles.east[4 * bins + 3 * k] = 30.0F;
  EXPECT_EQ(profiles.test().broken, 1U);
  EXPECT_EQ(profiles.rejected(4), static_cast<std::ptrdiff_t>(bins));
  EXPECT_EQ(profiles.north_status[4 * bins], suspect);
  EXPECT_EQ(profiles.rejected(3) + profiles.rejected(5), 0);
}

TEST(EnsembleTest, FewerFailedBinsFailAlone) {
  Profiles profiles;
  profiles.east[4 * bins] = profiles.east[4 * bins + 5] = 30.0F;
  EXPECT_EQ(profiles.test().broken, 0U);
  EXPECT_EQ(profiles.rejected(4), 2);
}

TEST(EnsembleTest, BinsThatNeverHadAValueDoNotCount) {
  Profiles profiles;
  for (std::size_t k = 0; k < 6; ++k) {
    profiles.east[bins + k] = std::nanf("");
    profiles.east_status[bins + k] = missing;
  }
  EXPECT_EQ(profiles.test().broken, 0U);
  EXPECT_EQ(profiles.rejected(1), 0);
}

TEST(EnsembleTest, APaddedRecordIsNotACalm) {
  Profiles profiles;
  for (std::size_t k = 0; k < bins; ++k)
    profiles.east[7 * bins + k] = profiles.north[7 * bins + k] = 0.0F;
  for (std::size_t k = 8; k < bins; ++k)
    profiles.east[2 * bins + k] = profiles.north[2 * bins + k] = 0.0F;
  profiles.east[5 * bins] = profiles.north[5 * bins] = 0.0F;  // one still bin may be
  const EnsembleReport report = profiles.test();
  EXPECT_EQ(report.zeros, 1U);
  EXPECT_EQ(report.zero_bins, 4U);
  EXPECT_EQ(profiles.rejected(7), static_cast<std::ptrdiff_t>(bins));
  EXPECT_EQ(profiles.rejected(2), 4);
  EXPECT_EQ(profiles.rejected(5), 0);
}

TEST(GrossRange, MarksOnlyWhatHasAValueAndLiesOutside) {
  const std::vector<float> values{0.0F, 36.0F, -0.1F, 35.0F, 99.0F};
  std::vector<SampleStatus> status{ok, ok, not_checked, ok, missing};
  EXPECT_EQ(test_gross_range({0, 35}, values, status), 2U);
  EXPECT_EQ(status, (std::vector<SampleStatus>{ok, suspect, suspect, ok, missing}));
}

TEST(GrossRange, BoundsTheSpeedNotTheComponents) {
  const std::vector<float> east{5.9F, 5.9F, 0.0F};
  const std::vector<float> north{0.0F, 5.9F, 8.1F};
  std::vector<SampleStatus> east_status(3, not_checked);
  std::vector<SampleStatus> north_status(3, not_checked);
  EXPECT_EQ(test_speed_range(8.0, east, north, east_status, north_status), 2U);
  EXPECT_EQ(east_status[0], not_checked);
  EXPECT_EQ(east_status[1], suspect);
  EXPECT_EQ(north_status[2], suspect);
}

}  // namespace
}  // namespace slackwater::ingest::profile_consistency_test
