#include "tests/twin/navigation/navigation_for_tests.h"

namespace slackwater::twin::dead_reckoning_test {
namespace {

/// Instruments carried along a way by hand: no dynamics, so that only what they show counts.
class Carried {
 public:
  Carried(const std::string& model, const std::function<void(Sensors&)>& change,
          const Triple<double>& start_m, std::uint64_t seed = 7, double east_m_s = 0,
          double depth_m = 60)
      : ready_(tests::ready_of("name: test\nseed: 7\nduration: 30min\nstep_s: 0.1\nwater: "
                               "{made_up: {depth_m: " +
                               std::to_string(depth_m) +
                               ", current: [{depth_m: 0, east_m_s: " + std::to_string(east_m_s) +
                               ", north_m_s: 0}]}}\nvehicles: [{name: it, model: " + model +
                               ", start: {north_m: 0, east_m: 0, depth_m: 10}}]\n")),
        vehicle_(*ready_.agents[0].vehicle) {
    change(vehicle_.sensors);
    navigation_ = plan_navigation(vehicle_, dt_s, false);
    body_.attitude.w = 1;
    body_.position_m = start_m;
    state_ = begun(navigation_, seed, "it", body_);
  }

  /// Moves it over ground, level, its bow where it goes; at rest it keeps its heading.
  void carry(const Triple<double>& velocity_m_s, double for_s) {
    const double speed = std::hypot(velocity_m_s.x, velocity_m_s.y);
    if (speed > 0) body_.attitude = attitude_of({0, 0, std::atan2(velocity_m_s.y, velocity_m_s.x)});
    body_.nu.linear = rotation_of(body_.attitude).to_body(velocity_m_s);
    const auto steps = static_cast<int>(std::lround(for_s / dt_s));
    for (int i = 0; i < steps; ++i) {
      t_s_ += dt_s;
      body_.position_m = body_.position_m + dt_s * velocity_m_s;
      (void)sense(navigation_, {*ready_.agents[0].water, 0, t_s_}, body_, state_);
    }
  }

  [[nodiscard]] Triple<double> error_m() const { return state_.error_m; }
  [[nodiscard]] double lost_m() const { return std::hypot(error_m().x, error_m().y); }
  [[nodiscard]] const NavigationState& state() const { return state_; }

 private:
  static constexpr double dt_s = 0.1;
  ReadyRun ready_;
  Vehicle vehicle_;
  Navigation navigation_;
  BodyState<double> body_;
  NavigationState state_;
  double t_s_ = 0;
};

void make_perfect(Sensors& sensors) { sensors = tests::perfect(sensors); }

TEST(DeadReckoning, PerfectInstrumentsAreNeverLost) {
  Carried it("lrauv_tethys", make_perfect, {0, 0, 10});
  it.carry({1, 0, 0}, 100);
  it.carry({0, 1, 0.1}, 100);
  it.carry({-0.7, -0.7, -0.1}, 100);
  // The first step of each leg is half a step's way at once: no body starts so.
  EXPECT_LT(it.lost_m(), 0.2);
  const double before_m = it.lost_m();
  it.carry({-0.7, -0.7, 0}, 300);
  EXPECT_NEAR(it.lost_m(), before_m, 0.01);
}

TEST(DeadReckoning, AHeadingThatIsWrongByHCarriesAsideBySineHOfTheWay) {
  for (const double h : {0.01, 0.05}) {
    Carried it("lrauv_tethys",
               [&](Sensors& s) {
                 make_perfect(s);
                 s.compass->constant_rad = h;
               },
               {0, 0, 10});
    it.carry({1, 0, 0}, 1000);
    EXPECT_NEAR(it.error_m().y, 1000 * std::sin(h), 0.3) << h;
    EXPECT_NEAR(it.error_m().x, 1000 * (std::cos(h) - 1), 0.3) << h;
  }
}

TEST(DeadReckoning, AScaleThatIsWrongCarriesAlongByItsShareOfTheWay) {
  Carried it("lrauv_tethys",
             [](Sensors& s) {
               make_perfect(s);
               s.dvl->scale = 1.01;
             },
             {0, 0, 10});
  it.carry({0, 1, 0}, 600);
  EXPECT_NEAR(it.error_m().y, 6, 0.1);
  EXPECT_NEAR(it.error_m().x, 0, 0.2);  // a bow put round within a step
}

TEST(DeadReckoning, WhiteNoiseOfTheDvlWalksItByTheRootOfTheTime) {
  // A pair of beams at slant s gives one axis: n/(sqrt(2) sin s) a ping, so n sqrt(T t)/(sqrt(2)
  // sin s) in each of two axes.
  constexpr double noise_m_s = 0.02, ping_s = 0.2;
  const double axis_m_s = noise_m_s / (std::sqrt(2.0) * std::sin(constants::pi / 6));
  constexpr int seeds = 60;
  double early2 = 0, late2 = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    Carried it(
        "lrauv_tethys",
        [&](Sensors& s) {
          make_perfect(s);
          s.dvl->noise_sd_m_s = noise_m_s;
        },
        {0, 0, 10}, static_cast<std::uint64_t>(seed));
    it.carry({}, 100);
    early2 += it.lost_m() * it.lost_m() / seeds;
    it.carry({}, 300);
    late2 += it.lost_m() * it.lost_m() / seeds;
  }
  const auto expected_m = [&](double t_s) { return axis_m_s * std::sqrt(2 * ping_s * t_s); };
  // Of 120 squares the mean root is known within 1/sqrt(240), 6.5 %; three of these.
  EXPECT_NEAR(std::sqrt(early2) / expected_m(100), 1, 0.2);
  EXPECT_NEAR(std::sqrt(late2) / expected_m(400), 1, 0.2);
  EXPECT_NEAR(std::sqrt(late2 / early2), 2, 0.4);
}

TEST(DeadReckoning, ATrackThroughTheWaterDriftsWithTheWater) {
  // 1000 m of water: the bed is not heard. Held over one place, it takes itself to be going up the
  // stream.
  Carried it("lrauv_tethys", make_perfect, {0, 0, 10}, 7, 0.3, 1000);
  it.carry({}, 200);
  EXPECT_EQ(it.state().instruments.shown.dvl_is_bottom, 0);
  EXPECT_NEAR(it.error_m().y, -0.3 * 200, 0.8);  // the first seconds of the filter: 0.3 m/s by 2 s
  EXPECT_NEAR(it.error_m().x, 0, 0.05);
}

TEST(DeadReckoning, WithoutAnyVelocityItStaysLevelAndTakesItselfToBeStill) {
  Carried it("lrauv_tethys",
             [](Sensors& s) {
               s.dvl.reset();
               s.gnss.reset();
             },
             {0, 0, 10});
  it.carry({}, 1200);
  const EulerAngles angles = euler_angles(it.state().navigator.attitude);
  EXPECT_LT(std::abs(angles.roll_rad), 0.03);  // 0.05 m/s2 of an accelerometer are 0.005 rad
  EXPECT_LT(std::abs(angles.pitch_rad), 0.03);
  EXPECT_LT(std::abs(it.state().navigator.velocity_m_s.x), 0.1);
  EXPECT_NEAR(it.error_m().z, 0, 0.2);
}

TEST(DeadReckoning, AFixAtTheSurfaceEndsTheDriftThatALongDiveBrought) {
  Carried it("lrauv_tethys", [](Sensors& s) { s.compass->constant_rad = 0.05; }, {0, 0, 10});
  it.carry({1, 0, 0}, 600);
  EXPECT_GT(it.lost_m(), 15);
  EXPECT_TRUE(std::isnan(it.state().instruments.shown.gnss_position_m.x));
  it.carry({0, 0, -0.5}, 20);  // to the surface
  it.carry({}, 60);
  EXPECT_LT(it.lost_m(), 4);  // of the receiver: 95 % within 2.4 m
  EXPECT_FALSE(std::isnan(it.state().instruments.shown.gnss_position_m.x));
  const double at_surface_m = it.lost_m();
  it.carry({0, 0, 0.5}, 20);
  it.carry({}, 30);
  EXPECT_NEAR(it.lost_m(), at_surface_m, 1);  // under water it goes on from there
}

TEST(DeadReckoning, AReceiverBoundsTheErrorForAsLongAsItSees) {
  double worst_m = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Carried it(
        "lrauv_tethys", [](Sensors&) {}, {0, 0, 0}, seed);
    for (int leg = 0; leg < 20; ++leg) {
      it.carry({leg % 2 == 0 ? 1.0 : -1.0, 0, 0}, 60);
      worst_m = std::max(worst_m, it.lost_m());
    }
  }
  // Four standard deviations of its slow error, 0.93 m along each axis.
  EXPECT_LT(worst_m, 4.5);
  EXPECT_GT(worst_m, 0.5);
}

}  // namespace
}  // namespace slackwater::twin::dead_reckoning_test
