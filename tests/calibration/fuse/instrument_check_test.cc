#include "calibration/fuse/instrument_check.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "calibration/fuse/fusion.h"
#include "tests/calibration/fuse/made_up_sea.h"

namespace slackwater::calibration::tests::instrument_check_test {
namespace {

constexpr int hours_in_all = 16 * 24;
const UtcTime until = add_hours(sea_start, hours_in_all);
const std::vector<double> product_depths{0, 5, 10, 20, 30};
const std::vector<double> bins{4, 10, 16, 22};
constexpr double distance_m = 2000;

/// A tide on an ellipse, and a drift that turns within a fortnight.
Horizontal truth(double hour, double depth_m) {
  const RotaryTide m2{{0.315, 0}, {0.135, 0}};
  return (1 - 0.3 * std::pow(depth_m / 30, 3)) * m2.at(hour) +
         (1 - 0.5 * depth_m / 30) * std::polar(0.06, 2 * std::numbers::pi * hour / 340);
}

/// A product that errs as products do, and an instrument 2 km away that says what it sees.
struct Twin {
  explicit Twin(std::uint64_t seed)
      : random(seed, "instrument_check"),
        slow(random, 0.10, 96, hours_in_all),
        quick(random, 0.04, 4, hours_in_all),
        elsewhere(random, 0.04, 30, hours_in_all) {}

  [[nodiscard]] VectorColumn product() const {
    return made_up_column(product_depths, hours_in_all, 1, [&](double h, double z) {
      return truth(h, z) + slow.at(h) + quick.at(h);
    });
  }
  [[nodiscard]] Horizontal seen(double hour, double depth_m, double noise_m_s = 0.02) {
    return truth(hour, depth_m) + elsewhere.at(hour) +
           noise_m_s * Horizontal{random.normal(), random.normal()};
  }
  /// Every ten minutes.
  VectorColumn instrument(const FlowOfHours& flow) const {
    return made_up_column(bins, hours_in_all, 1.0 / 6, flow);
  }
  VectorColumn honest(double noise_m_s = 0.02) {
    return instrument([&](double h, double z) { return seen(h, z, noise_m_s); });
  }

  Rng random;
  RedSeries slow;
  RedSeries quick;
  RedSeries elsewhere;
};

MooredInstrumentVerdict verdict_on(const VectorColumn& product, const VectorColumn& instrument) {
  return check_instrument(product, instrument, distance_m, until);
}

void expect_rejected(const MooredInstrumentVerdict& verdict, const std::string& because) {
  EXPECT_EQ(verdict.use, MooredInstrumentUse::rejected);
  EXPECT_NE(verdict.why.find(because), std::string::npos) << "said: " << verdict.why;
}

TEST(InstrumentCheck, AnHonestInstrumentIsUsedWholeAndNothingIsSaid) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Twin twin(seed);
    const VectorColumn instrument = twin.honest();
    const MooredInstrumentVerdict verdict = verdict_on(twin.product(), instrument);
    EXPECT_EQ(verdict.use, MooredInstrumentUse::used) << verdict.why;
    EXPECT_TRUE(verdict.remarks.empty()) << verdict.remarks.front();
    EXPECT_EQ(verdict.column.status, instrument.status);
    for (const double noise : verdict.errors.noise_m_s) EXPECT_NEAR(noise, 0.02, 0.002);
  }
}

TEST(InstrumentCheck, ABiasNoProductExplainsIsRejectedWithItsFigure) {
  Twin twin(2);
  const VectorColumn biased = twin.instrument([&](double h, double z) {
    return twin.seen(h, z) + Horizontal{0.6, -0.8};
  });
  const MooredInstrumentVerdict verdict = verdict_on(twin.product(), biased);
  expect_rejected(verdict, "it differs from the product by ");
  expect_rejected(verdict, " m/s on average over 16.0 days; expected at most 0.6");
}

TEST(InstrumentCheck, ABiasThatBeganYesterdayIsSeenThoughTheRecordIsLong) {
  Twin twin(3);
  const VectorColumn biased = twin.instrument([&](double h, double z) {
    return twin.seen(h, z) + (h > hours_in_all - 30 ? Horizontal{0, 1} : Horizontal{});
  });
  expect_rejected(verdict_on(twin.product(), biased), "on average over 26 h");
}

TEST(InstrumentCheck, ABiasAsProductsHaveIsLeftToTheFusion) {
  Twin twin(4);
  const VectorColumn biased = twin.instrument([&](double h, double z) {
    return twin.seen(h, z) + Horizontal{0.2, 0.1};
  });
  EXPECT_EQ(verdict_on(twin.product(), biased).use, MooredInstrumentUse::used);
}

TEST(InstrumentCheck, AWrongSignIsRejected) {
  Twin twin(5);
  const VectorColumn wrong = twin.instrument([&](double h, double z) { return -twin.seen(h, z); });
  expect_rejected(verdict_on(twin.product(), wrong), "its tide runs opposite to the product's");
}

TEST(InstrumentCheck, ADeclinationOfThirtyDegreesIsRejectedWithItsAngleAndSense) {
  Twin twin(6);
  for (const double degrees : {30.0, -30.0, 90.0}) {
    const Horizontal turn = std::polar(1.0, -degrees * std::numbers::pi / 180);
    const VectorColumn wrong =
        twin.instrument([&](double h, double z) { return turn * twin.seen(h, z); });
    const MooredInstrumentVerdict verdict = verdict_on(twin.product(), wrong);
    expect_rejected(verdict, degrees > 0 ? " degrees clockwise" : " degrees anticlockwise");
    const double said = std::stod(verdict.why.substr(verdict.why.find(" turned ") + 8));
    EXPECT_NEAR(said, std::abs(degrees), 5) << verdict.why;
  }
}

TEST(InstrumentCheck, AClockThreeHoursOffIsSeenInTheTideWithItsSign) {
  Twin twin(7);
  for (const double late_h : {3.0, -3.0, 2.0}) {
    const VectorColumn wrong =
        twin.instrument([&](double h, double z) { return twin.seen(h - late_h, z); });
    const MooredInstrumentVerdict verdict = verdict_on(twin.product(), wrong);
    expect_rejected(verdict, late_h > 0 ? " h late compared" : " h early compared");
    const double said = std::stod(verdict.why.substr(verdict.why.find(" is ") + 4));
    EXPECT_NEAR(said, std::abs(late_h), 0.5) << verdict.why;
  }
}

TEST(InstrumentCheck, ATideInACircleCannotTellAClockFromAFrameAndSaysBoth) {
  const RotaryTide circle{{0.5, 0}, {0, 0}};
  const VectorColumn product = made_up_column(product_depths, hours_in_all, 1,
                                              [&](double h, double) { return circle.at(h); });
  const VectorColumn late =
      made_up_column(bins, hours_in_all, 0.5, [&](double h, double) { return circle.at(h - 3); });
  const MooredInstrumentVerdict verdict = verdict_on(product, late);
  expect_rejected(verdict, "degrees");
  expect_rejected(verdict, " h late");
}

TEST(InstrumentCheck, WhatAGoodProductMayErrInItsTideIsNoFaultOfTheInstrument) {
  Twin twin(8);
  const Horizontal turn = std::polar(1.0, 12 * std::numbers::pi / 180);
  const VectorColumn other =
      twin.instrument([&](double h, double z) { return 1.3 * turn * twin.seen(h - 0.7, z); });
  const MooredInstrumentVerdict verdict = verdict_on(twin.product(), other);
  EXPECT_EQ(verdict.use, MooredInstrumentUse::used) << verdict.why;
}

TEST(InstrumentCheck, BesideAProductWithoutTideTheInstrumentIsNotBlamedForSeeingIt) {
  Twin twin(9);
  const VectorColumn instrument = twin.instrument([&](double h, double z) {
    return twin.seen(h, z) + 2.0 * truth(h, z);  // 1.35 m/s of tide
  });
  const auto drift = [&](double h, double) { return twin.slow.at(h); };
  for (const double step_h : {1.0, 24.0}) {
    const VectorColumn product =
        made_up_column(product_depths, hours_in_all, step_h, drift, step_h > 1);
    const MooredInstrumentVerdict verdict = verdict_on(product, instrument);
    EXPECT_EQ(verdict.use, MooredInstrumentUse::used) << verdict.why;
    EXPECT_TRUE(verdict.remarks.empty());
  }
}

TEST(InstrumentCheck, AnInstrumentThatEndedIsNotUsedWhenLittleOfItIsRemembered) {
  Twin twin(10);
  const auto ended = [&](double days) {
    VectorColumn instrument = twin.honest();
    for (std::size_t t = 0; t < instrument.times(); ++t) {
      if (hours_between(instrument.time[t].centre(), until) >= 24 * days) continue;
      for (std::size_t k = 0; k < bins.size(); ++k)
        instrument.status[instrument.offset(t, k)] = SampleStatus::missing;
    }
    return verdict_on(twin.product(), instrument);
  };
  EXPECT_EQ(ended(4).use, MooredInstrumentUse::ended);
  EXPECT_EQ(ended(4).why, "it ended 4.0 days before");
  const MooredInstrumentVerdict lately = ended(2);
  EXPECT_EQ(lately.use, MooredInstrumentUse::used);
  ASSERT_EQ(lately.remarks.size(), 1U);
  EXPECT_EQ(lately.remarks[0], "its last good value is 2.0 days before the end of the day");
  EXPECT_TRUE(ended(0.2).remarks.empty());
}

TEST(InstrumentCheck, OneThatSpeaksOfOtherDepthsIsApart) {
  Twin twin(11);
  const VectorColumn deep =
      made_up_column({40, 50}, hours_in_all, 1, [](double h, double) { return truth(h, 30); });
  EXPECT_EQ(verdict_on(twin.product(), deep).use, MooredInstrumentUse::apart);
}

TEST(InstrumentCheck, AStatedErrorBeyondTheNoiseLasts) {
  Twin twin(12);
  const auto lasting = [&](double noise_m_s, double stated_m_s) {
    return check_instrument(twin.product(), twin.honest(noise_m_s), distance_m, until, stated_m_s)
        .errors.lasting_m_s;
  };
  EXPECT_NEAR(lasting(0.02, 0.20), std::sqrt(0.04 - 0.0004), 1e-3);
  EXPECT_NEAR(lasting(0.12, 0.20), 0.16, 0.01);
  EXPECT_EQ(lasting(0.12, 0.05), 0) << "it shows more than it states";
  EXPECT_EQ(lasting(0.02, 0.01), 0) << "nobody is trusted beyond what profilers do in the tank";
}

/// Errors of D+1's start: the fused column's at the last time, over draws.
struct Errors {
  double product = 0;
  double fused = 0;
};

Errors errors_at_the_end(double noise_m_s) {
  Errors sum;
  for (std::uint64_t seed = 100; seed < 115; ++seed) {
    Twin twin(seed);
    const VectorColumn product = twin.product();
    const MooredInstrumentVerdict verdict = verdict_on(product, twin.honest(noise_m_s));
    EXPECT_EQ(verdict.use, MooredInstrumentUse::used) << verdict.why;
    const FusedColumn fused = fuse(product, verdict.column, distance_m, {}, verdict.errors);
    for (std::size_t t = product.times() - 24; t < product.times(); ++t) {
      for (std::size_t k = 0; k < product.levels(); ++k) {
        const std::size_t o = product.offset(t, k);
        const Horizontal right =
            truth(hours_between(sea_start, product.time[t].centre()), product.levels_m[k]);
        sum.product += std::norm(product.value[o] - right);
        sum.fused += std::norm(fused.column.value[o] - right);
      }
    }
  }
  return {std::sqrt(sum.product), std::sqrt(sum.fused)};
}

TEST(InstrumentCheck, ANoisyInstrumentCountsForLessAndStillHelps) {
  const Errors quiet = errors_at_the_end(0.02);
  const Errors loud = errors_at_the_end(0.3);
  std::printf("error of the fused column over that of the product: noise 0.02 %.3f, 0.3 %.3f\n",
              quiet.fused / quiet.product, loud.fused / loud.product);
  EXPECT_LT(quiet.fused, 0.75 * quiet.product);
  EXPECT_LT(loud.fused, 0.95 * loud.product);
  EXPECT_GT(loud.fused, quiet.fused);
  Twin twin(13);
  const MooredInstrumentVerdict verdict = verdict_on(twin.product(), twin.honest(0.3));
  ASSERT_EQ(verdict.remarks.size(), 1U);
  EXPECT_EQ(verdict.remarks[0].substr(0, 25), "its values scatter by 0.3") << verdict.remarks[0];
}

/// A sea, a product and an instrument as they may honestly be.
struct HonestPair {
  VectorColumn product;
  VectorColumn instrument;
};

HonestPair honest_pair(std::uint64_t seed) {
  Rng random(seed, "honest instruments");
  const double hours = random.uniform(30, 24 * 30);
  const int all = static_cast<int>(hours) + 2;
  const auto angle = [&](double degrees) {
    return std::polar(1.0, random.normal() * degrees * std::numbers::pi / 180);
  };
  // Tide: ellipses of any shape; the product errs in size, phase and orientation.
  const double size = std::exp(random.uniform(std::log(0.03), std::log(1.2)));
  std::vector<RotaryTide> seen;
  std::vector<RotaryTide> modelled;
  for (const double period : {12.4206, 12.0, 25.82, 6.2103}) {
    const double share = period == 12.4206 ? 1 : period == 6.2103 ? 0.1 : 0.3;
    RotaryTide tide{size * share * random.uniform() * std::polar(1.0, random.uniform(-3.14, 3.14)),
                    size * share * random.uniform() * std::polar(1.0, random.uniform(-3.14, 3.14)),
                    period};
    seen.push_back(tide);
    const double larger = 1 + 0.15 * random.normal();
    const Horizontal turn = angle(7);
    const Horizontal phase = angle(12);
    tide.anticlockwise *= larger * turn * phase;
    tide.clockwise *= larger * turn * std::conj(phase);
    modelled.push_back(tide);
  }
  const RedSeries eddies(random, random.uniform(0.02, 0.25), random.uniform(40, 200), all);
  const RedSeries slow(random, random.uniform(0.02, 0.15), random.uniform(30, 200), all);
  const RedSeries quick(random, random.uniform(0.01, 0.06), random.uniform(2, 8), all);
  const RedSeries elsewhere(random, random.uniform(0.01, 0.08), random.uniform(5, 60), all);
  // Inertial motion: it decays and is stirred anew; the product has its own phases.
  const RedSeries free(random, random.uniform(0, 0.12), 60, all);
  const RedSeries modelled_free(random, random.uniform(0, 0.12), 60, all);
  const Horizontal mean = std::polar(random.uniform(0, 0.6), random.uniform(-3.14, 3.14));
  const double noise = std::exp(random.uniform(std::log(0.005), std::log(0.15)));
  const bool has_tide = random.uniform() < 0.7;
  const auto inertial = [](const RedSeries& amplitude, double h) {
    return amplitude.at(h) * std::polar(1.0, -2 * std::numbers::pi * h / 14.8);
  };
  const double steps[] = {1, 1, 1, 3, 6, 24};
  const double step_h = steps[static_cast<int>(random.uniform(0, 5.999))];
  const bool means = step_h >= 24 || (step_h <= 1 && random.uniform() < 0.4);
  HonestPair pair;
  pair.product = made_up_column(
      product_depths, std::floor(hours / step_h) * step_h, step_h,
      [&](double h, double z) {
        Horizontal sum =
            mean + eddies.at(h) + slow.at(h) + quick.at(h) + inertial(modelled_free, h);
        for (const RotaryTide& tide : modelled)
          if (has_tide && step_h < 24) sum += (1 - 0.01 * z) * tide.at(h);
        return sum;
      },
      means);
  const double samplings[] = {1.0 / 6, 0.5, 1};
  const double resolution = random.uniform() < 0.3 ? 0.01 : 0.001;
  pair.instrument = made_up_column(
      bins, hours, samplings[static_cast<int>(random.uniform(0, 2.999))], [&](double h, double z) {
        Horizontal sum = mean + eddies.at(h) + elsewhere.at(h) + inertial(free, h) +
                         noise * Horizontal{random.normal(), random.normal()};
        for (const RotaryTide& tide : seen) sum += (1 - 0.01 * z) * tide.at(h);
        return Horizontal{resolution * std::round(sum.real() / resolution),
                          resolution * std::round(sum.imag() / resolution)};
      });
  return pair;
}

TEST(InstrumentCheck, OfThreeHundredHonestInstrumentsNoneIsRejected) {
  int rejected = 0;
  std::size_t broken = 0;
  std::size_t values = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const HonestPair pair = honest_pair(seed);
    const MooredInstrumentVerdict verdict = check_instrument(
        pair.product, pair.instrument, distance_m, pair.instrument.time.back().end);
    if (verdict.use != MooredInstrumentUse::used) {
      ++rejected;
      std::printf("seed %d: %s\n", static_cast<int>(seed), verdict.why.c_str());
    }
    values += verdict.column.status.size();
    const auto now = static_cast<std::size_t>(std::count(
        verdict.column.status.begin(), verdict.column.status.end(), SampleStatus::suspect));
    broken += now;
    if (now > 0)
      std::printf("seed %d: %zu of %zu values, noise %.3f m/s: %s\n", static_cast<int>(seed), now,
                  verdict.column.status.size(), verdict.errors.noise_m_s.front(),
                  verdict.remarks.front().c_str());
  }
  std::printf("rejected %d of 300, broken %zu of %zu values\n", rejected, broken, values);
  // None in three hundred: less than one in a hundred with 95 % confidence.
  EXPECT_EQ(rejected, 0);
  EXPECT_LE(broken * 100000, values);
}

}  // namespace
}  // namespace slackwater::calibration::tests::instrument_check_test
