#include <algorithm>

#include "tests/ingest/grib/grib_fixture.h"

// Waves of NCEP: HTSGW, PERPW and DIRPW by their numbers of the WMO's code table 4.2, discipline 10
// (oceanography), category 0 (waves).

namespace slackwater::ingest::tests::grib_wave_test {
namespace {

class NcepsWaves : public GribTest {
 protected:
  void write(long number, double value) const {
    write_bent(2,
               [&](grib::Message& message) {
                 message.set("centre", std::string("kwbc"));
                 message.set("discipline", 10L);
                 message.set("parameterCategory", 0L);
                 message.set("parameterNumber", number);
                 message.set("typeOfFirstFixedSurface", 1L);
                 const auto points =
                     static_cast<std::size_t>(message.integer("numberOfDataPoints"));
                 message.set_values(std::vector<double>(points, value));
               },
               {"swh"});
  }
  void expect(const std::string& standard_name, const std::string& unit, double value) {
    const Ingested ingested = decode();
    ASSERT_EQ(ingested.granules.size(), 1U);
    const auto& variables = ingested.granules[0].granule.variables;
    ASSERT_EQ(variables.size(), 1U);
    EXPECT_EQ(variables[0].standard_name, standard_name);
    EXPECT_EQ(variables[0].unit, unit);
    EXPECT_NEAR(read(ingested.granules[0], standard_name).values.at(0), value, 1e-3);
  }
};

TEST_F(NcepsWaves, HtsgwIsTheSignificantHeight) {
  write(3, 2.5);
  expect("sea_surface_wave_significant_height", "m", 2.5);
}

TEST_F(NcepsWaves, PerpwIsThePeriodOfThePeak) {
  write(11, 9.25);
  expect("sea_surface_wave_period_at_variance_spectral_density_maximum", "s", 9.25);
}

TEST_F(NcepsWaves, DirpwIsTheDirectionOfThePeak) {
  write(10, 270);
  expect("sea_surface_wave_from_direction_at_variance_spectral_density_maximum", "degree", 270);
}

}  // namespace
}  // namespace slackwater::ingest::tests::grib_wave_test
