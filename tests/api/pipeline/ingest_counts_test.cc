#include "api/pipeline/ingest/ingest_counts.h"

#include <gtest/gtest.h>

namespace slackwater::api::ingest_counts_test {
namespace {

using ingest::DecodedGranule;

const UtcTime midnight = parse_utc("2025-03-10T00:00:00Z");

DecodedGranule granule(DataStatus status, int first_hour, int hours,
                       std::optional<int> member = {}) {
  DecodedGranule decoded;
  decoded.granule.status = status;
  decoded.granule.ensemble_member = member;
  for (int h = 0; h < hours; ++h)
    decoded.granule.grid.time.push_back(
        TimeCell::instant(midnight + std::chrono::hours(first_hour + h)));
  return decoded;
}

std::string told(const std::vector<DecodedGranule>& granules) {
  return text_of(counts_of(granules), "analysis");
}

TEST(IngestCounts, AnalysedAndForecastTimesAreToldApart) {
  const std::vector file{granule(DataStatus::analysis, 0, 49),
                         granule(DataStatus::forecast, 49, 71)};
  const IngestCounts counts = counts_of(file);
  EXPECT_EQ(counts.times, 120U);
  EXPECT_EQ(counts.by_status.at("analysis"), 49U);
  EXPECT_EQ(counts.by_status.at("forecast"), 71U);
  EXPECT_EQ(told(file), "analysis, 49 times, and forecast, 71 times");
}

TEST(IngestCounts, MembersAreNoTimes) {
  std::vector<DecodedGranule> file;
  for (int member = 0; member < 11; ++member)
    file.push_back(granule(DataStatus::forecast, 0, 73, member));
  EXPECT_EQ(counts_of(file).times, 73U);
  EXPECT_EQ(counts_of(file).members, 11U);
  EXPECT_EQ(told(file), "forecast, 73 times of 11 members");
}

TEST(IngestCounts, QuantitiesOnGridsOfTheirOwnShareTheirTimes) {
  EXPECT_EQ(told({granule(DataStatus::analysis, 0, 24), granule(DataStatus::analysis, 0, 24),
                  granule(DataStatus::analysis, 12, 24)}),
            "analysis, 36 times");
}

TEST(IngestCounts, AControlAloneIsNoEnsembleAndABathymetryHasNoTimes) {
  EXPECT_EQ(told({granule(DataStatus::forecast, 0, 5, 0)}), "forecast, 5 times");
  EXPECT_EQ(told({granule(DataStatus::analysis, 0, 0)}), "analysis, 0 times");
}

}  // namespace
}  // namespace slackwater::api::ingest_counts_test
