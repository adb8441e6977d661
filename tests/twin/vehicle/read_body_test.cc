#include "twin/vehicle/read_body.h"
#include "tests/support/contains.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "tests/support/shared_data.h"

namespace slackwater::twin::read_body_test {
namespace {

using tests::contains;

/// The made-up vehicle with one line put in the place of another.
std::string yaml_with(const std::string& line, const std::string& instead) {
  std::string yaml = R"(dimensions_m: {length: 1.0, width: 0.6, height: 0.4}
rigid_body:
  mass_kg: 100
  centre_of_gravity_m: [0, 0, 0.01]
  inertia_kg_m2: {xx: 3, yy: 8, zz: 9, xz: 0.1}
displacement: {volume_m3: 0.0976, centre_of_buoyancy_m: [0, 0, -0.02]}
added_mass: {X_u_dot: -5, Y_v_dot: -50, N_r_dot: -2}
damping: {X_u: -4, Y_v_abs_v: -300}
drag_stations: {along: length, count: 4}
trailing_edge: {position_x_m: -0.5, added_mass_kg_m: 40}
)";
  const std::size_t at = yaml.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  return yaml.replace(at, line.size(), instead);
}

Body read(const std::string& yaml) {
  const Config config = Config::parse(yaml, "made-up.yaml");
  Body body = read_body(config);
  config.expect_all_read();
  return body;
}

std::string refusal(const std::string& line, const std::string& instead) {
  try {
    (void)read(yaml_with(line, instead));
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return {};
}

TEST(ReadBody, TurnsSnameSignsIntoPositiveMatricesOnce) {
  const Body body = read(yaml_with("mass_kg: 100", "mass_kg: 100"));
  EXPECT_EQ(body.added_mass.entry[1][1], 50);
  EXPECT_EQ(body.added_mass.entry[2][2], 0);
  EXPECT_EQ(body.linear_damping.linear.x, 4);
  EXPECT_EQ(body.quadratic_damping.linear.y, 300);
  EXPECT_EQ(body.rigid_mass.entry[0][0], 100);
  EXPECT_EQ(body.rigid_mass.entry[0][4], 1);  // m z_g
  EXPECT_EQ(body.rigid_mass.entry[1][3], -1);
  EXPECT_EQ(body.rigid_mass.entry[3][5], 0.1);
  EXPECT_EQ(body.stations, 4U);
  EXPECT_EQ(body.station_m[0].x, -0.375);
  EXPECT_EQ(body.station_m[3].x, 0.375);
  EXPECT_EQ(body.trailing_edge_x_m, -0.5);
  EXPECT_EQ(body.trailing_edge_kg_m, 40);
}

TEST(ReadBody, RefusesWhatNoBodyCanBeAndSaysWhy) {
  EXPECT_TRUE(contains(refusal("xx: 3", "xx: 0.5"), "triangle inequality"));
  EXPECT_TRUE(contains(refusal("xx: 3, yy: 8, zz: 9", "xx: 60, yy: 80, zz: 90"),
                       "mass at the edge of its hull"));
  EXPECT_TRUE(contains(refusal("xz: 0.1", "xz: 40"), "principal values"));
  EXPECT_TRUE(contains(refusal("X_u: -4", "X_u: 4"), "give -4"));
  EXPECT_TRUE(contains(refusal("volume_m3: 0.0976", "volume_m3: 97.6"), "box around the hull"));
  EXPECT_TRUE(contains(refusal("mass_kg: 100", "mass_kg: 1000"), "displaces"));
  EXPECT_TRUE(contains(refusal("mass_kg: 100", "mass_kg: 0"), "mass_kg"));
  EXPECT_TRUE(contains(refusal("mass_kg: 100", "mass_kg: .nan"), "mass_kg"));
  EXPECT_TRUE(contains(refusal("centre_of_gravity_m: [0, 0, 0.01]", "centre_of_gravity_m: [0, 0]"),
                       "[x, y, z]"));
  EXPECT_TRUE(contains(refusal("along: length", "along: width"), "length or height"));
  EXPECT_TRUE(contains(refusal("count: 4", "count: 9"), "count"));
  EXPECT_TRUE(contains(refusal("X_u_dot", "X_udot"), "X_u_dot"));
  EXPECT_TRUE(contains(refusal("position_x_m: -0.5", "position_x_m: 0.5"), "position_x_m"));
}

TEST(ReadBody, IsInTheWaterThatItsNumbersAreFor) {
  EXPECT_EQ(read(yaml_with("mass_kg: 100", "mass_kg: 100")).fluid_density_kg_m3, 1025);
  const std::string fresh = yaml_with("dimensions_m", "water_density_kg_m3: 1000\ndimensions_m");
  EXPECT_EQ(read(fresh).fluid_density_kg_m3, 1000);
  EXPECT_TRUE(contains(refusal("dimensions_m", "water_density_kg_m3: 1.025\ndimensions_m"),
                       "water_density_kg_m3"));
}

TEST(ReadBody, RefusesAnAddedMassThatMakesEnergy) {
  // 150 kg across, 11 kg m2 about z: their product is smaller than the square of 50 kg m.
  EXPECT_TRUE(contains(refusal("N_r_dot: -2", "N_r_dot: -2, Y_r_dot: 50"), "positive definite"));
  EXPECT_EQ(refusal("N_r_dot: -2", "N_r_dot: -2, Y_r_dot: 20"), "");
}

/// The inertia that a public model gives this vehicle "to keep the trajectory straight"
/// (twin/docs/vehicles.md).
TEST(ReadBody, RefusesTheInertiaOfThePlaceholderLrauv) {
  std::string yaml = R"(dimensions_m: {length: 2.3, width: 0.305, height: 0.305}
rigid_body: {mass_kg: 125, inertia_kg_m2: {xx: 10000, yy: 5.0e6, zz: 5.0e6}}
)";
  EXPECT_THROW((void)read(yaml), Error);
}

TEST(ReadBody, TheBundledVehiclesFloatAsTheirSheetsSay) {
  const auto body_of = [](const char* id) {
    return read_body(
        Config::load(tests::source_folder() / "data/vehicles" / (std::string(id) + ".yaml")));
  };
  const Body blue = body_of("bluerov2_heavy");
  EXPECT_NEAR(blue.fluid_density_kg_m3 * blue.displaced_volume_m3 - blue.mass_kg, 0.235, 1e-9);
  const Body lrauv = body_of("lrauv_tethys");
  EXPECT_NEAR(lrauv.fluid_density_kg_m3 * lrauv.displaced_volume_m3, lrauv.mass_kg, 1e-3);
  const Body x500 = body_of("x500");
  EXPECT_EQ(x500.displaced_volume_m3, 0);
  EXPECT_NEAR(x500.quadratic_damping.linear.x, 0.5 * 1.225 * 0.06, 1e-12);
}

}  // namespace
}  // namespace slackwater::twin::read_body_test
