#include "calibration/day/given/driving_ensemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>

#include "calibration/day/daily_forecast.h"
#include "fields/base/numbers/random.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::driving_ensemble_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);
const std::vector<double> depth_m{2, 8, 20};
constexpr int horizon_h = 48;
constexpr std::size_t stamps = horizon_h + 1;

double hour_of(UtcTime time) { return hours_between(UtcTime(day), time); }

/// The wind of the centre: an analysis up to the end of D, a control run from there.
Horizontal central_wind(UtcTime time, double) {
  return std::polar(8 + 2 * std::sin(0.2 * hour_of(time)), 0.6 + 0.03 * hour_of(time));
}

/// A surface that goes with the wind, 40 degrees to its right, and a drift.
Horizontal wind_driven_sea(UtcTime time, double depth) {
  const Horizontal response =
      std::polar(0.018 * std::exp(-depth / 12), -40 * std::numbers::pi / 180);
  return Horizontal(0.1, -0.05) + response * central_wind(time, 0);
}

/// What member n says: the control and a departure of its own, two slow turns of random size that
/// grow to their full size within `growth_h` of lead.
Horizontal member_wind(int number, UtcTime time, double size_m_s, double growth_h) {
  Rng random(static_cast<std::uint64_t>(number), "tests/wind_member");
  const double lead_h = hours_between(end_of_day, time);
  const auto drawn = [&] { return size_m_s * Horizontal(random.normal(), random.normal()); };
  const Horizontal first = drawn();
  const Horizontal second = drawn();
  const double grown = std::clamp(lead_h / growth_h, 0.0, 1.0);
  return central_wind(time, 0) + grown * (first * std::polar(1.0, 0.21 * lead_h) +
                                          second * std::polar(1.0, -0.08 * lead_h));
}

struct EnsembleForTests {
  int members = 30;
  double size_m_s = 1.6;
  double growth_h = 6;
  int reach_h = 96;
  UtcTime issued = end_of_day;
};

Origin member_origin(UtcTime issued, int number) {
  Origin origin = forecast_of("ens", issued, 100 + number);
  origin.ensemble_member = number;
  origin.attribution = "an ensemble made up for tests";
  return origin;
}

/// The sea with the control of a run; members come on top.
KnownSeriesForTests sea_with_control() {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model", 1), instants(UtcTime(day) - days(4), end_of_day), depth_m,
              wind_driven_sea);
  sea.wind(analysis_of("wind", 2), instants(UtcTime(day) - days(7), end_of_day), central_wind);
  sea.wind(member_origin(end_of_day, 0), instants(end_of_day, end_of_day + days(4)), central_wind);
  return sea;
}

void add_members(KnownSeriesForTests& sea, const EnsembleForTests& ensemble) {
  for (int n = 1; n <= ensemble.members; ++n) {
    sea.wind(member_origin(ensemble.issued, n),
             instants(ensemble.issued, ensemble.issued + hours(ensemble.reach_h)),
             [=](UtcTime time, double) {
               return member_wind(n, time, ensemble.size_m_s, ensemble.growth_h);
             });
  }
}

KnownSeriesForTests sea_with(const EnsembleForTests& ensemble) {
  KnownSeriesForTests sea = sea_with_control();
  add_members(sea, ensemble);
  return sea;
}

ForecastOptions options_of(WindPolicy wind = WindPolicy::best) {
  ForecastOptions options;
  options.day = day;
  options.issued = end_of_day + hours(5);
  options.horizon = hours(horizon_h);
  options.wind = wind;
  return options;
}

/// Modulus of the complex correlation.
double correlation(const std::vector<Horizontal>& a, const std::vector<Horizontal>& b) {
  const auto count = static_cast<double>(a.size());
  const Horizontal mean_a = std::accumulate(a.begin(), a.end(), Horizontal{}) / count;
  const Horizontal mean_b = std::accumulate(b.begin(), b.end(), Horizontal{}) / count;
  Horizontal product{};
  double square_a = 0;
  double square_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    product += (a[i] - mean_a) * std::conj(b[i] - mean_b);
    square_a += std::norm(a[i] - mean_a);
    square_b += std::norm(b[i] - mean_b);
  }
  return std::abs(product) / std::sqrt(square_a * square_b);
}

/// Issued member m's wind over time, and its departures from the centre.
std::vector<Horizontal> wind_of(const ForecastColumn& c, std::size_t m) {
  return {c.wind_member_m_s.begin() + static_cast<std::ptrdiff_t>(m * stamps),
          c.wind_member_m_s.begin() + static_cast<std::ptrdiff_t>((m + 1) * stamps)};
}
std::vector<Horizontal> wind_departure(const ForecastColumn& c, std::size_t m) {
  std::vector<Horizontal> wind = wind_of(c, m);
  for (std::size_t t = 0; t < stamps; ++t) wind[t] -= c.wind_m_s[t];
  return wind;
}
std::vector<Horizontal> surface_departure(const ForecastColumn& c, std::size_t m) {
  std::vector<Horizontal> current;
  for (std::size_t t = 0; t < stamps; ++t) {
    const std::size_t o = t * depth_m.size();
    current.push_back(c.member_m_s[m * c.current_m_s.size() + o] - c.current_m_s[o]);
  }
  return current;
}
std::vector<Horizontal> wind_of_driver(int number, const EnsembleForTests& ensemble) {
  std::vector<Horizontal> wind;
  for (std::size_t t = 0; t < stamps; ++t) {
    wind.push_back(
        member_wind(number, end_of_day + hours(t), ensemble.size_m_s, ensemble.growth_h));
  }
  return wind;
}

void append(std::vector<Horizontal>& all, const std::vector<Horizontal>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

TEST(DrivingEnsemble, EachIssuedMemberHasTheWindOfTheMemberItNames) {
  for (const int members : {11, 30, 50}) {
    const EnsembleForTests ensemble{.members = members};
    const KnownSeriesForTests sea = sea_with(ensemble);
    const DailyForecast made = make_forecast(site_of({sea.data}), options_of());
    const ForecastColumn& c = made.snapshot.columns.front();
    ASSERT_EQ(c.wind_member_number.size(), 24U) << members;
    EXPECT_EQ(made.snapshot.wind_ensemble, "ens issued 2024-06-12T00:00:00Z");
    const std::set<int> numbers(c.wind_member_number.begin(), c.wind_member_number.end());
    EXPECT_EQ(numbers.size(), static_cast<std::size_t>(std::min(members, 24)));
    double least = 1;
    std::vector<Horizontal> said;
    std::vector<Horizontal> carried;
    for (std::size_t m = 0; m < 24; ++m) {
      const int number = c.wind_member_number[m];
      ASSERT_GE(number, 1);
      ASSERT_LE(number, members);
      std::vector<Horizontal> driver = wind_of_driver(number, ensemble);
      least = std::min(least, correlation(wind_of(c, m), driver));
      for (std::size_t t = 0; t < stamps; ++t) driver[t] -= central_wind(end_of_day + hours(t), 0);
      append(said, driver);
      append(carried, wind_departure(c, m));
    }
    EXPECT_GT(least, 0.9) << members;
    // Not the wind that all share but what each says of its own; 0.3 of it drawn in half of 11's.
    EXPECT_GT(correlation(carried, said), 0.95) << members;
  }
}

TEST(DrivingEnsemble, TheSurfaceCurrentOfAMemberFollowsItsWind) {
  // The rest is what no wind explains: memory, parameters, and the lag of water behind the wind.
  for (const int members : {11, 30, 50}) {
    const KnownSeriesForTests sea = sea_with({.members = members, .size_m_s = 2.5});
    const DailyForecast made = make_forecast(site_of({sea.data}), options_of());
    const ForecastColumn& c = made.snapshot.columns.front();
    std::vector<Horizontal> current;
    std::vector<Horizontal> wind;
    std::vector<Horizontal> wind_of_another;
    for (std::size_t m = 0; m < 24; ++m) {
      append(current, surface_departure(c, m));
      append(wind, wind_departure(c, m));
      append(wind_of_another, wind_departure(c, (m + 5) % 24));
    }
    EXPECT_GT(correlation(current, wind), 0.55) << members;
    EXPECT_LT(correlation(current, wind_of_another), 0.25) << members;
  }
}

TEST(DrivingEnsemble, TheRunIsNamedOnceAndItsFilesAreAmongTheInputs) {
  const KnownSeriesForTests sea = sea_with({.members = 30});
  const DailyForecast made = make_forecast(site_of({sea.data}), options_of());
  const auto& notes = made.columns.front().notes;
  EXPECT_EQ(std::count_if(notes.begin(), notes.end(),
                          [](const std::string& note) {
                            return note.starts_with(
                                "wind of 24 members from 30 of ens issued 2024-06-12T00:00:00Z, "
                                "numbers recorded");
                          }),
            1);
  EXPECT_TRUE(std::count(made.snapshot.attributions.begin(), made.snapshot.attributions.end(),
                         "an ensemble made up for tests"));
  for (int n = 0; n <= 30; ++n) {
    EXPECT_TRUE(std::binary_search(made.input_granules.begin(), made.input_granules.end(), 100 + n))
        << n;
  }
  EXPECT_FALSE(made.snapshot.hindsight);
}

void expect_same(const ForecastColumn& a, const ForecastColumn& b) {
  EXPECT_EQ(a.current_m_s, b.current_m_s);
  EXPECT_EQ(a.current_sigma_m_s, b.current_sigma_m_s);
  EXPECT_EQ(a.member_m_s, b.member_m_s);
  EXPECT_EQ(a.wind_m_s, b.wind_m_s);
  EXPECT_EQ(a.wind_member_m_s, b.wind_member_m_s);
  EXPECT_EQ(a.wind_member_number, b.wind_member_number);
}

TEST(DrivingEnsemble, TheOrderOfPiecesTheThreadsAndTheColumnsDoNotMatter) {
  KnownSeriesForTests sea = sea_with({.members = 30});
  const SiteData data = site_of({sea.data, sea.data});
  const DailyForecast made = make_forecast(data, options_of());
  expect_same(made.snapshot.columns[0], made.snapshot.columns[1]);
  auto& pieces = sea.data.wind.pieces;
  std::reverse(pieces.begin(), pieces.end());
  std::rotate(pieces.begin(), pieces.begin() + 7, pieces.end());
  ForecastOptions threaded = options_of();
  threaded.threads = 3;
  const DailyForecast again = make_forecast(site_of({sea.data, sea.data}), threaded);
  expect_same(again.snapshot.columns[0], made.snapshot.columns[0]);
  EXPECT_EQ(again.columns[0].notes, made.columns[0].notes);

  ForecastOptions reseeded = options_of();
  reseeded.seed = 2;
  const DailyForecast other = make_forecast(data, reseeded);
  EXPECT_NE(other.snapshot.columns[0].wind_member_number,
            made.snapshot.columns[0].wind_member_number);
  EXPECT_EQ(other.snapshot.columns[0].wind_m_s, made.snapshot.columns[0].wind_m_s);
}

TEST(DrivingEnsemble, AMemberIsTheSameWhateverTheirNumber) {
  const KnownSeriesForTests sea = sea_with({.members = 11});
  const SiteData data = site_of({sea.data});
  const auto made_with = [&](int members) {
    ForecastOptions options = options_of();
    options.horizon = hours(24);
    options.members = members;
    return make_forecast(data, options).snapshot;
  };
  const Snapshot usual = made_with(24);
  const Snapshot more = made_with(60);
  EXPECT_EQ(usual.members, 25u);
  EXPECT_EQ(more.members, 61u);
  EXPECT_EQ(usual.headline, more.headline);
  const ForecastColumn& few = usual.columns[0];
  ForecastColumn first = more.columns[0];
  ASSERT_EQ(first.member_m_s.size(), 60 * first.current_m_s.size());
  ASSERT_EQ(first.wind_member_number.size(), 60u);
  first.member_m_s.resize(few.member_m_s.size());
  first.wind_member_m_s.resize(few.wind_member_m_s.size());
  first.wind_member_number.resize(24);
  expect_same(first, few);
}

TEST(DrivingEnsemble, FourMembersOrOnesNotKnownLeaveTheForecastAsItWas) {
  const DailyForecast without = make_forecast(site_of({sea_with_control().data}), options_of());
  EXPECT_TRUE(without.snapshot.columns[0].wind_member_number.empty());
  EXPECT_EQ(without.snapshot.columns[0].wind_member_m_s.size(), 24 * stamps);
  const KnownSeriesForTests few = sea_with({.members = 4});
  expect_same(make_forecast(site_of({few.data}), options_of()).snapshot.columns[0],
              without.snapshot.columns[0]);
  const KnownSeriesForTests later = sea_with({.members = 30, .issued = end_of_day + hours(6)});
  const DailyForecast unseen = make_forecast(site_of({later.data}), options_of());
  expect_same(unseen.snapshot.columns[0], without.snapshot.columns[0]);
  EXPECT_TRUE(unseen.snapshot.wind_ensemble.empty());
}

TEST(DrivingEnsemble, APersistedWindHasNoWeatherMembers) {
  const KnownSeriesForTests sea = sea_with({.members = 30});
  const DailyForecast made = make_forecast(site_of({sea.data}), options_of(WindPolicy::persist));
  EXPECT_TRUE(made.snapshot.columns[0].wind_member_number.empty());
  EXPECT_FALSE(made.snapshot.columns[0].wind_member_m_s.empty());
}

TEST(DrivingEnsemble, ALargerSpreadOfTheWeatherWidensTheBand) {
  const auto sigma = [](double size_m_s) {
    const KnownSeriesForTests sea = sea_with({.members = 30, .size_m_s = size_m_s});
    const auto made = make_forecast(site_of({sea.data}), options_of());
    return made.snapshot.columns[0].current_sigma_m_s[36 * depth_m.size()];
  };
  const double narrow = sigma(0.8);
  const double wide = sigma(4.0);
  EXPECT_GT(wide, 1.3 * narrow);
  // An ensemble that says next to nothing is still no surer than an analysis.
  EXPECT_NEAR(sigma(0.05) / sigma(0.2), 1.0, 0.1);
}

TEST(DrivingEnsemble, IsLeftOutWhereTheWindIsNoForecastAnyMore) {
  // Analyses up to 12 h after D: the departures of a run from before are not what they are in doubt
  // by.
  HorizonWind wind;
  std::vector<UtcTime> hourly;
  const WindEnsembleRun run{"ens", "ens", end_of_day, {1, 2, 3, 4, 5}, {}, {}};
  wind.member_run = run;
  for (int h = 0; h <= 24; ++h) {
    hourly.push_back(end_of_day + hours(h));
    wind.wind_m_s.emplace_back(5, 0);
    wind.source.push_back(h <= 12 ? DataStatus::analysis : DataStatus::forecast);
  }
  for (int n = 1; n <= 5; ++n)
    wind.members.push_back({n, std::vector<Horizontal>(25, Horizontal(5.0 + n, 1))});
  const WindDepartures departures = departures_of(wind, hourly);
  EXPECT_EQ(departures.number, run.number);
  for (std::size_t n = 0; n < 5; ++n) {
    EXPECT_TRUE(std::isnan(departures.departure_m_s[n * 25 + 12].real()));
    EXPECT_EQ(departures.departure_m_s[n * 25 + 13], Horizontal(static_cast<double>(n) + 1, 1));
  }
  std::fill(wind.source.begin(), wind.source.end(), DataStatus::observation);
  EXPECT_TRUE(departures_of(wind, hourly).empty());
}

TEST(DrivingEnsemble, BeyondItsEndTheNoteSaysSoAndTheSpreadGoesOn) {
  const EnsembleForTests ensemble{.members = 30, .reach_h = 30};
  const KnownSeriesForTests sea = sea_with(ensemble);
  const DailyForecast made = make_forecast(site_of({sea.data}), options_of());
  const ForecastColumn& c = made.snapshot.columns[0];
  ASSERT_EQ(c.wind_member_number.size(), 24U);
  bool is_said = false;
  for (const std::string& note : made.columns[0].notes)
    is_said = is_said || note.find("it has no value at 18 of 48 hours") != std::string::npos;
  EXPECT_TRUE(is_said);
  const auto spread_at = [&](std::size_t t) {
    double squares = 0;
    for (std::size_t m = 0; m < 24; ++m)
      squares += std::norm(c.wind_member_m_s[m * stamps + t] - c.wind_m_s[t]) / 48;
    return std::sqrt(squares);
  };
  EXPECT_GT(spread_at(48), 1.0);
  for (std::size_t m = 0; m < 24; ++m) {
    // An hour after the end a member still has most of what it had.
    const Horizontal last = wind_departure(c, m)[30];
    EXPECT_LT(std::abs(wind_departure(c, m)[31] - last), 3.5) << m;
  }
}

TEST(LooksAhead, IsARunThatWasIssuedAfterWhatIsKnown) {
  const Origin origin = member_origin(end_of_day + hours(6), 1);
  const WindEnsembleRun run{"ens", "ens", *origin.reference_time, {1}, {&origin}, {}};
  ForecastPlan plan;
  plan.best.known_by = end_of_day + hours(5);
  EXPECT_TRUE(looks_ahead(run, plan));
  plan.best.known_by = end_of_day + hours(6);
  EXPECT_FALSE(looks_ahead(run, plan));
}

}  // namespace
}  // namespace slackwater::calibration::driving_ensemble_test
