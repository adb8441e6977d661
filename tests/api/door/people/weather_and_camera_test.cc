// The weather in a supervisor's hand, the camera in that of whoever has the helm, and what all see
// of both; a run that was led is made again to the last bit.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <mutex>

#include "api/door/people/farm_output.h"
#include "api/door/people/playback/logged_run.h"
#include "api/log/command_tables.h"
#include "api/program/paths.h"
#include "fields/wave/sea_sampling.h"
#include "fields/wind/log_profile.h"
#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/hung_line.h"
#include "twin/risk/workability/sun_position.h"

namespace slackwater::tests::weather_and_camera_test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using people::Role;

/// An ROV and a craft that floats, in waves and a light wind, and a coaster that comes by.
const std::string fleet = R"(name: led
seed: 7
duration: 30min
step_s: 0.05
log_every_s: 0.5
water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0.1, north_m_s: 0}],
                  wind: {speed_m_s: 4, from_deg: 200}}}
waves: {components: 16, partitions: [{significant_height_m: 0.5, peak_period_s: 6, from_deg: 200}]}
gusts: dryden
vehicles:
  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10},
     tasks: [{do: hold}]}
  - {name: usv, model: wamv16, start: {north_m: 60, east_m: 0, depth_m: 0}, tasks: [{do: hold}]}
traffic:
  alarm: {cpa_m: 200, tcpa_min: 5}
  vessels:
    - {mmsi: 211000001, name: COASTER, speed_m_s: 8,
       waypoints: [{north_m: 100, east_m: -900}, {north_m: 100, east_m: 20000}]}
)";

struct LedSession : testing::Test {
  twin::CommandArbiter* arbiter = nullptr;  ///< as another door has it
  std::shared_ptr<const twin::Environment> environment;
  SessionUnderWay run{
      fleet, {4, people::TokenBook::drawn(UtcTime::max()), [this](const api::RunInHand& hand) {
                arbiter = &hand.arbiter;
                environment = hand.environment;
              }}};
  StationClient ann{run, run.token(Role::drives)};
  StationClient sue{run, run.token(Role::supervises)};
  StationClient guest{run, run.token(Role::looks_on)};
  json anns = ann.hello("Ann"), sues = sue.hello("Sue"), guests = guest.hello("Gus");

  /// As a station has it, by the formula of api/docs/session_wire.md.
  static double elevation_m(const json& sea, double factor, const Horizontal& at, double t_s) {
    double sum = 0;
    for (const json& wave : sea.at("waves"))
      sum += wave[0].get<double>() *
             std::cos(wave[1].get<double>() * at.real() + wave[2].get<double>() * at.imag() -
                      wave[3].get<double>() * t_s + wave[4].get<double>());
    return factor * sum;
  }
  /// As the vehicles have it.
  static double elevation_m(const SeaRealisation& sea, const Horizontal& at, double t_s) {
    return sample_waves(sea, {at.real(), at.imag(), 0, t_s}).motion.elevation_m;
  }

  static json gale() {
    return {{"do", "weather"},
            {"wind", {{"speed_m_s", 12}, {"from_deg", 270}}},
            {"waves_m", 1.2},
            {"current", {{"speed_m_s", 0.4}, {"to_deg", 90}}},
            {"water_visibility_m", 1.5},
            {"over_s", 4}};
  }
};

TEST_F(LedSession, EverybodyIsShownTheWeatherAndWhatOfItIsLed) {
  const json own = guests["weather"];
  EXPECT_NEAR(own["wind_m_s"].get<double>(), 4, 0.01);
  EXPECT_NEAR(own["wind_from_deg"].get<double>(), 200, 0.5);
  EXPECT_NEAR(own["waves_m"].get<double>(), 0.5, 0.01);
  EXPECT_TRUE(own["led"].empty());
  EXPECT_TRUE(own["visibility_m"].is_null()) << "nobody says";
  EXPECT_TRUE(own["farm"].is_null()) << "no turbines here";
  expect_refused(ann.asks(gale()), "unauthorised", "role of supervisor");
  expect_taken(sue.asks(gale()));
  const json row = guest.told(
      "action", [](const json& is) { return is["what"] == "weather" && is["taken"] == true; });
  EXPECT_EQ(row["before"], "as the run has it");
  EXPECT_EQ(row["after"],
            "wind 12.0 m/s from 270 deg, waves 1.2 m, current 0.40 m/s to 90 deg, visibility under "
            "water 1.5 m");
  const json led = guest.told(
      "weather", [](const json& is) { return is["settles_in_s"] == 0 && !is["led"].empty(); });
  ASSERT_FALSE(led.is_null());
  EXPECT_EQ(led["led"], json({"wind", "waves", "current", "water_visibility"}));
  EXPECT_EQ(led["led_by"], "Sue");
  EXPECT_NEAR(led["wind_m_s"].get<double>(), 12, 0.01);
  EXPECT_NEAR(led["wind_from_deg"].get<double>(), 270, 0.5);
  EXPECT_NEAR(led["waves_m"].get<double>(), 1.2, 0.01);
  EXPECT_NEAR(led["current_m_s"].get<double>(), 0.4, 0.01);
  EXPECT_EQ(led["water_visibility_m"], 1.5);
  // Who comes later sees it at once; and back it goes.
  StationClient late(run, run.token(Role::looks_on));
  EXPECT_EQ(late.hello("Lea")["weather"]["led"].size(), 4U);
  expect_taken(sue.asks({{"do", "weather"}, {"over_s", 1}}));
  EXPECT_FALSE(guest
                   .told("weather",
                         [](const json& is) {
                           return is["led"].empty() && is["led_by"].is_null() &&
                                  std::abs(is["wind_m_s"].get<double>() - 4) < 0.01;
                         })
                   .is_null());
}

// Three buoys: a station has the surface under them as the vehicles of the run do, by the waves
// that its welcome told and the factor of the weather, before and after somebody led them higher.
TEST_F(LedSession, EverybodyHasTheSeaThatTheVehiclesAreIn) {
  const json sea = guests.at("sea");
  EXPECT_EQ(sea.at("depth_m"), 40);
  ASSERT_EQ(sea.at("waves").size(), 16U);
  const auto expect_the_same = [&](const SeaRealisation& own, const json& weather, double from_s,
                                   double within_m) {
    for (const Horizontal& buoy : {Horizontal{0, 0}, {-320.5, 77}, {1500, -2200}})
      for (const double t_s : {from_s, from_s + 12.3, from_s + 1799.9})
        EXPECT_NEAR(elevation_m(sea, weather.at("waves_factor"), buoy, t_s),
                    elevation_m(own, buoy, t_s), within_m);
  };
  EXPECT_EQ(guests.at("weather").at("waves_factor"), 1);
  expect_the_same(*environment->sea, guests.at("weather"), 0, 1e-6);
  expect_taken(sue.asks({{"do", "weather"}, {"waves_m", 1.2}, {"over_s", 1}}));
  const json led = guest.told(
      "weather", [](const json& is) { return is["settles_in_s"] == 0 && !is["led"].empty(); });
  ASSERT_FALSE(led.is_null());
  EXPECT_NEAR(led.at("waves_factor").get<double>(), 2.4, 0.01);
  // Settled, it stays so; the factor is told to a thousandth.
  expect_the_same(*environment->weather->now()->sea, led, 1800, 0.001);
}

TEST_F(LedSession, EverybodyHasTheSunWhereItStands) {
  const twin::SunPosition sun =
      twin::sun_position(environment->origin, parse_utc(guests.at("start").get<std::string>()));
  const json told = guests.at("weather").at("sun");
  // Told to a tenth of a degree, and the run is a few seconds old: 0.004 degrees each.
  EXPECT_NEAR(told["elevation_deg"].get<double>(), sun.elevation_deg, 0.15);
  EXPECT_NEAR(told["azimuth_deg"].get<double>(), sun.azimuth_deg, 0.2);
}

// From the surface to the bed, as the vehicles have it, before and after somebody led it.
TEST_F(LedSession, EverybodyHasTheCurrentAtEachDepth) {
  const auto expect_all = [](const json& weather, double east_m_s) {
    const json currents = weather.at("currents");
    ASSERT_EQ(currents.size(), 17U);
    EXPECT_EQ(currents.front()[0], 0);
    EXPECT_EQ(currents.back()[0], -40);
    for (const json& at : currents) {
      EXPECT_NEAR(at[1].get<double>(), east_m_s, 0.001);
      EXPECT_NEAR(at[2].get<double>(), 0, 0.001);
    }
  };
  expect_all(guests.at("weather"), 0.1);
  expect_taken(sue.asks(
      {{"do", "weather"}, {"current", {{"speed_m_s", 0.4}, {"to_deg", 90}}}, {"over_s", 1}}));
  const json led = guest.told(
      "weather", [](const json& is) { return is["settles_in_s"] == 0 && !is["led"].empty(); });
  ASSERT_FALSE(led.is_null());
  EXPECT_NEAR(led.at("currents").front()[1].get<double>(), 0.4, 0.001);
}

TEST_F(LedSession, WhatNoWeatherIsIsRefusedWithWhatWouldDo) {
  expect_refused(sue.asks({{"do", "weather"}, {"waves_m", 7}}), "out_of_range", "break");
  expect_refused(sue.asks({{"do", "weather"}, {"wind", {{"speed_m_s", 99}, {"from_deg", 0}}}}),
                 "out_of_range", "expected 0 to 60 m/s");
  expect_refused(sue.asks({{"do", "weather"}, {"wind", 12}}), "unreadable", "expected an object");
  expect_refused(sue.asks({{"do", "weather"}, {"wind", {{"speed_m_s", 9}}}}), "unreadable",
                 "weather: wind: found no from_deg");
  expect_refused(sue.asks({{"do", "weather"}, {"over_s", 0}}), "out_of_range", "over: found 0 s");
  // Another door asks for the supervisor's role too.
  twin::WeatherAsked asked;
  asked.visibility_m = 1000;
  const auto refused = arbiter->set_weather("dds 01", asked, arbiter->time_s());
  ASSERT_TRUE(refused);
  EXPECT_TRUE(contains(refused->text, "the supervisors"));
}

// What the lessons of the page ask to be done with the weather is taken.
TEST_F(LedSession, DoesWhatItsLessonsAsk) {
  const auto folder = source_folder() / "api" / "web" / "session" / "lessons" / "en";
  std::size_t lessons = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    json weather = json::parse(std::ifstream(file.path())).at("task").at("weather");
    weather["do"] = "weather";
    weather["over_s"] = 1;
    const json answer = sue.asks(weather);
    EXPECT_EQ(answer["taken"], true) << file.path().filename() << ": " << answer;
    ++lessons;
  }
  EXPECT_EQ(lessons, 5U);
}

TEST_F(LedSession, TheCameraIsTurnedByWhoeverHasTheHelm) {
  const json turn{{"pan_deg", 30}, {"tilt_deg", -45}, {"zoom", 2}};
  expect_refused(ann.asks(ann.command("camera", 0, turn)), "unauthorised", "ask for it first");
  expect_taken(ann.asks({{"do", "ask"}, {"vehicle", 0}}));
  expect_taken(ann.asks(ann.command("camera", 0, turn)));
  const json status = guest.told(
      "status", [](const json& is) { return is["vehicle"] == 0 && is["camera"]["zoom"] == 2; });
  ASSERT_FALSE(status.is_null());
  EXPECT_EQ(status["camera"]["pan_deg"], 30);
  EXPECT_EQ(status["camera"]["tilt_deg"], -45);
  EXPECT_NE(status["doing"], "velocity") << "it drives nobody";
  expect_refused(
      ann.asks(ann.command("camera", 0, {{"pan_deg", 200}, {"tilt_deg", 0}, {"zoom", 1}})),
      "unreadable", "expected a number from -180 to 180");
  expect_refused(
      ann.asks(ann.command("camera", 0, {{"pan_deg", 0}, {"tilt_deg", 0}, {"zoom", 40}})),
      "unreadable", "from 1 to 10");
  // Its own mission looks ahead.
  expect_taken(ann.asks(ann.command("resume", 0)));
  EXPECT_FALSE(
      guest
          .told("status",
                [](const json& is) { return is["vehicle"] == 0 && is["camera"]["pan_deg"] == 0; })
          .is_null());
}

TEST_F(LedSession, TrafficIsShownWithHowNearItWillCome) {
  ASSERT_EQ(guests["traffic"]["vessels"].size(), 1U);
  const json vessel = guests["traffic"]["vessels"][0];
  EXPECT_EQ(vessel["name"], "COASTER");
  EXPECT_EQ(vessel["course_deg"], 90);
  EXPECT_NEAR(vessel["speed_m_s"].get<double>(), 8, 0.01);
  const json status = guest.told(
      "status", [](const json& is) { return is["vehicle"] == 0 && !is["alarms"].empty(); });
  ASSERT_FALSE(status.is_null());
  const json alarm = status["alarms"][0];
  EXPECT_EQ(alarm["name"], "COASTER");
  // The way passes 100 m north of it, in less than two minutes: meanwhile the vehicle, which finds
  // its place in the current yet, would go some 20 m by its velocity of now.
  EXPECT_NEAR(alarm["cpa_m"].get<double>(), 100, 40);
  EXPECT_NEAR(alarm["cpa_s"].get<double>(), 900 / 8.0, 30);
  // Somebody sees to it, and all are told who.
  EXPECT_TRUE(alarm["acknowledged_by"].is_null());
  expect_taken(ann.asks({{"do", "acknowledge"}, {"vehicle", 0}, {"mmsi", 211000001}}));
  EXPECT_FALSE(guest
                   .told("status",
                         [](const json& is) {
                           return is["vehicle"] == 0 && !is["alarms"].empty() &&
                                  is["alarms"][0]["acknowledged_by"] == "Ann";
                         })
                   .is_null());
}

TEST_F(LedSession, ARunThatWasLedIsMadeAgainToTheLastBit) {
  expect_taken(ann.asks({{"do", "ask"}, {"vehicle", 0}}));
  expect_taken(ann.asks(ann.command("camera", 0, {{"pan_deg", 5}, {"tilt_deg", 0}, {"zoom", 1}})));
  expect_taken(sue.asks(gale()));
  ann.listen(700ms);
  // One that joins is made ready in the weather of then.
  expect_taken(sue.asks({{"do", "spawn"},
                         {"model", "x500"},
                         {"name", "uav"},
                         {"east_m", 20},
                         {"north_m", 0},
                         {"up_m", 30},
                         {"heading_deg", 0}}));
  ann.listen(500ms);
  json calmer = gale();
  calmer["wind"] = nullptr;
  calmer["over_s"] = 7;
  expect_taken(sue.asks(calmer));
  ann.listen(700ms);
  const api::ScenarioResult& first = run.ended();
  ASSERT_EQ(first.commands.size(), 4U);
  EXPECT_EQ(std::get<twin::SetWeather>(first.commands[1].what).asked.over_s, 4);
  const TemporaryFolder folder;
  ingest::write_trajectories(first.file, folder / "log.nc");
  const auto read = api::commands_in(ingest::read_trajectories(folder / "log.nc"));
  EXPECT_EQ(std::get<twin::SetWeather>(read[1].what).asked,
            std::get<twin::SetWeather>(first.commands[1].what).asked);
  // Who watches it again sees where the camera looked.
  const people::LoggedRun watched = people::read_logged_run(folder / "log.nc", api::data_folder());
  const people::LoggedVehicle& rov = watched.vehicles[0];
  ASSERT_EQ(rov.cameras.size(), 1U);
  EXPECT_NEAR(rov.cameras[0].pointing.pan_rad, 5 * constants::degree, 1e-12);
  const double then_s = rov.cameras[0].from_s;
  const auto camera_at = [&](double at_s) {
    const people::Moment moment = people::moment_of(watched.t_s, at_s);
    return vehicle_then(rov, status_place(rov, moment, at_s)).camera;
  };
  EXPECT_EQ(camera_at(then_s), rov.cameras[0].pointing);
  EXPECT_EQ(camera_at(0).pan_rad, 0);
  for (const std::size_t threads : {1U, 2U}) {
    api::RunChoice choice;
    choice.threads = threads;
    const api::ReplayResult again =
        api::replay(folder / "log.nc", folder / "store", std::nullopt, choice);
    EXPECT_TRUE(again.is_identical) << threads << ": " << again.difference;
  }
}

// A tether is shown as the run has it: each line that is told is that of a barrier, to the
// centimetre that is told.
TEST(TetherOfASession, IsThatOfTheTwin) {
  std::mutex mutex;
  std::vector<std::array<twin::Triple<double>, twin::tether_nodes>> hung;
  SessionUnderWay::Choice choice;
  choice.real_time_factor = 4;
  choice.also = [&](const api::RunInHand& hand) {
    hand.run.at_barrier([&mutex, &hung, &run = hand.run](const twin::StepTime&) {
      const std::lock_guard lock(mutex);
      hung.push_back(twin::hung_line(run.agents()[0], run.states()[0]));
    });
  };
  SessionUnderWay run(R"(name: on a tether
seed: 7
duration: 30min
step_s: 0.05
log_every_s: 0.5
water: {made_up: {depth_m: 40, wind: {speed_m_s: 4, from_deg: 200},
                  current: [{depth_m: 0, east_m_s: 0.3, north_m_s: 0},
                            {depth_m: 40, east_m_s: 0.1, north_m_s: 0.2}]}}
vehicles:
  - {name: rov, model: bluerov2_heavy, start: {north_m: 5, east_m: 0, depth_m: 10},
     tether: {top: {north_m: 0, east_m: 0, depth_m: 1}, length_m: 30}, tasks: [{do: hold}]}
)",
                      std::move(choice));
  StationClient guest(run, run.token(Role::looks_on));
  const json welcome = guest.hello("Gus");
  EXPECT_EQ(welcome.at("lines").size(), 1U);
  EXPECT_TRUE(welcome.at("water").at("forecast").is_null()) << "it is made up";
  // The current goes from one to the other with the depth, told to a thousandth.
  for (const json& at : welcome.at("weather").at("currents")) {
    const double share = -at[0].get<double>() / 40;
    EXPECT_NEAR(at[1].get<double>(), 0.3 - 0.2 * share, 0.0006);
    EXPECT_NEAR(at[2].get<double>(), 0.2 * share, 0.0006);
  }
  const auto least_off_m = [&](const json& nodes) {
    const std::lock_guard lock(mutex);
    double least_m = INFINITY;
    for (const auto& line : hung) {
      double most_m = 0;
      for (std::size_t i = 0; i < line.size(); ++i)
        most_m =
            std::max(most_m, length_of(line[i] - twin::Triple<double>{nodes[i][1], nodes[i][0],
                                                                      -nodes[i][2].get<double>()}));
      least_m = std::min(least_m, most_m);
    }
    return least_m;
  };
  for (int i = 0; i < 5; ++i) {
    const json line = guest.told("line", [](const json& is) { return is["vehicle"] == 0; });
    ASSERT_FALSE(line.is_null());
    ASSERT_EQ(line["nodes"].size(), twin::tether_nodes);
    EXPECT_EQ(line["nodes"][0], json({0, 0, -1})) << "its top";
    EXPECT_LE(least_off_m(line["nodes"]), 0.0087) << "sqrt(3) half centimetres";
  }
}

// At a site with turbines all see what they make, and that it follows the wind.
TEST(FarmOutput, IsToldLiveAgainstTheWind) {
  const auto kind = std::make_shared<const Turbine>(
      Turbine::load(source_folder() / "data" / "turbines" / "nrel_5mw.yaml"));
  SessionUnderWay::Choice choice;
  choice.real_time_factor = 4;
  choice.with_water = [&](api::ScenarioWater& water) {
    water.surround.turbine = kind;
    water.surround.turbines_m = {{0, 2000}, {2000, 2000}};
  };
  SessionUnderWay run(fleet, std::move(choice));
  StationClient sue(run, run.token(Role::supervises));
  const json turbines = sue.hello("Sue").at("turbines");
  EXPECT_EQ(turbines["places"], json({{0, 2000}, {2000, 2000}}));
  EXPECT_EQ(turbines["hub_height_m"], kind->hub_height_m);
  const auto told_at = [&](double wind_m_s) {
    return sue.told("weather", [&](const json& is) {
      return !is["farm"].is_null() && is["settles_in_s"] == 0 &&
             std::abs(is["wind_m_s"].get<double>() - wind_m_s) < 0.01;
    });
  };
  const json before = told_at(4);
  ASSERT_FALSE(before.is_null());
  EXPECT_EQ(before["farm"]["turbines"], 2);
  EXPECT_EQ(before["farm"]["each"].size(), 2U);
  EXPECT_EQ(before["farm"]["rated_w"], 2 * kind->rated_power_w);
  const auto asked = [](double speed_m_s) {
    return json{{"do", "weather"},
                {"wind", {{"speed_m_s", speed_m_s}, {"from_deg", 180}}},  // they stand abreast
                {"over_s", 1}};
  };
  (void)sue.asks(asked(8));
  const double hub_m_s = 8 * log_profile_ratio(kind->hub_height_m, 10);
  const double expected_w = 2 * kind->power_w(hub_m_s);
  // Worked out beside the run: perhaps told a second after the wind.
  const json after = sue.told("weather", [&](const json& is) {
    return std::abs(is["wind_m_s"].get<double>() - 8) < 0.01 &&
           std::abs(is["farm"]["power_w"].get<double>() - expected_w) < 0.05e6;
  });
  EXPECT_FALSE(after.is_null()) << "expected " << expected_w << " W";
}

// One turbine alone makes what its curve says; of two in a row the second makes less.
TEST(FarmOutput, IsThatOfTheCurvesLessTheWakes) {
  const auto kind = std::make_shared<const Turbine>(
      Turbine::load(source_folder() / "data" / "turbines" / "nrel_5mw.yaml"));
  people::FarmOutput alone({kind, {{0, 0}}});
  EXPECT_NEAR(alone.at({9, 0}).power_w, kind->power_w(9), 1e-6 * kind->rated_power_w);
  EXPECT_EQ(alone.at({9, 0}).rated_w, kind->rated_power_w);
  EXPECT_EQ(alone.at({0, 0}).power_w, 0);
  people::FarmOutput row({kind, {{0, 0}, {5 * kind->rotor_diameter_m, 0}}});
  const double along_w = row.at({9, 0}).power_w, across_w = row.at({0, 9}).power_w;
  EXPECT_NEAR(across_w, 2 * kind->power_w(9), 1e-6 * kind->rated_power_w);
  // The one in the wake has the less, turns the slower, and the wind comes back behind it.
  const people::TurbineNow first = row.at({9, 0}).turbines[0], second = row.at({9, 0}).turbines[1];
  EXPECT_NEAR(first.wind_m_s, 9, 1e-9);
  EXPECT_NEAR(kind->power_w(second.wind_m_s), second.power_w, 1e-6 * kind->rated_power_w);
  EXPECT_NEAR(first.rotor_speed_rad_s, 8 * 9 / 63.0, 1e-9)
      << "a tip eight times as fast as the wind";
  EXPECT_LT(second.rotor_speed_rad_s, first.rotor_speed_rad_s);
  EXPECT_NEAR(first.power_w + second.power_w, along_w, 1e-6 * along_w);
  for (const people::TurbineNow& turbine : {first, second}) {
    EXPECT_LT(turbine.wind_left[0], turbine.wind_left[1]);
    EXPECT_LT(turbine.wind_left[1], turbine.wind_left[2]);
    EXPECT_LT(turbine.wind_left[2], 1);
  }
  EXPECT_EQ(alone.at({0, 0}).turbines[0].wind_left[0], 1);
  EXPECT_LT(along_w, 0.85 * across_w);
  EXPECT_GT(along_w, 0.5 * across_w);
}

}  // namespace
}  // namespace slackwater::tests::weather_and_camera_test
