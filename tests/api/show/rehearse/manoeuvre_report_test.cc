#include "api/show/rehearse/manoeuvre_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fields/base/constants.h"

namespace slackwater::tests::manoeuvre_report_test {
namespace {

using namespace api;
using constants::degree;
using nlohmann::json;
using twin::ManoeuvreAccount;
using twin::ManoeuvreKind;
using twin::Ordered;
using twin::TaskOrder;

TaskOrder order(double t_s, Ordered what, double value) {
  return {t_s, 1, static_cast<double>(what), value};
}

/// To port by ten degrees of rudder, at 100 s.
ManoeuvreAccount turn() {
  ManoeuvreAccount m;
  m.task = 1;
  m.kind = ManoeuvreKind::turning_circle;
  m.by_rudder = true;
  m.legs = 1;
  m.orders = {order(40, Ordered::begin, 0), order(100, Ordered::helm, -10 * degree),
              order(160, Ordered::over, 0)};
  m.ended_s = 160;
  m.turned_rad = -100 * degree;
  m.approach = {1.5, 0.001, 0};
  m.circle.emplace();
  m.circle->advance_m = 21.26;
  m.circle->transfer_m = 12;
  m.absent = {{"tactical_diameter_m", "ended at 100 degrees from its approach"},
              {"full_s", "ended at 100 degrees from its approach"},
              {"steady", "too soon"}};
  return m;
}

TEST(ManoeuvreReport, SaysFiguresAndWhyOthersAreAbsent) {
  EXPECT_EQ(manoeuvre_name(turn()), "turning circle (task 2)");
  EXPECT_EQ(
      manoeuvre_text(turn()),
      "to port by 10 degrees of rudder: advance 21.26 m, transfer 12.00 m; no tactical "
      "diameter, no full turn: ended at 100 degrees from its approach; no steady turn: too soon; "
      "approach of 1.500 m/s");
  ManoeuvreAccount swaying = turn();
  swaying.approach->most_off_m_s = 0.2;
  EXPECT_NE(
      manoeuvre_text(swaying).find("the approach was not steady: 1.500 m/s and up to 0.200 off it"),
      std::string::npos);
}

TEST(ManoeuvreReport, IsJsonInDegreesWithNullForWhatIsAbsent) {
  const json m = manoeuvre_json(turn());
  EXPECT_EQ(m.at("kind"), "turning_circle");
  EXPECT_EQ(m.at("task"), 1);
  EXPECT_EQ(m.at("began_s"), 40);
  EXPECT_EQ(m.at("executed_s"), 100);
  EXPECT_EQ(m.at("ended_s"), 160);
  EXPECT_EQ(m.at("helms"), json::parse(R"([{"at_s": 100, "helm_deg": -10}])"));
  EXPECT_EQ(m.at("figures").at("advance_m"), 21.26);
  EXPECT_TRUE(m.at("figures").at("tactical_diameter_m").is_null());
  EXPECT_TRUE(m.at("figures").at("steady").is_null());
  EXPECT_EQ(m.at("absent").size(), 3U);
  EXPECT_EQ(m.at("absent").at(2), json::parse(R"({"figure": "steady", "why": "too soon"})"));
}

TEST(ManoeuvreReport, OfThrustersHasShares) {
  ManoeuvreAccount m = turn();
  m.by_rudder = false;
  m.kind = ManoeuvreKind::spiral;
  m.circle.reset();
  m.spiral.emplace();
  m.spiral->points = {{0.2, 3 * degree, true}, {-0.2, -3 * degree, false}};
  m.spiral->loop_width_rad = 0.05;
  EXPECT_EQ(manoeuvre_json(m).at("figures").at("points").at(0),
            json::parse(R"({"helm_share": 0.2, "turn_deg_s": 3, "steady": true})"));
  EXPECT_EQ(manoeuvre_json(m).at("figures").at("loop_width_share"), 0.05);
  EXPECT_TRUE(manoeuvre_json(m).at("figures").at("loop_height_deg_s").is_null());
}

TEST(ManoeuvreReport, OfStepsHasTheCompass) {
  ManoeuvreAccount m;
  m.kind = ManoeuvreKind::steps;
  m.orders = {order(0, Ordered::begin, 0)};
  twin::StepAccount& step = m.steps.emplace_back();
  step.what = Ordered::heading;
  step.from = -20 * degree;
  step.to = 30 * degree;
  step.response.emplace();
  step.response->rise_s = 4;
  step.response->steady_error = 0.5 * degree;
  const json told = manoeuvre_json(m).at("figures").at("steps").at(0);
  EXPECT_EQ(told.at("from"), 340);
  EXPECT_EQ(told.at("to"), 30);
  EXPECT_EQ(told.at("rise_s"), 4);
  EXPECT_EQ(told.at("steady_error"), 0.5);
  EXPECT_TRUE(told.at("settling_s").is_null());
  EXPECT_EQ(manoeuvre_text(m),
            "heading from 340.0 to 30.0 degrees at 0 s: rise 4.00 s, overshoot 0.0 %, did not "
            "settle within 5 %, +0.500 degrees off at its end");
  m.orders.clear();
  m.absent = {{"all", "it did not come to it"}};
  m.steps.clear();
  EXPECT_EQ(manoeuvre_text(m), "no figures: it did not come to it");
  EXPECT_TRUE(manoeuvre_json(m).at("figures").is_null());
}

}  // namespace
}  // namespace slackwater::tests::manoeuvre_report_test
