#include "fields/wind/farm_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "tests/support/shared_data.h"

namespace slackwater::farm_flow_test {
namespace {

constexpr double d_m = 126.0;
constexpr Horizontal west_wind{10.0, 0.0};

const Turbine& nrel_5mw() {
  static const Turbine turbine =
      Turbine::load(tests::source_folder() / "data" / "turbines" / "nrel_5mw.yaml");
  return turbine;
}

FarmSettings settings_of(WakeModel model, Superposition rule = {}) {
  FarmSettings settings;
  settings.wake.model = model;
  settings.superposition = rule;
  return settings;
}

std::vector<Horizontal> random_layout(std::uint64_t seed, int n) {
  Rng rng(seed, "farm_layout");
  std::vector<Horizontal> out;
  for (int i = 0; i < n; ++i) out.emplace_back(rng.uniform(-3000, 3000), rng.uniform(-3000, 3000));
  return out;
}

TEST(FarmFlow, GivesALoneTurbineTheFreeWind) {
  const std::vector<Horizontal> one{{100, 200}};
  const FarmFlow flow(nrel_5mw(), one, west_wind, {});
  EXPECT_NEAR(flow.turbines()[0].inflow_speed_m_s, 10, 1e-13);
  EXPECT_NEAR(flow.power_w(), nrel_5mw().power_w(10), 1e-6);
  EXPECT_DOUBLE_EQ(flow.turbines()[0].turbulence_intensity, 0.08);
  EXPECT_EQ(flow.speed_ratio({0, 200}, 90), 1);              // ahead
  EXPECT_NEAR(flow.speed_ratio({500, 3000}, 90), 1, 1e-12);  // beside
  EXPECT_LT(flow.speed_ratio({700, 200}, 90), 0.8);
  EXPECT_LT(flow.speed_ratio({700, 200}, 90), flow.speed_ratio({700, 200}, 20));
}

TEST(FarmFlow, AddsTheWakesOfARowAsEachRuleSays) {
  // Jensen's disc covers the whole rotor behind, so that the sums can be done by hand.
  const std::vector<Horizontal> row{{0, 0}, {7 * d_m, 0}, {14 * d_m, 0}};
  const auto deficit = [](double ct, double x) {
    return (1 - std::sqrt(1 - ct)) * std::pow(1 / (1 + 0.08 * x), 2);
  };
  using Scale = Superposition::Scale;
  using Sum = Superposition::Sum;
  for (const Scale scale : {Scale::free_stream, Scale::local_inflow})
    for (const Sum sum : {Sum::linear, Sum::root_sum_square}) {
      const FarmFlow flow(nrel_5mw(), row, west_wind, settings_of(WakeModel::jensen, {scale, sum}));
      const double ct_1 = nrel_5mw().thrust_coefficient(10);
      const double u_2 = 10 * (1 - deficit(ct_1, 7));
      const double ct_2 = nrel_5mw().thrust_coefficient(u_2);
      const double from_1 = 10 * deficit(ct_1, 14);
      const double from_2 = (scale == Scale::free_stream ? 10 : u_2) * deficit(ct_2, 7);
      const double lost = sum == Sum::linear ? from_1 + from_2 : std::hypot(from_1, from_2);
      EXPECT_NEAR(flow.turbines()[1].inflow_speed_m_s, u_2, 1e-12);
      EXPECT_NEAR(flow.turbines()[2].inflow_speed_m_s, 10 - lost, 1e-12);
      EXPECT_NEAR(flow.turbines()[2].power_w, nrel_5mw().power_w(10 - lost), 1e-4);
    }
}

TEST(FarmFlow, AddsTurbulenceBehindARotorAndNotBesideIt) {
  const std::vector<Horizontal> four{
      {0, 0}, {7 * d_m, 0}, {7 * d_m, 10 * d_m}, {7 * d_m, -10 * d_m}};
  const FarmFlow flow(nrel_5mw(), four, west_wind, {});
  const double ct = nrel_5mw().thrust_coefficient(10);
  EXPECT_NEAR(flow.turbines()[1].turbulence_intensity,
              std::hypot(0.08, added_turbulence(ct, 0.08, 7)), 1e-12);
  EXPECT_DOUBLE_EQ(flow.turbines()[2].turbulence_intensity, 0.08);
  EXPECT_DOUBLE_EQ(flow.turbines()[3].turbulence_intensity, 0.08);
}

TEST(FarmFlow, AveragesTheWindOverTheWholeRotor) {
  // A rotor half in the wake of another, against a fine sum over squares of half a metre.
  const std::vector<Horizontal> pair{{0, 0}, {6 * d_m, 0.6 * d_m}};
  const FarmFlow flow(nrel_5mw(), pair, west_wind, settings_of(WakeModel::gaussian));
  const Wake wake =
      make_wake({.model = WakeModel::gaussian}, d_m, 90, nrel_5mw().thrust_coefficient(10), 0.08);
  double sum = 0;
  int count = 0;
  for (double y = -63.25; y < 63.5; y += 0.5)
    for (double z = -63.25; z < 63.5; z += 0.5) {
      if (std::hypot(y, z) > 63) continue;
      sum += 10 * (1 - wake_deficit(wake, 6 * d_m, std::hypot(0.6 * d_m + y, z)));
      ++count;
    }
  // The rim is known to half a metre of 63: 1e-3 m/s.
  EXPECT_NEAR(flow.turbines()[1].inflow_speed_m_s, sum / count, 1e-3);
  EXPECT_LT(flow.turbines()[1].inflow_speed_m_s, 9.5);
}

TEST(FarmFlow, TurnsWithTheWindAndMovesWithTheFarm) {
  const std::vector<Horizontal> layout = random_layout(3, 16);
  for (const WakeModel model :
       {WakeModel::jensen, WakeModel::gaussian, WakeModel::larsen, WakeModel::blended}) {
    const FarmFlow flow(nrel_5mw(), layout, west_wind, settings_of(model));
    const Horizontal turn = std::polar(1.0, 0.7);
    const Horizontal shift{12000, -5000};
    std::vector<Horizontal> turned;
    for (const Horizontal& at : layout) turned.push_back(at * turn + shift);
    const FarmFlow other(nrel_5mw(), turned, west_wind * turn, settings_of(model));
    for (std::size_t i = 0; i < layout.size(); ++i) {
      // Jensen's edge is a cliff: no point of a disc of this layout is within rounding of it.
      EXPECT_NEAR(flow.turbines()[i].inflow_speed_m_s, other.turbines()[i].inflow_speed_m_s, 1e-9);
    }
    EXPECT_NEAR(flow.speed_ratio({500, 300}, 60),
                other.speed_ratio(Horizontal(500, 300) * turn + shift, 60), 1e-11);
  }
}

TEST(FarmFlow, DoesNotCareInWhichOrderTheTurbinesAreGiven) {
  std::vector<Horizontal> layout = random_layout(4, 16);
  const FarmFlow flow(nrel_5mw(), layout, {-6, 7}, {});
  std::reverse(layout.begin(), layout.end());
  const FarmFlow reversed(nrel_5mw(), layout, {-6, 7}, {});
  for (std::size_t i = 0; i < layout.size(); ++i)
    EXPECT_EQ(flow.turbines()[i], reversed.turbines()[layout.size() - 1 - i]);
}

TEST(FarmFlow, LosesPowerInEveryModelAndNeverMakesWind) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const WakeModel model :
         {WakeModel::jensen, WakeModel::gaussian, WakeModel::larsen, WakeModel::blended}) {
      const std::vector<Horizontal> layout = random_layout(seed, 25);
      const FarmFlow flow(nrel_5mw(), layout, {0, -9}, settings_of(model));
      EXPECT_LT(flow.power_w(), 25 * nrel_5mw().power_w(9)) << "seed " << seed;
      for (const TurbineFlow& at : flow.turbines()) {
        EXPECT_LE(at.inflow_speed_m_s, 9 * (1 + 1e-14));
        EXPECT_GE(at.inflow_speed_m_s, 0);
      }
    }
}

TEST(FarmFlow, HasNoWakesInACalmNorInAStorm) {
  const std::vector<Horizontal> row{{0, 0}, {7 * d_m, 0}};
  for (const double speed : {0.0, 2.5, 26.0, 50.0}) {
    const FarmFlow flow(nrel_5mw(), row, {speed, 0}, {});
    EXPECT_EQ(flow.power_w(), 0) << speed;
    EXPECT_EQ(flow.speed_ratio({500, 0}, 90), 1) << speed;
    EXPECT_NEAR(flow.turbines()[1].inflow_speed_m_s, speed, 1e-12);
  }
}

TEST(FarmFlow, LeavesATurbineBelowCutInWithoutAWakeOfItsOwn) {
  // In 3.2 m/s the second turbine stands in 2.x m/s and turns no more.
  const std::vector<Horizontal> row{{0, 0}, {5 * d_m, 0}};
  const FarmFlow flow(nrel_5mw(), row, {3.2, 0}, {});
  EXPECT_GT(flow.turbines()[0].power_w, 0);
  EXPECT_LT(flow.turbines()[1].inflow_speed_m_s, 3);
  EXPECT_EQ(flow.turbines()[1].power_w, 0);
  EXPECT_EQ(flow.turbines()[1].thrust_coefficient, 0);
}

TEST(FarmFlow, MapsTheSameRatiosThatItSamples) {
  const std::vector<Horizontal> layout = random_layout(8, 16);
  const HorizontalGrid grid{{-3500, -3200}, 71.0, 67.0, 100, 96};
  std::vector<double> map(grid.columns * grid.rows);
  for (const WakeModel model :
       {WakeModel::jensen, WakeModel::gaussian, WakeModel::larsen, WakeModel::blended})
    for (const Superposition::Sum sum :
         {Superposition::Sum::linear, Superposition::Sum::root_sum_square}) {
      const Superposition rule{Superposition::Scale::local_inflow, sum};
      const FarmFlow flow(nrel_5mw(), layout, {7, -5}, settings_of(model, rule));
      flow.speed_ratios(grid, map);
      double deepest = 1;
      for (std::size_t row = 0; row < grid.rows; ++row)
        for (std::size_t column = 0; column < grid.columns; ++column) {
          const Horizontal at = grid.south_west_m + Horizontal(71.0 * static_cast<double>(column),
                                                               67.0 * static_cast<double>(row));
          // Rounding of positions alone, against gradients of 0.1 per metre; each wake's border of
          // 2e-8 may fall on either side.
          ASSERT_NEAR(map[row * grid.columns + column], flow.speed_ratio(at, 90), 4e-7);
          deepest = std::min(deepest, map[row * grid.columns + column]);
        }
      EXPECT_LT(deepest, 0.7);
    }
}

TEST(FarmFlow, RefusesTurbinesOnOnePlaceAndMapsOfAnotherSize) {
  const std::vector<Horizontal> twice{{1, 1}, {1, 1}};
  EXPECT_THROW(FarmFlow(nrel_5mw(), twice, west_wind, {}), ContractViolation);
  const std::vector<Horizontal> one{{1, 1}};
  EXPECT_THROW(FarmFlow(nrel_5mw(), one, {std::nan(""), 0}, {}), ContractViolation);
  const FarmFlow flow(nrel_5mw(), one, west_wind, {});
  std::vector<double> map(5);
  EXPECT_THROW(flow.speed_ratios({{0, 0}, 1, 1, 2, 3}, map), ContractViolation);
}

}  // namespace
}  // namespace slackwater::farm_flow_test
