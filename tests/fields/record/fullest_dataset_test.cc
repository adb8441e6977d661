#include "fields/record/leading_dataset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "fields/record/choose.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::fullest_dataset_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using namespace tests;

const UtcTime midnight = parse_utc("2024-06-11T00:00:00Z");
const UtcTime next_midnight = midnight + std::chrono::hours(24);
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A day of a dataset.
struct DayOf {
  Origin origin;
  Duration step;
  std::vector<double> depth_m;
  double distance_m = 0;
  Duration length = hours(24);
};

std::optional<std::string> fullest(const std::vector<DayOf>& sets) {
  VectorRecord record;
  for (const DayOf& set : sets) {
    record.pieces.push_back(vector_piece(set.origin,
                                         means(midnight, midnight + set.length, set.step),
                                         set.depth_m, steady({1, 0}), set.distance_m));
  }
  const auto leading = leading_dataset(record, midnight, next_midnight);
  std::reverse(record.pieces.begin(), record.pieces.end());
  EXPECT_EQ(leading_dataset(record, midnight, next_midnight), leading)
      << "the order of pieces plays no part";
  return leading;
}

TEST(FullestDataset, OfProductsTheOneWithMostValuesLeads) {
  EXPECT_EQ(fullest({{analysis_of("a"), hours(3), {1, 2}}, {analysis_of("b"), hours(1), {1, 2}}}),
            "b");
  EXPECT_EQ(fullest({{analysis_of("a"), hours(1), {1}}, {analysis_of("b"), hours(2), {1, 2}}}), "b")
      << "as many values on more levels";
  EXPECT_EQ(fullest({{analysis_of("b"), hours(1), {1}}, {analysis_of("a"), hours(1), {1}}}), "a")
      << "then the name";
}

TEST(FullestDataset, CountsWhatIsInTheSpanAlone) {
  const Origin here = analysis_of("here");
  const Origin elsewhere = analysis_of("elsewhere");
  const VectorRecord record{
      {vector_piece(here, instants(midnight, midnight + hours(3)), {1}, steady({1, 0})),
       vector_piece(elsewhere, instants(midnight - hours(99), midnight - hours(1)), {1},
                    steady({1, 0}))}};
  EXPECT_EQ(leading_dataset(record, midnight, next_midnight), "here");
  EXPECT_EQ(leading_dataset(record, next_midnight, next_midnight + hours(9)), std::nullopt);
  EXPECT_EQ(leading_dataset({}, midnight, next_midnight), std::nullopt);
}

TEST(FullestDataset, MissingValuesDoNotCount) {
  const Origin holes = analysis_of("holes");
  const Origin sparse = analysis_of("sparse");
  const VectorRecord record{
      {vector_piece(holes, instants(midnight, midnight + hours(20)), {1}, steady({nan, nan})),
       vector_piece(sparse, instants(midnight, midnight + hours(1)), {1}, steady({1, 0}))}};
  EXPECT_EQ(leading_dataset(record, midnight, next_midnight), "sparse");
}

TEST(FullestDataset, AProductThatResolvesTheTideLeadsOverAnInstrument) {
  const DayOf buoy{station_of("buoy"), minutes(10), {1, 2, 3}, 100.0};
  EXPECT_EQ(fullest({{analysis_of("model"), hours(1), {1}}, buoy}), "model");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(3), {1}}, buoy}), "model");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(4), {1}}, buoy}), "buoy");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(24), {1}}, buoy}), "buoy");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(1), {1}, 0, hours(20)}, buoy}), "model");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(1), {1}, 0, hours(19)}, buoy}), "buoy")
      << "it does not span the day";
}

TEST(FullestDataset, WhereNeitherSpansTheDayTheMoreValuesLead) {
  const DayOf buoy{station_of("buoy"), hours(1), {1, 2}, 100.0, hours(10)};
  EXPECT_EQ(fullest({{analysis_of("model"), hours(24), {1, 2, 3}}, buoy}), "buoy");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(1), {1, 2}, 0, hours(10)}, buoy}), "model")
      << "of equals the product";
}

TEST(FullestDataset, OfInstrumentsThatSpanTheDayTheNearestLeads) {
  const DayOf far{station_of("far"), minutes(10), {1, 2, 3}, 3000.0};
  EXPECT_EQ(fullest({{station_of("near"), hours(1), {1}, 200.0}, far}), "near");
  EXPECT_EQ(fullest({{station_of("near"), hours(1), {1}, 200.0, hours(12)}, far}), "far")
      << "half a day is not the day";
}

TEST(FullestDataset, ModelOutputWrittenAsAPointSeriesIsAProduct) {
  Origin model = station_of("model");
  model.status = DataStatus::analysis;
  EXPECT_FALSE(is_in_situ(model));
  EXPECT_EQ(fullest({{model, hours(1), {1}}, {station_of("buoy"), minutes(10), {1}, 100.0}}),
            "model");
}

}  // namespace
}  // namespace slackwater::fullest_dataset_test
