#include "twin/mission/cable_of_site.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/numbers/random.h"
#include "fields/site/site.h"
#include "tests/support/error_of.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "twin/mission/site_work.h"
#include "twin/mission/work_pattern.h"

namespace slackwater::tests::cable_of_site_test {
namespace {

using twin::CableRole;
using twin::Triple;
using twin::WorkCable;
using twin::WorkSite;

Config entry(const std::string& yaml) { return Config::parse(yaml, "task.yaml"); }

std::string chosen(const std::string& yaml, const WorkSite& site, std::size_t turbine = 0) {
  return twin::cable_of_site(entry(yaml), site, site.turbines[turbine]).id;
}

/// Points a metre apart along a route: the nearest of them is near enough to the nearest of all.
double nearest_of_many(const WorkCable& cable, const twin::WorkTurbine& turbine) {
  double least_m = 1e99;
  for (std::size_t i = 1; i < cable.route_m.size(); ++i) {
    const Triple<double>&a = cable.route_m[i - 1], &b = cable.route_m[i];
    const int count = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y));
    for (int k = 0; k <= count; ++k) {
      const double share = static_cast<double>(k) / count;
      least_m = std::min(least_m, std::hypot(a.x + share * (b.x - a.x) - turbine.north_m,
                                             a.y + share * (b.y - a.y) - turbine.east_m));
    }
  }
  return least_m;
}

TEST(CableOfSite, ARoleTakesTheNearestOfThatRole) {
  Rng random(20261127, "tests/cable_of_site");
  for (int trial = 0; trial < 200; ++trial) {
    WorkSite site = small_farm();
    site.cables.clear();
    for (int i = 0; i < 6; ++i) {
      WorkCable cable;
      cable.id = "K" + std::to_string(i);
      for (int k = 0; k < 4; ++k)
        cable.route_m.push_back({random.uniform(-900, 900), random.uniform(-900, 900), 35});
      cable.role = i % 2 == 0 ? CableRole::array : CableRole::to_shore;
      site.cables.push_back(cable);
    }
    for (const CableRole role : {CableRole::array, CableRole::to_shore}) {
      const std::string name = twin::name_of(role);
      const WorkCable& found =
          twin::cable_of_site(entry("cable_role: " + name), site, site.turbines[1]);
      EXPECT_EQ(found.role, role);
      for (const WorkCable& other : site.cables) {
        if (other.role != role) continue;
        EXPECT_LE(nearest_of_many(found, site.turbines[1]),
                  nearest_of_many(other, site.turbines[1]) + 0.6)
            << trial << " " << name;
      }
    }
  }
}

TEST(CableOfSite, OfThoseAsNearTheFirstIsTaken) {
  WorkSite site = small_farm();
  WorkCable other = site.cables[0];
  other.id = "A01-B09";
  site.cables.push_back(other);
  EXPECT_EQ(chosen("cable_role: array", site), "A01-A02");
  std::swap(site.cables[0], site.cables[1]);
  EXPECT_EQ(chosen("cable_role: array", site), "A01-B09");
  EXPECT_EQ(chosen("cable: A01-A02", site), "A01-A02");
}

TEST(CableOfSite, RefusesWhatTheSiteDoesNotHaveAndSaysWhatItHas) {
  const WorkSite site = small_farm();
  const auto message = [&](const std::string& yaml) {
    return error_of([&] { return chosen(yaml, site); });
  };
  EXPECT_NE(message("cable_role: export").find("found export, the site has A01-A02 (array)"),
            std::string::npos);
  EXPECT_NE(message("cable_role: inter").find("expected array or export"), std::string::npos);
  EXPECT_NE(message("{cable: A01-A02, cable_role: array}").find("beside `cable`"),
            std::string::npos);
  EXPECT_NE(message("cable: B").find("the site has A01-A02 (array)"), std::string::npos);
}

TEST(CableOfSite, TheRoleIsByWhatACableJoins) {
  const Site site = parse_site(
      "id: here\nlatitude_deg: 54\nlongitude_deg: 6.5\nwater_depth_m: 30\nlanding_deg: "
      "180\nfoundation: {kind: "
      "monopile, diameter_m: 6, top_height_m: 20}\nturbines:\n  - {id: T1, latitude_deg: 54, "
      "longitude_deg: 6.5}\n  - {id: T2, latitude_deg: 54.01, longitude_deg: 6.5}\ncables:\n  - "
      "{id: K1, from: T1, to: T2}\n  - {id: K2, from: T2, via: [{latitude_deg: 54.1, "
      "longitude_deg: 6.6}]}\n",
      "here.yaml");
  const WorkSite work = twin::work_site_of(site);
  EXPECT_EQ(work.cables[0].role, CableRole::array);
  EXPECT_EQ(work.cables[1].role, CableRole::to_shore);
  EXPECT_EQ(chosen("cable_role: export", work), "K2");
}

TEST(CableOfSite, TheShippedTaskIsOfAnySiteWithAnArrayCable) {
  twin::MissionParts parts = small_farm_parts();
  const auto way = [&] {
    const Config mission = Config::parse(
        "name: test\nseed: 7\nduration: 3h\nstep_s: 0.05\nlog_every_s: 1\nwater: {made_up: "
        "{depth_m: 35}}\ntasks: [cable_burial]\nturbines: [A01]\n",
        "mission.yaml");
    std::vector<Triple<double>> places;
    for (const auto& vehicle : twin::expand_mission(mission, parts).scenario.vehicles)
      for (const auto& task : vehicle.tasks)
        for (const auto& waypoint : task.waypoints) places.push_back(waypoint.position_m);
    return places;
  };
  const auto named_so = way();
  parts.site.cables[0].id = "string 4, section 2";
  const auto named_otherwise = way();
  ASSERT_EQ(named_so.size(), named_otherwise.size());
  ASSERT_GT(named_so.size(), 4U);
  for (std::size_t i = 0; i < named_so.size(); ++i)
    EXPECT_EQ(length_of(named_so[i] - named_otherwise[i]), 0) << i;
}

}  // namespace
}  // namespace slackwater::tests::cable_of_site_test
