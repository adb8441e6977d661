#include "fields/base/constants.h"
#include "fields/base/turn.h"
#include "tests/bench/counted_allocations.h"
#include "tests/twin/run/manoeuvre_for_tests.h"
#include "twin/step/open_loop.h"
#include "twin/step/vehicle_step.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::tests::manoeuvres_in_a_run_test {
namespace {

using constants::degree;
using constants::pi;
using twin::ManoeuvreAccount;
using twin::Ordered;
using twin::TaskOrder;

std::vector<TaskOrder> helms_of(const ManoeuvreAccount& account) {
  std::vector<TaskOrder> helms;
  for (const TaskOrder& order : account.orders)
    if (order.is(Ordered::helm)) helms.push_back(order);
  return helms;
}

/// An Otter's turn by her propellers as the run left them, from where the helm was put over,
/// without any of what steers her: every step a place and a heading.
struct Integrated {
  std::vector<double> t_s, north_m, east_m, turned_rad;

  Integrated(const twin::Vehicle& vehicle, const twin::VehicleState<double>& from,
             double left_rad_s, double right_rad_s, double lasts_s) {
    const twin::StepPlan plan = twin::plan_step(vehicle, helm_step_s);
    twin::VehicleState<double> state = from;
    twin::VehicleCommand<double> command;
    command.thruster[0] = left_rad_s;
    command.thruster[1] = right_rad_s;
    double turned = 0, before = twin::euler_angles(state.body.attitude).yaw_rad;
    for (int i = 0; i * helm_step_s <= lasts_s; ++i) {
      t_s.push_back(i * helm_step_s);
      north_m.push_back(state.body.position_m.x);
      east_m.push_back(state.body.position_m.y);
      turned_rad.push_back(turned);
      twin::step(vehicle, plan, state, command, {});
      const double now = twin::euler_angles(state.body.attitude).yaw_rad;
      turned += wrapped_rad(now - before);
      before = now;
    }
  }
  /// The step in which it has turned so far.
  [[nodiscard]] std::size_t at(double turned) const {
    std::size_t i = 0;
    while (i + 1 < turned_rad.size() && turned_rad[i] < turned) ++i;
    return i;
  }
  [[nodiscard]] double along_m(std::size_t i, double course_rad) const {
    return (north_m[i] - north_m[0]) * std::cos(course_rad) +
           (east_m[i] - east_m[0]) * std::sin(course_rad);
  }
  [[nodiscard]] double across_m(std::size_t i, double course_rad) const {
    return (east_m[i] - east_m[0]) * std::cos(course_rad) -
           (north_m[i] - north_m[0]) * std::sin(course_rad);
  }
};

TEST(ManoeuvresInARun, ACircleOfTheOtterIsThatOfHerPropellersAlone) {
  Flown flown = begun_flight(
      doing("otter", "{do: turning_circle, helm_share: 0.3, speed_m_s: 1.2, lasts_s: 90}", afloat));
  twin::VehicleState<double> executed;
  while (flown.state().mission.manoeuvre.leg == 0) {
    executed = flown.state().vehicle;
    flown.run->step();
    if (std::lround(flown.run->time_s() / helm_step_s) % 2 == 0)
      flown.log.append(flown.run->time_s(), flown.run->agents(), flown.run->states());
  }
  const double executed_s = flown.state().mission.orders.back().t_s;
  EXPECT_NEAR(executed_s, 60, 1e-6);
  flown.until(160);
  const ManoeuvreAccount account = flown.account().manoeuvres.at(0);
  const twin::TurningCircle& circle = account.circle.value();

  // The commands, from the thrusters five seconds on: their lag is 0.1 s.
  Flown again = begun_flight(
      doing("otter", "{do: turning_circle, helm_share: 0.3, speed_m_s: 1.2, lasts_s: 90}", afloat));
  again.until(65);
  const auto& behind = again.state().vehicle.thruster;
  EXPECT_GT(behind[0], behind[1]) << "to starboard";
  const twin::Vehicle& otter = *again.run->agents()[0].vehicle;
  const Integrated alone(otter, executed, behind[0], behind[1], 90);
  const double course_rad = twin::euler_angles(executed.body.attitude).yaw_rad;
  const std::size_t quarter = alone.at(0.5 * pi), half = alone.at(pi);
  // A step of 0.05 s at 1.2 m/s, where it is across the way.
  const double step_m = 1.2 * helm_step_s;
  EXPECT_NEAR(circle.advance_m.value(), alone.along_m(quarter, course_rad), step_m);
  EXPECT_NEAR(circle.transfer_m.value(), alone.across_m(quarter, course_rad), step_m);
  EXPECT_NEAR(circle.tactical_diameter_m.value(), alone.across_m(half, course_rad), step_m);
  EXPECT_NEAR(circle.full_s.value(), alone.t_s[alone.at(2 * pi)], 0.1);
  EXPECT_TRUE(account.approach.value().is_steady());
  EXPECT_NEAR(account.approach->speed_m_s, 1.2, 0.01);
  EXPECT_TRUE(account.is_over());
}

/// The sum of the thrusts of the Otter, which do not go by her speed, and the shaft of the REMUS.
TEST(ManoeuvresInARun, HoldThePropulsionOfTheApproach) {
  Flown otter = begun_flight(
      doing("otter", "{do: turning_circle, helm_share: 0.4, speed_m_s: 1.2, lasts_s: 60}", afloat));
  otter.until(60);
  const auto sum_n = [](const twin::AgentState& state) {
    return state.vehicle.thrust_n[0] + state.vehicle.thrust_n[1];
  };
  const double approach_n = sum_n(otter.state());
  otter.until(80);
  EXPECT_NEAR(sum_n(otter.state()), approach_n, 1e-3 * approach_n);
  EXPECT_LT(otter.state().vehicle.body.nu.linear.x, 1.18) << "she loses speed for all that";

  Flown remus = begun_flight(
      doing("remus100", "{do: turning_circle, helm_deg: 10, speed_m_s: 1.5, lasts_s: 60}"));
  remus.until(60);
  const double approach_rad_s = remus.state().vehicle.thruster[0];
  remus.until(61);
  const double held_rad_s = remus.state().vehicle.thruster[0];
  remus.until(90);
  EXPECT_NEAR(held_rad_s, approach_rad_s, 2e-3 * approach_rad_s);
  EXPECT_NEAR(remus.state().vehicle.thruster[0], held_rad_s, 2e-3 * approach_rad_s);
  EXPECT_NEAR(remus.state().vehicle.rudder_rad, 10 * degree, 1e-9);
}

TEST(ManoeuvresInARun, AnAuvKeepsItsDepthMeanwhile) {
  for (const char* const model : {"lrauv_tethys", "lauv"}) {
    Flown flown = begun_flight(doing(model, "{do: zig_zag, helm_deg: 10, lasts_s: 120}"));
    double most_m = 0;
    flown.until(30);
    while (flown.run->time_s() < 180) {
      flown.run->step();
      most_m = std::max(most_m, std::abs(flown.state().vehicle.body.position_m.z - 20));
    }
    EXPECT_LT(most_m, 0.5) << model;
  }
}

TEST(ManoeuvresInARun, AZigZagPutsTheHelmOverWhereTheHeadingHasChanged) {
  Flown flown = begun_flight(
      doing("lauv",
            "{do: zig_zag, helm_deg: 15, heading_change_deg: 20, speed_m_s: 1.4, lasts_s: "
            "200}"));
  flown.until(200);
  const ManoeuvreAccount account = flown.account().manoeuvres.at(0);
  const std::vector<TaskOrder> helms = helms_of(account);
  ASSERT_EQ(helms.size(), 5U);
  const std::vector<double> yaw = flown.log.column(0, "yaw"),
                            rudder = flown.log.column(0, "rudder"),
                            rate = flown.log.column(0, "rate_body");
  const auto row_at = [&](double t_s) { return static_cast<std::size_t>(std::lround(t_s / 0.1)); };
  const double course = yaw[row_at(helms[0].t_s)];
  EXPECT_NEAR(course, 40 * degree, 0.5 * degree);
  double side = 1;
  for (std::size_t i = 0; i < helms.size(); ++i, side = -side) {
    EXPECT_NEAR(helms[i].value, side * 15 * degree, 1e-12);
    // Half a second from side to side at 1 rad/s, behind a lag of 0.1 s.
    EXPECT_NEAR(rudder[row_at(helms[i].t_s + 1.2)], side * 15 * degree, 0.1 * degree);
    if (i == 0) continue;
    // Of the row beside it, half a tenth of a second off, and a step of 0.05 s.
    const std::size_t row = row_at(helms[i].t_s);
    EXPECT_NEAR(wrapped_rad(yaw[row] - course), -side * 20 * degree,
                0.11 * std::abs(rate[3 * row + 2]));
  }
  // What the task did is what the pure figures see in its rows.
  LogRows rows(flown.log, 0);
  std::vector<twin::ManoeuvreRow> until_over;
  for (const twin::ManoeuvreRow& row : twin::manoeuvre_rows(rows.rows()))
    if (row.t_s <= account.ended_s) until_over.push_back(row);
  const twin::ZigZag pure = twin::zig_zag(until_over, helms[0].t_s, 20 * degree);
  EXPECT_EQ(account.zig_zag.value(), pure);
  ASSERT_EQ(pure.overshoot_rad.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(pure.execute_s[i], helms[i + 1].t_s - helms[0].t_s, 0.1);
    EXPECT_GT(pure.overshoot_rad[i], 0);
  }
  EXPECT_TRUE(account.is_over());
  EXPECT_TRUE(account.absent.empty());
}

/// Craft that are alike on both sides.
TEST(ManoeuvresInARun, ToPortAreThoseToStarboardInAMirror) {
  for (const auto& [model, start, helm] :
       {std::tuple{"otter", afloat, "helm_share: 0.3, speed_m_s: 1.2"},
        {"lauv", std::string("depth_m: 20, heading_deg: 40"), "helm_deg: 12"}}) {
    const auto figures = [&, m = std::string(model), s = start, h = std::string(helm)](
                             const std::string& kind, const std::string& side) {
      return flown_manoeuvre(
          doing(m, "{do: " + kind + ", side: " + side + ", " + h + ", approach_s: 40, lasts_s: 90}",
                s),
          140);
    };
    const ManoeuvreAccount to_starboard = figures("turning_circle", "starboard"),
                           to_port = figures("turning_circle", "port");
    EXPECT_TRUE(to_starboard.circle->to_starboard);
    EXPECT_FALSE(to_port.circle->to_starboard);
    EXPECT_NEAR(to_port.circle->advance_m.value(), to_starboard.circle->advance_m.value(), 0.01);
    EXPECT_NEAR(to_port.circle->tactical_diameter_m.value(),
                to_starboard.circle->tactical_diameter_m.value(), 0.01);
    EXPECT_NEAR(to_port.turned_rad, -to_starboard.turned_rad, 0.01);
    const ManoeuvreAccount right = figures("zig_zag", "starboard"),
                           left = figures("zig_zag", "port");
    ASSERT_EQ(right.zig_zag->overshoot_rad.size(), left.zig_zag->overshoot_rad.size()) << model;
    ASSERT_FALSE(right.zig_zag->overshoot_rad.empty()) << model;
    for (std::size_t i = 0; i < right.zig_zag->overshoot_rad.size(); ++i)
      EXPECT_NEAR(right.zig_zag->overshoot_rad[i], left.zig_zag->overshoot_rad[i], 0.05 * degree);
  }
}

TEST(ManoeuvresInARun, AreTheSameWhateverTheCourse) {
  const auto circle = [](const std::string& heading) {
    return flown_manoeuvre(
        doing("remus100", "{do: turning_circle, helm_deg: 10, approach_s: 40, lasts_s: 60}",
              "depth_m: 20, heading_deg: " + heading),
        100);
  };
  const ManoeuvreAccount north = circle("0"), other = circle("217");
  EXPECT_NEAR(north.circle->advance_m.value(), other.circle->advance_m.value(), 1e-3);
  EXPECT_NEAR(north.circle->transfer_m.value(), other.circle->transfer_m.value(), 1e-3);
  EXPECT_NEAR(north.circle->steady.value().turn_rad_s, other.circle->steady.value().turn_rad_s,
              1e-5);
}

/// Between two descriptions of one thing: the radius of the steady turn by its rate, and that of
/// the circle through three places of its track.
TEST(ManoeuvresInARun, ASteadyTurnHasTheRadiusOfItsTrack) {
  Flown flown = begun_flight(
      doing("remus100", "{do: turning_circle, helm_deg: 12, approach_s: 40, lasts_s: 90}"));
  flown.until(120);
  const ManoeuvreAccount account = flown.account().manoeuvres.at(0);
  const twin::SteadyTurn& steady = account.circle.value().steady.value();
  const std::vector<double> x = flown.log.column(0, "x"), y = flown.log.column(0, "y");
  const std::size_t last = static_cast<std::size_t>(std::lround(account.ended_s / 0.1));
  const auto third = static_cast<std::size_t>(2 * pi / std::abs(steady.turn_rad_s) / 3 / 0.1);
  const auto side_m = [&](std::size_t a, std::size_t b) {
    return std::hypot(x[a] - x[b], y[a] - y[b]);
  };
  const std::size_t i = last - third, j = last - third / 2, k = last;
  const double a = side_m(i, j), b = side_m(j, k), c = side_m(i, k);
  const double area_m2 =
      0.5 * std::abs((x[j] - x[i]) * (y[k] - y[i]) - (x[k] - x[i]) * (y[j] - y[i]));
  EXPECT_NEAR(steady.radius_m, a * b * c / (4 * area_m2), 0.02 * steady.radius_m);
}

/// The Otter is unstable on her course: with nobody at her controls she circles to either side, at
/// a rate that her equations tell (`open_loop_of`). Her spiral and her pull-out find it again.
TEST(ManoeuvresInARun, ASpiralAndAPullOutFindTheCircleOfAnUnstableCraft) {
  Flown spiral = begun_flight(doing(
      "otter",
      "{do: spiral, speed_m_s: 1.5, each_s: 60, helms_share: [0.2, 0.1, 0.05, 0, -0.05, -0.1, "
      "-0.2, -0.1, -0.05, 0, 0.05, 0.1, 0.2]}",
      afloat));
  spiral.until(60 + 13 * 60 + 1);
  const ManoeuvreAccount account = spiral.account().manoeuvres.at(0);
  const double circles_rad_s = twin::open_loop_of(*spiral.run->agents()[0].vehicle).turn_rad_s;
  ASSERT_GT(circles_rad_s, 1 * degree);
  ASSERT_EQ(account.spiral.value().points.size(), 13U);
  EXPECT_NEAR(account.spiral->loop_height_rad_s.value(), 2 * circles_rad_s, 0.1 * circles_rad_s);
  EXPECT_GT(account.spiral->loop_width_rad.value(), 0);
  EXPECT_TRUE(account.absent.empty());

  const ManoeuvreAccount pull_out = flown_manoeuvre(
      doing("otter",
            "{do: pull_out, side: port, helm_share: 0.2, speed_m_s: 1.5, turn_s: 60, "
            "lasts_s: 90}",
            afloat),
      220);
  EXPECT_LT(pull_out.pull_out.value().turn_rad_s, -circles_rad_s);
  EXPECT_NEAR(pull_out.pull_out->residual_rad_s, -circles_rad_s, 0.05 * circles_rad_s);
}

TEST(ManoeuvresInARun, OfAStableCraftLeaveNoTurnAndNoLoop) {
  const ManoeuvreAccount pull_out =
      flown_manoeuvre(doing("lauv", "{do: pull_out, helm_deg: 10, turn_s: 40, lasts_s: 40}"), 150);
  EXPECT_GT(pull_out.pull_out.value().turn_rad_s, 2 * degree);
  EXPECT_NEAR(pull_out.pull_out->residual_rad_s, 0, 0.05 * degree);
  const ManoeuvreAccount spiral = flown_manoeuvre(
      doing("lauv", "{do: spiral, helms_deg: [10, 5, 0, -5, -10, -5, 0, 5, 10], each_s: 25}"), 300);
  EXPECT_NEAR(spiral.spiral.value().loop_height_rad_s.value(), 0, 0.05 * degree);
  EXPECT_NEAR(spiral.spiral->loop_width_rad.value(), 0, 0.05 * degree);
}

TEST(ManoeuvresInARun, AnRovTurnsByItsThrustersAndKeepsItsDepth) {
  Flown flown = begun_flight(doing(
      "bluerov2_heavy",
      "{do: turning_circle, side: port, helm_share: 0.05, speed_m_s: 0.4, approach_s: 30, lasts_s: "
      "60}"));
  flown.until(80);
  const ManoeuvreAccount account = flown.account().manoeuvres.at(0);
  EXPECT_LT(account.turned_rad, -90 * degree);
  EXPECT_TRUE(account.circle.value().advance_m);
  EXPECT_NEAR(flown.state().vehicle.body.position_m.z, 20, 0.3);
}

TEST(ManoeuvresInARun, StepsAreKeptByTheAutopilot) {
  Flown flown =
      begun_flight(doing("lauv",
                         "{do: steps, duration_s: 200, table: [{at_s: 0, speed_m_s: 1.2}, {at_s: "
                         "50, heading_deg: 70}, "
                         "{at_s: 100, depth_m: 23}, {at_s: 150, speed_m_s: 1.6}]}, {do: hold}"));
  flown.until(199);
  EXPECT_NEAR(flown.state().vehicle.body.position_m.z, 23, 0.3);
  EXPECT_NEAR(yaw_rad(flown.state()), 70 * degree, 1 * degree);
  EXPECT_NEAR(flown.state().vehicle.body.nu.linear.x, 1.6, 0.05);
  flown.until(201);
  EXPECT_EQ(flown.state().mission.task, 1U);
  EXPECT_EQ(flown.state().mission.kept_m.z, 23) << "the task after it goes on there";
  const ManoeuvreAccount account = flown.account().manoeuvres.at(0);
  ASSERT_EQ(account.steps.size(), 3U) << "the speed that it begins with is no step";
  EXPECT_EQ(account.steps[0].what, Ordered::heading);
  EXPECT_NEAR(account.steps[0].at_s, 50, 1e-6);
  EXPECT_NEAR(account.steps[0].from, 40 * degree, 1e-9);
  EXPECT_NEAR(account.steps[0].to, 70 * degree, 1e-9);
  EXPECT_NEAR(account.steps[0].lasted_s, 150, 1e-6) << "to the end of the task";
  EXPECT_EQ(account.steps[1].what, Ordered::depth);
  EXPECT_EQ(account.steps[2].what, Ordered::speed);
  for (const twin::StepAccount& step : account.steps) {
    ASSERT_TRUE(step.response);
    EXPECT_TRUE(step.response->rise_s && step.response->settling_s) << name_of(step.what);
    EXPECT_LT(std::abs(step.response->steady_error), 0.03 * std::abs(step.to - step.from));
  }
  // Against the rows themselves: when the heading first comes to nine tenths of its step.
  const std::vector<double> yaw = flown.log.column(0, "yaw");
  std::size_t low = 500, high = 500;
  while (yaw[low] < 43 * degree) ++low;
  while (yaw[high] < 67 * degree) ++high;
  EXPECT_NEAR(account.steps[0].response->rise_s.value(), 0.1 * static_cast<double>(high - low),
              0.1);
}

TEST(ManoeuvresInARun, HeadingStepsGoTheShortWayOverNorth) {
  const ManoeuvreAccount account = flown_manoeuvre(
      doing("lauv", "{do: steps, duration_s: 70, table: [{at_s: 20, heading_deg: 20}]}",
            "depth_m: 20, heading_deg: 340"),
      80);
  ASSERT_EQ(account.steps.size(), 1U);
  EXPECT_NEAR(account.steps[0].to - account.steps[0].from, 40 * degree, 1e-9);
  EXPECT_LT(account.steps[0].response.value().overshoot, 0.5);
}

TEST(ManoeuvresInARun, BeginAnewAfterSomebodyAtTheHelm) {
  Flown flown = begun_flight(
      doing("otter",
            "{do: turning_circle, helm_share: 0.3, speed_m_s: 1.2, approach_s: 30, lasts_s: "
            "60}",
            afloat));
  flown.until(40);
  ASSERT_EQ(flown.state().mission.manoeuvre.leg, 1) << "in its turn";
  steer(*flown.run, {0.5, 0, 0, 0}, 5);
  flown.run->enqueue({0, 0, twin::Resume{}});
  flown.until(50);
  EXPECT_EQ(flown.state().mission.manoeuvre.leg, 0) << "in its approach";
  flown.until(180);
  const ManoeuvreAccount account = flown.account().manoeuvres.at(0);
  EXPECT_NEAR(account.executed_s().value(), 45 + 30, 0.2);
  EXPECT_EQ(helms_of(account).size(), 1U) << "the one before is no part of it";
  EXPECT_TRUE(account.approach.value().is_steady());
}

// By hand she goes on straight: that is none of her turn.
TEST(ManoeuvresInARun, HaveTheFiguresUntilSomebodyTookThemOver) {
  Flown flown = begun_flight(
      doing("otter",
            "{do: turning_circle, helm_share: 0.3, speed_m_s: 1.2, approach_s: 30, lasts_s: 300}",
            afloat));
  flown.until(40);
  const double turned_rad = flown.state().mission.manoeuvre.turned_rad;
  steer(*flown.run, {0.5, 0, 0, 0}, 5);
  flown.until(75);
  const ManoeuvreAccount account = flown.account().manoeuvres.at(0);
  EXPECT_TRUE(account.was_interrupted);
  EXPECT_NEAR(account.ended_s, 40, 0.1);
  // A row is two steps apart.
  EXPECT_NEAR(account.turned_rad, turned_rad, 2 * 0.05 * 0.5);
  EXPECT_FALSE(account.circle.value().steady);
  const auto full = std::find_if(account.absent.begin(), account.absent.end(),
                                 [](const auto& figure) { return figure.name == "full_s"; });
  ASSERT_NE(full, account.absent.end());
  EXPECT_EQ(full->why.rfind("was interrupted at ", 0), 0U) << full->why;
}

TEST(ManoeuvresInARun, BeginAnewAtTheDepthWhereTheyAreLeft) {
  Flown flown = begun_flight(
      doing("bluerov2_heavy",
            "{do: turning_circle, helm_share: 0.05, speed_m_s: 0.4, approach_s: 60, lasts_s: 60}"));
  flown.until(20);
  const double before_m = flown.state().vehicle.body.position_m.z;
  steer(*flown.run, {0, 0, 0.3, 0}, 10);
  flown.run->enqueue({0, 0, twin::Resume{}});
  flown.until(31);
  const double kept_m = flown.state().mission.kept_m.z;
  EXPECT_GT(kept_m, before_m + 1) << "it was led down";
  flown.until(70);
  // Its way down ends within that of the depth that it keeps.
  EXPECT_NEAR(flown.state().vehicle.body.position_m.z, kept_m, 0.3);
}

/// Every figure that is null is named with its reason.
TEST(ManoeuvresInARun, SayWhyEachFigureOfACircleIsAbsent) {
  const ManoeuvreAccount cut = flown_manoeuvre(
      doing("otter",
            "{do: turning_circle, helm_share: 0.3, speed_m_s: 1.2, approach_s: 30, lasts_s: 120}",
            afloat),
      33);
  std::vector<std::string> names;
  for (const auto& figure : cut.absent) names.push_back(figure.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"advance_m", "transfer_m", "tactical_diameter_m", "quarter_s",
                                      "half_s", "three_quarters_s", "full_s", "steady"}));
}

TEST(ManoeuvresInARun, ThatDoNotEndSaySo) {
  const std::string circle =
      "{do: turning_circle, helm_share: 0.3, speed_m_s: 1.2, approach_s: 30, lasts_s: 120}";
  const ManoeuvreAccount cut = flown_manoeuvre(doing("otter", circle, afloat), 33);
  EXPECT_FALSE(cut.is_over());
  ASSERT_FALSE(cut.absent.empty());
  EXPECT_EQ(cut.absent[0].name, "advance_m");
  EXPECT_EQ(cut.absent[0].why.rfind("the run ended at ", 0), 0U) << cut.absent[0].why;
  const ManoeuvreAccount approach = flown_manoeuvre(doing("otter", circle, afloat), 20);
  ASSERT_EQ(approach.absent.size(), 1U);
  EXPECT_EQ(approach.absent[0].why, "the run ended in its approach");
  const ManoeuvreAccount none =
      flown_manoeuvre(doing("otter", "{do: hold, duration: 5min}, " + circle, afloat), 20);
  EXPECT_EQ(none.absent.at(0).why, "it did not come to it");
  EXPECT_FALSE(none.has_begun());
}

TEST(ManoeuvresInARun, HaveNoFiguresOfRowsThatAreTooFarApart) {
  Flown flown = begun_flight(doing("remus100", "{do: turning_circle, helm_deg: 12, lasts_s: 60}"));
  twin::RunLog sparse;
  for (int i = 0; i < 120 * 20; ++i) {
    flown.run->step();
    if (i % 100 == 99) sparse.append(flown.run->time_s(), flown.run->agents(), flown.run->states());
  }
  const ManoeuvreAccount account = account_of_rows(*flown.run, sparse).manoeuvres.at(0);
  EXPECT_FALSE(account.circle);
  ASSERT_EQ(account.absent.size(), 1U);
  EXPECT_NE(account.absent[0].why.find("expected at most 20; log "), std::string::npos)
      << account.absent[0].why;
}

/// In blocks, on threads, and taken up in the middle of a zig-zag.
TEST(ManoeuvresInARun, AreTheSameToTheBit) {
  std::string yaml = calm_head(0.05);
  for (const auto& [name, model, task] :
       {std::tuple{"a", "remus100",
                   "{do: zig_zag, helm_deg: 10, heading_change_deg: 10, "
                   "approach_s: 15, lasts_s: 30}"},
        {"b", "otter", "{do: spiral, helms_share: [0.2, 0, -0.2], approach_s: 5, each_s: 5}"},
        {"c", "lauv", "{do: steps, duration_s: 30, table: [{at_s: 9, heading_deg: 20}]}"},
        {"d", "remus100", "{do: turning_circle, approach_s: 8, lasts_s: 30}"}})
    yaml += std::string("  - {name: ") + name + ", model: " + model +
            ", start: {north_m: 0, east_m: 0, depth_m: 10}, speed_m_s: 1.4, tasks: [" + task +
            "]}\n";
  const twin::ReadyRun ready = ready_of(yaml);
  constexpr int before = 500, after = 240;
  twin::RunSettings settings = settings_of(0.05);
  settings.is_batch = false;
  twin::Run plain(ready.agents, ready.states, settings);
  twin::RunLog first, expected;
  step_and_log(plain, before, first);
  const twin::Run::Checkpoint checkpoint = plain.checkpoint();
  EXPECT_GT(checkpoint.states[0].mission.manoeuvre.leg, 1);
  step_and_log(plain, after, expected);
  for (const std::size_t threads : {1U, 3U}) {
    settings.is_batch = true;
    settings.threads = threads;
    twin::Run whole(ready.agents, ready.states, settings);
    twin::RunLog skipped, got;
    step_and_log(whole, before, skipped);
    step_and_log(whole, after, got);
    expect_same_bits(got, expected, std::to_string(threads) + " threads");
    twin::Run second(ready.agents, ready.states, settings);
    second.restore(checkpoint);
    twin::RunLog taken_up;
    step_and_log(second, after, taken_up);
    expect_same_bits(taken_up, expected, "taken up");
    for (std::size_t i = 0; i < ready.agents.size(); ++i)
      EXPECT_EQ(second.states()[i].mission.orders, plain.states()[i].mission.orders);
  }
}

TEST(ManoeuvresInARun, StepWithoutAllocating) {
  const auto run = lone_run(
      doing("remus100",
            "{do: zig_zag, helm_deg: 10, heading_change_deg: 10, approach_s: 20, lasts_s: 60}"));
  go_on(*run, 1);
  const std::size_t before = bench::allocations();
  go_on(*run, 50);
  EXPECT_EQ(bench::allocations(), before);
  EXPECT_GT(state_of_lone(*run).mission.manoeuvre.leg, 2);
}

}  // namespace
}  // namespace slackwater::tests::manoeuvres_in_a_run_test
