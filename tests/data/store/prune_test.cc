#include "data/store/prune.h"

#include <gtest/gtest.h>

#include "data/store/store.h"
#include "tests/data/store/sample_rows.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::store::tests::prune_test {
namespace {

using slackwater::tests::TemporaryFolder;

const UtcTime after_everything = parse_utc("2100-01-01T00:00:00Z");

class Prune : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::int64_t> granules_of(int number) {
    std::vector<std::int64_t> ids;
    for (const GranuleRow& granule : store_.find_granules({})) {
      if (granule.source_sha256 == samples::source(number).sha256) ids.push_back(granule.id);
    }
    return ids;
  }
  TemporaryFolder temporary_;
  Store store_ = Store::open(temporary_ / "store", OpenMode::create_or_write);
};

TEST_F(Prune, RemovesSourcesIngestedBeforeAnInstantWithTheirFiles) {
  for (int number = 1; number <= 3; ++number) samples::ingest(store_, number);
  const PruneReport report = store_.prune({samples::source(2).ingested_at, false, false});
  EXPECT_EQ(report.sources, 1U);
  EXPECT_EQ(report.granules, 2U);
  EXPECT_EQ(report.content_files, 2U);
  EXPECT_EQ(report.bytes, samples::content_of(1, 0).size() + samples::content_of(1, 1).size());
  EXPECT_EQ(store_.list_sources().size(), 2U);
  EXPECT_TRUE(store_.check(true).findings.empty());
}

TEST_F(Prune, KeepsForecastsAndWhatTheyWereMadeFromUnlessToldOtherwise) {
  samples::ingest(store_, 1);
  samples::ingest(store_, 2);
  samples::issue(store_, 1, granules_of(1));
  EXPECT_EQ(store_.prune({after_everything, false, true}).sources, 1U);
  EXPECT_EQ(store_.list_forecasts().size(), 1U);
  EXPECT_EQ(granules_of(1).size(), 2U);
  const PruneReport report = store_.prune({after_everything, true, false});
  EXPECT_EQ(report.forecasts, 1U);
  EXPECT_EQ(report.sources, 1U);
  EXPECT_EQ(report.content_files, 3U);
  EXPECT_TRUE(store_.check(true).findings.empty());
}

TEST_F(Prune, WithoutAnInstantRemovesNoRow) {
  samples::ingest(store_, 1);
  samples::issue(store_, 1);
  const PruneReport report = store_.prune({std::nullopt, true, true});
  EXPECT_EQ(report.sources + report.forecasts + report.content_files, 0U);
}

TEST_F(Prune, KeepsStaticFieldsSuchAsBathymetry) {
  auto bathymetry = samples::granules(store_, 1);
  for (NewGranule& granule : bathymetry) {
    granule.row.first_time = granule.row.last_time = std::nullopt;
  }
  store_.commit_ingest(samples::source(1), bathymetry);
  EXPECT_EQ(store_.prune({after_everything, true, true}).sources, 0U);
}

TEST_F(Prune, KeepsContentThatAnotherSourceStillNames) {
  samples::ingest(store_, 1);
  SourceFile later = samples::source(1);
  later.cut_key = "another cut";
  later.ingested_at = samples::source(50).ingested_at;
  store_.commit_ingest(later, samples::granules(store_, 1));
  const PruneReport report = store_.prune({samples::source(40).ingested_at, false, true});
  EXPECT_EQ(report.sources, 1U);
  EXPECT_EQ(report.content_files, 0U);
  EXPECT_TRUE(store_.check(true).findings.empty());
}

TEST_F(Prune, ADryRunCountsWhatTheRealOneRemovesAndRemovesNothing) {
  for (int number = 1; number <= 3; ++number) samples::ingest(store_, number);
  samples::issue(store_, 1, granules_of(1));
  for (const bool forecasts : {false, true}) {
    const PruneOptions dry{after_everything, forecasts, true, true};
    const PruneReport first = store_.prune(dry);
    EXPECT_GT(first.sources, 0U);
    EXPECT_EQ(store_.list_sources().size(), 3U) << "nothing has gone";
    EXPECT_EQ(store_.list_forecasts().size(), 1U);
    EXPECT_TRUE(store_.check(true).findings.empty());
    if (!forecasts) continue;
    const PruneReport real = store_.prune({after_everything, forecasts, true});
    EXPECT_EQ(real.sources, first.sources);
    EXPECT_EQ(real.granules, first.granules);
    EXPECT_EQ(real.forecasts, first.forecasts);
    EXPECT_EQ(real.content_files, first.content_files);
    EXPECT_EQ(real.bytes, first.bytes);
  }
}

}  // namespace
}  // namespace slackwater::store::tests::prune_test
