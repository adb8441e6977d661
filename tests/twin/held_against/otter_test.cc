// data/vehicles/otter.yaml beside open-loop runs of Fossen's model of the same boat, from which its
// numbers are. Nothing was tuned on these runs.
//
// One thing of that model is not ours: its crossFlowDrag sums 21 ordinates where 20 strips fill the
// hull, so that it has 5 % too much drag in sway and 21 % in yaw. The true integral turns 3 %
// faster; that is the larger part of the tolerance of 5 %.
#include <functional>

#include "tests/support/vehicle_for_tests.h"
#include "tests/twin/held_against/reference_run.h"

namespace slackwater::twin::otter_test {
namespace {

using tests::expect_within;
using tests::reference_run;
using tests::RunRows;

struct Propellers {
  double left_rad_s = 0, right_rad_s = 0;
};

/// From rest, heading north, as long as the reference, a row wherever that has one.
RunRows run_beside(const RunRows& reference, const std::function<Propellers(double)>& commands,
                   const Triple<double>& current_m_s = {}) {
  constexpr double step_s = 0.02;
  const Vehicle otter = tests::bundled_vehicle("otter");
  const StepPlan plan = plan_step(otter, step_s);
  const Body& body = otter.body;
  VehicleState<double> state =
      placed(otter, {0, 0, floating_depth_m(body.hull, body.mass_kg, body.fluid_density_kg_m3)}, 0);
  Surroundings<double> around;
  around.water.velocity_m_s = current_m_s;
  RunRows rows;
  const int steps = static_cast<int>(std::lround(reference.last("t_s") / step_s));
  for (int i = 0; i <= steps; ++i) {
    const double t_s = i * step_s;
    if (i % 10 == 0) tests::add_row(rows, t_s, state);
    VehicleCommand<double> command;
    const Propellers wanted = commands(t_s);
    command.thruster[0] = wanted.left_rad_s;
    command.thruster[1] = wanted.right_rad_s;
    step(otter, plan, state, command, around);
  }
  return rows;
}

double speed_m_s(const RunRows& rows) { return std::hypot(rows.last("u_m_s"), rows.last("v_m_s")); }

TEST(OtterHeldAgainst, StraightAhead) {
  SLACKWATER_NEEDS_SHARED(shared);
  for (const double thrust_n : {20.0, 100.0, 200.0}) {
    const std::string name = "otter_straight_" + std::to_string(std::lround(thrust_n)) + "N";
    const RunRows reference = reference_run(shared, name);
    const double each_rad_s = std::sqrt(thrust_n / 2 / 0.01108);
    const RunRows ours = run_beside(reference, [&](double) {
      return Propellers{each_rad_s, each_rad_s};
    });
    expect_within(name + " u", ours.last("u_m_s"), reference.last("u_m_s"), 0.01);
    expect_within(name + " 63 %", ours.rise_s("u_m_s", 0.632), reference.rise_s("u_m_s", 0.632),
                  0.05);
    EXPECT_NEAR(ours.last("east_m"), 0, 1e-6);
  }
}

TEST(OtterHeldAgainst, Turns) {
  SLACKWATER_NEEDS_SHARED(shared);
  for (const auto& [name, propellers] : {std::pair{"otter_turn_100_80", Propellers{100, 80}},
                                         {"otter_turn_60_minus30", {60, -30}}}) {
    const RunRows reference = reference_run(shared, name);
    const RunRows ours =
        run_beside(reference, [&, p = propellers](double) { return Propellers{p}; });
    const auto diameter_m = [](const RunRows& rows) {
      return 2 * speed_m_s(rows) / rows.last("r_rad_s");
    };
    expect_within(std::string(name) + " u", ours.last("u_m_s"), reference.last("u_m_s"), 0.05);
    expect_within(std::string(name) + " r", ours.last("r_rad_s"), reference.last("r_rad_s"), 0.05);
    expect_within(std::string(name) + " diameter", diameter_m(ours), diameter_m(reference), 0.05);
  }
}

TEST(OtterHeldAgainst, ZigZag) {
  SLACKWATER_NEEDS_SHARED(shared);
  const RunRows reference = reference_run(shared, "otter_zigzag_80_60");
  const RunRows ours = run_beside(reference, [](double t_s) {
    // Over every 10 s; a hair before, for a time is a sum of steps.
    const bool to_starboard = std::lround(std::floor((t_s + 1e-6) / 10)) % 2 == 0;
    return to_starboard ? Propellers{80, 60} : Propellers{60, 80};
  });
  for (int leg = 0; leg < 6; ++leg) {
    const auto swing_rad = [&](const RunRows& rows) {
      return std::remainder(rows.at("yaw_rad", 10 * (leg + 1)) - rows.at("yaw_rad", 10 * leg),
                            2 * constants::pi);
    };
    expect_within("otter_zigzag_80_60 swing " + std::to_string(leg + 1), swing_rad(ours),
                  swing_rad(reference), 0.05);
  }
  expect_within("otter_zigzag_80_60 last r", ours.last("r_rad_s"), reference.last("r_rad_s"), 0.05);
}

/// Propellers at rest, 0.5 m/s towards 045.
TEST(OtterHeldAgainst, Drift) {
  SLACKWATER_NEEDS_SHARED(shared);
  const RunRows reference = reference_run(shared, "otter_drift_0p5_to_045");
  const double each_m_s = 0.5 * std::sqrt(0.5);
  const RunRows ours =
      run_beside(reference, [](double) { return Propellers{}; }, {each_m_s, each_m_s, 0});
  const double way_m = std::hypot(reference.last("north_m"), reference.last("east_m"));
  const double off_m = std::hypot(ours.last("north_m") - reference.last("north_m"),
                                  ours.last("east_m") - reference.last("east_m"));
  EXPECT_NEAR(reference.last("t_s"), 300, 1e-9);
  std::printf("otter_drift_0p5_to_045: %.3f m off in %.2f m, %.3f %% of 1 %%\n", off_m, way_m,
              100 * off_m / way_m);
  EXPECT_LT(off_m, 0.01 * way_m);
}

}  // namespace
}  // namespace slackwater::twin::otter_test
