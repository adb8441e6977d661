// The modes of each plane beside those of the whole motion: of a craft that is alike on both sides
// none are lost and none are new.
#include "twin/step/plane_modes.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/support/vehicle_for_tests.h"
#include "twin/step/open_loop.h"

namespace slackwater::twin::plane_modes_test {
namespace {

TEST(PlaneModes, OfBothPlanesTogetherAreThoseOfTheWholeMotion) {
  for (const char* id : {"remus100", "lauv", "bluerov2_heavy", "otter", "wamv16", "ctv24"}) {
    const Vehicle vehicle = tests::bundled_vehicle(id);
    const double speed_m_s = vehicle.cruise_speed_m_s;
    const Eigen::VectorXcd whole = open_loop_matrix(vehicle, speed_m_s).eigenvalues();
    const PlaneModes planes = plane_modes(vehicle, speed_m_s);
    std::vector<std::complex<double>> both = planes.vertical;
    both.insert(both.end(), planes.horizontal.begin(), planes.horizontal.end());
    std::size_t swinging = 0;
    for (const std::complex<double>& mode : both) swinging += mode.imag() > 0 ? 1 : 0;
    EXPECT_EQ(both.size() + swinging, 9U) << id;
    for (const std::complex<double>& mode : both) {
      double nearest = 1e9;
      for (const std::complex<double>& of_whole : whole)
        nearest = std::min(nearest, std::abs(of_whole - mode));
      // Differences of 1e-6 leave six digits; a double 0 of depth splits at the root of those.
      EXPECT_LT(nearest, 1e-3 * std::max(std::abs(mode), 1.0)) << id << " " << mode;
    }
    EXPECT_TRUE(std::is_sorted(planes.vertical.begin(), planes.vertical.end(),
                               [](const auto& a, const auto& b) { return a.real() > b.real(); }))
        << id;
  }
}

/// A hull without lift: v and r by hand. With d the sway damping, n the yaw damping and m the Munk
/// moment (a_v - a_u) u, all linear: lambda of [[-d/m_v, -m_u u/m_v], [m/I, -n/I]].
TEST(PlaneModes, OfAHullAreThoseOfAMatrixByHand) {
  Vehicle hull = tests::bundled_vehicle("remus100");
  Body& body = hull.body;
  body.speed_lift = {};
  body.cross_damping = {};
  body.cross_flow = {};
  body.trailing_edge_kg_m = 0;
  hull.rudder.area_m2 = hull.elevator.area_m2 = 0;
  body.centre_of_gravity_m = {0, 0, 0.02};
  body.linear_damping = {{1, 20, 20}, {1, 8, 6}};
  body.quadratic_damping = {};
  body.added_mass = {};
  const double diagonal[] = {1, 35, 35, 0.1, 5, 5};
  for (std::size_t i = 0; i < 6; ++i) body.added_mass.entry[i][i] = diagonal[i];
  // Yaw stands apart from roll only where the mass does: gravity at the origin, as far as they go.
  body.rigid_mass = {};
  const double rigid[] = {30, 30, 30, 0.2, 3.5, 3.5};
  for (std::size_t i = 0; i < 6; ++i) {
    body.rigid_mass.entry[i][i] = rigid[i];
    body.inverse_mass.entry[i] = {};
    body.inverse_mass.entry[i][i] = 1 / (rigid[i] + diagonal[i]);
  }
  const double u = 1.5, m_v = 65, inertia = 8.5;
  Eigen::Matrix2d by_hand;
  by_hand << -20 / m_v, -(30 + 1) * u / m_v, -(35 - 1) * u / inertia, -6 / inertia;
  Eigen::Vector2d expected = by_hand.eigenvalues().real();
  std::sort(expected.begin(), expected.end());
  std::vector<double> found;
  for (const std::complex<double>& mode : plane_modes(hull, u).horizontal)
    if (mode.imag() == 0) found.push_back(mode.real());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0], expected[1], 1e-5);
  EXPECT_NEAR(found[1], expected[0], 1e-5);
  EXPECT_GT(found[0], 0) << "the moment of its added mass turns it across its way";
}

}  // namespace
}  // namespace slackwater::twin::plane_modes_test
