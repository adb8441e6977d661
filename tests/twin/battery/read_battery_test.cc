#include <gtest/gtest.h>

#include <fstream>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "twin/battery/battery_step.h"

namespace slackwater::twin::read_battery_test {
namespace {

using tests::contains;

const std::string pack_yaml = R"(chemistry: nca_nmc_18650
cells_in_series: 4
capacity_ah: 18
resistance_ohm: 0.028
rc_resistance_ohm: 0.010
rc_capacitance_f: 3000
least_voltage_v: 12
most_current_a: 60
temperature_degc: 25
)";
const std::string cell_yaml = R"(name: made up
source: none
state_of_charge: [0, 0.5, 1]
open_circuit_voltage_v: [3, 3.7, 4.2]
capacity: {temperature_degc: [0, 25], factor: [0.8, 1]}
resistance: {temperature_degc: [0, 25], factor: [2, 1]}
)";

std::string with(std::string yaml, const std::string& line, const std::string& instead) {
  const std::size_t at = yaml.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  return yaml.replace(at, line.size(), instead);
}

Battery read(const std::string& pack, const std::filesystem::path& data) {
  const Config config = Config::parse(pack, "made-up.yaml");
  Battery battery = read_battery(config, data);
  config.expect_all_read();
  return battery;
}
Battery read(const std::string& pack) { return read(pack, tests::source_folder() / "data"); }

template <typename Work>
std::string refusal_of(Work&& work) {
  try {
    (void)work();
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "nothing was refused";
}
std::string refusal(const std::string& line, const std::string& instead) {
  return refusal_of([&] { return read(with(pack_yaml, line, instead)); });
}

TEST(ReadBattery, APackIsItsCellsInSeries) {
  const Battery battery = read(pack_yaml);
  EXPECT_NEAR(rest_voltage_v(battery, rested(battery, 1)), 16.72, 1e-12);
  EXPECT_NEAR(rest_voltage_v(battery, rested(battery, 0)), 12, 1e-12);
  EXPECT_NEAR(rest_voltage_v(battery, rested(battery, 0.05)), 13.4, 1e-12);
  EXPECT_NEAR(rest_voltage_v(battery, rested(battery, 0.45)), 14.8, 1e-12);
  EXPECT_EQ(battery.capacity_c, 64800);
  EXPECT_EQ(battery.resistance_ohm, 0.028);
}

TEST(ReadBattery, TheColdTakesCapacityAndAddsResistance) {
  const Battery cold = read(with(pack_yaml, "degc: 25", "degc: 5"));
  EXPECT_NEAR(cold.capacity_c, 64800 * 0.895, 1e-9);
  EXPECT_NEAR(cold.resistance_ohm, 0.028 * 1.575, 1e-12);
  EXPECT_NEAR(cold.rc_resistance_ohm, 0.010 * 1.575, 1e-12);
  const Battery unsaid = read(with(pack_yaml, "temperature_degc: 25\n", ""));
  EXPECT_NEAR(unsaid.capacity_c, 64800 * 0.96, 1e-9);  // 15 degrees
}

TEST(ReadBattery, RefusesWhatNoPackIsAndSaysWhatToDo) {
  EXPECT_TRUE(contains(refusal("capacity_ah: 18", "capacity_ah: 0"), "capacity_ah"));
  EXPECT_TRUE(contains(refusal("capacity_ah: 18", "capacity_ah: 18000"), "Ah, not mAh"));
  EXPECT_TRUE(contains(refusal("capacity_ah: 18", "capacity_ah: .nan"), "capacity_ah"));
  EXPECT_TRUE(contains(refusal("resistance_ohm: 0.028", "resistance_ohm: 28"), "resistance_ohm"));
  EXPECT_TRUE(contains(refusal("resistance_ohm: 0.028", "resistance_ohm: 2.8"), "not milliohm"));
  EXPECT_TRUE(
      contains(refusal("rc_capacitance_f: 3000", "rc_capacitance_f: 0"), "rc_capacitance_f"));
  EXPECT_TRUE(contains(refusal("least_voltage_v: 12", "least_voltage_v: 3.0"), "not a cell's"));
  EXPECT_TRUE(
      contains(refusal("least_voltage_v: 12", "least_voltage_v: 16.8"), "16.72 V when full"));
  EXPECT_TRUE(contains(refusal("degc: 25", "degc: 60"), "from -10 to 40"));
  EXPECT_TRUE(contains(refusal("degc: 25", "degc: 288"), "temperature_degc"));
  EXPECT_TRUE(contains(refusal("cells_in_series: 4", "cells_in_series: 0"), "cells_in_series"));
  EXPECT_TRUE(contains(refusal("chemistry: nca_nmc_18650", "chemistry: nca"), "lipo_hobby"));
  EXPECT_TRUE(
      contains(refusal("chemistry: nca_nmc_18650", "chemistry: ../vehicles/x500"), "chemistry"));
  EXPECT_TRUE(contains(refusal("most_current_a", "max_current_a"), "most_current_a"));
}

TEST(ReadBattery, RefusesCurvesThatNoCellHas) {
  const tests::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "batteries");
  const auto refused = [&](const std::string& line, const std::string& instead) {
    std::ofstream(folder.path() / "batteries" / "made_up.yaml") << with(cell_yaml, line, instead);
    return refusal_of(
        [&] { return read(with(pack_yaml, "nca_nmc_18650", "made_up"), folder.path()); });
  };
  EXPECT_EQ(refused("made up", "made up"), "nothing was refused");
  EXPECT_TRUE(contains(refused("[3, 3.7, 4.2]", "[3, 4.3, 4.2]"), "rises with its charge"));
  EXPECT_TRUE(contains(refused("[3, 3.7, 4.2]", "[3, 4.2]"), "found 2 values for the 3"));
  EXPECT_TRUE(contains(refused("[3, 3.7, 4.2]", "[3000, 3700, 4200]"), "open_circuit_voltage_v"));
  EXPECT_TRUE(contains(refused("[3, 3.7, 4.2]", "[3, .nan, 4.2]"), "open_circuit_voltage_v"));
  EXPECT_TRUE(contains(refused("[0, 0.5, 1]", "[0.1, 0.5, 1]"), "from 0 (empty) to 1 (full)"));
  EXPECT_TRUE(contains(refused("[0, 0.5, 1]", "[0, 0, 1]"), "rising order"));
  EXPECT_TRUE(contains(refused("[0, 0.5, 1]", "[0, 0.33331, 1]"), "round them"));
  EXPECT_TRUE(contains(refused("factor: [0.8, 1]", "factor: [0.8, 0]"), "capacity.factor"));
}

}  // namespace
}  // namespace slackwater::twin::read_battery_test
