#include "fields/current/tide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "fields/current/astronomy.h"

namespace slackwater::tide_test {
namespace {

const Angle latitude = Angle::from_degrees(54.0);
const UtcTime start = parse_utc("2023-03-05T00:00:00Z");

struct Series {
  std::vector<TimeCell> time;
  std::vector<Horizontal> value;
  std::vector<SampleStatus> status;
};

using Signal = std::function<Horizontal(UtcTime)>;

Series sampled(const Signal& signal, double days, double step_h = 1.0) {
  Series series;
  for (double t_h = 0; t_h < days * 24.0 - 1e-9; t_h += step_h) {
    series.time.push_back(TimeCell::instant(add_hours(start, t_h)));
    series.value.push_back(signal(series.time.back().start));
    series.status.push_back(SampleStatus::ok);
  }
  return series;
}

TideFit fitted(const Series& s, Angle at = latitude) {
  return fit_tide(s.time, s.value, s.status, at);
}

Horizontal tide_at(const TideFit& fit, UtcTime time) {
  return tide_over(fit, TimeCell::instant(time));
}

double speed(std::string_view name) { return tidal_constituent(name).speed_rad_s; }

/// Phasors of one constituent about `start`.
struct Wave {
  std::string name;
  Horizontal plus;
  Horizontal minus;
};

Signal tide_of(const std::vector<Wave>& waves, Horizontal mean = {}) {
  return [=](UtcTime time) {
    Horizontal sum = mean;
    for (const Wave& wave : waves) {
      const Horizontal turn = std::polar(1.0, speed(wave.name) * seconds_between(start, time));
      sum += wave.plus * turn + wave.minus * std::conj(turn);
    }
    return sum;
  };
}

const TideTerm* find(const TideFit& fit, std::string_view name) {
  const auto found = std::find_if(fit.terms.begin(), fit.terms.end(),
                                  [&](const TideTerm& t) { return t.name == name; });
  return found == fit.terms.end() ? nullptr : &*found;
}

bool says(const TideFit& fit, std::string_view text) {
  return std::any_of(fit.notes.begin(), fit.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST(FitTide, RecoversAnExactTideOfThirtyDaysToRounding) {
  const std::vector<Wave> waves{
      {"M2", {0.40, 0.11}, {-0.08, 0.25}}, {"S2", {0.10, -0.07}, {0.05, 0.02}},
      {"N2", {0.05, 0.04}, {-0.03, 0.01}}, {"O1", {0.02, 0.05}, {0.01, -0.06}},
      {"Q1", {0.01, 0.0}, {0.02, 0.0}},    {"M4", {0.03, -0.01}, {0.0, 0.02}},
      {"MS4", {0.01, 0.01}, {0.02, 0.0}},  {"MN4", {0.004, 0.0}, {0.0, 0.004}},
      {"M6", {0.0, 0.01}, {0.005, 0.0}}};
  const Signal signal = tide_of(waves, {0.07, -0.03});
  const TideFit fit = fitted(sampled(signal, 30));
  // S2 carries K2 and K1 is absent: with S2 inferring K2 an S2-only sea is not in the model, so
  // compare without S2.
  std::vector<Wave> splittable = waves;
  std::erase_if(splittable, [](const Wave& w) { return w.name == "S2"; });
  const Signal exact = tide_of(splittable, {0.07, -0.03});
  const TideFit exact_fit = fitted(sampled(exact, 30));
  EXPECT_LT(exact_fit.residual_rms_m_s, 1e-12);
  EXPECT_NEAR(std::abs(exact_fit.mean - Horizontal(0.07, -0.03)), 0.0, 1e-12);
  for (const double t_h : {0.0, 100.3, 719.0, 1500.0})
    EXPECT_NEAR(std::abs(tide_at(exact_fit, add_hours(start, t_h)) - exact(add_hours(start, t_h))),
                0.0, 1e-11);
  EXPECT_EQ(find(exact_fit, "S2"),
            nullptr);  // absent from the sea: dropped by signal-to-noise, and named
  EXPECT_TRUE(says(exact_fit, "S2 dropped: signal-to-noise"));
  // The inferred K2 that is not there costs at most its share of S2.
  EXPECT_LT(fit.residual_rms_m_s, 0.272 * 0.14);
}

TEST(FitTide, PhasorsAreThoseOfTheSignal) {
  const Wave m2{"M2", {0.4, 0.1}, {-0.1, 0.2}};
  const TideFit fit = fitted(sampled(tide_of({m2}), 200));
  const TideTerm* term = find(fit, "M2");
  ASSERT_NE(term, nullptr);
  const Horizontal shift = std::polar(1.0, speed("M2") * seconds_between(start, fit.reference));
  EXPECT_NEAR(std::abs(term->counter_clockwise - m2.plus * shift), 0.0, 1e-12);
  EXPECT_NEAR(std::abs(term->clockwise - m2.minus * std::conj(shift)), 0.0, 1e-12);
}

TEST(FitTide, SplitsM2AndS2FromTheirRayleighLengthOn) {
  const std::vector<Wave> waves{{"M2", {0.4, 0.0}, {0.1, 0.0}}, {"S2", {0.0, 0.15}, {0.05, 0.0}}};
  const std::array<std::string_view, 2> names{"M2", "S2"};
  const Series series = sampled(tide_of(waves, {0.1, 0.1}), 15);
  const TideFit fit = fit_prescribed_tide(series.time, series.value, series.status, names);
  EXPECT_LT(fit.residual_rms_m_s, 1e-13);
  EXPECT_NEAR(std::abs(find(fit, "S2")->counter_clockwise), 0.15, 1e-12);
  EXPECT_EQ(find(fitted(series), "S2")->inferred_from, "");
  EXPECT_EQ(find(fitted(sampled(tide_of(waves), 14.7)), "S2")->inferred_from, "M2");
}

/// A tide with the equilibrium ratios and one phase lag per species: what inference assumes.
Signal equilibrium_like(const std::vector<std::pair<std::string, double>>& amplitudes) {
  return [=](UtcTime time) {
    Horizontal sum{};
    for (const auto& [name, amplitude] : amplitudes) {
      const double v = astronomical_argument_rad(tidal_constituent(name), time);
      sum += amplitude * (Horizontal(0.9, 0.2) * std::polar(1.0, v) +
                          Horizontal(-0.1, 0.4) * std::polar(1.0, -v));
    }
    return sum;
  };
}

TEST(FitTide, AShortRecordCarriesTheSpringNeapCycleByInference) {
  const Signal signal = equilibrium_like({{"M2", 0.5}, {"S2", 0.5 * 0.465}, {"N2", 0.5 * 0.191}});
  const Series series = sampled(signal, 5);
  const TideFit fit = fitted(series);
  // Exact but for the rates of the table against those of V (1e-8 rad an hour): five days and ten
  // days later.
  for (const double t_h : {50.0, 200.0, 360.0})
    EXPECT_NEAR(std::abs(tide_at(fit, add_hours(start, t_h)) - signal(add_hours(start, t_h))), 0.0,
                2e-5)
        << t_h;
  EXPECT_TRUE(says(fit, "S2 inferred from M2"));
  EXPECT_EQ(find(fit, "S2")->inferred_from, "M2");
}

TEST(FitTide, DiurnalTideOfAShortRecordCarriesO1AndP1) {
  const Signal signal = equilibrium_like({{"K1", 0.2}, {"O1", 0.2 * 0.711}, {"P1", 0.2 * 0.331}});
  const TideFit fit = fitted(sampled(signal, 10));
  EXPECT_NEAR(std::abs(tide_at(fit, add_hours(start, 400.0)) - signal(add_hours(start, 400.0))),
              0.0, 2e-5);
}

TEST(FitTide, UnderThreeDaysThereIsNoTideButAMean) {
  const TideFit fit = fitted(sampled([](UtcTime) { return Horizontal(0.2, -0.1); }, 2.9));
  EXPECT_TRUE(fit.terms.empty());
  EXPECT_NEAR(std::abs(fit.mean - Horizontal(0.2, -0.1)), 0.0, 1e-14);
  EXPECT_TRUE(says(fit, "shorter than 3"));
}

TEST(FitTide, TurningTheCurrentTurnsTheTide) {
  Rng random(11, "tide/rotation");
  Series series = sampled(
      tide_of({{"M2", {0.4, 0.1}, {0.1, -0.2}}, {"K1", {0.05, 0.0}, {0.1, 0.1}}}, {0.1, 0.0}), 20);
  for (Horizontal& value : series.value)
    value += Horizontal(random.normal(), random.normal()) * 0.02;
  Series turned = series;
  const Horizontal turn = std::polar(1.0, 0.7);
  for (Horizontal& value : turned.value) value *= turn;
  const TideFit a = fitted(series);
  const TideFit b = fitted(turned);
  ASSERT_EQ(a.terms.size(), b.terms.size());
  for (const double t_h : {3.0, 500.0}) {
    const UtcTime time = add_hours(start, t_h);
    EXPECT_NEAR(std::abs(tide_at(b, time) - turn * tide_at(a, time)), 0.0, 1e-12);
  }
}

TEST(FitTide, MeansAreFittedAsMeans) {
  const Wave m4{"M4", {0.2, 0.0}, {0.0, 0.1}};
  Series series;
  const Signal signal = tide_of({m4}, {0.05, 0.0});
  const double w = speed("M4");
  for (int i = 0; i < 200 * 8;
       ++i) {  // means over three hours, written out: sin(w D/2)/(w D/2) of the centre
    const UtcTime from = add_hours(start, 3.0 * i);
    series.time.push_back({from, from + std::chrono::hours(3)});
    const double half = 0.5 * w * 10800.0;
    const Horizontal mean(0.05, 0.0);
    series.value.push_back(mean + (signal(add_hours(from, 1.5)) - mean) * (std::sin(half) / half));
    series.status.push_back(SampleStatus::ok);
  }
  const TideFit fit = fitted(series);
  EXPECT_NEAR(std::abs(find(fit, "M4")->counter_clockwise), 0.2, 1e-12);
  const UtcTime time = add_hours(start, 77.7);
  EXPECT_NEAR(std::abs(tide_at(fit, time) - signal(time)), 0.0, 1e-11);
  EXPECT_NEAR(std::abs(tide_over(fit, series.time[9]) - series.value[9]), 0.0, 1e-11);
}

TEST(TideOver, TheMeanOverACellIsTheIntegralOfTheInstants) {
  const TideFit fit = fitted(sampled(
      tide_of({{"M2", {0.4, 0.1}, {0.1, -0.2}}, {"M4", {0.1, 0.0}, {0.0, 0.03}}}, {0.1, 0.2}),
      200));
  const TimeCell cell{add_hours(start, 10.0), add_hours(start, 16.0)};
  Horizontal sum{};
  constexpr int n = 2160;  // midpoints at whole 10 s: error (w dt)^2/24 = 4e-7 of the amplitude
  for (int i = 0; i < n; ++i)
    sum += tide_at(fit, cell.start + std::chrono::milliseconds(10000 * i + 5000));
  EXPECT_NEAR(std::abs(tide_over(fit, cell) - sum / double(n)), 0.0, 5e-7);
}

TEST(FitTide, GapsAndRejectedValuesDoNotBiasIt) {
  const Signal signal =
      tide_of({{"M2", {0.4, 0.1}, {0.1, -0.2}}, {"O1", {0.1, 0.0}, {0.0, 0.1}}}, {0.1, 0.2});
  Series series = sampled(signal, 200);
  for (std::size_t i = 0; i < series.value.size(); ++i) {
    if (i % 7 == 3 || (i > 900 && i < 1100)) {
      series.status[i] = i % 2 ? SampleStatus::suspect : SampleStatus::missing;
      series.value[i] = {45.0, std::nan("")};  // must never be read
    }
  }
  const TideFit fit = fitted(series);
  EXPECT_LT(fit.residual_rms_m_s, 1e-12);
  EXPECT_NEAR(std::abs(tide_at(fit, add_hours(start, 1000.0)) - signal(add_hours(start, 1000.0))),
              0.0, 1e-11);
}

TEST(FitTide, NoiseAloneGivesAlmostNoTide) {
  // Signal-to-noise of pure noise is about 1 for each of 4 real numbers; a few of the six may pass
  // 2 by chance.
  std::size_t kept = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng random(seed, "tide/noise");
    const TideFit fit = fitted(
        sampled([&](UtcTime) { return 0.1 * Horizontal(random.normal(), random.normal()); }, 20));
    for (const TideTerm& term : fit.terms) kept += term.inferred_from.empty() ? 1 : 0;
  }
  EXPECT_LT(static_cast<double>(kept) / (20.0 * 6.0), 0.25);  // P(chi2_4/4 > 2) = 9 %
}

TEST(FitTide, TheNoiseOfAnEstimateIsThatOfRepeatedRecords) {
  // The spread of M2 over 60 records against the spread the ratio claims; both know 60 numbers to
  // 10 %.
  const Signal signal = tide_of({{"M2", {0.2, 0.0}, {0.1, 0.0}}});
  double squares = 0;
  double claimed = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng random(seed, "tide/repeat");
    Series series = sampled(signal, 20);
    for (Horizontal& value : series.value)
      value += 0.2 * Horizontal(random.normal(), random.normal());
    const TideFit fit = fitted(series);
    const TideTerm* m2 = find(fit, "M2");
    ASSERT_NE(m2, nullptr) << "seed " << seed;
    const Horizontal shift = std::polar(1.0, speed("M2") * seconds_between(start, fit.reference));
    // The inferred N2 that is not there is a bias of its own; compare about the mean estimate only
    // in size.
    squares += std::norm(m2->counter_clockwise - 0.2 * shift) / 60.0;
    claimed += (std::norm(m2->counter_clockwise) + std::norm(m2->clockwise)) / m2->signal_to_noise /
               2.0 / 60.0;
  }
  EXPECT_GT(squares / claimed, 0.5);
  EXPECT_LT(squares / claimed, 5.0);
}

TEST(FitTide, DailyMeansAndSixHourlyInstantsLeaveOutWhatTheyCannotSee) {
  const TideFit six = fitted(sampled(tide_of({{"M2", {0.4, 0.1}, {0.1, -0.2}}}), 30, 6.0));
  EXPECT_EQ(find(six, "M4"), nullptr);
  EXPECT_EQ(find(six, "S2"), nullptr);  // twice a day at four values a day: the two senses are one
  EXPECT_TRUE(says(six, "M4 left out"));
  Series days;
  for (int i = 0; i < 20; ++i) {
    const UtcTime from = start + std::chrono::days(i);
    days.time.push_back({from, from + std::chrono::days(1)});
    days.value.emplace_back(0.1, 0.0);
    days.status.push_back(SampleStatus::ok);
  }
  EXPECT_TRUE(fitted(days).terms.empty());
}

/// A tide of one species with the equilibrium ratios, so that what rides on its carrier in a short
/// record is right: of the constituent of that name 0.3 m/s clockwise and 0.2 counter-clockwise.
struct OneSpecies {
  OneSpecies(const std::string& name, double latitude_deg, double days) {
    std::vector<std::pair<std::string, double>> ratios{{name, 1.0}};
    if (name == "M2") ratios = {{"M2", 1.0}, {"S2", 0.465}, {"N2", 0.191}};
    if (name == "K1") ratios = {{"K1", 1.0}, {"O1", 0.711}, {"P1", 0.331}};
    const Signal signal = [&](UtcTime time) {
      Horizontal sum(0.1, 0.0);
      for (const auto& [constituent, ratio] : ratios) {
        const double v = astronomical_argument_rad(tidal_constituent(constituent), time);
        sum += ratio * (0.2 * std::polar(1.0, v) + Horizontal(0.0, 0.3) * std::polar(1.0, -v));
      }
      return sum;
    };
    fit = fitted(sampled(signal, days), Angle::from_degrees(latitude_deg));
    const TideTerm* found = find(fit, name);
    EXPECT_NE(found, nullptr) << name << " in " << days << " days";
    if (found != nullptr) term = *found;
  }
  TideFit fit;
  TideTerm term;
};

TEST(FitTide, LeavesOutTheInertialSenseOfALineThatIsNoFurtherThanOneRayleighWidth) {
  struct Place {
    const char* name;
    double latitude_deg;
    double inside_days;   ///< | |w| - |f| | T < 2 pi
    double outside_days;  ///< and not any more; 0: not looked at
  };
  // |f| = 2.00548 sin(latitude) turns a day; K1 1.00274, O1 0.92954, M2 1.93227, N2 1.89598.
  for (const Place& at :
       {Place{"K1", 30, 300, 0}, Place{"K1", -30, 300, 0}, Place{"K1", 33, 10, 14},
        Place{"K1", -33, 10, 14}, Place{"O1", 27.6, 100, 0}, Place{"O1", -27.6, 100, 0},
        Place{"M2", 54, 3.1, 3.4}, Place{"N2", 71, 300, 0}, Place{"M2", 70, 15, 25},
        Place{"M2", -75, 150, 220}}) {
    SCOPED_TRACE(std::string(at.name) + " at " + std::to_string(at.latitude_deg));
    const OneSpecies inside(at.name, at.latitude_deg, at.inside_days);
    EXPECT_TRUE(inside.term.near_inertial);
    const bool is_north = at.latitude_deg > 0;
    EXPECT_EQ(is_north ? inside.term.clockwise : inside.term.counter_clockwise, Horizontal{});
    const double tolerance = 0.02;  // S2 carries a K2 that is not there, O1 a Q1
    EXPECT_NEAR(inside.term.left_out_m_s, is_north ? 0.3 : 0.2, tolerance);
    EXPECT_NEAR(std::abs(is_north ? inside.term.counter_clockwise : inside.term.clockwise),
                is_north ? 0.2 : 0.3, tolerance);
    EXPECT_TRUE(says(inside.fit, std::string(at.name) + " cannot be told from inertial motion"));
    EXPECT_TRUE(says(inside.fit, is_north ? "its clockwise part is left out"
                                          : "its counter-clockwise part is left out"));
    if (at.outside_days == 0) continue;
    const OneSpecies outside(at.name, at.latitude_deg, at.outside_days);
    EXPECT_FALSE(outside.term.near_inertial);
    EXPECT_EQ(outside.term.left_out_m_s, 0);
    EXPECT_NE(outside.term.clockwise, Horizontal{});
    EXPECT_NE(outside.term.counter_clockwise, Horizontal{});
  }
}

TEST(FitTide, NearTheEquatorNothingIsLeftOut) {
  for (const double latitude_deg : {0.0, 0.5, -3.0}) {
    for (const char* name : {"K1", "M2"}) {
      const OneSpecies line(name, latitude_deg, 10);
      EXPECT_FALSE(line.term.near_inertial);
      EXPECT_NE(line.term.clockwise, Horizontal{});
      EXPECT_NE(line.term.counter_clockwise, Horizontal{});
    }
  }
}

TEST(FitTide, OfACarrierAndItsRidersEachIsJudgedByItsOwnSpeed) {
  // At 26 degrees and in ten days O1, which rides on K1 there, is near-inertial and K1 is not.
  const Series series =
      sampled(equilibrium_like({{"K1", 0.3}, {"O1", 0.3 * 0.711}, {"P1", 0.3 * 0.331}}), 10);
  const TideFit fit = fitted(series, Angle::from_degrees(26.0));
  EXPECT_FALSE(find(fit, "K1")->near_inertial);
  EXPECT_TRUE(find(fit, "O1")->near_inertial);
  EXPECT_EQ(find(fit, "O1")->clockwise, Horizontal{});
  EXPECT_NE(find(fit, "K1")->clockwise, Horizontal{});
}

TEST(FitTide, AClusterOfTimesDropsWhatItCannotDetermine) {
  // Two bursts of two hours 20 days apart determine next to nothing.
  Series series = sampled(tide_of({{"M2", {0.4, 0.1}, {0.1, -0.2}}}), 20, 0.25);
  for (std::size_t i = 8; i + 8 < series.status.size(); ++i)
    series.status[i] = SampleStatus::missing;
  const TideFit fit = fitted(series);
  EXPECT_LT(fit.terms.size(), 6u);
  EXPECT_TRUE(says(fit, "condition number"));
  for (const TideTerm& term : fit.terms) EXPECT_LT(std::abs(term.counter_clockwise), 10.0);
}

TEST(FitTide, AnEmptyRecordSaysSo) {
  const TideFit fit = fit_tide({}, {}, {}, latitude);
  EXPECT_TRUE(fit.terms.empty());
  EXPECT_TRUE(says(fit, "no value"));
  const std::vector<TimeCell> one(1);
  EXPECT_THROW((void)fit_tide(one, {}, {}, latitude), ContractViolation);
}

TEST(RecordLength, CountsTheStepOfTheLastInstant) {
  const Series series = sampled([](UtcTime) { return Horizontal(); }, 15);
  EXPECT_EQ(record_length(series.time, series.status), std::chrono::hours(360));
}

}  // namespace
}  // namespace slackwater::tide_test
