#include "fields/service/forecast_origin.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"

namespace slackwater::forecast_origin_test {
namespace {

TEST(ForecastOrigin, NamesAreReadAsTheyAreWritten) {
  for (const ForecastOrigin origin : {ForecastOrigin::forecast, ForecastOrigin::hindcast})
    EXPECT_EQ(forecast_origin_from(name_of(origin)), origin);
  EXPECT_EQ(name_of(ForecastOrigin::hindcast), "hindcast");
}

TEST(ForecastOrigin, AnotherNameIsRefusedWithWhatWasExpected) {
  try {
    (void)forecast_origin_from("nowcast");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_EQ(error.message(), "found forecast origin 'nowcast', expected forecast or hindcast");
  }
}

}  // namespace
}  // namespace slackwater::forecast_origin_test
