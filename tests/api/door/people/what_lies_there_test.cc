// What a session tells of what lies in the water: bed, cables, moorings; of thrusters and turbines.
#include <gtest/gtest.h>

#include <cmath>

#include "api/door/people/told.h"
#include "api/program/paths.h"
#include "fields/base/constants.h"
#include "fields/geo/local_frame.h"
#include "fields/service/field.h"
#include "fields/site/site.h"
#include "tests/api/door/people/station_for_tests.h"
#include "twin/mission/site_work.h"

namespace slackwater::tests::what_lies_there_test {
namespace {

using nlohmann::json;
using people::Role;

const std::string rov_that_holds = R"(name: alone
seed: 7
duration: 30min
step_s: 0.05
log_every_s: 0.5
water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0.4, north_m_s: 0}]}}
waves: {from: calm}
vehicles:
  - {name: rov, model: bluerov2_heavy, start: {north_m: 5, east_m: 0, depth_m: 10, heading_deg: 0},
     tasks: [{do: hold}]}
)";

Site example_farm() { return find_site("example_farm", {source_folder() / "data/sites"}); }

/// The water deepens to the east, by 4 m in 100, and half as much to the north.
void slope_the_bed(api::ScenarioWater& water) {
  Snapshot sloped = water.surround.field->snapshot();
  const GeoPoint origin = water.surround.site;
  for (ForecastColumn& column : sloped.columns)
    column.water_depth_m = 1000 +
                           (column.point.longitude_deg() > origin.longitude_deg() ? 700 : -700) +
                           (column.point.latitude_deg() > origin.latitude_deg() ? 250 : -250);
  water.surround.field = std::make_shared<Field>(std::make_shared<Snapshot>(std::move(sloped)));
}

TEST(GroundOfASession, HasTheBedOfTheVehiclesRowByRowFromTheSouthWest) {
  struct Known {
    double east_m, north_m, up_m;
  };
  std::vector<Known> known;
  SessionUnderWay::Choice choice;
  choice.with_water = slope_the_bed;
  choice.also = [&](const api::RunInHand& hand) {
    for (const double east_m : {-200.0, 0.0, 100.0})
      for (const double north_m : {-200.0, 50.0}) {
        const BedSample bed = hand.run.agents().front().water->bed({north_m, east_m, 0});
        ASSERT_EQ(bed.status, SampleStatus::ok);
        known.push_back({east_m, north_m, -bed.water_depth_m});
      }
  };
  SessionUnderWay run(rov_that_holds, std::move(choice));
  StationClient guest(run, run.token(Role::looks_on));
  const json bed = guest.hello("Gus").at("bed");
  const auto across = bed.at("across").get<std::size_t>();
  const double step_m = bed.at("step_m"), west_m = bed.at("east_m"), south_m = bed.at("north_m");
  ASSERT_EQ(bed.at("up_m").size(), across * across);
  EXPECT_NEAR(step_m * static_cast<double>(across - 1), -2 * west_m, 1e-9) << "about the origin";
  EXPECT_LE(west_m, -200);
  ASSERT_EQ(known.size(), 6U);
  for (const Known& at : known) {
    // Of a plane between four columns all four corners about a place say the same as the plane.
    const double right = (at.east_m - west_m) / step_m, up = (at.north_m - south_m) / step_m;
    const auto column = std::min(static_cast<std::size_t>(right), across - 2);
    const auto row = std::min(static_cast<std::size_t>(up), across - 2);
    const auto told = [&](std::size_t r, std::size_t c) {
      return bed["up_m"][r * across + c].get<double>();
    };
    const double a = right - static_cast<double>(column), b = up - static_cast<double>(row);
    const double between = (1 - b) * ((1 - a) * told(row, column) + a * told(row, column + 1)) +
                           b * ((1 - a) * told(row + 1, column) + a * told(row + 1, column + 1));
    EXPECT_NEAR(between, at.up_m, 0.011) << at.east_m << " E, " << at.north_m << " N";
  }
  const json& up_m = bed["up_m"];
  EXPECT_LT(up_m[across - 1].get<double>(), up_m[0].get<double>()) << "deeper to the east";
  EXPECT_LT(up_m[across * (across - 1)].get<double>(), up_m[0].get<double>()) << "and to the north";
}

// Ends and lengths by the site's own words, whatever the origin is.
TEST(GroundOfASession, HasCablesAndMooringsAboutItsOrigin) {
  const Site site = example_farm();
  SessionUnderWay::Choice choice;
  choice.with_water = [&](api::ScenarioWater& water) {
    water.lines = twin::site_lines_of(site, LocalFrame(site.turbines[1].point));  // A02
  };
  SessionUnderWay run(rov_that_holds, std::move(choice));
  StationClient guest(run, run.token(Role::looks_on));
  const json welcome = guest.hello("Gus");
  ASSERT_EQ(welcome.at("cables").size(), 1U);
  const json cable = welcome["cables"][0];
  EXPECT_EQ(cable["id"], "A01-A02");
  EXPECT_EQ(cable["burial_m"], 1);
  ASSERT_EQ(cable["route"].size(), 3U);
  EXPECT_EQ(cable["route"][2], json({0, 0, -40})) << "it ends at the origin, on the run's own bed";
  // A01 lies 0.0095 degrees west and 0.0009 south: 697 m and 100 m on the ellipsoid at 48.85 N
  // (111 207 m and 73 363 m a degree, WGS 84 series).
  EXPECT_NEAR(cable["route"][0][0].get<double>(), -0.0095 * 73'363, 0.5);
  EXPECT_NEAR(cable["route"][0][1].get<double>(), -0.0009 * 111'207, 0.5);
  ASSERT_EQ(welcome.at("moorings").size(), 3U);
  const json& line = welcome["moorings"][1];
  EXPECT_EQ(line["id"], "F01 M2");
  EXPECT_EQ(line["fairlead"][2], -14);
  EXPECT_EQ(line["anchor"][2], -35) << "the site's depth of water";
  const double east_m = line["anchor"][0].get<double>() - line["fairlead"][0].get<double>();
  const double north_m = line["anchor"][1].get<double>() - line["fairlead"][1].get<double>();
  EXPECT_NEAR(std::hypot(east_m, north_m), 250 - 6, 0.02) << "from the floater's side";
  EXPECT_NEAR(std::atan2(east_m, north_m) / constants::degree, 120, 0.01);
}

// A cable of a site that says no depth lies on the run's own bed; nowhere, where that is not known.
TEST(GroundOfASession, ACableLiesWhereTheBedIsKnown) {
  Site site = example_farm();
  site.water_depth_m = std::nullopt;
  const twin::SiteLines lines = twin::site_lines_of(site, LocalFrame(site.point));
  ASSERT_EQ(lines.cables.size(), 1U);
  EXPECT_TRUE(std::isnan(lines.cables[0].route_m[0].z));
  EXPECT_TRUE(lines.moorings.empty()) << "its floater has no depth of its own";
  SessionUnderWay::Choice choice;
  choice.with_water = [&](api::ScenarioWater& water) { water.lines = lines; };
  SessionUnderWay run(rov_that_holds, std::move(choice));
  StationClient guest(run, run.token(Role::looks_on));
  EXPECT_EQ(guest.hello("Gus").at("cables")[0].at("route")[0][2], -40);
}

TEST(GroundOfASession, AMadeUpRunHasNoneOfASite) {
  SessionUnderWay run(rov_that_holds);
  StationClient guest(run, run.token(Role::looks_on));
  const json welcome = guest.hello("Gus");
  EXPECT_TRUE(welcome.at("cables").empty());
  EXPECT_TRUE(welcome.at("moorings").empty());
  EXPECT_TRUE(welcome.at("surfaces").empty());
  for (const json& up_m : welcome.at("bed").at("up_m")) EXPECT_EQ(up_m, -40);
}

// In a current to the east a vehicle that holds its place pushes to the west: the sum of what its
// thrusters tell, along their axes, does so too.
TEST(ThrustsOfASession, PushAgainstTheCurrent) {
  SessionUnderWay::Choice choice;
  choice.real_time_factor = 20;
  SessionUnderWay run(rov_that_holds, std::move(choice));
  StationClient guest(run, run.token(Role::looks_on));
  const json mounts = guest.hello("Gus").at("vehicles")[0].at("mounts");
  ASSERT_EQ(mounts.size(), 8U);
  for (const json& mount : mounts) {
    const double x = mount["axis"][0], y = mount["axis"][1], z = mount["axis"][2];
    EXPECT_NEAR(std::hypot(x, y, z), 1, 0.0009) << "each is told to half a thousandth";
  }
  // Once it holds, bow to the north as it began: west is to port.
  guest.listen(std::chrono::seconds(2));
  const json thrust = guest.told("thrust", [&](const json& is) {
    double to_starboard = 0;
    for (std::size_t i = 0; i < mounts.size(); ++i)
      to_starboard += is["share"][i].get<double>() * mounts[i]["axis"][1].get<double>();
    return to_starboard < -0.1;  // what each is rounded to, 0.02, adds up to 0.08 at most
  });
  EXPECT_FALSE(thrust.is_null());
}

// By hand from the table of data/turbines/nrel_5mw.yaml: 0.5 rho A Cp U^3 with A = pi 63^2 m2, to
// the kilowatt that is told; rated from 11.4 m/s on, and nothing outside of cut-in and cut-out.
TEST(CurveOfTurbines, IsThatOfTheTable) {
  const Turbine kind = Turbine::load(source_folder() / "data" / "turbines" / "nrel_5mw.yaml");
  const json curve = people::curve_json(kind);
  for (const json& at : curve) {
    const double wind_m_s = at[0], power_w = at[1];
    if (wind_m_s < 3 || wind_m_s > 25)
      EXPECT_EQ(power_w, 0) << wind_m_s;
    else if (wind_m_s >= 12)
      EXPECT_EQ(power_w, 5e6) << wind_m_s;
  }
  const auto at = [&](double wind_m_s) {
    for (const json& row : curve)
      if (row[0] == wind_m_s) return row[1].get<double>();
    return std::nan("");
  };
  const double half_rho_area = 0.5 * 1.225 * 3.141592653589793 * 63 * 63;
  EXPECT_NEAR(at(3), half_rho_area * 0.178085 * 27, 500);
  EXPECT_NEAR(at(6), half_rho_area * 0.428823 * 216, 500);
  EXPECT_NEAR(at(10), half_rho_area * 0.435903 * 1000, 500);
  EXPECT_GT(curve.back()[0].get<double>(), 25) << "beyond cut-out";
}

}  // namespace
}  // namespace slackwater::tests::what_lies_there_test
