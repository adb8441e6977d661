// How long a battery gives a steady power, beside the energy of its curve.
#include "twin/battery/lasts.h"

#include <gtest/gtest.h>

#include "tests/support/vehicle_for_tests.h"

namespace slackwater::twin::lasts_test {
namespace {

TEST(BatteryLasts, AsLongAsItsEnergyDoesWhereNothingIsLost) {
  Battery ideal = *tests::bundled_vehicle("remus100").battery;
  ideal.resistance_ohm = ideal.rc_resistance_ohm = 1e-9;
  ideal.least_voltage_v = 0;
  const double energy_j = open_circuit_energy_j(ideal, 1, 0);
  EXPECT_GT(energy_j, 800 * 3600);
  for (const double power_w : {20.0, 100.0, 400.0})
    EXPECT_NEAR(lasts_s(ideal, power_w), energy_j / power_w, 0.003 * energy_j / power_w) << power_w;
}

TEST(BatteryLasts, ShorterUnderALargeLoadAndNotForAMomentBeyondWhatItGives) {
  const Battery battery = *tests::bundled_vehicle("remus100").battery;
  const double energy_j = open_circuit_energy_j(battery, 1, 0);
  EXPECT_LT(600 * lasts_s(battery, 600), 0.97 * energy_j);
  EXPECT_GT(600 * lasts_s(battery, 600), 0.5 * energy_j);
  EXPECT_EQ(lasts_s(battery, 1e6), 0);
}

}  // namespace
}  // namespace slackwater::twin::lasts_test
