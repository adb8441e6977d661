// A sea whose truth is known, and a provider whose runs err in a known way: what is issued against
// its parents, our own forecast and the provider's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "calibration/day/column/methods.h"
#include "calibration/day/daily_forecast.h"
#include "fields/base/numbers/random.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::provider_twin_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay first_day = parse_day("2024-05-01");
const std::vector<double> depth_m{2, 8, 20};
constexpr int record_days = 32;
constexpr int first_scored = 24;  ///< days after the first
constexpr int last_scored = 28;

double hour_of(UtcTime time) { return hours_between(UtcTime(first_day), time); }

/// Weather of the sea, hour by hour: a first-order process of 0.15 m/s that lasts three days.
const std::vector<Horizontal>& mesoscale() {
  static const std::vector<Horizontal> series = [] {
    Rng random(7, "tests/provider_twin/mesoscale");
    const double keep = std::exp(-1.0 / 72);
    // One draw after the other: arguments of a call are worked out in any order.
    const auto draw = [&random] {
      const double north = random.normal();
      return Horizontal(random.normal(), north);
    };
    std::vector<Horizontal> values{0.15 * std::sqrt(0.5) * draw()};
    while (values.size() < 24 * (record_days + 5)) {
      values.push_back(keep * values.back() + 0.15 * std::sqrt(0.5 * (1 - keep * keep)) * draw());
    }
    return values;
  }();
  return series;
}

/// A tide, and the weather on a line between hours.
Horizontal water(UtcTime time, double depth) {
  const double hour = hour_of(time);
  const auto low = static_cast<std::size_t>(hour);
  const double share = hour - static_cast<double>(low);
  const Horizontal weather = (1 - share) * mesoscale().at(low) + share * mesoscale().at(low + 1);
  return std::polar(0.35, 2 * std::numbers::pi * hour / 12.4206 + 0.3) +
         weather * (0.6 + 0.4 * std::exp(-depth / 20));
}

/// What a run issued at a time says wrong of another.
using RunErrorForTests = std::function<Horizontal(UtcTime issued, UtcTime time)>;

/// A model that is wrong by 0.09 m/s, turning once in nine days.
Horizontal smooth_error(UtcTime, UtcTime time) {
  return std::polar(0.09, 2 * std::numbers::pi * hour_of(time) / 216);
}

/// The same, and from 30 h on 0.6 m/s more, another way in each run.
Horizontal bad_from_30_h(UtcTime issued, UtcTime time) {
  const double lead_h = hours_between(issued, time);
  const double more = 0.6 * std::clamp((lead_h - 30) / 6, 0.0, 1.0);
  return smooth_error(issued, time) + std::polar(more, 2.4 * hour_of(issued) / 24);
}

struct Provider {
  RunErrorForTests error;
  Duration step = hours(1);
  bool is_means = true;
  std::vector<int> missing_runs{};  ///< days after the first at whose end no run is issued
};

/// The record, and a run of 84 h at the end of every day.
KnownSeriesForTests sea_of(const Provider* provider) {
  KnownSeriesForTests sea;
  const UtcTime from(first_day);
  sea.current(analysis_of("model"), means(from, from + days(record_days)), depth_m, water);
  if (provider == nullptr) return sea;
  for (int day = 0; day < record_days; ++day) {
    const auto& missing = provider->missing_runs;
    if (std::find(missing.begin(), missing.end(), day) != missing.end()) continue;
    const UtcTime issued = from + days(day + 1);
    const auto said = [&](UtcTime time, double depth) {
      return water(time, depth) + provider->error(issued, time);
    };
    const auto cells = provider->is_means ? means(issued, issued + hours(84), provider->step)
                                          : instants(issued, issued + hours(84), provider->step);
    sea.current(forecast_of("model", issued, 100 + day), cells, depth_m, said);
  }
  return sea;
}

/// Squared errors by day of lead.
struct Errors {
  std::vector<double> square = std::vector<double>(3);
  std::vector<double> count = std::vector<double>(3);
  void add(int lead_h, Horizontal error) {
    const auto day = static_cast<std::size_t>((lead_h - 1) / 24);
    square[day] += std::norm(error);
    count[day] += 1;
  }
  [[nodiscard]] double rmse(std::size_t day) const { return std::sqrt(square[day] / count[day]); }
  [[nodiscard]] double all() const {
    return std::sqrt((square[0] + square[1] + square[2]) / (count[0] + count[1] + count[2]));
  }
};

struct Scored {
  Errors issued;
  double inside_80 = 0;          ///< share of components in the issued band
  double largest_step = 0;       ///< of the issued series less the truth's, from stamp to stamp
  std::optional<Earned> earned;  ///< of the last day
};

Scored score(const KnownSeriesForTests& sea, int from = first_scored, int to = last_scored) {
  const SiteData data = site_of({sea.data});
  RehearsedDays rehearsals(data);
  Scored scored;
  double inside = 0;
  double count = 0;
  for (int day = from; day <= to; ++day) {
    ForecastOptions options;
    options.day = first_day + days(day);
    options.issued = UtcTime(*options.day) + days(1);
    options.rehearsals = &rehearsals;
    const DailyForecast made = make_forecast(data, options);
    const ForecastColumn& column = made.snapshot.columns.front();
    const auto& stamps = made.snapshot.time;
    std::vector<Horizontal> before;
    for (std::size_t t = 0; t < stamps.size(); ++t) {
      std::vector<Horizontal> now;
      for (std::size_t k = 0; k < depth_m.size(); ++k) {
        const std::size_t o = t * depth_m.size() + k;
        now.push_back(column.current_m_s[o] - water(stamps[t], depth_m[k]));
        if (t == 0) continue;
        scored.issued.add(static_cast<int>(t), now.back());
        const double z = 1.2816 * column.current_sigma_m_s[o];
        inside += (std::abs(now.back().real()) < z ? 1 : 0) + (std::abs(now.back().imag()) < z);
        count += 2;
        scored.largest_step = std::max(scored.largest_step, std::abs(now[k] - before[k]));
      }
      before = now;
    }
    scored.earned = made.earned;
  }
  scored.inside_80 = inside / count;
  return scored;
}

/// The provider's own error, of the newest run at the end of each day.
Errors errors_of(const Provider& provider, int from = first_scored, int to = last_scored) {
  Errors errors;
  for (int day = from; day <= to; ++day) {
    const UtcTime end = UtcTime(first_day) + days(day + 1);
    UtcTime issued = end;
    const auto& missing = provider.missing_runs;
    while (std::find(missing.begin(), missing.end(), static_cast<int>(hour_of(issued) / 24) - 1) !=
           missing.end())
      issued -= days(1);
    for (int h = 1; h <= 72 && end + hours(h) <= issued + hours(84); ++h)
      errors.add(h, provider.error(issued, end + hours(h)));
  }
  return errors;
}

const Scored& ours_alone() {
  static const Scored scored = score(sea_of(nullptr));
  return scored;
}

void print(const char* what, const Errors& errors) {
  std::printf("%-22s %.4f  %.4f  %.4f m/s\n", what, errors.rmse(0), errors.rmse(1), errors.rmse(2));
}

/// What is issued beats both parents over all, and on no day of lead is it worse than the better by
/// more than a share: five days in a sea whose weather lasts three hold few independent errors.
Scored expect_better_than_both(const char* what, const Provider& provider, double noise = 0.03) {
  const Scored both = score(sea_of(&provider));
  const Errors theirs = errors_of(provider);
  const Errors& ours = ours_alone().issued;
  std::printf("%s\n", what);
  print("  ours alone", ours);
  print("  the provider's", theirs);
  print("  issued", both.issued);
  std::printf("  in the band %.2f, largest step of the error %.4f m/s\n  %s\n", both.inside_80,
              both.largest_step, both.earned->blend.provenance.c_str());
  for (const Blend& later : both.earned->later) std::printf("  %s\n", later.provenance.c_str());
  EXPECT_LT(both.issued.all(), ours.all());
  EXPECT_LT(both.issued.all(), theirs.all());
  for (std::size_t day = 0; day < 3; ++day) {
    EXPECT_LT(both.issued.rmse(day), (1 + noise) * std::min(ours.rmse(day), theirs.rmse(day)))
        << "day of lead " << day + 1;
  }
  return both;
}

TEST(ProviderTwin, HourlyMeansWithASmoothErrorAreCorrected) {
  const Scored both = expect_better_than_both("hourly means", {smooth_error});
  EXPECT_LT(both.issued.rmse(0), 0.6 * 0.09) << "the error of D is carried, not averaged";
}

TEST(ProviderTwin, SixHourlyInstantsMakeNoJump) {
  const Scored both =
      expect_better_than_both("six-hourly instants", {smooth_error, hours(6), false});
  // The truth's own hours differ by a tide, known to all, and the weather's steps.
  double largest = 0;
  for (std::size_t h = 1; h < mesoscale().size(); ++h)
    largest = std::max(largest, std::abs(mesoscale()[h] - mesoscale()[h - 1]));
  EXPECT_LT(both.largest_step, 2 * largest);
}

TEST(ProviderTwin, AMissingRunLeavesTheOneBefore) {
  expect_better_than_both("runs missing",
                          {smooth_error, hours(1), true, {12, 17, first_scored + 1, 27}});
}

TEST(ProviderTwin, ARunThatTurnsBadIsLeftWhereItDoes) {
  expect_better_than_both("bad from +30 h", {bad_from_30_h}, 0.02);
}

TEST(ProviderTwin, APerfectProviderIsBelievedWithinTenDays) {
  const Provider perfect{[](UtcTime, UtcTime) { return Horizontal{}; }};
  const Scored after_ten_days = score(sea_of(&perfect), 10, 12);
  print("perfect, ten days", after_ten_days.issued);
  EXPECT_LT(after_ten_days.issued.all(), 0.15 * ours_alone().issued.all());
  const Scored at_once = score(sea_of(&perfect), 3, 4);
  const Scored alone = score(sea_of(nullptr), 3, 4);
  print("perfect, three days", at_once.issued);
  print("  ours alone", alone.issued);
  EXPECT_LT(at_once.issued.all(), 0.3 * alone.issued.all());
}

/// Nothing but one run is stored: it is day D, the provider's forecast of the days after it, and
/// all that past days could be held against. It says nothing of its own errors.
TEST(ProviderRun, IsNeverHeldAgainstItself) {
  const UtcTime issued(first_day + days(4));
  KnownSeriesForTests sea;
  sea.current(forecast_of("model", issued), means(issued, issued + hours(120)), depth_m,
              [](UtcTime time, double depth) { return water(time, depth); });
  ForecastOptions options;
  options.day = first_day + days(5);
  options.issued = UtcTime(first_day) + days(6) + hours(5);
  options.horizon = hours(48);
  const DailyForecast made = make_forecast(site_of({sea.data}), options);
  EXPECT_TRUE(made.snapshot.degraded);
  EXPECT_NE(made.snapshot.headline.find("of a provider's forecast, not analysed"),
            std::string::npos)
      << made.snapshot.headline;
  const ForecastColumn& column = made.snapshot.columns.front();
  double narrowest_m_s = 1;
  for (std::size_t t = 12; t < made.snapshot.time.size(); ++t)
    for (std::size_t k = 0; k < depth_m.size(); ++k)
      narrowest_m_s = std::min(narrowest_m_s, column.current_sigma_m_s[t * depth_m.size() + k]);
  EXPECT_GT(narrowest_m_s, 0.025) << "runs are off by more than that after half a day";
}

}  // namespace
}  // namespace slackwater::calibration::provider_twin_test
