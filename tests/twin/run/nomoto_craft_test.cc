// A craft whose equation of yaw is Nomoto's of the first order, flown through scenario, approach,
// thrusters and log: its zig-zag, pull-out and turn against the closed form.
#include <fstream>

#include "fields/base/constants.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/manoeuvre_for_tests.h"

namespace slackwater::tests::nomoto_craft_test {
namespace {

using constants::degree;
using twin::ManoeuvreAccount;

// T r' + r = K s with s the share of the yaw moment: added mass alike ahead and sideways has no
// moment of its own, nothing else turns it, and its drives push as hard at any speed.
constexpr double arm_m = 0.4, most_n = 150, inertia_kg_m2 = 30 + 20, damping_n_m_s = 40;
// What the allocation takes for all that there is is a thousandth less.
constexpr double most_yaw_n_m = (1 - 1e-3) * 2 * arm_m * most_n;
constexpr double T_s = inertia_kg_m2 / damping_n_m_s;
constexpr double K_per_s = most_yaw_n_m / damping_n_m_s;  ///< per share

constexpr const char* craft = R"(id: nomoto
name: craft of Nomoto
kind: usv
largest_step_s: 0.01
cruise_speed_m_s: 1
dimensions_m: {length: 2, width: 1.1, height: 0.5}
rigid_body: {mass_kg: 80, centre_of_gravity_m: [0, 0, 0], inertia_kg_m2: {xx: 17, yy: 30, zz: 30}}
hulls: {beam_m: 0.25, depth_m: 0.35, deadrise_deg: 57, from_x_m: -1, to_x_m: 1,
        centre_y_m: [-0.4, 0.4], keel_z_m: 0.2, strips: 8}
added_mass: {X_u_dot: -20, Y_v_dot: -20, Z_w_dot: -55, K_p_dot: -4, M_q_dot: -17, N_r_dot: -20}
damping: {X_u: -60, Y_v: -150, Z_w: -600, K_p: -60, M_q: -260, N_r: -40}
thruster:
  kind: drive
  propeller_diameter_m: 0.2
  efficiency: 0.6
  most_thrust_n: 150
  least_thrust_n: -150
  rise_time_constant_s: 0.01
  fall_time_constant_s: 0.01
mounts:
  - {position_m: [-0.9, -0.4, 0], direction: [1, 0, 0]}
  - {position_m: [-0.9, 0.4, 0], direction: [1, 0, 0]}
hotel_w: 0
)";

class NomotoCraft : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(folder_ / "nomoto.yaml") << craft; }
  [[nodiscard]] ManoeuvreAccount flown(const std::string& task, double lasts_s) const {
    std::string yaml = doing((folder_ / "nomoto.yaml").string(), task, afloat);
    for (const auto& [found, instead] :
         {std::pair{"step_s: 0.05", "step_s: 0.01"}, {"log_every_s: 0.1", "log_every_s: 0.02"}})
      yaml.replace(yaml.find(found), std::string(found).size(), instead);
    const auto run = begun(ready_of(yaml), 0.01);
    twin::RunLog log;
    log.append(0, run->agents(), run->states());
    while (run->time_s() < lasts_s) {
      for (int i = 0; i < 2; ++i) run->step();
      log.append(run->time_s(), run->agents(), run->states());
    }
    return account_of_rows(*run, log).manoeuvres.at(0);
  }
  TemporaryFolder folder_;
};

/// Turned on, with the helm against it, until it stands: the overshoot.
double overshoot_rad(double rate_rad_s, double share) {
  const double wanted = K_per_s * share;
  return T_s * (rate_rad_s - wanted * std::log1p(rate_rad_s / wanted));
}

/// From a rate on under a helm: how fast it turns when it has turned so far.
double rate_at(double from_rad_s, double share, double turn_rad) {
  const double wanted = K_per_s * share;
  const auto rate = [&](double t_s) {
    return wanted + (from_rad_s - wanted) * std::exp(-t_s / T_s);
  };
  const auto turned = [&](double t_s) {
    return wanted * t_s + (from_rad_s - wanted) * T_s * (1 - std::exp(-t_s / T_s));
  };
  // From where it stands, behind which it only goes on.
  double low_s = from_rad_s < 0 ? T_s * std::log1p(-from_rad_s / wanted) : 0, high_s = 1e3;
  for (int i = 0; i < 200; ++i) {
    const double middle_s = 0.5 * (low_s + high_s);
    (turned(middle_s) < turn_rad ? low_s : high_s) = middle_s;
  }
  return rate(low_s);
}

TEST_F(NomotoCraft, HasTheOvershootsOfItsClosedForm) {
  for (const char* const side : {"starboard", "port"}) {
    const ManoeuvreAccount account =
        flown(std::string("{do: zig_zag, side: ") + side +
                  ", helm_share: 0.1, heading_change_deg: 20, approach_s: 20, lasts_s: 60}",
              60);
    const twin::ZigZag& found = account.zig_zag.value();
    ASSERT_EQ(found.overshoot_rad.size(), 4U);
    double rate_rad_s = rate_at(0, 0.1, 20 * degree);
    for (std::size_t i = 0; i < 4; ++i) {
      // The lag of the drives, 0.01 s, and a step of 0.01 s until the helm is given: 0.02 s of the
      // rate, some 0.2 degrees of 9.
      const double late_rad = 0.02 * rate_rad_s;
      EXPECT_NEAR(found.overshoot_rad[i], overshoot_rad(rate_rad_s, 0.1), late_rad) << i;
      EXPECT_GT(found.overshoot_rad[i], overshoot_rad(rate_rad_s, 0.1)) << "later, not sooner";
      rate_rad_s = rate_at(-rate_rad_s, 0.1, 40 * degree);
    }
  }
}

TEST_F(NomotoCraft, TurnsSteadilyAtItsGainAndHasNothingLeftAmidships) {
  const ManoeuvreAccount account =
      flown("{do: pull_out, helm_share: 0.1, approach_s: 20, turn_s: 20, lasts_s: 20}", 61);
  EXPECT_NEAR(account.pull_out.value().turn_rad_s, K_per_s * 0.1, 1e-5 * K_per_s);
  EXPECT_NEAR(account.pull_out->residual_rad_s, 0, 1e-5 * K_per_s);
}

TEST_F(NomotoCraft, HasASpiralThatIsAStraightLine) {
  const ManoeuvreAccount account = flown(
      "{do: spiral, helms_share: [0.1, 0.05, 0, -0.05, -0.1, -0.05, 0, 0.05, 0.1], approach_s: 20, "
      "each_s: 15}",
      156);
  ASSERT_EQ(account.spiral.value().points.size(), 9U);
  for (const twin::SpiralPoint& point : account.spiral->points) {
    EXPECT_TRUE(point.is_steady);
    EXPECT_NEAR(point.turn_rad_s, K_per_s * point.helm_rad, 1e-5 * K_per_s);
  }
  EXPECT_NEAR(account.spiral->loop_width_rad.value(), 0, 1e-3);
}

}  // namespace
}  // namespace slackwater::tests::nomoto_craft_test
