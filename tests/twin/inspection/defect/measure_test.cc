#include "twin/inspection/defect/measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "tests/twin/inspection/defect/defects_for_tests.h"

namespace slackwater::tests::measure_test {
namespace {

using twin::DefectKind;
using twin::Instrument;
using twin::InstrumentKind;
using twin::Quantity;

struct Measures {
  const char* name;
  Quantity quantity;
  InstrumentKind by;
  const char* unit;
  double noise_sd;
  double noise_per_range;
  double bias_sd;
  double range_m;
  double severity;
};

// Each with figures of its own, in the unit of its instrument.
const Measures cases[]{
    {"scour", Quantity::scour_depth, InstrumentKind::multibeam, "m", 0.05, 0.002, 0.03, 20, 1.2},
    {"burial", Quantity::burial_depth, InstrumentKind::magnetometer, "m", 0.03, 0.02, 0.02, 1, 0.4},
    {"thickness", Quantity::wall_thickness, InstrumentKind::thickness, "mm", 0.2, 0, 0.1, 0.01,
     0.002},
    {"potential in mV", Quantity::potential, InstrumentKind::potential, "mV", 5, 0, 3, 0.05, 0.3},
    {"potential in V", Quantity::potential, InstrumentKind::potential, "V", 0.005, 0, 0.003, 0.05,
     0.9},
    {"chain", Quantity::chain_diameter, InstrumentKind::rgb, "m", 0.0005, 0, 0.0002, 1, 0.03},
    {"growth", Quantity::growth_thickness, InstrumentKind::lidar, "m", 0.003, 0.001, 0.002, 2, 0.1},
};

Instrument made(const Measures& c) {
  Instrument i = instrument(c.by, c.unit);
  i.noise_sd = c.noise_sd;
  i.noise_per_range = c.noise_per_range;
  i.bias_sd = c.bias_sd;
  return i;
}

TEST(Measures, ScatterAsTheirInstrumentSaysAboutATruthOffByItsBias) {
  // Sorties of so many readings: within one the noise, between their means the bias.
  constexpr int sorties = 400, readings = 100;
  for (const Measures& c : cases) {
    const Instrument by = made(c);
    const double unit = twin::unit_factor(c.quantity, by);
    const double truth = twin::value_of(c.quantity, c.severity, facts());
    double within = 0, mean = 0, between = 0;
    for (int s = 0; s < sorties; ++s) {
      double sum = 0, squares = 0;
      for (int r = 0; r < readings; ++r) {
        const std::string place = std::to_string(r);
        const twin::ReadingKey key{static_cast<std::uint64_t>(s), "rov1/probe", place};
        const double off = twin::measured(c.quantity, truth, by, c.range_m, key) - truth;
        sum += off;
        squares += off * off;
      }
      within += (squares - sum * sum / readings) / (readings - 1) / sorties;
      mean += sum / readings / sorties;
      between += sum / readings * (sum / readings) / sorties;
    }
    const double sd = unit * (c.noise_sd + c.noise_per_range * c.range_m);
    const double bias_sd = unit * c.bias_sd;
    // Of a variance from n normals: relative (2/n)^(1/2); three of these.
    const double n = static_cast<double>(sorties) * (readings - 1);
    EXPECT_NEAR(within / (sd * sd), 1, 3 * std::sqrt(2 / n)) << c.name;
    const double means = bias_sd * bias_sd + sd * sd / readings;
    EXPECT_NEAR(between / means, 1, 3 * std::sqrt(2.0 / sorties)) << c.name;
    EXPECT_NEAR(mean, 0, 3 * std::sqrt(means / sorties)) << c.name;
  }
}

TEST(Measures, AreTheSameWheneverTheyAreAskedFor) {
  const Instrument by = made(cases[0]);
  const auto at = [&](std::uint64_t seed, const char* name, const char* place) {
    return twin::measured(Quantity::scour_depth, 1, by, 20, {seed, name, place});
  };
  EXPECT_EQ(at(1, "rov1/mbes", "3"), at(1, "rov1/mbes", "3"));
  EXPECT_NE(at(1, "rov1/mbes", "3"), at(2, "rov1/mbes", "3"));
  EXPECT_NE(at(1, "rov1/mbes", "3"), at(1, "rov2/mbes", "3"));
  EXPECT_NE(at(1, "rov1/mbes", "3"), at(1, "rov1/mbes", "4"));
}

TEST(Measures, OfOneSortieShareTheirBias) {
  Instrument by = made(cases[0]);
  by.noise_sd = by.noise_per_range = 0;
  const double first = twin::measured(Quantity::scour_depth, 1, by, 20, {1, "rov1/mbes", "3"});
  EXPECT_NE(first, 1);
  EXPECT_EQ(twin::measured(Quantity::scour_depth, 1, by, 5, {1, "rov1/mbes", "4"}), first);
  EXPECT_NE(twin::measured(Quantity::scour_depth, 1, by, 5, {2, "rov1/mbes", "4"}), first);
}

TEST(Measures, TellTheSeverityBack) {
  for (const Measures& c : cases) {
    const double value = twin::value_of(c.quantity, c.severity, facts());
    EXPECT_NEAR(twin::severity_of(c.quantity, value, facts()), c.severity, 1e-12) << c.name;
  }
  // What grew thicker is taken for sound, not for less than that.
  EXPECT_EQ(twin::severity_of(Quantity::wall_thickness, facts().wall_m + 0.001, facts()), 0);
}

TEST(Measures, OfAnAnodeStayProtectedUntilItsUtilisation) {
  const twin::PotentialRule& rule = facts().potential;
  EXPECT_EQ(twin::potential_mv(rule, 0), -1050);
  EXPECT_NEAR(twin::potential_mv(rule, 0.4), -925, 1e-9);
  EXPECT_NEAR(twin::potential_mv(rule, 0.8), -800, 1e-9);
  EXPECT_NEAR(twin::potential_mv(rule, 1), -650, 1e-9);
  for (double x = 0; x <= 1; x += 0.01)
    EXPECT_NEAR(twin::depletion_of(rule, twin::potential_mv(rule, x)), x, 1e-12);
  EXPECT_EQ(twin::depletion_of(rule, -1100), 0);
  EXPECT_EQ(twin::depletion_of(rule, -500), 1);
}

TEST(Measures, AreMadeByWhatCanMakeThem) {
  EXPECT_EQ(twin::quantity_of(DefectKind::scour, InstrumentKind::multibeam), Quantity::scour_depth);
  EXPECT_EQ(twin::quantity_of(DefectKind::corrosion, InstrumentKind::thickness),
            Quantity::wall_thickness);
  EXPECT_FALSE(twin::quantity_of(DefectKind::crack, InstrumentKind::rgb));
  EXPECT_FALSE(twin::quantity_of(DefectKind::scour, InstrumentKind::side_scan));
}

TEST(Measures, RefuseAUnitThatIsNotTheirs) {
  const auto says = [](Quantity quantity, const char* unit) {
    return message_of(
        [&] { (void)twin::unit_factor(quantity, instrument(InstrumentKind::potential, unit)); });
  };
  EXPECT_NE(says(Quantity::potential, "m").find("expected mV or V"), std::string::npos);
  EXPECT_NE(says(Quantity::scour_depth, "").find("expected m or mm"), std::string::npos);
  EXPECT_EQ(says(Quantity::wall_thickness, "mm"), "");
}

}  // namespace
}  // namespace slackwater::tests::measure_test
