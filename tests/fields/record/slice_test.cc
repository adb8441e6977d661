#include "fields/record/slice.h"

#include <gtest/gtest.h>

#include "fields/record/choose.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::slice_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using namespace tests;

const UtcTime midnight = parse_utc("2024-06-11T00:00:00Z");
const UtcTime next_midnight = midnight + std::chrono::hours(24);

TEST(Slice, KeepsTheCellsThatLieWhollyInside) {
  const Origin origin = analysis_of("model");
  const VectorColumn hourly =
      vector_piece(origin, means(midnight, next_midnight), {5.0, 10.0},
                   [](UtcTime time, double depth) {
                     return Horizontal(hours_between(midnight, time), depth);
                   })
          .column;
  const VectorColumn part = slice(hourly, midnight + minutes(90), midnight + hours(5));
  ASSERT_EQ(part.times(), 3u) << "02-03, 03-04 and 04-05; 01-02 is cut and left out";
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_EQ(part.value[part.offset(t, 1)], Horizontal(2.5 + double(t), 10.0));
    EXPECT_EQ(part.source[t], DataStatus::analysis);
  }
  EXPECT_EQ(part.levels_m, hourly.levels_m);
  EXPECT_EQ(part.vertical, hourly.vertical);
  EXPECT_EQ(part.point, hourly.point);
}

TEST(Slice, NeighbouringSpansShareAnInstantAndDivideMeans) {
  const Origin origin = analysis_of("model");
  const UtcTime noon = midnight + hours(12);
  const VectorColumn instant =
      vector_piece(origin, instants(midnight, next_midnight), {5.0}, steady({1, 0})).column;
  EXPECT_EQ(slice(instant, midnight, noon).times() + slice(instant, noon, next_midnight).times(),
            instant.times() + 1);
  const VectorColumn mean =
      vector_piece(origin, means(midnight, next_midnight), {5.0}, steady({1, 0})).column;
  EXPECT_EQ(slice(mean, midnight, noon).times() + slice(mean, noon, next_midnight).times(),
            mean.times());
}

}  // namespace
}  // namespace slackwater::slice_test
