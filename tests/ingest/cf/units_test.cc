#include "ingest/cf/units.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"

namespace slackwater::ingest::units_test {
namespace {

TEST(UnitConversion, SpellingsOfOneUnitAreIdentities) {
  for (const char* spelling : {"m s-1", "m/s", "m s**-1", "meter second-1", "m.s-1", "m s^-1"}) {
    EXPECT_TRUE(unit_conversion(spelling, "m s-1", "u").is_identity()) << spelling;
  }
  for (const char* spelling : {"degree", "degrees", "Degree true", "degree_true", "degrees_true"}) {
    EXPECT_TRUE(unit_conversion(spelling, "degree", "direction").is_identity()) << spelling;
  }
}

TEST(UnitConversion, ScalesAndOffsetsAreThoseOfTheUnits) {
  EXPECT_DOUBLE_EQ(unit_conversion("cm s-1", "m s-1", "u").scale, 0.01);
  EXPECT_NEAR(unit_conversion("knot", "m s-1", "u").scale, 1852.0 / 3600.0,
              1e-12);  // the international knot
  EXPECT_DOUBLE_EQ(unit_conversion("degrees_C", "K", "t").offset, 273.15);
  EXPECT_NEAR(unit_conversion("degF", "K", "t").scale, 5.0 / 9.0, 1e-9);
  EXPECT_DOUBLE_EQ(unit_conversion("km", "m", "depth").scale, 1000.0);
}

TEST(UnitConversion, AnotherDimensionIsRefusedByName) {
  for (const char* unit : {"K", "m", "furious", "", "1", "dBZ"}) {
    try {
      (void)unit_conversion(unit, "m s-1", "variable 'uo'");
      FAIL() << "accepted '" << unit << "' for a velocity";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      EXPECT_NE(error.message().find("variable 'uo': found unit '" + std::string(unit) + "'"),
                std::string::npos);
    }
  }
}

TEST(UnitConversion, APureNumberIsNoAngle) {
  EXPECT_THROW((void)unit_conversion("1", "degree", "direction"), Error);
  EXPECT_NEAR(unit_conversion("radian", "degree", "direction").scale, 57.29577951308232, 1e-9);
}

}  // namespace
}  // namespace slackwater::ingest::units_test
