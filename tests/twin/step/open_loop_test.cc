// What a vehicle does that nobody controls: the eigenvalues of its linearised motion against that
// motion itself, against a matrix by hand, and against what the program does by raw thrusters.
#include "twin/step/open_loop.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <complex>
#include <fstream>
#include <iterator>

#include "tests/support/temporary_folder.h"
#include "tests/support/vehicle_for_tests.h"
#include "tests/twin/run/helm_for_tests.h"
#include "twin/step/vehicle_step.h"

namespace slackwater::twin::open_loop_test {
namespace {

using tests::bundled_vehicle;
using Vector9 = Eigen::Matrix<double, open_loop_states, 1>;

/// The forces that hold a vehicle alike on all sides straight and level: its resistance, and what
/// its weight lacks.
Spatial<double> held_on_its_way(const Vehicle& vehicle, double speed_m_s) {
  const Body& body = vehicle.body;
  const double drag_n = body.linear_damping.linear.x * speed_m_s +
                        body.quadratic_damping.linear.x * speed_m_s * speed_m_s;
  const double light_n =
      body.hull.strips > 0
          ? 0
          : constants::gravity_m_s2 *
                (body.fluid_density_kg_m3 * body.displaced_volume_m3 - body.mass_kg);
  return {{drag_n, 0, light_n}, {}};
}

/// The vehicle's own motion from a small way off, by its equations in full, step by step.
Vector9 moved_by_its_equations(const Vehicle& vehicle, double speed_m_s, const Vector9& off,
                               double lasts_s) {
  const Body& body = vehicle.body;
  BodyState<double> at;
  const double depth_m = body.hull.strips > 0
                             ? floating_depth_m(body.hull, body.mass_kg, body.fluid_density_kg_m3)
                             : 1000;
  at.position_m.z = depth_m + off[0];
  at.attitude = attitude_of({off[1], off[2], 0});
  at.nu = {{speed_m_s + off[3], off[4], off[5]}, {off[6], off[7], off[8]}};
  const int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    Forcing<double> forcing;
    forcing.tau = held_on_its_way(vehicle, speed_m_s);
    if (has_fins(vehicle)) forcing.tau = forcing.tau + fins_force(vehicle, at.nu, 0.0, 0.0);
    at = stepped(body, at, forcing, lasts_s / steps);
  }
  const EulerAngles angles = euler_angles(at.attitude);
  Vector9 out;
  out << at.position_m.z - depth_m, angles.roll_rad, angles.pitch_rad, at.nu.linear.x - speed_m_s,
      at.nu.linear.y, at.nu.linear.z, at.nu.angular.x, at.nu.angular.y, at.nu.angular.z;
  return out;
}

TEST(OpenLoop, EachModeGrowsAsItsEigenvalueSays) {
  for (const char* id : {"bluerov2_heavy", "lrauv_tethys", "wamv16", "ctv24"}) {
    const Vehicle vehicle = bundled_vehicle(id);
    for (const double share : {0.5, 1.0}) {
      const double speed_m_s = share * vehicle.cruise_speed_m_s;
      const Eigen::EigenSolver<OpenLoopMatrix> modes(open_loop_matrix(vehicle, speed_m_s));
      for (int i = 0; i < open_loop_states; ++i) {
        const std::complex<double> rate = modes.eigenvalues()[i];
        // A quarter of what it takes to change e-fold or to swing once.
        const double lasts_s = 0.25 / std::max(std::abs(rate), 0.05);
        const Eigen::Matrix<std::complex<double>, open_loop_states, 1> mode =
            modes.eigenvectors().col(i);
        constexpr double small = 1e-6;
        const Vector9 off = small * mode.real();
        if (off.norm() < 0.1 * small) continue;
        const Vector9 expected = small * (std::exp(rate * lasts_s) * mode).real();
        const Vector9 came = moved_by_its_equations(vehicle, speed_m_s, off, lasts_s);
        EXPECT_LT((came - expected).norm(), 2e-3 * off.norm())
            << id << " at " << speed_m_s << " m/s, mode " << i << " of " << rate << ":\n"
            << came.transpose() << "\n"
            << expected.transpose();
      }
    }
  }
}

/// (m + Y_v.) v' = -(m + X_u.) u r - L (v + x r),
/// (I + N_r.) r' = -(Y_v. - X_u.) u v - x L (v + x r)
/// with the fins' lift L = rho A C u / 2 at x.
TEST(OpenLoop, TheYawOfAnAuvIsThatOfTheTextbook) {
  const Vehicle auv = bundled_vehicle("lrauv_tethys");
  const Body& body = auv.body;
  constexpr double u = 1;
  const double lift =
      0.5 * body.fluid_density_kg_m3 * auv.rudder.area_m2 * auv.rudder.lift_slope_per_rad * u;
  const double x = auv.rudder.position_x_m;
  const double surge_kg = body.added_mass.entry[0][0], sway_kg = body.added_mass.entry[1][1];
  const double mass = body.mass_kg + sway_kg;
  const double inertia = body.rigid_mass.entry[5][5] + body.added_mass.entry[5][5];
  Eigen::Matrix2d by_hand;
  by_hand << -lift / mass, (-(body.mass_kg + surge_kg) * u - lift * x) / mass,
      (-(sway_kg - surge_kg) * u - x * lift) / inertia, -x * x * lift / inertia;
  const OpenLoopMatrix all = open_loop_matrix(auv, u);
  Eigen::Matrix2d own;
  own << all(4, 4), all(4, 8), all(8, 4), all(8, 8);
  EXPECT_LT((own - by_hand).norm(), 1e-4 * by_hand.norm()) << own << "\n\n" << by_hand;
  const double half = 0.5 * by_hand.trace();
  const double grows = half + std::sqrt(half * half - by_hand.determinant());
  ASSERT_GT(grows, 0);
  EXPECT_NEAR(open_loop_of(auv).yaw_per_s, grows, 1e-3 * grows);
}

/// A bundled vehicle with one thing changed.
Vehicle changed(const std::string& id, const std::string& what, const std::string& instead) {
  const auto data = tests::source_folder() / "data";
  std::ifstream in(data / "vehicles" / (id + ".yaml"));
  std::string yaml(std::istreambuf_iterator<char>(in), {});
  const std::size_t at = yaml.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  const tests::TemporaryFolder folder;
  std::ofstream(folder / "odd.yaml") << yaml.replace(at, what.size(), instead);
  return read_vehicle(folder / "odd.yaml", data);
}

TEST(OpenLoop, IsSaidAtLoadInWords) {
  const auto notes = [](const Vehicle& vehicle) { return words_of(open_loop_of(vehicle)); };
  const std::string rov = notes(bundled_vehicle("bluerov2_heavy"));
  EXPECT_NE(rov.find("keep a hold of depth or attitude on"), std::string::npos) << rov;
  EXPECT_NE(rov.find("with all its thrust, at 1.4 m/s, it somersaults"), std::string::npos) << rov;
  EXPECT_NE(rov.find("at 0.5 m/s"), std::string::npos) << rov;
  const std::string auv = notes(bundled_vehicle("lrauv_tethys"));
  EXPECT_NE(auv.find("and it circles at"), std::string::npos) << auv;
  EXPECT_EQ(auv.find("somersaults"), std::string::npos) << auv;
  EXPECT_EQ(notes(bundled_vehicle("x500")), "");
}

TEST(OpenLoop, WhatIsStableSaysNothingOfIt) {
  // Fins four times as large hold its course; so much weight below the buoyancy holds it level.
  const Vehicle finned = changed("lrauv_tethys", "area_m2: 0.0244", "area_m2: 0.0976");
  EXPECT_EQ(open_loop_of(finned).yaw_per_s, 0);
  const Vehicle stiff = changed("bluerov2_heavy", "centre_of_buoyancy_m: [0, 0, -0.01]",
                                "centre_of_buoyancy_m: [0, 0, -0.1]");
  EXPECT_EQ(open_loop_of(stiff).pitch_per_s, 0);
  EXPECT_GT(open_loop_of(bundled_vehicle("bluerov2_heavy")).pitch_per_s, 0);
}

/// All that pushes along the way at a share of its command.
std::vector<double> ahead(const Vehicle& vehicle, double share) {
  std::vector<double> out;
  for (std::size_t i = 0; i < vehicle.mounts; ++i) {
    const double x = vehicle.mount[i].direction.x;
    out.push_back(std::abs(x) < 0.5 ? 0 : std::copysign(share, x));
  }
  return out;
}

TEST(OpenLoop, TheProgramDoesByRawThrustersWhatIsSaid) {
  const auto driven = [](const std::string& model, double share, double for_s) {
    const auto run =
        tests::lone_run(tests::lone(model, "north_m: 0, east_m: 0, depth_m: 30, heading_deg: 0"));
    // A degree off, as the check has it: what lies alike on both sides starts nothing by itself.
    VehicleState<double> off = tests::state_of_lone(*run).vehicle;
    off.body.attitude = attitude_of({0, constants::degree, 0});
    off.body.nu.linear.y = 0.01;
    run->enqueue({0, 0, PutVehicle{off}});
    const std::vector<double> raw = ahead(*run->agents()[0].vehicle, share);
    for (double t = 0; t < for_s; t += 0.5) {
      run->enqueue({0, 0, SetThrusters{raw}});
      tests::go_on(*run, 0.5);
    }
    return tests::state_of_lone(*run);
  };
  const AgentState rov = driven("bluerov2_heavy", 1, 60);
  EXPECT_FALSE(std::isnan(rov.milestones.capsized_s)) << "it goes over";
  const AgentState auv = driven("lrauv_tethys", 1, 300);
  EXPECT_TRUE(std::isnan(auv.milestones.capsized_s));
  // Its propeller gives a little more than the speed of the check.
  const double turn_rad_s = open_loop_of(bundled_vehicle("lrauv_tethys")).turn_rad_s;
  EXPECT_GT(turn_rad_s, 0.01);
  EXPECT_NEAR(std::abs(auv.vehicle.body.nu.angular.z), turn_rad_s, 0.3 * turn_rad_s);
}

}  // namespace
}  // namespace slackwater::twin::open_loop_test
