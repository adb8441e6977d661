// A site's leading product and what happens where it is silent.
#include "calibration/day/leading_day.h"

#include <gtest/gtest.h>

#include "calibration/day/daily_forecast.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::leading_day_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);
const UtcTime five_o_clock = end_of_day + hours(29);

/// A tide of a metre a second, and what a product without it sees.
Horizontal tidal(UtcTime time, double) {
  return {0.1 + std::cos(2 * 3.14159265 * hours_between(end_of_day, time) / 12.4206), 0.2};
}

struct TwoProducts {
  KnownSeriesForTests sea;
  /// @param regional_until  days after the end of D until which the regional product is stored
  explicit TwoProducts(int regional_until, int from = -20) {
    Origin regional = analysis_of("regional", 1);
    regional.rank = {true, true, 0.03};
    Origin global = analysis_of("global", 2);
    global.rank = {false, false, 0.08};
    if (regional_until > from)
      sea.current(regional, instants(end_of_day + days(from), end_of_day + days(regional_until)),
                  {1, 5}, tidal);
    // More values, on more levels.
    sea.current(global, instants(end_of_day - days(20), end_of_day, std::chrono::minutes(30)),
                {1, 3, 5, 9}, steady({0.1, 0.2}));
    sea.wind(analysis_of("wind", 3), instants(end_of_day - days(20), end_of_day + days(4)),
             steady({6, 2}));
  }
  [[nodiscard]] SiteData site() { return site_of({sea.data}); }
};

ForecastOptions at_five() {
  ForecastOptions options;
  options.issued = five_o_clock;
  options.horizon = hours(24);
  return options;
}

TEST(LeadingDay, TheRegionalTidalProductLeadsWhateverHasMoreValues) {
  TwoProducts two(0);
  const auto leading = leading_day(two.site(), {five_o_clock});
  ASSERT_TRUE(leading);
  EXPECT_EQ(leading->dataset, "regional");
  EXPECT_EQ(leading->day, day);
  EXPECT_EQ(leading->stands_in_for, "");
}

TEST(LeadingDay, WhereItIsLateItsLastGoodDayServes) {
  TwoProducts two(-2);
  const auto leading = leading_day(two.site(), {five_o_clock});
  ASSERT_TRUE(leading);
  EXPECT_EQ(leading->dataset, "regional");
  EXPECT_EQ(leading->day, day - days(2));
}

TEST(LeadingDay, SaysHowLongItsCurrentsWereAveraged) {
  TwoProducts two(0);
  EXPECT_EQ(leading_day(two.site(), {five_o_clock})->averaging, Duration(0));
  KnownSeriesForTests sea;
  sea.current(analysis_of("daily"), means(end_of_day - days(6), end_of_day, days(1)), {1, 5},
              steady({0.1, 0.2}));
  EXPECT_EQ(leading_day(site_of({sea.data}), {five_o_clock})->averaging, Duration(days(1)));
}

TEST(LeadingDay, WhereItIsSilentLongerAnotherStandsInUntilItIsForgotten) {
  for (const int silent : {3, 5, 7, 9}) {
    TwoProducts two(-silent);
    const auto leading = leading_day(two.site(), {five_o_clock});
    ASSERT_TRUE(leading);
    EXPECT_EQ(leading->dataset, "global") << silent;
    EXPECT_EQ(leading->day, day);
    EXPECT_EQ(leading->stands_in_for, silent < 9 ? "regional" : "") << silent;
  }
}

TEST(LeadingDay, TheProductThatTheSiteNamesLeads) {
  TwoProducts two(0);
  SiteData site = two.site();
  site.site.current_product = "global";
  const auto leading = leading_day(site, {five_o_clock});
  ASSERT_TRUE(leading);
  EXPECT_EQ(leading->dataset, "global");
  site.site.current_product = "unheard of";
  EXPECT_EQ(leading_day(site, {five_o_clock})->dataset, "regional") << "nothing of it is stored";
  const Snapshot made = make_forecast(site, at_five()).snapshot;
  EXPECT_TRUE(made.degraded);
  EXPECT_NE(made.headline.find("names currents of unheard of"), std::string::npos) << made.headline;
}

TEST(LeadingDay, AStandInIsDegradedNamedAndAsWideAsTheTwoAreKnownToDiffer) {
  TwoProducts two(-4);
  TwoProducts alone(-30);
  const Snapshot stood_in = make_forecast(two.site(), at_five()).snapshot;
  const Snapshot own = make_forecast(alone.site(), at_five()).snapshot;
  EXPECT_TRUE(stood_in.degraded);
  EXPECT_EQ(own.headline.find("is used instead"), std::string::npos) << own.headline;
  EXPECT_NE(stood_in.headline.find("regional"), std::string::npos) << stood_in.headline;
  EXPECT_NE(stood_in.headline.find("global is used instead"), std::string::npos)
      << stood_in.headline;
  // The tide that one has and the other lacks: 1/sqrt(2) m/s in one of two components.
  const double known = std::sqrt(0.5 / 2);
  for (std::size_t i = 0; i < stood_in.columns[0].current_sigma_m_s.size(); ++i) {
    EXPECT_NEAR(stood_in.columns[0].current_sigma_m_s[i],
                std::hypot(own.columns[0].current_sigma_m_s[i], known), 0.02);
  }
}

}  // namespace
}  // namespace slackwater::calibration::leading_day_test
