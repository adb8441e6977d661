#include "twin/tether/read_tether.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/support/shared_data.h"

namespace slackwater::twin::read_tether_test {
namespace {

std::string yaml_with(const std::string& line, const std::string& instead) {
  std::string yaml = R"(tether:
  longest_m: 150
  diameter_m: 0.0076
  mass_per_m_kg: 0.043
  breaking_load_n: 1557
  elongation_at_break: 0.02
  tangential_drag_coefficient: 0.01
  attachment_m: [-0.2, 0, -0.1]
)";
  const std::size_t at = yaml.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  return yaml.replace(at, line.size(), instead);
}

std::optional<Tether> read(const std::string& yaml) {
  const Config config = Config::parse(yaml, "made-up.yaml");
  std::optional<Tether> tether = read_tether(config);
  config.expect_all_read();
  return tether;
}

testing::AssertionResult refused(const std::string& line, const std::string& instead,
                                 const std::string& why) {
  try {
    (void)read(yaml_with(line, instead));
  } catch (const Error& problem) {
    if (problem.kind() == ErrorKind::invalid_input &&
        problem.message().find(why) != std::string::npos)
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << "not '" << why << "' in: " << problem.message();
  }
  return testing::AssertionFailure() << instead << " was taken";
}

TEST(ReadTether, TakesWhatTheFileSays) {
  const Tether tether = read(yaml_with("150", "100")).value();
  EXPECT_EQ(tether.longest_m, 100);
  EXPECT_EQ(tether.diameter_m, 0.0076);
  EXPECT_EQ(tether.axial_stiffness_n, 1557 / 0.02);
  EXPECT_EQ(tether.normal_drag_coefficient, 1.2);
  EXPECT_EQ(tether.attachment_m.z, -0.1);
  EXPECT_FALSE(read("{}").has_value());
}

TEST(ReadTether, RefusesWhatNoLineCanBeAndSaysWhy) {
  EXPECT_TRUE(refused("diameter_m: 0.0076", "diameter_m: 7.6", "check the unit"));
  EXPECT_TRUE(refused("mass_per_m_kg: 0.043", "mass_per_m_kg: 43", "density"));
  EXPECT_TRUE(refused("mass_per_m_kg: 0.043", "mass_per_m_kg: 0.001", "density"));
  EXPECT_TRUE(refused("1557", "350000", "no fibre"));
  EXPECT_TRUE(refused("1557", "35", "own weight"));
  EXPECT_TRUE(refused("tangential_drag_coefficient: 0.01",
                      "normal_drag_coefficient: 0.1\n  tangential_drag_coefficient: 0.9",
                      "are the two exchanged"));
  EXPECT_TRUE(
      refused("elongation_at_break: 0.02", "elongation_at_break: 2", "elongation_at_break"));
  EXPECT_TRUE(refused("[-0.2, 0, -0.1]", "[-0.2, 0]", "[x, y, z]"));
  EXPECT_TRUE(refused("breaking_load_n: 1557", "braking_load_n: 1557", "breaking_load_n"));
  EXPECT_TRUE(refused("longest_m: 150", "longest_m: .nan", "longest_m"));
}

TEST(ReadTether, TheBundledRovHasTheTetherOfItsSheet) {
  const Config config = Config::load(tests::source_folder() / "data/vehicles/bluerov2_heavy.yaml");
  const Tether tether = read_tether(config).value();
  EXPECT_EQ(tether.diameter_m, 0.0076);
  EXPECT_EQ(tether.mass_per_m_kg, 0.043);
  EXPECT_EQ(tether.breaking_load_n, 1557);  // 350 lbf
  EXPECT_FALSE(
      read_tether(Config::load(tests::source_folder() / "data/vehicles/lrauv_tethys.yaml")));
}

}  // namespace
}  // namespace slackwater::twin::read_tether_test
