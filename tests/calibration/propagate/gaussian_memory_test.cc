#include "calibration/propagate/gaussian_memory.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

const UtcTime end_of_day{hours(24)};
constexpr double damping_per_h = 1.0 / 48;
constexpr double coriolis_rad_h = 0.39;
const Horizontal i_unit{0, 1};

UtcTime lead(double hour) { return add_hours(end_of_day, hour); }

/// A column at instants (hours after the end of D), without values yet.
VectorColumn column(const std::vector<double>& hour, const std::vector<double>& depth_m) {
  VectorColumn out;
  out.levels_m = depth_m;
  for (const double h : hour) out.time.push_back(TimeCell::instant(lead(h)));
  out.value.resize(hour.size() * depth_m.size());
  out.status.assign(out.value.size(), SampleStatus::ok);
  out.source.assign(hour.size(), DataStatus::analysis);
  return out;
}

std::vector<double> hourly(int from, int to) {
  std::vector<double> hour;
  for (int h = from; h <= to; ++h) hour.push_back(h);
  return hour;
}

std::vector<UtcTime> times(const std::vector<double>& hour) {
  std::vector<UtcTime> out;
  for (const double h : hour) out.push_back(lead(h));
  return out;
}

std::vector<Horizontal> random_vectors(std::size_t n, double size, Rng& random) {
  std::vector<Horizontal> out(n);
  for (Horizontal& value : out) value = {size * random.normal(), size * random.normal()};
  return out;
}

std::vector<Horizontal> times_factor(std::vector<Horizontal> values, Horizontal factor) {
  for (Horizontal& value : values) value *= factor;
  return values;
}

std::vector<Horizontal> conjugates(std::vector<Horizontal> values) {
  for (Horizontal& value : values) value = std::conj(value);
  return values;
}

struct Forecast {
  std::vector<Horizontal> mean;
  std::vector<double> variance;
};

Forecast forecast(const GaussianMemory& memory, const std::vector<double>& hour,
                  const std::vector<Horizontal>& answer) {
  Forecast out{std::vector<Horizontal>(answer.size()), std::vector<double>(answer.size())};
  memory.predict(times(hour), answer, out.mean, out.variance);
  return out;
}

/// The same at all depths, and sure of its own amplitudes.
MemoryKernel plain() {
  MemoryKernel kernel;
  kernel.deep_share = 1;
  kernel.surprise_weight = 0;
  return kernel;
}

MemoryKernel only_inertial() {
  MemoryKernel kernel = plain();
  kernel.constant_m_s = kernel.slow_m_s = kernel.recent_m_s = kernel.own_share = 0;
  return kernel;
}

// --- The textbook, written densely: one level, all terms in one covariance, a plain inverse. ---

Horizontal textbook_kernel(const MemoryKernel& k, double t, double u, Horizontal answer_t,
                           Horizontal answer_u) {
  const double d = t - u;
  return k.constant_m_s * k.constant_m_s +
         k.slow_m_s * k.slow_m_s * std::exp(-std::abs(d) / k.slow_h) +
         k.inertial_m_s * k.inertial_m_s *
             std::exp(-damping_per_h * std::abs(d) - i_unit * coriolis_rad_h * d) +
         k.recent_m_s * k.recent_m_s * std::exp(-std::abs(d) / k.recent_h) +
         k.own_share * k.own_share * answer_t * std::conj(answer_u);
}

/// The kernel of a level: all amplitudes but the own share fade with depth.
MemoryKernel faded(MemoryKernel k, double depth_m) {
  const double left = k.deep_share + (1 - k.deep_share) * std::exp(-depth_m / k.fading_depth_m);
  for (double* amplitude :
       {&k.constant_m_s, &k.slow_m_s, &k.inertial_m_s, &k.recent_m_s, &k.noise_m_s})
    *amplitude *= left;
  return k;
}

/// Values of one level.
struct TextbookLevel {
  std::vector<double> hour;
  std::vector<Horizontal> value;
  std::vector<Horizontal> answer;
  std::vector<double> sigma;  ///< stated, of a component
};

struct Textbook {
  Eigen::VectorXcd mean;
  Eigen::MatrixXcd covariance;
  double chi_squared = 0;
  double log_evidence = 0;
};

Textbook textbook(const MemoryKernel& k, const TextbookLevel& level,
                  const std::vector<double>& later, const std::vector<Horizontal>& answer_later) {
  std::vector<double> hour = level.hour;
  std::vector<Horizontal> answer = level.answer;
  hour.insert(hour.end(), later.begin(), later.end());
  answer.insert(answer.end(), answer_later.begin(), answer_later.end());
  const auto all = static_cast<Eigen::Index>(hour.size());
  const auto n = static_cast<Eigen::Index>(level.hour.size());
  Eigen::MatrixXcd joint(all, all);
  for (Eigen::Index i = 0; i < all; ++i) {
    for (Eigen::Index j = 0; j < all; ++j) {
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(j);
      joint(i, j) = textbook_kernel(k, hour[a], hour[b], answer[a], answer[b]);
    }
    joint(i, i) += k.noise_m_s * k.noise_m_s;
    if (i < n && !level.sigma.empty())
      joint(i, i) += 2 * std::pow(level.sigma[static_cast<std::size_t>(i)], 2);
  }
  const Eigen::MatrixXcd of_values = joint.topLeftCorner(n, n);
  const Eigen::MatrixXcd cross = joint.bottomLeftCorner(all - n, n);
  const Eigen::MatrixXcd inverse = of_values.inverse();
  const Eigen::Map<const Eigen::VectorXcd> y(level.value.data(), n);
  Textbook out;
  out.mean = cross * inverse * y;
  out.covariance = joint.bottomRightCorner(all - n, all - n) - cross * inverse * cross.adjoint();
  out.chi_squared = (y.adjoint() * inverse * y).value().real();
  out.log_evidence = -out.chi_squared - std::log(of_values.determinant().real()) -
                     static_cast<double>(n) * std::log(std::acos(-1.0));
  return out;
}

TEST(GaussianMemory, IsTheTextbooksRegressionWithGapsAndStatedErrors) {
  const std::vector<double> hour{-24, -18, -13, -12, -6, -5, 0};
  const std::vector<double> later{-9, 0.5, 6, 24, 72};
  const std::size_t levels = 4;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Rng random(seed, "textbook");
    VectorColumn residual = column(hour, {1, 5, 20, 60});
    residual.value = random_vectors(residual.value.size(), 0.1, random);
    const std::vector<Horizontal> answer = random_vectors(residual.value.size(), 0.2, random);
    const std::vector<Horizontal> answer_later = random_vectors(later.size() * levels, 0.2, random);
    std::vector<double> sigma(residual.value.size(), 0.0);
    for (double& s : sigma) s = random.uniform(0, 0.05);
    residual.status[residual.offset(2, 1)] = SampleStatus::missing;
    residual.status[residual.offset(6, 1)] = SampleStatus::suspect;
    residual.status[residual.offset(0, 3)] = SampleStatus::missing;

    const MemoryKernel kernel;
    const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h, kernel,
                                sigma);
    const Forecast ours = forecast(memory, later, answer_later);
    double log_evidence = 0;
    double chi_squared = 0;
    double values = 0;
    std::vector<Textbook> expected;
    for (std::size_t k = 0; k < levels; ++k) {
      TextbookLevel level;
      for (std::size_t t = 0; t < hour.size(); ++t) {
        if (!residual.has(t, k)) continue;
        const std::size_t o = residual.offset(t, k);
        level.hour.push_back(hour[t]);
        level.value.push_back(residual.value[o]);
        level.answer.push_back(answer[o]);
        level.sigma.push_back(sigma[o]);
      }
      std::vector<Horizontal> level_later;
      for (std::size_t t = 0; t < later.size(); ++t)
        level_later.push_back(answer_later[t * levels + k]);
      expected.push_back(textbook(faded(kernel, residual.levels_m[k]), level, later, level_later));
      log_evidence += expected.back().log_evidence;
      chi_squared += expected.back().chi_squared;
      values += static_cast<double>(level.hour.size());
    }
    const double w = kernel.surprise_weight;
    const double kappa_squared = (1 + w * chi_squared / values) / (1 + w);
    EXPECT_NEAR(memory.surprise(), std::sqrt(kappa_squared), 1e-9);
    EXPECT_NEAR(memory.log_evidence(), log_evidence, 1e-8 * std::abs(log_evidence));
    for (std::size_t k = 0; k < levels; ++k) {
      for (std::size_t t = 0; t < later.size(); ++t) {
        const auto i = static_cast<Eigen::Index>(t);
        // Condition 1e5 times rounding of values of 0.1.
        EXPECT_LT(std::abs(ours.mean[t * levels + k] - expected[k].mean(i)), 1e-11);
        EXPECT_NEAR(ours.variance[t * levels + k],
                    0.5 * kappa_squared * expected[k].covariance(i, i).real(), 1e-11);
      }
    }
  }
}

TEST(GaussianMemory, ARougherSeaWidensTheBandsAndLeavesTheMeanToItsAmplitude) {
  Rng random(8, "rough");
  VectorColumn calm = column(hourly(-23, 0), {5, 30});
  calm.value = random_vectors(48, 0.02, random);
  VectorColumn rough = calm;
  rough.value = times_factor(calm.value, 10.0);
  const std::vector<Horizontal> none(48);
  const GaussianMemory of_calm(calm, none, end_of_day, damping_per_h, coriolis_rad_h);
  const GaussianMemory of_rough(rough, none, end_of_day, damping_per_h, coriolis_rad_h);
  EXPECT_GT(of_rough.surprise(), 3 * of_calm.surprise());
  const Forecast ours_calm = forecast(of_calm, {12}, std::vector<Horizontal>(2));
  const Forecast ours_rough = forecast(of_rough, {12}, std::vector<Horizontal>(2));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT(std::abs(ours_rough.mean[k] - 10.0 * ours_calm.mean[k]), 1e-12);
    EXPECT_NEAR(ours_rough.variance[k] / ours_calm.variance[k],
                std::pow(of_rough.surprise() / of_calm.surprise(), 2), 1e-9);
  }
}

TEST(GaussianMemory, WithoutValuesThePriorIsLeft) {
  VectorColumn residual = column({-6, 0}, {5, 50});
  residual.status.assign(4, SampleStatus::missing);
  const MemoryKernel kernel;
  const GaussianMemory memory(residual, std::vector<Horizontal>(4), end_of_day, damping_per_h,
                              coriolis_rad_h, kernel);
  const std::vector<Horizontal> answer{{0.1, 0}, {0, 0.3}};
  const Forecast ours = forecast(memory, {12}, answer);
  const double prior =
      MemoryCovariance(kernel, 1, 0).variance_m2_s2() + kernel.noise_m_s * kernel.noise_m_s;
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_FALSE(memory.has(k));
    EXPECT_EQ(ours.mean[k], Horizontal{});
    const double share = kernel.own_share * kernel.own_share * std::norm(answer[k]);
    const double amplitude = kernel.amplitude_at(residual.levels_m[k]);
    EXPECT_NEAR(ours.variance[k], 0.5 * (amplitude * amplitude * prior + share), 1e-15);
  }
  EXPECT_FALSE(memory.at_depth(10).has_value());
  EXPECT_EQ(memory.log_evidence(), 0.0);
  EXPECT_EQ(memory.surprise(), 1.0);
}

TEST(GaussianMemory, LongAfterTheDayOnlyTheConstantIsRemembered) {
  Rng random(7, "long after");
  VectorColumn residual = column(hourly(-24, 0), {5});
  residual.value = random_vectors(25, 0.2, random);
  MemoryKernel kernel = plain();
  kernel.constant_m_s = 0;
  const std::vector<Horizontal> none(25);
  const GaussianMemory memory(residual, none, end_of_day, damping_per_h, coriolis_rad_h, kernel);
  const Forecast ours = forecast(memory, {2e4}, {Horizontal{}});
  EXPECT_LT(std::abs(ours.mean[0]), 1e-12);
  const double prior =
      MemoryCovariance(kernel, 1, 0).variance_m2_s2() + kernel.noise_m_s * kernel.noise_m_s;
  EXPECT_NEAR(ours.variance[0], 0.5 * prior, 1e-12);
}

TEST(GaussianMemory, InertialMotionIsCarriedWithItsRotationAndDamping) {
  MemoryKernel kernel = only_inertial();
  kernel.noise_m_s = 1e-7;
  VectorColumn residual = column({-24, -18, -12, -6, 0}, {5});
  const Horizontal lambda(damping_per_h, coriolis_rad_h);
  const Horizontal amplitude(0.08, -0.03);
  for (std::size_t t = 0; t < residual.times(); ++t)
    residual.value[t] = amplitude * std::exp(-lambda * (6.0 * static_cast<double>(t) - 24.0));
  const GaussianMemory memory(residual, std::vector<Horizontal>(5), end_of_day, damping_per_h,
                              coriolis_rad_h, kernel);
  const std::vector<double> later{1, 7.5, 24, 72};
  const Forecast ours = forecast(memory, later, std::vector<Horizontal>(4));
  for (std::size_t t = 0; t < later.size(); ++t) {
    // Noise of 1e-6 of the motion.
    EXPECT_LT(std::abs(ours.mean[t] - amplitude * std::exp(-lambda * later[t])), 1e-9);
    const double unknown = 1 - std::exp(-2 * damping_per_h * later[t]);
    EXPECT_NEAR(ours.variance[t], 0.5 * kernel.inertial_m_s * kernel.inertial_m_s * unknown, 1e-9);
  }
}

TEST(GaussianMemory, AConstantStaysConstantWhereNothingIsBelievedOfIt) {
  MemoryKernel kernel;
  kernel.constant_m_s = 1e3;  // as good as unknown: the regression is then unbiased
  VectorColumn residual = column(hourly(-23, 0), {5});
  const Horizontal constant(0.31, -0.12);
  residual.value.assign(24, constant);
  const GaussianMemory memory(residual, std::vector<Horizontal>(24), end_of_day, damping_per_h,
                              coriolis_rad_h, kernel);
  const Forecast ours = forecast(memory, {1, 12, 72}, std::vector<Horizontal>(3));
  for (const Horizontal mean : ours.mean) EXPECT_LT(std::abs(mean - constant), 1e-6);
}

TEST(GaussianMemory, ALevelLearnsItsOwnShareOfTheWindsAnswer) {
  MemoryKernel kernel;
  kernel.noise_m_s = 1e-5;
  kernel.constant_m_s = kernel.slow_m_s = kernel.inertial_m_s = kernel.recent_m_s = 1e-6;
  Rng random(3, "own share");
  VectorColumn residual = column(hourly(-23, 0), {5});
  const std::vector<Horizontal> answer = random_vectors(24, 0.1, random);
  const Horizontal share(-0.2, 0.1);  // weaker, and turned to the left
  residual.value = times_factor(answer, share);
  const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h, kernel);
  const Horizontal later(0.3, 0.2);
  const Forecast ours = forecast(memory, {10}, {later});
  EXPECT_LT(std::abs(ours.mean[0] - share * later), 1e-6);
}

TEST(GaussianMemory, TurningTheValuesTurnsTheMeanAndLeavesTheVariance) {
  Rng random(4, "turn");
  VectorColumn residual = column(hourly(-23, 0), {5, 30});
  residual.value = random_vectors(48, 0.1, random);
  const std::vector<Horizontal> answer = random_vectors(48, 0.1, random);
  const std::vector<Horizontal> answer_later = random_vectors(6, 0.1, random);
  const Horizontal turn = std::polar(1.0, 2.1);
  const auto forecast_of = [&](const VectorColumn& values, Horizontal wind_turn) {
    return forecast(GaussianMemory(values, times_factor(answer, wind_turn), end_of_day,
                                   damping_per_h, coriolis_rad_h),
                    {1, 9, 40}, times_factor(answer_later, wind_turn));
  };
  const Forecast plain = forecast_of(residual, 1.0);
  VectorColumn turned = residual;
  turned.value = times_factor(residual.value, turn);
  // Condition 3e5 times rounding of values of 0.1, in all comparisons of whole regressions.
  // The share is complex: how the wind's answer itself is turned does not matter.
  for (const Horizontal wind_turn : {turn, Horizontal(1.0)}) {
    const Forecast ours = forecast_of(turned, wind_turn);
    for (std::size_t o = 0; o < 6; ++o) {
      EXPECT_LT(std::abs(ours.mean[o] - turn * plain.mean[o]), 1e-11);
      EXPECT_NEAR(ours.variance[o], plain.variance[o], 1e-12);
    }
  }
}

TEST(GaussianMemory, MirrorsInTheSouthernHemisphere) {
  Rng random(5, "south");
  VectorColumn north = column(hourly(-23, 0), {5, 30});
  north.value = random_vectors(48, 0.1, random);
  const std::vector<Horizontal> answer = random_vectors(48, 0.1, random);
  const std::vector<Horizontal> answer_later = random_vectors(6, 0.1, random);
  VectorColumn south = north;
  south.value = conjugates(north.value);
  const std::vector<double> later{1, 9, 40};
  const Forecast in_north =
      forecast(GaussianMemory(north, answer, end_of_day, damping_per_h, coriolis_rad_h), later,
               answer_later);
  const Forecast in_south = forecast(
      GaussianMemory(south, conjugates(answer), end_of_day, damping_per_h, -coriolis_rad_h), later,
      conjugates(answer_later));
  for (std::size_t o = 0; o < 6; ++o) {
    EXPECT_LT(std::abs(in_south.mean[o] - std::conj(in_north.mean[o])), 1e-11);
    EXPECT_NEAR(in_south.variance[o], in_north.variance[o], 1e-12);
  }
}

/// Three days of daily means of one level, each of this value.
VectorColumn daily_means(Horizontal value) {
  VectorColumn residual = column({0, 0, 0}, {5});
  for (int d = 0; d < 3; ++d)
    residual.time[static_cast<std::size_t>(d)] = {lead(24.0 * (d - 3)), lead(24.0 * (d - 2))};
  residual.value.assign(3, value);
  return residual;
}

TEST(GaussianMemory, DailyMeansKnowTheConstant) {
  MemoryKernel kernel;
  kernel.constant_m_s = 1e3;
  const Horizontal constant(0.2, 0.1);
  const GaussianMemory memory(daily_means(constant), std::vector<Horizontal>(3), end_of_day,
                              damping_per_h, coriolis_rad_h, kernel);
  const Forecast ours = forecast(memory, {12}, {Horizontal{}});
  EXPECT_LT(std::abs(ours.mean[0] - constant), 1e-6);
}

TEST(GaussianMemory, DailyMeansKnowNothingOfAnInertialMotionOfADay) {
  // At 30 degrees of latitude the period is the day: whatever the means are, they are not this.
  const double period_of_a_day_rad_h = 2 * std::acos(-1.0) / 24;
  const MemoryKernel kernel = only_inertial();
  const GaussianMemory memory(daily_means({0.2, 0.1}), std::vector<Horizontal>(3), end_of_day, 1e-8,
                              period_of_a_day_rad_h, kernel);
  const Forecast ours = forecast(memory, {12}, {Horizontal{}});
  // Damping leaves 1e-7 of the motion's variance in the mean of a day, which is 400 times the noise's:
  // values of 0.2 weigh 1e-5.
  EXPECT_LT(std::abs(ours.mean[0]), 1e-4);
  const double prior =
      kernel.inertial_m_s * kernel.inertial_m_s + kernel.noise_m_s * kernel.noise_m_s;
  EXPECT_NEAR(ours.variance[0], 0.5 * prior, 1e-3 * prior);
}

// --- Levels and depths. ---

TEST(GaussianMemory, ALevelWithoutValuesIsBetweenItsNeighboursAndHeldBeyondThem) {
  Rng random(6, "levels");
  VectorColumn residual = column(hourly(-23, 0), {0, 10, 20, 40, 80});
  residual.value = random_vectors(residual.value.size(), 0.1, random);
  for (std::size_t t = 0; t < residual.times(); ++t) {
    for (const std::size_t k : {0U, 2U, 4U})
      residual.status[residual.offset(t, k)] = SampleStatus::missing;
  }
  const std::vector<Horizontal> answer = random_vectors(residual.value.size(), 0.1, random);
  const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h);
  const Forecast ours = forecast(memory, {6}, random_vectors(5, 0.1, random));
  for (const std::size_t k : {0U, 2U, 4U}) EXPECT_FALSE(memory.has(k));
  EXPECT_TRUE(memory.has(1));
  EXPECT_EQ(ours.mean[0], ours.mean[1]);
  EXPECT_EQ(ours.mean[4], ours.mean[3]);
  EXPECT_LT(std::abs(ours.mean[2] - (2.0 * ours.mean[1] + ours.mean[3]) / 3.0), 1e-15);
  EXPECT_NEAR(ours.variance[2], (2.0 * ours.variance[1] + ours.variance[3]) / 3.0, 1e-15);
  const LevelMix mix = *memory.at_depth(30);
  EXPECT_EQ(mix.above, 1U);
  EXPECT_EQ(mix.below, 3U);
  EXPECT_NEAR(mix.share_below, 2.0 / 3.0, 1e-15);
}

TEST(GaussianMemory, AColumnWithoutADepthAxisIsOneLevel) {
  VectorColumn residual = column(hourly(-23, 0), {0});
  residual.levels_m.clear();
  residual.value.assign(24, {0.1, 0.0});
  const GaussianMemory memory(residual, std::vector<Horizontal>(24), end_of_day, damping_per_h,
                              coriolis_rad_h);
  EXPECT_EQ(memory.levels(), 1U);
  EXPECT_TRUE(memory.has(0));
  EXPECT_NEAR(forecast(memory, {1}, {Horizontal{}}).mean[0].real(), 0.1, 0.01);
}

TEST(GaussianMemory, TenMinutesSayWhatTheirHoursSay) {
  const auto motion = [](double hour) {
    return Horizontal(0.2, 0.1) + 0.1 * std::exp(-i_unit * coriolis_rad_h * hour);
  };
  std::vector<double> fine;
  for (int i = -143; i <= 0; ++i) fine.push_back(i / 6.0);
  std::vector<double> coarse;
  for (int h = -23; h <= 0; ++h) coarse.push_back(h - 25.0 / 60);  // mean of -50 .. 0 minutes
  const auto later = [&](const std::vector<double>& hour) {
    VectorColumn residual = column(hour, {5});
    for (std::size_t t = 0; t < hour.size(); ++t) residual.value[t] = motion(hour[t]);
    return forecast(GaussianMemory(residual, std::vector<Horizontal>(hour.size()), end_of_day,
                                   damping_per_h, coriolis_rad_h, plain()),
                    {12}, {Horizontal{}});
  };
  // An inertial motion loses (0.39 x 50/60)^2/24 of its 0.1 m/s in the mean of an hour: 0.4 mm/s.
  EXPECT_LT(std::abs(later(fine).mean[0] - later(coarse).mean[0]), 5e-4);
  EXPECT_NEAR(later(fine).variance[0], later(coarse).variance[0], 1e-12);
}

// --- Statistics. ---

TEST(GaussianMemory, BandsHoldWhatTheyPromiseOnDataOfThePrior) {
  // Levels are independent draws of a day and one later hour from the prior of the textbook.
  const std::size_t draws = 3000;
  const std::vector<double> day = hourly(-23, 0);
  MemoryKernel kernel;
  kernel.deep_share = 1;  // the draws are levels
  Rng random(11, "prior");
  std::vector<double> depth_m;
  for (std::size_t k = 0; k < draws; ++k) depth_m.push_back(static_cast<double>(k));
  std::vector<double> all = day;
  all.push_back(15);
  const std::size_t n = all.size();
  VectorColumn residual = column(day, depth_m);
  std::vector<Horizontal> answer(residual.value.size());
  std::vector<Horizontal> answer_later(draws);
  std::vector<Horizontal> truth(draws);
  // One answer to the wind for all, so that one factor makes all draws.
  const std::vector<Horizontal> s = random_vectors(n, 0.15, random);
  Eigen::MatrixXcd joint(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      joint(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          textbook_kernel(kernel, all[i], all[j], s[i], s[j]);
  }
  joint.diagonal().array() += kernel.noise_m_s * kernel.noise_m_s;
  const Eigen::MatrixXcd factor = joint.llt().matrixL();
  for (std::size_t k = 0; k < draws; ++k) {
    const std::vector<Horizontal> white = random_vectors(n, std::sqrt(0.5), random);
    const Eigen::VectorXcd drawn =
        factor * Eigen::Map<const Eigen::VectorXcd>(white.data(), static_cast<Eigen::Index>(n));
    for (std::size_t t = 0; t < day.size(); ++t) {
      residual.value[residual.offset(t, k)] = drawn(static_cast<Eigen::Index>(t));
      answer[residual.offset(t, k)] = s[t];
    }
    answer_later[k] = s.back();
    truth[k] = drawn(static_cast<Eigen::Index>(n - 1));
  }
  const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h, kernel);
  EXPECT_NEAR(memory.surprise(), 1.0, 0.01);
  const Forecast ours = forecast(memory, {15}, answer_later);
  double inside = 0;
  double squares = 0;
  for (std::size_t k = 0; k < draws; ++k) {
    const Horizontal error = truth[k] - ours.mean[k];
    const double sigma = std::sqrt(ours.variance[k]);
    inside +=
        (std::abs(error.real()) < 1.28155 * sigma) + (std::abs(error.imag()) < 1.28155 * sigma);
    squares += std::norm(error) / ours.variance[k];
  }
  // 6000 independent values: binomial sigma 0.0052, that of the mean square 0.018; 3.3 of each.
  const double values = 2.0 * static_cast<double>(draws);
  EXPECT_NEAR(inside / values, 0.8, 3.3 * std::sqrt(0.16 / values));
  EXPECT_NEAR(squares / values, 1.0, 3.3 * std::sqrt(2.0 / values));
}

/// Covariance over members of two places in the arrays of a member.
Horizontal covariance_over(const std::vector<Horizontal>& departures, std::size_t places,
                           std::size_t a, std::size_t b) {
  Horizontal sum{};
  for (std::size_t o = 0; o < departures.size(); o += places)
    sum += departures[o + a] * std::conj(departures[o + b]);
  return sum * static_cast<double>(places) / static_cast<double>(departures.size());
}

/// A column of three levels of which the second has a gap.
VectorColumn sampled_column(Rng& random) {
  VectorColumn residual = column({-24, -18, -12, -6, 0}, {5, 25, 60});
  residual.value = random_vectors(residual.value.size(), 0.1, random);
  residual.status[residual.offset(4, 1)] = SampleStatus::missing;
  return residual;
}

TEST(GaussianMemory, MembersHaveThePosteriorsCovarianceInTime) {
  Rng random(12, "members");
  const std::vector<double> later{0.5, 6, 24};
  const VectorColumn residual = sampled_column(random);
  const std::vector<Horizontal> answer = random_vectors(15, 0.2, random);
  const std::vector<Horizontal> answer_later = random_vectors(9, 0.4, random);
  const MemoryKernel kernel;
  const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h, kernel);
  const int members = 40000;
  std::vector<Horizontal> departures(9 * static_cast<std::size_t>(members));
  memory.sample(times(later), answer_later, random, members, departures);

  for (std::size_t k = 0; k < 3; ++k) {
    TextbookLevel level;
    for (std::size_t t = 0; t < 5; ++t) {
      if (!residual.has(t, k)) continue;
      level.hour.push_back(6.0 * static_cast<double>(t) - 24.0);
      level.value.push_back(residual.value[3 * t + k]);
      level.answer.push_back(answer[3 * t + k]);
    }
    Textbook expected = textbook(faded(kernel, residual.levels_m[k]), level, later,
                                 {answer_later[k], answer_later[3 + k], answer_later[6 + k]});
    expected.covariance *= memory.surprise() * memory.surprise();
    // A correlation of complex numbers over 40 000 members has sigma 0.005; 4 of them.
    for (std::size_t t = 0; t < 3; ++t) {
      const auto i = static_cast<Eigen::Index>(t);
      Horizontal mean{};
      for (std::size_t o = 3 * t + k; o < departures.size(); o += 9) mean += departures[o];
      EXPECT_LT(std::abs(mean) / members, 0.02 * std::sqrt(expected.covariance(i, i).real()));
      for (std::size_t u = 0; u < 3; ++u) {
        const auto j = static_cast<Eigen::Index>(u);
        const double scale =
            std::sqrt(expected.covariance(i, i).real() * expected.covariance(j, j).real());
        const Horizontal ours = covariance_over(departures, 9, 3 * t + k, 3 * u + k);
        EXPECT_LT(std::abs(ours - expected.covariance(i, j)), 0.02 * scale);
      }
    }
  }
}

TEST(GaussianMemory, DeparturesOfTwoLevelsForgetEachOtherWithTheirDistance) {
  Rng random(15, "depth");
  MemoryKernel kernel;
  kernel.vertical_scale_m = 30;
  // Not in the order of depth; all feel the same wind, so that nothing but the draw tells them apart.
  VectorColumn residual = column({-24, -18, -12, -6, 0}, {35, 5, 35.003});
  residual.value = random_vectors(15, 0.1, random);
  const GaussianMemory memory(residual, std::vector<Horizontal>(15, {0.1, 0.1}), end_of_day,
                              damping_per_h, coriolis_rad_h, kernel);
  const int members = 40000;
  std::vector<Horizontal> departures(6 * static_cast<std::size_t>(members));
  memory.sample(times({6, 24}), std::vector<Horizontal>(6, {0.3, -0.2}), random, members,
                departures);
  for (const std::size_t t : {0U, 3U}) {
    const auto correlation = [&](std::size_t a, std::size_t b) {
      const auto of = [&](std::size_t i, std::size_t j) {
        return covariance_over(departures, 6, t + i, t + j);
      };
      return of(a, b) / std::sqrt(of(a, a).real() * of(b, b).real());
    };
    // Sigma 0.005; 4 of them.
    EXPECT_LT(std::abs(correlation(0, 1) - std::exp(-1.0)), 0.02);
    EXPECT_GT(correlation(0, 2).real(), 0.999);
  }
}

TEST(GaussianMemory, MembersOfALevelWithoutValuesHaveItsVariance) {
  Rng random(13, "no values");
  VectorColumn residual = column({-24, -18, -12, -6, 0}, {5, 12, 35});
  residual.value = random_vectors(15, 0.1, random);
  for (std::size_t t = 0; t < 5; ++t)
    residual.status[residual.offset(t, 1)] = SampleStatus::missing;
  residual.status[residual.offset(4, 2)] = SampleStatus::missing;
  residual.status[residual.offset(3, 2)] = SampleStatus::missing;
  const std::vector<Horizontal> none(15);
  const GaussianMemory memory(residual, none, end_of_day, damping_per_h, coriolis_rad_h, plain());
  const std::vector<Horizontal> none_later(3);
  const Forecast ours = forecast(memory, {3}, none_later);
  ASSERT_GT(ours.variance[2], 1.2 * ours.variance[0]);
  const int members = 20000;
  std::vector<Horizontal> departures(3 * static_cast<std::size_t>(members));
  memory.sample(times({3}), none_later, random, members, departures);
  double squares = 0;
  for (std::size_t m = 0; m < static_cast<std::size_t>(members); ++m)
    squares += std::norm(departures[3 * m + 1]);
  // The mean square of 20 000 complex numbers has sigma 0.007.
  EXPECT_NEAR(squares / members / (2 * ours.variance[1]), 1.0, 0.03);
}

TEST(GaussianMemory, TheSameSeedDrawsTheSameMembers) {
  Rng random(14, "column");
  const VectorColumn residual = sampled_column(random);
  const GaussianMemory memory(residual, std::vector<Horizontal>(15), end_of_day, damping_per_h,
                              coriolis_rad_h);
  const auto drawn = [&](std::uint64_t seed, int members) {
    Rng stream(seed, "calibration/memory");
    std::vector<Horizontal> out(6 * static_cast<std::size_t>(members));
    memory.sample(times({1, 2}), std::vector<Horizontal>(6), stream, members, out);
    return out;
  };
  EXPECT_EQ(drawn(1, 5), drawn(1, 5));
  EXPECT_NE(drawn(1, 5), drawn(2, 5));
  const std::vector<Horizontal> more = drawn(1, 8);
  EXPECT_EQ(std::vector<Horizontal>(more.begin(), more.begin() + 30), drawn(1, 5));
}

TEST(GaussianMemory, RefusesArraysOfAnotherSizeAndAnswersThatAreNoNumbers) {
  const VectorColumn residual = column({-6, 0}, {5, 50});
  const std::vector<Horizontal> answer(4);
  EXPECT_THROW(GaussianMemory(residual, std::vector<Horizontal>(3), end_of_day, damping_per_h,
                              coriolis_rad_h),
               ContractViolation);
  const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h);
  const std::vector<UtcTime> later = times({1});
  std::vector<Horizontal> mean(2);
  std::vector<double> variance(2);
  std::vector<double> too_short(1);
  EXPECT_THROW(memory.predict(later, answer, mean, variance), ContractViolation);
  const std::vector<Horizontal> right(2);
  EXPECT_THROW(memory.predict(later, right, mean, too_short), ContractViolation);
  const std::vector<Horizontal> no_number{{std::nan(""), 0}, {}};
  EXPECT_THROW(memory.predict(later, no_number, mean, variance), ContractViolation);
  Rng random(1, "sizes");
  EXPECT_THROW(memory.sample(later, right, random, 3, mean), ContractViolation);
  EXPECT_THROW((void)memory.has(2), ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration
