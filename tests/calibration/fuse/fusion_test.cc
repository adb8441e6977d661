#include "calibration/fuse/fusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "calibration/fuse/observed_at.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration::tests::fusion_test {
namespace {

const UtcTime start = parse_utc("2024-03-01T00:00:00Z");

VectorColumn column(const std::vector<double>& depths_m, int hours, double step_h,
                    const std::function<Horizontal(double, double)>& value) {
  VectorColumn out;
  out.vertical = VerticalKind::depth_m;
  out.levels_m = depths_m;
  const int times = static_cast<int>(hours / step_h) + 1;
  for (int t = 0; t < times; ++t) {
    out.time.push_back(TimeCell::instant(add_hours(start, t * step_h)));
    out.source.push_back(DataStatus::analysis);
    for (const double depth : depths_m) {
      out.value.push_back(value(t * step_h, depth));
      out.status.push_back(SampleStatus::ok);
    }
  }
  return out;
}

/// A tide that both see, so that the product lacks no variance.
Horizontal tide(double hour) { return std::polar(0.4, 0.5059 * hour); }

TEST(Fusion, OneObservationIsWeighedAsTheTextbookWeighsIt) {
  // One level, one time: e^ = w P_s / (P_s + I) d with P_s = P + R, and Var = P - w^2 P_s^2/(P_s +
  // I).
  const VectorColumn product = column({10}, 0, 1, [](double, double) {
    return Horizontal{0.2, 0};
  });
  const VectorColumn seen = column({10}, 0, 1, [](double, double) { return Horizontal{0.5, 0.1}; });
  const FusionSettings s;
  const double distance = 3000;
  const double p = s.product_error_m_s * s.product_error_m_s;
  const double r = std::pow(s.difference_m_s * std::cbrt(distance / s.difference_m), 2);
  const double i = s.instrument_error_m_s * s.instrument_error_m_s;
  const double w = p * std::exp(-distance / s.product_length_m) / (p + r);
  const FusedColumn fused = fuse(product, seen, distance);
  EXPECT_NEAR(fused.weight, w, 1e-12);
  const Horizontal wanted = Horizontal{0.2, 0} + w * (p + r) / (p + r + i) * Horizontal{0.3, 0.1};
  EXPECT_NEAR(std::abs(fused.column.value[0] - wanted), 0, 1e-12);
  EXPECT_NEAR(fused.sigma_m_s[0], std::sqrt(p - w * w * (p + r) * (p + r) / (p + r + i)), 1e-12);
}

TEST(Fusion, AnObservationSpreadsInDepthAsTheErrorsDo) {
  const VectorColumn product =
      column({0, 10, 35}, 0, 1, [](double, double) { return Horizontal{}; });
  const VectorColumn seen = column({10}, 0, 1, [](double, double) { return Horizontal{0.1, 0}; });
  const FusedColumn fused = fuse(product, seen, 0);
  const double at = fused.column.value[1].real();
  EXPECT_NEAR(fused.column.value[0].real() / at, std::exp(-10 / 25.0), 1e-12);
  EXPECT_NEAR(fused.column.value[2].real() / at, std::exp(-25 / 25.0), 1e-12);
  EXPECT_LT(fused.sigma_m_s[1], fused.sigma_m_s[0]);
  EXPECT_LT(fused.sigma_m_s[0], fused.sigma_m_s[2]);
}

TEST(Fusion, TheFartherTheInstrumentTheLessItCounts) {
  double before = 1.0001;
  for (const double distance : {0.0, 100.0, 500.0, 2000.0, 5000.0, 10000.0}) {
    const double weight = weight_at(distance);
    EXPECT_LT(weight, before) << distance;
    before = weight;
  }
  EXPECT_DOUBLE_EQ(weight_at(0), 1.0);
  const VectorColumn product = column({10}, 5, 1, [](double h, double) { return tide(h); });
  const VectorColumn wrong = column({10}, 5, 1, [](double, double) { return Horizontal{3, 3}; });
  const FusedColumn fused = fuse(product, wrong, 10001);
  EXPECT_EQ(fused.column.value, product.value);
  EXPECT_EQ(fused.times_observed, 0U);
}

TEST(Fusion, APersistentErrorIsCarriedBeyondTheLastObservationAndThenForgotten) {
  const Horizontal error{0.12, -0.05};
  const VectorColumn product = column({5, 20}, 400, 1, [](double h, double) { return tide(h); });
  const VectorColumn seen =
      column({5, 20}, 72, 1, [&](double h, double) { return tide(h) - error; });
  const FusedColumn fused = fuse(product, seen, 0);
  const auto departure = [&](int hour) {
    const std::size_t o = product.offset(static_cast<std::size_t>(hour), 0);
    return std::abs(fused.column.value[o] - (product.value[o] - error)) / std::abs(error);
  };
  EXPECT_LT(departure(72), 0.05);          // observed
  EXPECT_LT(departure(72 + 12), 0.35);     // carried
  EXPECT_GT(departure(72 + 300), 0.95);    // forgotten
  EXPECT_LT(departure(72 + 300), 1.0001);  // and never worse than the product
  const auto sigma = [&](int hour) {
    return fused.sigma_m_s[product.offset(static_cast<std::size_t>(hour), 0)];
  };
  EXPECT_LT(sigma(72), sigma(84));
  EXPECT_NEAR(sigma(372), FusionSettings{}.product_error_m_s, 1e-3);
}

TEST(Fusion, NothingIsKnownBeforeItIsSeen) {
  const VectorColumn product = column({5}, 48, 1, [](double h, double) { return tide(h); });
  VectorColumn seen = column({5}, 48, 1, [](double h, double) { return tide(h) + 0.1; });
  for (std::size_t t = 0; t < 24; ++t) seen.status[t] = SampleStatus::missing;
  const FusedColumn fused = fuse(product, seen, 0);
  for (std::size_t t = 0; t < 24; ++t) EXPECT_EQ(fused.column.value[t], product.value[t]) << t;
  // A later sample changes nothing earlier.
  VectorColumn longer = seen;
  longer.value.back() *= 0.3;  // less, so that the product still lacks no variance
  const FusedColumn other = fuse(product, longer, 0);
  for (std::size_t t = 0; t < 48; ++t)
    EXPECT_NEAR(std::abs(fused.column.value[t] - other.column.value[t]), 0, 1e-12) << t;
  EXPECT_GT(std::abs(fused.column.value[48] - other.column.value[48]), 0.1);
}

TEST(Fusion, TheKeptGainIsTheGainThatWouldBeComputed) {
  // The same series, once with a level that comes and goes: its gain is never kept.
  const VectorColumn product =
      column({3, 12, 24}, 600, 1, [](double h, double) { return tide(h); });
  VectorColumn seen =
      column({8, 20}, 600, 1, [](double h, double z) { return tide(h + 0.1) + 0.002 * z; });
  const FusedColumn kept = fuse(product, seen, 800);
  // At hour 590 it goes for one hour; ten hours later nothing is left of that but rounding and what
  // the slow part remembers of one missed value among hundreds.
  seen.status[seen.offset(590, 1)] = SampleStatus::missing;
  const FusedColumn computed = fuse(product, seen, 800);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t o = product.offset(600, k);
    EXPECT_NEAR(std::abs(kept.column.value[o] - computed.column.value[o]), 0, 2e-4);
    EXPECT_NEAR(kept.sigma_m_s[o], computed.sigma_m_s[o], 2e-5);
  }
}

TEST(Fusion, TurningTheAxesTurnsTheResult) {
  const Horizontal turn = std::polar(1.0, 1.1);
  const auto product_value = [](double h, double z) { return tide(h) * (1 - z / 60); };
  const auto seen_value = [](double h, double z) { return tide(h + 0.3) * (1 - z / 80) + 0.05; };
  const FusedColumn plain =
      fuse(column({3, 12, 24}, 48, 1, product_value), column({8, 20}, 48, 0.5, seen_value), 1500);
  const FusedColumn turned = fuse(
      column({3, 12, 24}, 48, 1, [&](double h, double z) { return turn * product_value(h, z); }),
      column({8, 20}, 48, 0.5, [&](double h, double z) { return turn * seen_value(h, z); }), 1500);
  for (std::size_t i = 0; i < plain.column.value.size(); ++i) {
    EXPECT_NEAR(std::abs(turn * plain.column.value[i] - turned.column.value[i]), 0, 1e-12);
    EXPECT_NEAR(plain.sigma_m_s[i], turned.sigma_m_s[i], 1e-12);
  }
}

TEST(Fusion, AProductWithoutTideTakesItFromAStationSomeKilometresOff) {
  const VectorColumn product = column({5, 20}, 96, 1, [](double, double) {
    return Horizontal{0.05, 0};
  });
  const VectorColumn seen = column({5, 20}, 96, 1, [](double h, double) { return 0.05 + tide(h); });
  const FusedColumn fused = fuse(product, seen, 5000);
  EXPECT_GT(fused.weight, 0.9);  // the tide is the same there; a product's bias need not be
  const std::size_t last = product.offset(96, 0);
  EXPECT_NEAR(std::abs(fused.column.value[last] - seen.value.back()), 0, 0.05);
}

TEST(Fusion, AnErrorThatLastsWeakensTheInstrumentAndItsNoiseDoesNotStrengthenIt) {
  const VectorColumn product = column({5, 20}, 96, 1, [](double h, double) { return tide(h); });
  Rng random(7, "fusion/errors");
  const VectorColumn seen = column({5, 20}, 96, 1, [&](double h, double) {
    return tide(h) + 0.3 * Horizontal{random.normal(), random.normal()};
  });
  const double plain = weight_at(2000);
  EXPECT_GT(fuse(product, seen, 2000).weight, plain + 0.1) << "noise taken for a tide it lacks";
  const FusedColumn known = fuse(product, seen, 2000, {}, {{0.3, 0.3}, 0});
  EXPECT_NEAR(known.weight, plain, 0.15) << "a sample of 2 x 97 values";
  const FusedColumn doubted = fuse(product, seen, 2000, {}, {{0.3, 0.3}, 0.2});
  EXPECT_LT(doubted.weight, 0.5 * known.weight);
  EXPECT_GT(doubted.sigma_m_s.back(), known.sigma_m_s.back());
}

TEST(Fusion, TheNoiseOfASampleAveragesOutOverAMean) {
  // One hourly mean of six samples: R is a sixth of theirs.
  VectorColumn product = column({10}, 0, 1, [](double, double) { return Horizontal{}; });
  product.time[0] = {start, add_hours(start, 1)};
  const VectorColumn seen = column({10}, 1, 1.0 / 6, [](double, double) {
    return Horizontal{0.3, 0};
  });
  const FusionSettings s;
  const double p = s.product_error_m_s * s.product_error_m_s;
  const FusedColumn fused = fuse(product, seen, 0, {}, {{0.3}, 0});
  EXPECT_NEAR(fused.column.value[0].real(), 0.3 * p / (p + 0.09 / 6), 1e-12);
}

TEST(Fusion, TheNoiseOfEachValueIsWhatAnotherSampleWouldMoveItBy) {
  // One moment, two thousand readings of it; the product varies more, so that it lacks nothing.
  const auto water = [](double, double depth) { return Horizontal{0.02 * depth, 0}; };
  const VectorColumn product =
      column({5, 12, 40}, 0, 1, [&](double h, double depth) { return 2.0 * water(h, depth); });
  Rng random(8, "fusion/fresh_noise");
  std::vector<double> squares(3);
  std::vector<Horizontal> sum(3);
  std::vector<double> stated;
  constexpr int readings = 2000;
  for (int reading = 0; reading < readings; ++reading) {
    const VectorColumn seen = column({5, 12, 40}, 0, 1, [&](double h, double depth) {
      const double east = random.normal();
      return water(h, depth) + 0.05 * Horizontal{east, random.normal()};
    });
    const FusedColumn fused = fuse(product, seen, 300, {}, {{0.05, 0.05, 0.05}, 0});
    stated = fused.noise_m_s;
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += fused.column.value[k] / double(readings);
      squares[k] += 0.5 * std::norm(fused.column.value[k]) / readings;
    }
  }
  ASSERT_EQ(stated.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const double found = std::sqrt(squares[k] - 0.5 * std::norm(sum[k]));
    EXPECT_NEAR(stated[k] / found, 1.0, 0.05) << k;
    EXPECT_LT(stated[k], 0.05);
  }
  const FusedColumn far = fuse(product, product, 20000);
  EXPECT_EQ(far.noise_m_s, std::vector<double>(3, 0.0)) << "nobody was heard";
}

TEST(Fusion, StatedErrorsAreThoseFoundWhereTheErrorsAreAsStated) {
  // 300 draws of the very process that is assumed, 24 h each: the error over its sigma has unit
  // variance (300 x 2 components: 5 % is 1.7 standard deviations of it).
  const FusionSettings s;
  const double distance = 2000;
  Rng random(20240301, "fusion/stated_errors");
  double squares = 0;
  int count = 0;
  for (int draw = 0; draw < 300; ++draw) {
    const auto ar1 = [&](double sigma, double memory_h, std::vector<Horizontal>& series) {
      Horizontal x = sigma * Horizontal{random.normal(), random.normal()};
      const double a = std::exp(-1 / memory_h);
      for (Horizontal& value : series) {
        value += x;
        x = a * x + sigma * std::sqrt(1 - a * a) * Horizontal{random.normal(), random.normal()};
      }
    };
    const double half = std::sqrt(0.5);
    const double r = s.difference_m_s * std::cbrt(distance / s.difference_m);
    const double rho = std::exp(-distance / s.product_length_m);
    // e at the site and at the station share rho of the variance.
    std::vector<Horizontal> at_site(25), at_station(25);
    std::vector<Horizontal> common(25), own_site(25), own_station(25), difference(25);
    for (const double memory : {s.slow_memory_h, s.quick_memory_h}) {
      ar1(half * s.product_error_m_s * std::sqrt(rho), memory, common);
      ar1(half * s.product_error_m_s * std::sqrt(1 - rho), memory, own_site);
      ar1(half * s.product_error_m_s * std::sqrt(1 - rho), memory, own_station);
      ar1(half * r, memory, difference);
    }
    for (std::size_t t = 0; t < 25; ++t) {
      at_site[t] = common[t] + own_site[t];
      at_station[t] = common[t] + own_station[t] + difference[t];
    }
    const auto index = [](double h) { return static_cast<std::size_t>(h + 0.5); };
    // A strong tide in both hides the sampling noise of "variance lacking".
    const VectorColumn product =
        column({10}, 24, 1, [&](double h, double) { return 10.0 * tide(h) + at_site[index(h)]; });
    const VectorColumn seen = column({10}, 24, 1, [&](double h, double) {
      return 10.0 * tide(h) + at_site[index(h)] - at_station[index(h)] +
             s.instrument_error_m_s * Horizontal{random.normal(), random.normal()};
    });
    const FusedColumn fused = fuse(product, seen, distance, s);
    const Horizontal truth = 10.0 * tide(24);
    squares += std::norm((fused.column.value[24] - truth) / fused.sigma_m_s[24]);
    count += 2;
  }
  EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.08);
}

TEST(ObservedLevel, AMeanTakesTheSamplesOfItsCellAndAnInstantItsNeighbours) {
  const VectorColumn seen = column({5}, 6, 1.0 / 6, [](double h, double) {
    return Horizontal{h, 0};
  });
  const ObservedLevel level(seen, 0, {});
  const TimeCell hour{add_hours(start, 2), add_hours(start, 3)};
  ASSERT_TRUE(level.at(hour));
  EXPECT_NEAR(level.at(hour)->real(), 2.5, 1e-9);
  EXPECT_NEAR(level.at(TimeCell::instant(add_hours(start, 2.25)))->real(), 2.25, 1e-9);
  EXPECT_FALSE(level.at(TimeCell::instant(add_hours(start, 7))));
  const TimeCell half_empty{add_hours(start, 5.7), add_hours(start, 6.7)};
  EXPECT_FALSE(level.at(half_empty));  // 0.3 h of 1 h are observed
}

TEST(ObservedLevel, AGapWiderThanStatedIsNotBridged) {
  const VectorColumn seen = column({5}, 12, 2, [](double h, double) { return Horizontal{h, 0}; });
  EXPECT_FALSE(ObservedLevel(seen, 0, {}).at(TimeCell::instant(add_hours(start, 3))));
  FusionSettings patient;
  patient.widest_gap = std::chrono::hours(2);
  EXPECT_NEAR(ObservedLevel(seen, 0, patient).at(TimeCell::instant(add_hours(start, 3)))->real(), 3,
              1e-12);
}

}  // namespace
}  // namespace slackwater::calibration::tests::fusion_test
