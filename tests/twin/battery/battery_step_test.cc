#include "twin/battery/battery_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "tests/support/battery_for_tests.h"
#include "tests/support/lanes_for_tests.h"

namespace slackwater::twin::battery_step_test {
namespace {

using tests::made_up_battery;
using State = BatteryState<double>;
using Output = BatteryOutput<double>;

Battery without_pair() {
  Battery battery = made_up_battery();
  battery.rc_resistance_ohm = 0;
  return battery;
}

/// I = (V - sqrt(V^2 - 4 R P))/(2 R): 15.2 V, 28 mOhm, 300 W.
TEST(BatteryStep, AConstantPowerLoadDrawsTheSmallerRoot) {
  const Battery battery = without_pair();
  State state = rested(battery, 0.5);
  const Output out = discharge(battery, battery_step(battery, 0.1), state, 300.0);
  EXPECT_NEAR(out.current_a, 20.5119, 5e-5);
  EXPECT_NEAR(out.terminal_voltage_v, 14.62567, 5e-6);
  EXPECT_NEAR(out.power_w, 300, 1e-10);
  EXPECT_EQ(out.curtailed, 0);
}

/// V1' = V1 e^(-dt/R1C1) + I R1 (1 - e^(-dt/R1C1)): 30 A for 60 s, 0.2594 V, whatever the step.
TEST(BatteryStep, TheResistorAndCapacitorMoveExactly) {
  const Battery battery = made_up_battery();
  for (const double dt_s : {0.1, 1.0, 20.0, 60.0}) {
    State state = rested(battery, 0.5);
    // A load of constant current, so that the closed form holds: limited to it.
    Battery limited = battery;
    limited.most_current_a = 30;
    const BatteryStep step = battery_step(limited, dt_s);
    for (double t = 0; t < 60 - 1e-6; t += dt_s) (void)discharge(limited, step, state, 1500.0);
    EXPECT_NEAR(state.rc_voltage_v, 0.2594, 5e-5) << dt_s << " s";
    EXPECT_NEAR(state.rc_voltage_v, 0.3 * (1 - std::exp(-2.0)), 1e-12) << dt_s << " s";
  }
}

TEST(BatteryStep, GivesAtMostTheSquareOfTheVoltageOverFourTimesTheResistance) {
  const Battery battery = without_pair();
  const BatteryStep step = battery_step(battery, 0.1);
  State state = rested(battery, 0.5);
  const Output most = discharge(battery, step, state, 5000.0);
  EXPECT_NEAR(most.power_w, 2062.857, 5e-4);
  EXPECT_NEAR(most.terminal_voltage_v, 7.6, 1e-9);
  EXPECT_EQ(most.curtailed, 1);
  state = rested(battery, 0.5);
  EXPECT_EQ(discharge(battery, step, state, 2062.85).curtailed, 0);
}

TEST(BatteryStep, TheCurrentLimitHoldsAndCurtails) {
  Battery battery = made_up_battery();
  battery.most_current_a = 60;
  State state = rested(battery, 0.5);
  const Output out = discharge(battery, battery_step(battery, 0.05), state, 1200.0);
  EXPECT_EQ(out.current_a, 60);
  EXPECT_EQ(out.curtailed, 1);
  EXPECT_NEAR(out.power_w, 60 * (15.2 - 60 * 0.028), 0.5);  // less what V1 builds up in 50 ms
  EXPECT_LT(out.power_w, 60 * (15.2 - 60 * 0.028));
}

TEST(BatteryStep, WithoutALoadNothingMovesButThePairRelaxes) {
  const Battery battery = made_up_battery();
  State state = rested(battery, 0.7);
  state.rc_voltage_v = 0.2;
  const Output out = discharge(battery, battery_step(battery, 30), state, 0.0);
  EXPECT_EQ(out.current_a, 0);
  EXPECT_EQ(out.curtailed, 0);
  EXPECT_EQ(state.charge, 0.7);
  EXPECT_NEAR(state.rc_voltage_v, 0.2 * std::exp(-1.0), 1e-15);
  EXPECT_EQ(rest_voltage_v(battery, state), 15.2 - state.rc_voltage_v);
}

/// Over a whole discharge: area under the open-circuit curve = delivered + I^2 R0 + V1^2/R1 + what
/// is left in C1.
TEST(BatteryStep, ChargeAndEnergyBalanceOverAWholeDischarge) {
  Battery battery = made_up_battery(12.0, 16.8);
  battery.open_circuit_v = {12.0, 14.2, 14.9, 15.7, 16.8};
  for (const double dt_s : {0.05, 1.0}) {
    const BatteryStep step = battery_step(battery, dt_s);
    State state = rested(battery, 1);
    double in_r0_j = 0, in_r1_j = 0, charge_c = 0, delivered_j = 0;
    // The load swings, so that the pair is never at rest.
    for (int i = 0; state.off < 0.5 && i * dt_s < 1e5; ++i) {
      const double load_w = 150 + 120 * std::sin(0.2 * i * dt_s);
      const double before_v = state.rc_voltage_v;
      const Output out = discharge(battery, step, state, load_w);
      charge_c += out.current_a * dt_s;
      delivered_j += out.power_w * dt_s;
      in_r0_j += out.current_a * out.current_a * battery.resistance_ohm * dt_s;
      const double middle_v = 0.5 * (before_v + state.rc_voltage_v);
      in_r1_j += middle_v * middle_v / battery.rc_resistance_ohm * dt_s;
    }
    ASSERT_EQ(state.off, 1);
    EXPECT_NEAR(charge_c / battery.capacity_c, 1, 1e-9);
    EXPECT_NEAR(state.drawn_c, charge_c, 1e-6);
    EXPECT_NEAR(state.delivered_j, delivered_j, 1e-3);
    const double stored_j =
        0.5 * battery.rc_capacitance_f * state.rc_voltage_v * state.rc_voltage_v;
    const double open_j = open_circuit_energy_j(battery, 1, 0);
    // By hand: trapezoids of the five voltages.
    EXPECT_NEAR(open_j, battery.capacity_c * (14.4 + 14.2 + 14.9 + 15.7) / 4, 1e-6);
    const double balance = (delivered_j + in_r0_j + in_r1_j + stored_j) / open_j;
    EXPECT_NEAR(balance, 1, 2e-6) << dt_s << " s";  // the issue asks for 1e-3
    EXPECT_GT(in_r0_j, 0.01 * open_j);              // and the losses are no rounding
    EXPECT_GT(in_r1_j, 0.004 * open_j);
  }
}

TEST(BatteryStep, TheEnergyGivenIsOfSecondOrderInTheStep) {
  Battery battery = made_up_battery(11, 17);
  battery.rc_capacitance_f = 600;  // 6 s, so that the steps below see it bend
  const auto charge_after = [&](double dt_s) {
    State state = rested(battery, 0.95);
    const BatteryStep step = battery_step(battery, dt_s);
    for (double t = 0; t < 48 - 1e-6; t += dt_s) (void)discharge(battery, step, state, 600.0);
    return state.charge;
  };
  const double exact = charge_after(0.01);
  const double coarse = std::abs(charge_after(4) - exact);
  const double fine = std::abs(charge_after(2) - exact);
  EXPECT_GT(coarse, 1e-9);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.35);
}

TEST(BatteryStep, ALastingLowVoltageEndsItAndAPassingOneDoesNot) {
  Battery battery = made_up_battery();
  battery.least_voltage_v = 14;
  const BatteryStep step = battery_step(battery, 0.5);
  const auto draw = [&](State& state, double load_w, double seconds) {
    for (double t = 0; t < seconds - 1e-9; t += 0.5) (void)discharge(battery, step, state, load_w);
  };
  State state = rested(battery, 0.5);
  draw(state, 700, 9.5);  // 46 A: 13.8 V
  EXPECT_EQ(state.off, 0);
  draw(state, 10, 1);
  draw(state, 700, 9.5);
  EXPECT_EQ(state.off, 0);
  draw(state, 700, 1);
  EXPECT_EQ(state.off, 1);
  const Output after = discharge(battery, step, state, 10.0);
  EXPECT_EQ(state.off, 1);  // though the voltage is back
  EXPECT_GT(after.terminal_voltage_v, 14);
  EXPECT_EQ(after.current_a, 0);
  EXPECT_EQ(after.power_w, 0);
  EXPECT_EQ(after.curtailed, 1);
}

TEST(BatteryStep, AnEmptyBatteryGivesNoMoreThanItHad) {
  const Battery battery = made_up_battery(12, 16.8);
  State state = rested(battery, 1e-5);  // 0.648 C
  const BatteryStep step = battery_step(battery, 0.1);
  for (int i = 0; i < 10; ++i) (void)discharge(battery, step, state, 200.0);
  EXPECT_EQ(state.off, 1);
  EXPECT_NEAR(state.drawn_c, 0.648, 1e-9);
  EXPECT_GE(state.charge, 0);
  EXPECT_EQ(rested(battery, 0).off, 1);
}

TEST(BatteryStep, EightLanesGiveTheBitsOfOne) {
  const Battery battery = [] {
    Battery b = made_up_battery(12, 16.8);
    b.most_current_a = 60;
    b.least_voltage_v = 13;
    b.cut_off_delay_s = 2;
    return b;
  }();
  const BatteryStep step = battery_step(battery, 0.1);
  Rng random(7, "tests/battery_lanes");
  State one[8];
  BatteryState<tests::Lanes> eight;
  double charge[8];
  for (std::size_t i = 0; i < 8; ++i)
    one[i] = rested(battery, charge[i] = 0.001 + 0.12 * static_cast<double>(i));
  eight.charge = tests::lanes_of(charge);
  for (const auto member :
       {&BatteryState<tests::Lanes>::rc_voltage_v, &BatteryState<tests::Lanes>::low_for_s,
        &BatteryState<tests::Lanes>::off, &BatteryState<tests::Lanes>::drawn_c,
        &BatteryState<tests::Lanes>::delivered_j}) {
    eight.*member = tests::Lanes::all(0);
  }
  int ended = 0;
  for (int i = 0; i < 2000; ++i) {
    double load_w[8];
    for (double& w : load_w) w = random.uniform(0, 1600);
    const BatteryOutput<tests::Lanes> out =
        discharge(battery, step, eight, tests::lanes_of(load_w));
    for (std::size_t k = 0; k < 8; ++k) {
      const Output alone = discharge(battery, step, one[k], load_w[k]);
      ASSERT_EQ(alone.power_w, tests::lane_of(out.power_w, k));
      ASSERT_EQ(alone.terminal_voltage_v, tests::lane_of(out.terminal_voltage_v, k));
      ASSERT_EQ(alone.curtailed, tests::lane_of(out.curtailed, k));
      ASSERT_EQ(one[k].charge, tests::lane_of(eight.charge, k));
      ASSERT_EQ(one[k].rc_voltage_v, tests::lane_of(eight.rc_voltage_v, k));
      ASSERT_EQ(one[k].off, tests::lane_of(eight.off, k));
    }
  }
  for (const State& state : one) ended += state.off > 0.5 ? 1 : 0;
  EXPECT_GT(ended, 0);
  EXPECT_LT(ended, 8);
}

TEST(BatteryStep, RefusesAStepWithoutLength) {
  EXPECT_THROW((void)battery_step(made_up_battery(), 0), ContractViolation);
  EXPECT_THROW((void)rested(made_up_battery(), 1.1), ContractViolation);
}

}  // namespace
}  // namespace slackwater::twin::battery_step_test
