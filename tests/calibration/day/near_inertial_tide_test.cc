// Seas whose tide stands within a Rayleigh width of the inertial frequency, with known truth: what
// is forecast when the line is left to the memory, when it is carried on as tide, and when it is
// dropped.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "calibration/day/daily_forecast.h"
#include "fields/base/numbers/random.h"
#include "fields/current/coriolis.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::near_inertial_tide_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);

struct Water {
  double latitude_deg = 0;
  int record_days = 0;
  double period_h = 0;          ///< of the tide
  double inertial_sense = 0;    ///< m/s, of the tide's part that turns as inertial motion does
  double other_sense = 0;       ///< m/s
  double inertial_rms_m_s = 0;  ///< of inertial motion, that is made anew within four days
};

/// One sea: tide, inertial motion, an eddying drift, and noise.
class Sea {
 public:
  Sea(const Water& water, std::uint64_t seed) : water_(water) {
    Rng random(seed, "tests/near_inertial_tide");
    const auto one = [&] {
      const double east = random.normal();
      return Horizontal(east, random.normal()) / std::sqrt(2.0);
    };
    const double f_rad_h = 3600 * coriolis_parameter_rad_s(Angle::from_degrees(water.latitude_deg));
    const double kept = std::exp(-1 / 96.0);
    const double kept_slow = std::exp(-1 / 120.0);
    Horizontal inertial = water.inertial_rms_m_s * one();
    Horizontal eddies = 0.04 * one();
    for (int h = 0; h <= 24 * (water.record_days + 4); ++h) {
      rest_.push_back(Horizontal(0.05, 0.02) + inertial + eddies + 0.01 * one());
      inertial = inertial * std::polar(kept, -f_rad_h) +
                 water.inertial_rms_m_s * std::sqrt(1 - kept * kept) * one();
      eddies = kept_slow * eddies + 0.04 * std::sqrt(1 - kept_slow * kept_slow) * one();
    }
    phase_[0] = random.uniform(0, 2 * std::numbers::pi);
    phase_[1] = random.uniform(0, 2 * std::numbers::pi);
  }

  /// At the whole hours.
  [[nodiscard]] Horizontal at(UtcTime time) const {
    const double hour = hours_between(end_of_day - days(water_.record_days), time);
    const double turn = 2 * std::numbers::pi * hour / water_.period_h;
    const double sense = water_.latitude_deg > 0 ? -1 : 1;
    return std::polar(water_.inertial_sense, sense * turn + phase_[0]) +
           std::polar(water_.other_sense, -sense * turn + phase_[1]) +
           rest_[static_cast<std::size_t>(std::lround(hour))];
  }

 private:
  Water water_;
  std::vector<Horizontal> rest_;
  double phase_[2]{};
};

using TidePart = decltype(ColumnParts{}.tide);

/// As it would be if there were no inertial motion: that of the equator.
const TidePart carried_on = [](const Chosen<Horizontal>& known, UtcDay, Angle) {
  return fit_column_tide(known.column, Angle::from_degrees(0));
};

/// Nobody remembers what was left out.
const TidePart dropped = [](const Chosen<Horizontal>& known, UtcDay on, Angle latitude) {
  FittedTide tide = tide_of_record(known, on, latitude);
  for (TideFit& level : tide.levels)
    for (TideTerm& term : level.terms) term.left_out_m_s = 0;
  return tide;
};

/// Root mean square over seeds and 72 hours.
double error_m_s(const Water& water, const TidePart& tide, int seeds) {
  double squares = 0;
  double count = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Sea sea(water, static_cast<std::uint64_t>(seed));
    KnownSeriesForTests known;
    known.data.point = GeoPoint::from_degrees(water.latitude_deg, 6.5);
    known.current(analysis_of("model"), instants(end_of_day - days(water.record_days), end_of_day),
                  {5}, [&](UtcTime time, double) { return sea.at(time); });
    ForecastOptions options;
    options.issued = end_of_day + hours(5);
    options.horizon = hours(72);
    options.parts.of_column.tide = tide;
    options.parts.rehearsal = [](auto&&...) -> Earned {
      throw Error(ErrorKind::unavailable, "our own forecast is looked at");
    };
    const Snapshot made = make_forecast(site_of({known.data}), options).snapshot;
    for (std::size_t t = 1; t < made.time.size(); ++t) {
      squares += std::norm(made.columns[0].current_m_s[t] - sea.at(made.time[t]));
      ++count;
    }
  }
  return std::sqrt(squares / count);
}

struct Errors {
  double memory = 0;
  double tide = 0;
  double nothing = 0;
};

Errors errors_of(const char* name, const Water& water, int seeds = 8) {
  const Errors found{error_m_s(water, tide_of_record, seeds), error_m_s(water, carried_on, seeds),
                     error_m_s(water, dropped, seeds)};
  std::printf("%s: left to the memory %.4f, carried on as tide %.4f, dropped %.4f m/s\n", name,
              found.memory, found.tide, found.nothing);
  return found;
}

constexpr double k1_h = 23.9344696;
constexpr double m2_h = 12.4206012;

TEST(NearInertialTide, ADiurnalTideAtThirtyDegreesIsBestLeftToTheMemoryInBothHemispheres) {
  Errors squares;
  for (const double latitude_deg : {30.0, -30.0}) {
    const Errors found = errors_of(latitude_deg > 0 ? "K1 at 30 N" : "K1 at 30 S",
                                   {latitude_deg, 20, k1_h, 0.2, 0.1, 0.04});
    EXPECT_LT(found.memory, found.tide) << latitude_deg;
    EXPECT_LT(found.memory, 0.65 * found.nothing) << latitude_deg;
    squares.memory += found.memory * found.memory;
    squares.tide += found.tide * found.tide;
  }
  EXPECT_LT(std::sqrt(squares.memory), 0.97 * std::sqrt(squares.tide));
}

TEST(NearInertialTide, WithoutAnyTideItCostsNextToNothing) {
  // The harmonic fit finds what inertial motion of ten days happens to leave.
  const Errors found = errors_of("no tide at 30 N", {30, 10, k1_h, 0, 0, 0.1});
  EXPECT_LT(found.memory, 1.04 * found.tide);
  EXPECT_LT(found.memory, 1.04 * found.nothing);
}

TEST(NearInertialTide, AStrongSemidiurnalTideInTheArcticIsNotLost) {
  const Errors found = errors_of("M2 at 75 N", {75, 20, m2_h, 0.3, 0.1, 0.03});
  EXPECT_LT(found.memory, 0.95 * found.tide);
  EXPECT_LT(found.memory, 0.7 * found.nothing);
}

TEST(NearInertialTide, ThreeDaysOfTheNorthSeaKeepTheirTide) {
  const Errors found = errors_of("three days of M2 at 54 N", {54, 3, m2_h, 0.3, 0.2, 0.05});
  EXPECT_LT(found.memory, found.tide);
  EXPECT_LT(found.memory, 0.6 * found.nothing);
}

TEST(NearInertialTide, NearTheEquatorEverythingIsAsItWas) {
  const Water water{0.5, 10, k1_h, 0.1, 0.1, 0.05};
  EXPECT_EQ(error_m_s(water, tide_of_record, 2), error_m_s(water, carried_on, 2));
}

}  // namespace
}  // namespace slackwater::calibration::near_inertial_tide_test
