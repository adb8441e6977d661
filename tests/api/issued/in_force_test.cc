#include "api/issued/in_force.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fields/base/error.h"
#include "tests/api/issued/issued_store.h"

namespace slackwater::api::in_force_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using tests::IssuedStore;

store::ForecastRow row_of(ForecastOrigin origin, int day, int hour, std::int64_t id) {
  store::ForecastRow row;
  row.site_id = "lone";
  row.origin = origin;
  row.day = parse_day("2025-03-09") + days(day);
  row.issued = UtcTime(row.day) + days(1) + hours(hour);
  row.id = id;
  return row;
}

TEST(InForce, AForecastBeforeHindsightThenDayThenIssueThenNumber) {
  const std::vector<store::ForecastRow> in_order{
      row_of(ForecastOrigin::forecast, 2, 6, 4), row_of(ForecastOrigin::forecast, 2, 6, 3),
      row_of(ForecastOrigin::forecast, 2, 5, 9), row_of(ForecastOrigin::forecast, 1, 9, 8),
      row_of(ForecastOrigin::hindcast, 5, 0, 7), row_of(ForecastOrigin::hindcast, 4, 0, 6)};
  for (std::size_t a = 0; a < in_order.size(); ++a) {
    for (std::size_t b = 0; b < in_order.size(); ++b)
      EXPECT_EQ(has_more_force(in_order[a], in_order[b]), a < b) << a << " against " << b;
  }
}

class InForceOfAStore : public ::testing::Test {
 protected:
  InForceOfAStore() {
    issued_.issue(IssuedStore::small("lone", 0, 0.1));
    later_ = issued_.issue(IssuedStore::small("lone", 1, 0.2));
    hindcast_ = issued_.issue(IssuedStore::small("lone", 2, 0.3), ForecastOrigin::hindcast);
    issued_.issue(IssuedStore::small("other", 1, 0.4));
  }
  store::Store open() const {
    return store::Store::open(issued_.path(), store::OpenMode::read_only);
  }
  IssuedStore issued_;
  std::int64_t later_ = 0;
  std::int64_t hindcast_ = 0;
};

TEST_F(InForceOfAStore, EachSitesOwnComesFirst) {
  store::Store store = open();
  EXPECT_EQ(forecast_in_force(store, {"lone", {}, {}}).row.id, later_);
  const auto rows = by_force(store, {});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].id, later_);
  EXPECT_EQ(rows[2].id, hindcast_) << "hindsight last";
  EXPECT_EQ(rows[3].site_id, "other");
}

TEST_F(InForceOfAStore, ADayOrATimeThatOnlyHindsightCoversIsAnsweredByIt) {
  store::Store store = open();
  const UtcDay day = parse_day("2025-03-09");
  store::ForecastRow newest = by_force(store, {"lone", {}, {}}).back();
  EXPECT_EQ(forecast_in_force(store, {"lone", newest.day, {}}).row.id, hindcast_);
  EXPECT_EQ(forecast_in_force(store, {"lone", {}, newest.valid_to}).row.id, hindcast_);
  EXPECT_LT(day, newest.day);
}

TEST_F(InForceOfAStore, WhatIsNotThereSaysWhatIs) {
  store::Store store = open();
  const auto refusal = [&](const WantedForecast& wanted) -> std::string {
    try {
      static_cast<void>(forecast_in_force(store, wanted));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::not_found);
      return error.what();
    }
    return {};
  };
  EXPECT_NE(refusal({"nowhere", {}, {}}).find("no issued forecast for site nowhere"),
            std::string::npos);
  EXPECT_NE(refusal({"lone", parse_day("2001-01-01"), {}}).find("of day 2001-01-01"),
            std::string::npos);
  const std::string late = refusal({"lone", {}, parse_utc("2031-01-01T00:00:00Z")});
  EXPECT_NE(late.find("covers 2031-01-01T00:00:00Z; the newest one is valid from 2025-03-"),
            std::string::npos)
      << late;
}

TEST_F(InForceOfAStore, OfFieldsThatReachAPlaceTheNearestSitesAnswers) {
  store::Store store = open();
  Snapshot shifted = IssuedStore::small("near", 1, 0.5);
  const GeoPoint& at = shifted.columns.front().point;
  const double east = at.longitude_deg() + 0.02;
  const double north = at.latitude_deg();
  shifted.columns.front().point = GeoPoint::from_degrees(north, east);
  const auto field = [](const Snapshot& s) {
    return std::make_shared<const Field>(std::make_shared<const Snapshot>(s));
  };
  const std::vector<std::shared_ptr<const Field>> fields{field(IssuedStore::small("lone", 1, 0.2)),
                                                         nullptr, field(shifted)};
  EXPECT_EQ(nearest_reaching(fields, east + 0.001, north), 2U);
  EXPECT_EQ(nearest_reaching(fields, east - 0.019, north), 0U);
  EXPECT_EQ(nearest_reaching(fields, east + 5, north), std::nullopt);
}

}  // namespace
}  // namespace slackwater::api::in_force_test
