#include "twin/vehicle/read_cross_flow.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/support/contains.h"

namespace slackwater::twin::read_cross_flow_test {
namespace {

using tests::contains;

/// Of a hull of 2 m in water of 1000 kg/m3.
CrossFlow read(const std::string& yaml, const Spatial<double>& quadratic_damping = {}) {
  const Config config = Config::parse("cross_flow: {" + yaml + "}", "made-up.yaml");
  Body body;
  body.fluid_density_kg_m3 = 1000;
  body.quadratic_damping = quadratic_damping;
  read_cross_flow(config, 2, body);
  config.expect_all_read();
  EXPECT_TRUE(body.has_more());
  return body.cross_flow;
}

std::string refusal(const std::string& yaml, const Spatial<double>& quadratic_damping = {}) {
  try {
    (void)read(yaml, quadratic_damping);
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return {};
}

TEST(ReadCrossFlow, TakesOneNumberForAllStripsOrOneForEachFromTheSternOn) {
  const CrossFlow flow = read(
      "from_x_m: -1.2, to_x_m: 0.8, strips: 4, sway: {drag_coefficient: 1.2, depth_m: 0.3}, "
      "heave: {drag_coefficient: [1, 1.5, 2, 2.5], breadth_m: 0.4}");
  EXPECT_EQ(flow.strips, 4U);
  EXPECT_NEAR(flow.x_m[0], -0.95, 1e-15);
  EXPECT_NEAR(flow.x_m[3], 0.55, 1e-15);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(flow.sway_n_s2_m2[i], 500 * 1.2 * 0.3 * 0.5, 1e-12);
    EXPECT_NEAR(flow.heave_n_s2_m2[i], 500 * (1 + 0.5 * static_cast<double>(i)) * 0.4 * 0.5, 1e-12);
  }
}

/// Fossen's Otter, 0.25 m on a draught of 0.1951 m, has 1.0042 there.
TEST(ReadCrossFlow, TakesHoernersCoefficientForASectionAfloat) {
  EXPECT_NEAR(hoerner_drag_coefficient(0.25 / (2 * 0.195122)), 1.0042, 1e-4);
  EXPECT_NEAR(hoerner_drag_coefficient(0.0108623), 1.96608, 1e-12);
  EXPECT_NEAR(hoerner_drag_coefficient(4.00309), 0.559315, 1e-12);
  EXPECT_NEAR(hoerner_drag_coefficient(0.5 * (0.833589 + 0.988002)), 0.5 * (0.87959 + 0.828415),
              1e-12);
  const CrossFlow flow = read(
      "from_x_m: -1, to_x_m: 1, strips: 2, sway: {section: {breadth_m: 0.25, draught_m: "
      "0.195122}}");
  EXPECT_NEAR(flow.sway_n_s2_m2[1], 500 * 1.0042 * 0.195122, 1e-2);
  EXPECT_EQ(flow.heave_n_s2_m2[1], 0);
}

TEST(ReadCrossFlow, SaysWhatIsWrong) {
  const std::string range = "from_x_m: -1, to_x_m: 1, ";
  const std::string sway = "sway: {drag_coefficient: 1, depth_m: 0.3}";
  EXPECT_TRUE(contains(refusal(range + "strips: 4"), "neither sway nor heave"));
  EXPECT_TRUE(contains(refusal(range + "strips: 21, " + sway), "strips"));
  EXPECT_TRUE(
      contains(refusal("from_x_m: 1, to_x_m: -1, strips: 2, " + sway), "forward of from_x_m"));
  EXPECT_TRUE(contains(refusal("from_x_m: -10, to_x_m: 10, strips: 2, " + sway),
                       "strips over 20 m of a vehicle that is 2 m long"));
  EXPECT_TRUE(contains(refusal(range + "strips: 3, sway: {drag_coefficient: [1, 2], depth_m: 0.3}"),
                       "found 2 numbers for 3 strips"));
  EXPECT_TRUE(contains(refusal(range + "strips: 3, sway: {drag_coefficient: 1}"), "depth_m"));
  EXPECT_TRUE(
      contains(refusal(range + "strips: 3, sway: {section: {breadth_m: 9, draught_m: 0.9}}"),
               "B/2T = 5; Hoerner's curve"));
  EXPECT_TRUE(contains(refusal(range + "strips: 3, " + sway, {{0, 80, 0}, {}}),
                       "sway beside damping.Y_v_abs_v"));
  const std::string heave = "heave: {drag_coefficient: 1, breadth_m: 0.3}";
  EXPECT_TRUE(contains(refusal(range + "strips: 3, " + heave, {{0, 0, 80}, {}}),
                       "heave beside damping.Z_w_abs_w"));
  // Beside what the strips do not say.
  EXPECT_EQ(refusal(range + "strips: 3, " + sway, {{9, 0, 80}, {1, 1, 1}}), "");
}

}  // namespace
}  // namespace slackwater::twin::read_cross_flow_test
