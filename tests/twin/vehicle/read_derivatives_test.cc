#include "twin/vehicle/read_derivatives.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "twin/body/body_dynamics.h"

namespace slackwater::twin::read_derivatives_test {
namespace {

using tests::contains;

/// The derivatives of a file, in a body that is nothing else.
Body read(const std::string& yaml, double trailing_edge_kg_m = 0) {
  const Config config = Config::parse(yaml, "made-up.yaml");
  Body body;
  body.trailing_edge_kg_m = trailing_edge_kg_m;
  body.added_mass = read_added_mass(config);
  read_damping(config, body);
  read_lift(config, body);
  config.expect_all_read();
  return body;
}

std::string refusal(const std::string& yaml, double trailing_edge_kg_m = 0) {
  try {
    (void)read(yaml, trailing_edge_kg_m);
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return {};
}

/// A REMUS 100's (Prestero 2001, appendix C): what its tables hold of the added mass, and of body
/// and fins with the speed, that of the added mass in a flow from aside included.
const std::string remus = R"(
added_mass: {X_u_dot: -0.93, Y_v_dot: -35.5, Z_w_dot: -35.5, K_p_dot: -0.0704, M_q_dot: -4.88,
             N_r_dot: -4.88, Y_r_dot: 1.93, Z_q_dot: -1.93}
)";
const std::string remus_lift = R"(Y_uv: -28.6, Y_ur: 5.22, N_uv: -24.0, N_ur: -2.0,
       Z_uw: -28.6, Z_uq: -5.22, M_uw: 24.0, M_uq: -2.0)";

std::array<double, 6> in_order(const Spatial<double>& a) {
  return {a.linear.x, a.linear.y, a.linear.z, a.angular.x, a.angular.y, a.angular.z};
}
Spatial<double> motion_of(std::size_t i, double size) {
  std::array<double, 6> way{};
  way[i] = size;
  return {{way[0], way[1], way[2]}, {way[3], way[4], way[5]}};
}
std::array<double, 6> more_force(const Body& body, const Spatial<double>& nu) {
  return in_order(lift_and_cross_flow(body, rotation_of(Attitude<double>{1, 0, 0, 0}), nu, {}));
}

constexpr std::string_view forces = "XYZKMN", motions = "uvwpqr";

TEST(ReadAddedMass, HasEachDerivativeAtItsPlaceAndItsMirror) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      const std::string name = std::string{forces[i], '_', motions[j]} + "_dot";
      const SpatialMatrix mass = read("added_mass: {" + name + ": -2.5}").added_mass;
      for (std::size_t k = 0; k < 6; ++k)
        for (std::size_t l = 0; l < 6; ++l)
          EXPECT_EQ(mass.entry[k][l], (k == i && l == j) || (k == j && l == i) ? 2.5 : 0)
              << name << k << l;
    }
  }
}

TEST(ReadAddedMass, TakesAPairThatAgreesAndRefusesOneThatDoesNot) {
  const Body body = read("added_mass: {Z_q_dot: -1.930, M_w_dot: -1.931}");
  EXPECT_NEAR(body.added_mass.entry[2][4], 1.9305, 1e-12);
  EXPECT_EQ(body.added_mass.entry[4][2], body.added_mass.entry[2][4]);
  const std::string told = refusal("added_mass: {Z_q_dot: -1.93, M_w_dot: 1.93}");
  EXPECT_TRUE(contains(told, "M_w_dot")) << told;
  EXPECT_TRUE(contains(told, "found 1.93 and Z_q_dot -1.93")) << told;
  EXPECT_TRUE(contains(told, "give one of them")) << told;
  EXPECT_TRUE(contains(refusal("added_mass: {Y_v_dot: 35}"), "give -35"));
  EXPECT_TRUE(contains(refusal("added_mass: {Y_p_dott: 1}"), "Y_p_dot"));
}

/// The coefficient of the product of two motions in -C_A nu: by the difference of three motions.
double product(const SpatialMatrix& mass, std::size_t force, std::size_t a, std::size_t b) {
  const auto of = [&](const Spatial<double>& nu) { return -in_order(coriolis(mass, nu))[force]; };
  if (a == b) return of(motion_of(a, 1));
  return of(motion_of(a, 1) + motion_of(b, 1)) - of(motion_of(a, 1)) - of(motion_of(b, 1));
}

TEST(ReadAddedMass, GivesTheCrossTermsOfPresterosTables) {
  const SpatialMatrix mass = read(remus).added_mass;
  constexpr std::size_t v = 1, w = 2, p = 3, q = 4, r = 5;
  EXPECT_NEAR(product(mass, 0, w, q), -35.5, 1e-9);
  EXPECT_NEAR(product(mass, 0, q, q), -1.93, 1e-9);
  EXPECT_NEAR(product(mass, 0, v, r), 35.5, 1e-9);
  EXPECT_NEAR(product(mass, 0, r, r), -1.93, 1e-9);
  EXPECT_NEAR(product(mass, 1, w, p), 35.5, 1e-9);
  EXPECT_NEAR(product(mass, 1, p, q), 1.93, 1e-9);
  EXPECT_NEAR(product(mass, 2, v, p), -35.5, 1e-9);
  EXPECT_NEAR(product(mass, 2, r, p), 1.93, 1e-9);
  EXPECT_NEAR(product(mass, 4, v, p), -1.93, 1e-9);
  EXPECT_NEAR(product(mass, 5, w, p), -1.93, 1e-9);
  // He has 4.86 for K_p_dot - N_r_dot, which are 4.81 with his 0.0704 and 4.88.
  EXPECT_NEAR(product(mass, 4, r, p), 4.86, 0.06);
  EXPECT_NEAR(product(mass, 5, p, q), -4.86, 0.06);
}

TEST(ReadDamping, HasEachTermOffTheDiagonalWithTheSignOfTables) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      if (i == j) continue;
      const std::string name{forces[i], '_', motions[j]};
      const Body body = read("damping: {" + name + ": 2.5}");
      EXPECT_TRUE(body.has_more());
      for (std::size_t k = 0; k < 6; ++k) {
        const std::array<double, 6> force = more_force(body, motion_of(k, -0.4));
        for (std::size_t l = 0; l < 6; ++l)
          EXPECT_NEAR(force[l], k == j && l == i ? 2.5 * -0.4 : 0, 1e-15) << name << k << l;
      }
    }
  }
  struct Quadratic {
    const char* name;
    std::size_t force, motion;
  };
  for (const auto& [name, i, j] : {Quadratic{"Y_r_abs_r", 1, 5}, Quadratic{"N_v_abs_v", 5, 1},
                                   Quadratic{"Z_q_abs_q", 2, 4}, Quadratic{"M_w_abs_w", 4, 2}}) {
    const Body body = read("damping: {" + std::string(name) + ": 2.5}");
    for (std::size_t k = 0; k < 6; ++k) {
      const std::array<double, 6> force = more_force(body, motion_of(k, -0.4));
      for (std::size_t l = 0; l < 6; ++l)
        EXPECT_NEAR(force[l], k == j && l == i ? -2.5 * 0.16 : 0, 1e-15) << name << k << l;
    }
  }
  EXPECT_FALSE(read("damping: {X_u: -4, N_r_abs_r: -3}").has_more());
  EXPECT_TRUE(contains(refusal("damping: {X_u: 4}"), "give -4"));
}

TEST(ReadDamping, ThatDrivesAMotionIsToldOf) {
  // LAUV (Estrela da Silva and others 2007).
  EXPECT_FALSE(motion_driven_by_damping(
      read("damping: {X_u: -2.4, Y_v: -23, Z_w: -23, K_p: -0.3, M_q: -9.7, N_r: -9.7, Y_r: 11.5, "
           "Z_q: -11.5, M_w: 3.1, N_v: -3.1}")));
  EXPECT_FALSE(motion_driven_by_damping(read("damping: {X_u: -4}")));
  // (d + d^T)/2 = [[4, -10], [-10, 9]]: the smaller root is 6.5 - sqrt(6.25 + 100) = -3.81.
  const auto told = motion_driven_by_damping(read("damping: {Y_v: -4, N_r: -9, Y_r: 12, N_v: 8}"));
  ASSERT_TRUE(told);
  EXPECT_TRUE(contains(*told, "3.81")) << *told;
  EXPECT_TRUE(contains(*told, "v ")) << *told;
  EXPECT_TRUE(contains(*told, "r ")) << *told;
  EXPECT_FALSE(contains(*told, "q ")) << *told;
}

/// What a table that holds the moment of the added mass says is what acts on a vehicle ahead.
TEST(ReadLift, IncludedIsWhatTheTableSaysTogetherWithTheAddedMass) {
  const Body body = read(remus + "lift: {munk: included, " + remus_lift + "}");
  const auto acts = [&](double u, std::size_t motion, double size) {
    const Spatial<double> nu = motion_of(0, u) + motion_of(motion, size);
    const std::array<double, 6> lift = more_force(body, nu);
    std::array<double, 6> all = in_order(coriolis(body.added_mass, nu));
    for (std::size_t i = 0; i < 6; ++i) all[i] = lift[i] - all[i];
    return all;
  };
  constexpr double u = 1.7, x = 0.2;
  EXPECT_NEAR(acts(u, 2, x)[4], 24.0 * u * x, 1e-12);
  EXPECT_NEAR(acts(u, 1, x)[5], -24.0 * u * x, 1e-12);
  EXPECT_NEAR(acts(u, 1, x)[1], -28.6 * u * x, 1e-12);
  EXPECT_NEAR(acts(u, 5, x)[1], 5.22 * u * x, 1e-12);
  EXPECT_NEAR(acts(u, 5, x)[5], -2.0 * u * x, 1e-12);
  EXPECT_NEAR(acts(u, 2, x)[2], -28.6 * u * x, 1e-12);
  EXPECT_NEAR(acts(u, 4, x)[2], -5.22 * u * x, 1e-12);
  EXPECT_NEAR(acts(u, 4, x)[4], -2.0 * u * x, 1e-12);
  // His parts: body -4.47 and fins -6.15 kg of M_uw; fins alone -6.15 kg of Z_uq, 6.15 of Y_ur.
  EXPECT_NEAR(body.speed_lift.m_uw, -4.47 - 6.15, 0.06);
  EXPECT_NEAR(body.speed_lift.n_uv, 4.47 + 6.15, 0.06);
  EXPECT_NEAR(body.speed_lift.z_uq, -6.15, 1e-12);
  EXPECT_NEAR(body.speed_lift.y_ur, 6.15, 1e-12);
  EXPECT_NEAR(body.speed_lift.m_uq, -3.93, 1e-12);
  EXPECT_NEAR(body.speed_lift.n_ur, -3.93, 1e-12);
  // Of what a table does not give nothing is taken off.
  EXPECT_EQ(read(remus + "lift: {munk: included, M_uw: 24}").speed_lift.z_uq, 0);
}

TEST(ReadLift, ApartIsTheDefaultAndLeftOutTakesTheMomentOfTheAddedMassAway) {
  const Body apart = read(remus + "lift: {" + remus_lift + "}");
  EXPECT_EQ(apart.speed_lift.m_uw, 24);
  EXPECT_EQ(apart.speed_lift.n_uv, -24);
  EXPECT_FALSE(apart.speed_lift.without_munk);
  EXPECT_EQ(read("lift: {K_up: -2}").speed_lift.k_up, -2);
  const Body left_out = read(remus + "lift: {munk: left_out, M_uw: -3}");
  const Spatial<double> nu{{-1.5, 0.2, 0.3}, {}};  // astern as ahead
  EXPECT_NEAR(more_force(left_out, nu)[4] - in_order(coriolis(left_out.added_mass, nu))[4],
              -3 * 1.5 * 0.3, 1e-12);
  EXPECT_NEAR(more_force(left_out, nu)[5] - in_order(coriolis(left_out.added_mass, nu))[5], 0,
              1e-12);
}

TEST(ReadLift, RefusesTwoWordsForOneForceAndUnknownOnes) {
  EXPECT_TRUE(contains(refusal("lift: {Y_uv: -3}", 40), "beside trailing_edge"));
  EXPECT_TRUE(contains(refusal("lift: {N_ur: -3}", 40), "beside trailing_edge"));
  EXPECT_EQ(refusal("lift: {M_uw: -3}", 40), "");
  const std::string told = refusal("lift: {munk: off}");
  EXPECT_TRUE(contains(told, "found off, expected apart")) << told;
  EXPECT_TRUE(contains(refusal("lift: {munk: included, Y_uv: -3}"), "neither M_uw nor N_uv"));
  EXPECT_TRUE(contains(refusal("lift: {X_uu: -3}"), "X_uu"));
}

}  // namespace
}  // namespace slackwater::twin::read_derivatives_test
