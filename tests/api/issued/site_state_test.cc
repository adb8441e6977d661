#include "api/issued/site_state.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/door/cli/serve/serve_health.h"
#include "tests/api/door/edr/made_up_store.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::site_state_test {
namespace {

using namespace api;
using namespace std::chrono_literals;
using nlohmann::json;

/// Sites "farm", "dateline" (issued 2025-03-10 05:00) and "lone" (the day after); each ends 12 h
/// after the midnight before its issue.
class SiteStates : public ::testing::Test {
 protected:
  SiteStates() { fill_with_made_up_forecasts(folder_ / "store"); }

  [[nodiscard]] static Freshness at(const std::string& now, Duration stale_after = 36h) {
    return {stale_after, [time = parse_utc(now)] { return time; }};
  }

  TemporaryFolder folder_;
};

SiteState of(const std::vector<SiteState>& states, const std::string& site) {
  for (const SiteState& state : states)
    if (state.site_id == site) return state;
  ADD_FAILURE() << "no site " << site;
  return states.front();
}

double gauge(const std::vector<http::Gauge>& gauges, const std::string& name,
             const std::string& site) {
  for (const http::Gauge& each : gauges)
    for (const auto& [label, value] : each.values)
      if (each.name == name && label == site) return value;
  ADD_FAILURE() << name << " of " << site;
  return -1;
}

TEST_F(SiteStates, AgeCountsFromTheIssueOfTheForecastInForce) {
  const IssuedFields forecasts(folder_ / "store", 1h);
  const auto states = site_states(*forecasts.catalogue(), at("2025-03-11T06:30:00Z"));
  ASSERT_EQ(states.size(), 3U);
  EXPECT_EQ(of(states, "lone").age, 90min) << "its older forecast was issued a day before";
  EXPECT_EQ(of(states, "farm").age, 25h + 30min);
  EXPECT_EQ(of(states, "lone").condition, SiteCondition::ok);
  EXPECT_EQ(of(states, "lone").site_name, "Site lone");
}

TEST_F(SiteStates, AForecastIsStaleBeyondTheLimitAndWhenItHasEnded) {
  const IssuedFields forecasts(folder_ / "store", 1h);
  const auto condition = [&](const std::string& now, Duration limit) {
    return of(site_states(*forecasts.catalogue(), at(now, limit)), "lone").condition;
  };
  EXPECT_EQ(condition("2025-03-11T07:00:00Z", 2h), SiteCondition::ok) << "at the limit";
  EXPECT_EQ(condition("2025-03-11T07:00:01Z", 2h), SiteCondition::stale);
  EXPECT_EQ(condition("2025-03-11T12:00:00Z", 36h), SiteCondition::ok) << "its last hour";
  EXPECT_EQ(condition("2025-03-11T12:00:01Z", 36h), SiteCondition::stale)
      << "nothing is left of it";
}

TEST_F(SiteStates, AClockThatIsBehindIsSaid) {
  const IssuedFields forecasts(folder_ / "store", 1h);
  const Freshness freshness = at("2025-03-11T02:00:00Z");
  const SiteState state = of(site_states(*forecasts.catalogue(), freshness), "lone");
  EXPECT_EQ(state.age, -3h);
  EXPECT_NE(in_words(state, freshness).find("3 h in the future by this machine's clock"),
            std::string::npos);
}

TEST_F(SiteStates, DegradationIsSaidInTheWordsOfTheForecast) {
  Snapshot made = lone_forecast(2, 7);
  made.degraded = true;
  made.headline = "No wind after 2025-03-11.";
  commit_made_up_forecast(folder_ / "store", made);
  const IssuedFields forecasts(folder_ / "store", 1h);
  const Freshness freshness = at("2025-03-12T10:00:00Z");
  const SiteState state = of(site_states(*forecasts.catalogue(), freshness), "lone");
  EXPECT_EQ(state.condition, SiteCondition::degraded);
  EXPECT_EQ(in_words(state, freshness), "Issued 5 h ago. Degraded: No wind after 2025-03-11.");
  EXPECT_EQ(gauge(forecast_gauges(*forecasts.catalogue(), freshness),
                  "slackwater_forecast_degraded", "lone"),
            1);
}

TEST_F(SiteStates, OneStaleSiteMakesTheServiceStaleAndTheAgesAreGauges) {
  const IssuedFields forecasts(folder_ / "store", 1h);
  const http::HealthFacts fresh = health_of(forecasts, at("2025-03-10T06:00:00Z"));
  EXPECT_EQ(fresh.status, "ok") << fresh.details;
  EXPECT_TRUE(fresh.is_current);

  const Freshness later = at("2025-03-11T06:30:00Z");
  const http::HealthFacts stale = health_of(forecasts, later);
  EXPECT_EQ(stale.status, "stale");
  EXPECT_TRUE(stale.can_serve) << "an old forecast that says so is better than none";
  EXPECT_FALSE(stale.is_current);
  const nlohmann::ordered_json& sites = stale.details.at("sites");
  ASSERT_EQ(sites.size(), 3U);
  EXPECT_EQ(sites[1].at("site"), "farm");
  EXPECT_EQ(sites[1].at("age_s"), 91800);
  EXPECT_EQ(sites[1].at("status"), "stale");
  EXPECT_EQ(sites[2].at("status"), "ok");

  const auto gauges = forecast_gauges(*forecasts.catalogue(), later);
  EXPECT_EQ(gauge(gauges, "slackwater_forecast_age_seconds", "farm"), 91800);
  EXPECT_EQ(gauge(gauges, "slackwater_forecast_age_seconds", "lone"), 5400);
  EXPECT_EQ(gauge(gauges, "slackwater_forecast_stale", "farm"), 1);
  EXPECT_EQ(gauge(gauges, "slackwater_forecast_stale", "lone"), 0);
}

TEST(SiteStatesOfAnEmptyStore, AreNoneAndThatIsNotOk) {
  const TemporaryFolder folder;
  static_cast<void>(store::Store::open(folder / "store", store::OpenMode::create_or_write));
  const IssuedFields forecasts(folder / "store", 1h);
  const http::HealthFacts health = health_of(forecasts, {});
  EXPECT_EQ(health.status, "empty");
  EXPECT_FALSE(health.is_current);
  EXPECT_TRUE(health.can_serve);
}

TEST(AgeInWords, IsRoundedDownInTheLargestUnitThatLeavesTwo) {
  EXPECT_EQ(age_in_words(59s), "0 min");
  EXPECT_EQ(age_in_words(119min), "119 min");
  EXPECT_EQ(age_in_words(2h), "2 h");
  EXPECT_EQ(age_in_words(47h + 59min), "47 h");
  EXPECT_EQ(age_in_words(48h), "2 days");
}

}  // namespace
}  // namespace slackwater::tests::site_state_test
