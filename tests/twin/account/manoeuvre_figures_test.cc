#include "twin/account/manoeuvre_figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/turn.h"

namespace slackwater::twin::manoeuvre_figures_test {
namespace {

using constants::degree;
using constants::pi;
using Rows = std::vector<ManoeuvreRow>;

/// Straight ahead on a course for 20 s, then at once on a circle, with a drift into the turn.
struct Circle {
  double radius_m = 50;
  double speed_m_s = 2;
  double side = 1;
  double course_rad = 0.3;
  double drift_rad = 0;

  [[nodiscard]] Rows rows(double dt_s, double lasts_s) const {
    Rows out;
    for (double t_s = 0; t_s <= lasts_s; t_s += dt_s) {
      const double on_s = std::max(t_s - 20, 0.0);
      const double turned = speed_m_s / radius_m * on_s;
      const double ahead_m = speed_m_s * std::min(t_s, 20.0) + radius_m * std::sin(turned);
      const double across_m = side * radius_m * (1 - std::cos(turned));
      const double c = std::cos(course_rad), s = std::sin(course_rad);
      ManoeuvreRow row;
      row.t_s = t_s;
      row.north_m = c * ahead_m - s * across_m;
      row.east_m = s * ahead_m + c * across_m;
      row.heading_rad = wrapped_rad(course_rad + side * turned);
      const double drift = on_s > 0 ? side * drift_rad : 0;
      row.ahead_m_s = speed_m_s * std::cos(drift);
      row.starboard_m_s = -speed_m_s * std::sin(drift);
      row.turn_rad_s = on_s > 0 ? side * speed_m_s / radius_m : 0;
      out.push_back(row);
    }
    return out;
  }
};

TEST(TurningCircleFigures, OfACircleAreItsRadiusAndDiameter) {
  for (const double side : {1.0, -1.0}) {
    Circle exact;
    exact.side = side;
    const double dt_s = 0.5;
    const TurningCircle found = turning_circle(exact.rows(dt_s, 220), 20);
    // A chord in the place of an arc: R (r dt)^2 / 8.
    const double tolerance_m = exact.radius_m * std::pow(2.0 / 50 * dt_s, 2) / 8 * 1.01;
    EXPECT_EQ(found.to_starboard, side > 0);
    EXPECT_NEAR(found.advance_m.value(), 50, tolerance_m);
    EXPECT_NEAR(found.transfer_m.value(), 50, tolerance_m);
    EXPECT_NEAR(found.tactical_diameter_m.value(), 100, tolerance_m);
    const double quarter_s = 0.5 * pi * 50 / 2;
    EXPECT_NEAR(found.quarter_s.value(), quarter_s, 1e-9);
    EXPECT_NEAR(found.half_s.value(), 2 * quarter_s, 1e-9);
    EXPECT_NEAR(found.three_quarters_s.value(), 3 * quarter_s, 1e-9);
    EXPECT_NEAR(found.full_s.value(), 4 * quarter_s, 1e-9);
  }
}

TEST(TurningCircleFigures, AreTheSameWhateverTheCourse) {
  Circle one, other;
  other.course_rad = -2.9;
  const TurningCircle a = turning_circle(one.rows(0.5, 220), 20);
  const TurningCircle b = turning_circle(other.rows(0.5, 220), 20);
  EXPECT_NEAR(a.advance_m.value(), b.advance_m.value(), 1e-9);
  EXPECT_NEAR(a.transfer_m.value(), b.transfer_m.value(), 1e-9);
}

TEST(TurningCircleFigures, TellTheSteadyTurnWithItsDrift) {
  for (const double side : {1.0, -1.0}) {
    Circle exact;
    exact.side = side;
    exact.drift_rad = 8 * degree;
    const TurningCircle found = turning_circle(exact.rows(0.5, 220), 20);
    ASSERT_TRUE(found.steady);
    EXPECT_NEAR(found.steady->radius_m, 50, 1e-9);
    EXPECT_NEAR(found.steady->turn_rad_s, side * 2 / 50, 1e-12);
    EXPECT_NEAR(found.steady->drift_rad, side * 8 * degree, 1e-12);
    EXPECT_NEAR(found.steady->speed_kept, 1, 1e-12);
  }
}

TEST(TurningCircleFigures, HaveNoSteadyTurnWhileItStillTightens) {
  const Circle exact;
  Rows rows = exact.rows(0.5, 220);
  for (ManoeuvreRow& row : rows) row.turn_rad_s *= 1 + 5e-3 * row.t_s;
  EXPECT_FALSE(turning_circle(rows, 20).steady);
  EXPECT_FALSE(turning_circle(exact.rows(0.5, 20 + 30), 20).steady) << "not a quarter of a turn";
}

TEST(TurningCircleFigures, CountFromAnExecuteBetweenTheRows) {
  // Every other second from 1 s on: the execute at 20 s is between two of them.
  const Circle exact;
  Rows rows;
  for (const ManoeuvreRow& row : exact.rows(1, 220))
    if (std::lround(row.t_s) % 2 == 1) rows.push_back(row);
  const TurningCircle found = turning_circle(rows, 20);
  const double tolerance_m = exact.radius_m * std::pow(2.0 / 50 * 2, 2) / 8 * 1.5;
  EXPECT_NEAR(found.advance_m.value(), 50, tolerance_m);
  EXPECT_NEAR(found.tactical_diameter_m.value(), 100, tolerance_m);
  EXPECT_NEAR(found.quarter_s.value(), 0.5 * pi * 50 / 2, 1e-9);
}

TEST(TurningCircleFigures, AreAbsentWhereTheRowsEndBefore) {
  const Circle exact;
  const TurningCircle found = turning_circle(exact.rows(0.5, 20 + 50), 20);  // 115 degrees
  EXPECT_TRUE(found.advance_m);
  EXPECT_FALSE(found.tactical_diameter_m);
  EXPECT_FALSE(found.full_s);
  EXPECT_FALSE(turning_circle({}, 0).advance_m);
}

/// Nomoto's craft of the first order, T r' + r = K delta, its helm put over at once: exact from
/// execute to execute.
struct Nomoto {
  double K_per_s = 0.2;
  double T_s = 8;

  [[nodiscard]] double rate_after(double r, double helm, double t_s) const {
    return K_per_s * helm + (r - K_per_s * helm) * std::exp(-t_s / T_s);
  }
  [[nodiscard]] double turned_in(double r, double helm, double t_s) const {
    return K_per_s * helm * t_s + (r - K_per_s * helm) * T_s * (1 - std::exp(-t_s / T_s));
  }
  /// What it turns on, with the helm against it, until it stands.
  [[nodiscard]] double overshoot(double r, double helm) const {
    const double steady = K_per_s * helm;
    return T_s * r - steady * T_s * std::log(1 + r / steady);
  }
};

struct ExactZigZag {
  std::vector<double> execute_s;
  std::vector<double> overshoot_rad;
  Rows rows;
};
/// @param side  of the first helm
ExactZigZag exact_zig_zag(const Nomoto& craft, double helm_rad, double psi_rad, double side,
                          double dt_s, int executes) {
  ExactZigZag out;
  double t_s = 0, r = 0, heading = 0, helm = side * helm_rad;
  int row = 0;
  for (int leg = 0; leg < executes + 1; ++leg) {
    // When the heading comes to +-psi on the side of the helm, by halving: it grows once it has
    // turned back.
    const double wanted = std::copysign(psi_rad, helm);
    double low = 0, high = 1000;
    const double r0 = r, from = heading;
    const auto beyond = [&](double at) {
      return std::copysign(1.0, helm) * (from + craft.turned_in(r0, helm, at) - wanted) >= 0;
    };
    if (leg > 0) low = craft.T_s * std::log(1 + std::abs(r0) / (craft.K_per_s * helm_rad));
    for (int i = 0; i < 200; ++i) (beyond(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    for (; row * dt_s < t_s + high; ++row) {
      const double on_s = row * dt_s - t_s;
      ManoeuvreRow at;
      at.t_s = row * dt_s;
      at.heading_rad = wrapped_rad(3 + from + craft.turned_in(r0, helm, on_s));
      at.turn_rad_s = craft.rate_after(r0, helm, on_s);
      at.helm_rad = helm;
      at.ahead_m_s = 1;
      at.north_m = at.t_s;  // along a line, for the length of the track
      out.rows.push_back(at);
    }
    t_s += high;
    heading = wanted;
    r = craft.rate_after(r0, helm, high);
    if (leg < executes) {
      out.execute_s.push_back(t_s);
      out.overshoot_rad.push_back(craft.overshoot(std::abs(r), helm_rad));
    }
    helm = -helm;
  }
  return out;
}

TEST(ZigZagFigures, OfANomotoCraftAreItsClosedForm) {
  for (const double side : {1.0, -1.0}) {
    const Nomoto craft;
    const ExactZigZag exact = exact_zig_zag(craft, 10 * degree, 10 * degree, side, 0.1, 5);
    const ZigZag found = zig_zag(exact.rows, 0, 10 * degree);
    ASSERT_EQ(found.execute_s.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
      // Of the heading between rows: its second derivative is 2 K delta / T at most, so it is off
      // by that dt^2 / 8, and the time by as much over the rate.
      EXPECT_NEAR(found.execute_s[i], exact.execute_s[i], 2e-3) << i;
      EXPECT_NEAR(found.overshoot_rad[i], exact.overshoot_rad[i], 1e-5) << i;
    }
    EXPECT_NEAR(found.period_s.value(), exact.execute_s[4] - exact.execute_s[2], 4e-3);
    EXPECT_NEAR(found.initial_turning_m.value(), exact.execute_s[0], 2e-3) << "at 1 m/s";
  }
}

TEST(ZigZagFigures, ComeNearerToTheClosedFormAsTheSquareOfTheRows) {
  const Nomoto craft;
  const auto off = [&](double dt_s) {
    const ExactZigZag exact = exact_zig_zag(craft, 20 * degree, 20 * degree, 1, dt_s, 3);
    const ZigZag found = zig_zag(exact.rows, 0, 20 * degree);
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i)
      most = std::max(most, std::abs(found.overshoot_rad.at(i) - exact.overshoot_rad[i]));
    return most;
  };
  EXPECT_LT(off(0.05), 1e-6);
  EXPECT_LT(off(0.5), 1e-3);
}

TEST(ZigZagFigures, AreOfAsManyExecutesAsTheRowsHave) {
  const ExactZigZag exact = exact_zig_zag({}, 10 * degree, 10 * degree, 1, 0.1, 2);
  EXPECT_EQ(zig_zag(exact.rows, 0, 10 * degree).execute_s.size(), 2U);
  EXPECT_TRUE(zig_zag(exact.rows, 0, 170 * degree).execute_s.empty());
  EXPECT_FALSE(zig_zag(exact.rows, 0, 10 * degree).period_s);
}

/// A spiral from 20 degrees down to -20 and up again, in steps of 5, each held for 60 s; the rate
/// goes to what `steady` says with a time constant of 3 s.
template <typename Steady>
Rows spiral_rows(const Steady& steady) {
  Rows rows;
  double r = 0, t_s = 0;
  const auto hold = [&](int helm_deg) {
    const double wanted = steady(helm_deg * degree, r), before = r;
    for (int i = 0; i < 120; ++i, t_s += 0.5) {
      r = wanted + (before - wanted) * std::exp(-0.5 * i / 3);
      ManoeuvreRow row;
      row.t_s = t_s;
      row.turn_rad_s = r;
      row.helm_rad = helm_deg * degree;
      rows.push_back(row);
    }
  };
  for (int helm_deg = 20; helm_deg >= -20; helm_deg -= 5) hold(helm_deg);
  for (int helm_deg = -15; helm_deg <= 20; helm_deg += 5) hold(helm_deg);
  return rows;
}

TEST(SpiralFigures, OfAStableCraftHaveNoLoop) {
  const Spiral found = spiral(spiral_rows([](double helm, double) { return 0.2 * helm; }));
  ASSERT_EQ(found.points.size(), 17U);
  for (const SpiralPoint& point : found.points) {
    EXPECT_NEAR(point.turn_rad_s, 0.2 * point.helm_rad, 1e-6);
    EXPECT_TRUE(point.is_steady);
  }
  EXPECT_NEAR(found.loop_width_rad.value(), 0, 1e-6);
  EXPECT_NEAR(found.loop_height_rad_s.value(), 0, 1e-6);
}

TEST(SpiralFigures, OfAnUnstableCraftHaveTheLoopOfItsRates) {
  // It stays on its side until the helm is more than 7 degrees against it.
  const Spiral found = spiral(spiral_rows([](double helm, double r) {
    const double to = std::abs(helm) > 7 * degree ? std::copysign(1.0, helm)
                                                  : std::copysign(1.0, r == 0 ? helm : r);
    return 0.02 * to + 0.05 * helm;
  }));
  // On the way down it changes between -5 and -10, on the way up between 5 and 10: straight between
  // the rates there.
  const double before = 0.02 - 0.05 * 5 * degree, after = -0.02 - 0.05 * 10 * degree;
  const double at_deg = 5 + 5 * before / (before - after);
  EXPECT_NEAR(found.loop_width_rad.value(), 2 * at_deg * degree, 1e-6);
  EXPECT_NEAR(found.loop_height_rad_s.value(), 0.04, 1e-6);
}

TEST(SpiralFigures, HaveNoLoopWhereTheHelmsGoOneWay) {
  Rows rows = spiral_rows([](double helm, double) { return 0.2 * helm; });
  rows.resize(9 * 120);  // from 20 to -20 degrees
  EXPECT_EQ(spiral(rows).points.size(), 9U);
  EXPECT_FALSE(spiral(rows).loop_width_rad);
  EXPECT_FALSE(spiral(rows).loop_height_rad_s);
}

TEST(SpiralFigures, SayWhereTheRateIsNotSteadyYet) {
  Rows rows;
  for (int i = 0; i < 100; ++i) {
    ManoeuvreRow row;
    row.t_s = i;
    row.turn_rad_s = 1e-3 * i;
    row.helm_rad = 0.1;
    rows.push_back(row);
  }
  ASSERT_EQ(spiral(rows).points.size(), 1U);
  EXPECT_FALSE(spiral(rows).points[0].is_steady);
}

TEST(PullOutFigures, AreTheRateThatIsLeft) {
  for (const double left : {0.0, 0.01, -0.02}) {
    Rows rows;
    for (int i = 0; i < 600; ++i) {
      ManoeuvreRow row;
      row.t_s = 0.5 * i;
      row.turn_rad_s = i < 100 ? 0.05 : left + (0.05 - left) * std::exp(-(row.t_s - 50) / 8);
      rows.push_back(row);
    }
    EXPECT_NEAR(residual_turn_rad_s(rows, 50), left, 1e-9);
  }
}

struct Response {
  std::vector<double> t_s;
  std::vector<double> value;
};
template <typename Of>
Response response_of(const Of& of, double lasts_s, double dt_s = 0.01) {
  Response out;
  for (double t_s = 0; t_s <= lasts_s; t_s += dt_s) {
    out.t_s.push_back(t_s);
    out.value.push_back(of(t_s));
  }
  return out;
}

TEST(StepFigures, OfALagAreThoseOfItsTimeConstant) {
  const double T_s = 4;
  for (const auto& [from, to] : {std::pair{0.0, 2.0}, std::pair{3.0, -1.0}}) {
    const double start = from, end = to;
    const Response lag =
        response_of([&](double t_s) { return end + (start - end) * std::exp(-t_s / T_s); }, 100);
    const StepResponse found = step_response(lag.t_s, lag.value, from, to);
    // Straight between rows 0.01 s apart: dt^2 / (8 T) = 3e-6 s.
    EXPECT_NEAR(found.rise_s.value(), T_s * std::log(9.0), 1e-5);
    EXPECT_NEAR(found.time_63_s.value(), T_s, 1e-5);
    EXPECT_NEAR(found.settling_s.value(), T_s * std::log(20.0), 1e-5);
    EXPECT_EQ(found.overshoot, 0);
    EXPECT_NEAR(found.steady_error, 0, 1e-7);
  }
}

TEST(StepFigures, OfAnOscillatorHaveItsOvershoot) {
  for (const double zeta : {0.2, 0.5, 0.7}) {
    const double own = std::sqrt(1 - zeta * zeta);
    const Response second = response_of(
        [&](double t_s) {
          return 1 -
                 std::exp(-zeta * t_s) * (std::cos(own * t_s) + zeta / own * std::sin(own * t_s));
        },
        100);
    const StepResponse found = step_response(second.t_s, second.value, 0, 1);
    EXPECT_NEAR(found.overshoot, std::exp(-pi * zeta / own), 2e-5) << zeta;
  }
}

TEST(StepFigures, SayWhatIsNeverReached) {
  const Response short_of = response_of([](double t_s) { return 0.8 * (1 - std::exp(-t_s)); }, 50);
  const StepResponse found = step_response(short_of.t_s, short_of.value, 0, 1);
  EXPECT_FALSE(found.rise_s);
  EXPECT_FALSE(found.settling_s);
  EXPECT_TRUE(found.time_63_s);
  EXPECT_NEAR(found.steady_error, -0.2, 1e-9);
}

}  // namespace
}  // namespace slackwater::twin::manoeuvre_figures_test
