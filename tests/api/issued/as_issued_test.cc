#include "api/issued/as_issued.h"

#include <gtest/gtest.h>

#include "api/issued/in_force.h"
#include "tests/api/issued/issued_store.h"

namespace slackwater::api::as_issued_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using std::chrono::minutes;

const UtcDay day_d = parse_day("2025-03-09");
const UtcTime morning = UtcTime(day_d) + hours(29);

store::ForecastRow row_of(std::int64_t id, UtcTime issued,
                          ForecastOrigin origin = ForecastOrigin::forecast, UtcDay day = day_d) {
  store::ForecastRow row;
  row.site_id = "lone";
  row.id = id;
  row.day = day;
  row.issued = issued;
  row.valid_from = UtcTime(day) + days(1);
  row.valid_to = row.valid_from + days(3);
  row.origin = origin;
  return row;
}

std::vector<std::int64_t> order_of(const std::vector<store::ForecastRow>& rows,
                                   std::vector<store::ForecastRow> of_site = {}) {
  of_site.insert(of_site.end(), rows.begin(), rows.end());
  std::vector<std::int64_t> ids;
  for (const store::ForecastRow& row : as_issued_first(rows, of_site)) ids.push_back(row.id);
  return ids;
}

using Ids = std::vector<std::int64_t>;

TEST(AsIssued, ARerunOfLaterDaysNeverReplacesTheForecast) {
  EXPECT_EQ(order_of({row_of(9, morning + days(3)), row_of(1, morning)}), (Ids{1, 9}));
  EXPECT_EQ(
      order_of({row_of(9, morning + days(400)), row_of(1, morning), row_of(4, morning + days(1))}),
      (Ids{1, 4, 9}))
      << "the next morning's job, where no newer day had come, is another morning's";
}

TEST(AsIssued, IssuedAgainTheSameMorningTheLastCounts) {
  EXPECT_EQ(order_of({row_of(1, morning), row_of(2, morning + hours(2)),
                      row_of(3, morning + same_morning), row_of(4, morning + hours(7))}),
            (Ids{3, 2, 1, 4}));
  EXPECT_EQ(order_of({row_of(1, morning), row_of(2, morning)}), (Ids{1, 2}))
      << "at one time, the first filed";
}

TEST(AsIssued, AHindcastIsTheLast) {
  const auto hindcast = ForecastOrigin::hindcast;
  EXPECT_EQ(order_of({row_of(1, UtcTime(day_d) + days(1), hindcast), row_of(7, morning),
                      row_of(8, UtcTime(day_d) + days(1), hindcast)}),
            (Ids{7, 8, 1}));
  EXPECT_EQ(order_of({row_of(1, morning, hindcast), row_of(2, morning, hindcast)}), (Ids{2, 1}))
      << "where there is nothing else, the newest";
}

TEST(AsIssued, AReplayFiledAfterLaterForecastsNeverReplacesTheForecast) {
  // Filed a day later with `--at`: two hours after the forecast, an hour before it, at its time.
  const store::ForecastRow next_day =
      row_of(5, morning + days(1), ForecastOrigin::forecast, day_d + days(1));
  EXPECT_EQ(order_of({row_of(1, morning), row_of(6, morning + hours(2)),
                      row_of(7, morning - hours(1)), row_of(8, morning)},
                     {next_day})
                .front(),
            1);
  EXPECT_EQ(order_of({row_of(6, morning)}, {next_day}), (Ids{6})) << "where there is nothing else";
}

TEST(OriginOfRun, APastDayAskedForByNameIsAHindcastOnceItWasIssued) {
  const std::vector<store::ForecastRow> of_site{row_of(1, morning)};
  const auto origin = [&](UtcDay day, UtcTime issued, bool named) {
    return origin_of_run(day, issued, named, false, of_site);
  };
  const auto forecast = ForecastOrigin::forecast;
  const auto hindcast = ForecastOrigin::hindcast;
  EXPECT_EQ(origin(day_d, morning + hours(2), true), forecast) << "the same morning, a file late";
  EXPECT_EQ(origin(day_d, morning + hours(7), true), hindcast);
  EXPECT_EQ(origin(day_d, morning + days(300), true), hindcast);
  EXPECT_EQ(origin(day_d, morning + days(1), false), forecast)
      << "the job's own choice: no newer day has come";
  EXPECT_EQ(origin(day_d - days(1), morning + hours(1), true), hindcast)
      << "never issued, and a later day was";
  EXPECT_EQ(origin(day_d - days(1), morning - days(1), true), forecast)
      << "at an issue time before that";
  EXPECT_EQ(origin_of_run(day_d, morning, true, false, {}), forecast);
  EXPECT_EQ(origin_of_run(day_d, morning, false, true, {}), hindcast) << "made in hindsight";
}

/// A forecast, the same morning's second issue, and a run of the day three days later, which covers
/// nothing any more.
class IssuedThrice : public ::testing::Test {
 protected:
  IssuedThrice() {
    for (const Duration later : {Duration(0), Duration(minutes(30)), Duration(days(3))}) {
      Snapshot made = tests::IssuedStore::small("lone", 0, 0.1 * static_cast<double>(++mark_));
      made.issued += later;
      ids_.push_back(issued_.issue(made));
      valid_from_ = made.time.front();
    }
  }
  std::int64_t in_force(const WantedForecast& wanted) {
    store::Store store = store::Store::open(issued_.path(), store::OpenMode::read_only);
    return forecast_in_force(store, wanted).row.id;
  }
  tests::IssuedStore issued_;
  int mark_ = 0;
  std::vector<std::int64_t> ids_;
  UtcTime valid_from_{};
};

TEST_F(IssuedThrice, AtATimeTheOneIssuedByThenIsInForce) {
  EXPECT_EQ(in_force({"lone", {}, valid_from_ + hours(5) + minutes(15)}), ids_[0]);
  EXPECT_EQ(in_force({"lone", {}, valid_from_ + hours(6)}), ids_[1]);
  EXPECT_EQ(in_force({"lone", {}, valid_from_ + hours(2)}), ids_[1])
      << "none was issued by then: as issued";
}

TEST_F(IssuedThrice, OfADayTheOneAsIssuedIsInForce) {
  EXPECT_EQ(in_force({"lone", parse_day("2025-03-09"), {}}), ids_[1]);
}

TEST_F(IssuedThrice, WhatWasIssuedAfterItsLastHourHasNoForceNow) {
  EXPECT_EQ(in_force({"lone", {}, {}}), ids_[1]);
}

}  // namespace
}  // namespace slackwater::api::as_issued_test
