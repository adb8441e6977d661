#include "twin/scenario/lay_out_surface.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "fields/base/constants.h"
#include "tests/support/error_of.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "twin/inspection/surface/make_surface.h"
#include "twin/mission/site_work.h"
#include "twin/mission/work_pattern.h"
#include "twin/scenario/write_conduct.h"

namespace slackwater::tests::lay_out_surface_test {
namespace {

using twin::Surface;
using twin::Triple;

twin::WorkSite example_farm() {
  return twin::work_site_of(find_site("example_farm", {source_folder() / "data/sites"}));
}
const twin::WorkTurbine& turbine_of(const twin::WorkSite& site, const std::string& id) {
  for (const twin::WorkTurbine& turbine : site.turbines)
    if (turbine.id == id) return turbine;
  throw std::runtime_error("no turbine " + id);
}
twin::PlannedSurface planned(const std::string& entry, const std::string& turbine = "A01") {
  const twin::WorkSite site = example_farm();
  return twin::lay_out_surface(Config::parse("{" + entry + "}", "task.yaml"), site,
                               turbine_of(site, turbine));
}
std::string text_of(const std::string& entry, const std::string& turbine = "A01") {
  return in_line(twin::surface_value(planned(entry, turbine)));
}
Surface laid_out(const std::string& entry, const std::string& turbine = "A01",
                 double patch_m = 0.5) {
  return twin::make_surface(planned(entry, turbine), patch_m);
}

TEST(LayOutSurface, APileGoesFromTheSeasSurfaceToTheBedUnlessItSaysOtherwise) {
  EXPECT_EQ(text_of("kind: monopile"),
            "{kind: monopile, name: \"A01/monopile\", north_m: 0, east_m: 0, radius_m: 3, from: "
            "{depth_m: 0}, to: {depth_m: 35}}");
  EXPECT_EQ(text_of("kind: monopile, from: {depth_m: 4}, to: {above_bed_m: 2}, patch_m: 0.3, "
                    "radius_m: 2.5, name: leg"),
            "{kind: monopile, name: leg, north_m: 0, east_m: 0, radius_m: 2.5, from: {depth_m: 4}, "
            "to: {depth_m: 33}, patch_m: 0.3}");
  EXPECT_EQ(laid_out("kind: monopile", "F01").sheet.height_m, 20);
}

TEST(LayOutSurface, EachKindCanBeMadeAtTheExampleFarm) {
  for (const char* entry :
       {"kind: monopile", "kind: transition_piece", "kind: tower",
        "kind: nacelle, rotor_faces_deg: 270", "kind: blade, blade: 3, rotor_faces_deg: 270",
        "kind: anodes", "kind: mooring_line, mooring: M1", "kind: cable, cable: A01-A02",
        "kind: bed", "kind: bed, outer_m: 30, scour: {depth_m: 2}", "kind: water"}) {
    const Surface surface =
        laid_out(entry, std::string(entry).find("mooring") != std::string::npos ? "F01" : "B02", 1);
    EXPECT_GT(surface.area_m2(), 1) << entry;
    EXPECT_NE(surface.name, twin::name_of(surface.kind));
  }
}

TEST(LayOutSurface, SizesAreThoseOfTheTurbine) {
  const Surface tower = laid_out("kind: tower");
  EXPECT_NEAR(tower.sheet.top_z_m, -87.6, 1e-6);
  EXPECT_NEAR(tower.sheet.width_m, 6 * constants::pi, 1e-9);
  const Surface piece = laid_out("kind: transition_piece");
  EXPECT_NEAR(piece.sheet.top_z_m, -20, 1e-9);
  EXPECT_NEAR(laid_out("kind: cable, cable: A01-A02, burial_m: 2").sheet.width_m,
              laid_out("kind: cable, cable: A01-A02").sheet.width_m, 1e-9);
  EXPECT_NE(text_of("kind: cable, cable: A01-A02").find("burial_m: 1,"), std::string::npos);
  // The cable is the same from whatever turbine.
  EXPECT_EQ(text_of("kind: cable, cable: A01-A02", "A01"),
            text_of("kind: cable, cable: A01-A02", "B02"));
}

/// The mean of what is nearest to each of the four ways along a blade faces that way.
TEST(LayOutSurface, ABladeIsWhereItsPatternFlies) {
  const twin::WorkSite site = example_farm();
  for (const int blade : {1, 2, 3}) {
    const std::string which =
        "blade: " + std::to_string(blade) + ", rotor_faces_deg: 300, rotor_azimuth_deg: 20";
    const Surface surface = laid_out("kind: blade, " + which);
    const Config work =
        Config::parse("{pattern: blade, stand_off_m: 10, " + which + "}", "work.yaml");
    const auto legs = twin::lay_out(work, site, turbine_of(site, "A01"));
    for (std::size_t i = 0; i + 1 < legs[0].waypoints.size(); i += 2) {
      const Triple<double> from = legs[0].waypoints[i].position_m;
      const Triple<double> way = legs[0].waypoints[i + 1].position_m - from;
      const double length_m = twin::length_of(way);
      double nearest_m = 1e9, farthest_m = 0;
      for (const twin::Patch& patch : surface.patches) {
        const Triple<double> off = patch.centre_m - from;
        const double along = twin::dot(off, way) / length_m;
        EXPECT_GT(along, -1e-3);
        EXPECT_LT(along, length_m + 1e-3);
        const double off_m = twin::length_of(off - (along / length_m) * way);
        nearest_m = std::min(nearest_m, off_m);
        farthest_m = std::max(farthest_m, off_m);
      }
      EXPECT_GT(nearest_m, 10 - 0.7 * 4.65 - 0.01);
      EXPECT_LT(nearest_m, 10);
      EXPECT_LT(farthest_m, 10 + 0.7 * 4.65 + 0.01);
    }
  }
}

TEST(LayOutSurface, AnodesAreWhereTheProbeStops) {
  const twin::WorkSite site = example_farm();
  const std::string levels = "from: {depth_m: 4}, to: {above_bed_m: 2}";
  const Surface anodes = laid_out("kind: anodes, " + levels);
  const Config work = Config::parse(
      "{pattern: verticals, stand_off_m: 1.5, bearings: 4, stops: 3, stop_s: 30, " + levels + "}",
      "work.yaml");
  std::size_t stops = 0;
  for (const twin::WorkLeg& leg : twin::lay_out(work, site, turbine_of(site, "A01"))) {
    if (leg.stay_s < 1) continue;
    ++stops;
    double nearest_m = 1e9;
    for (const twin::Patch& patch : anodes.patches)
      nearest_m =
          std::min(nearest_m, twin::length_of(patch.centre_m - leg.waypoints.back().position_m));
    // 1.5 m off the pile, 0.3 m of stand-off, half a bar; a patch's centre is near its middle.
    EXPECT_LT(nearest_m, 1.3);
  }
  EXPECT_EQ(stops, 12U);
}

TEST(LayOutSurface, WhatCannotBeIsRefusedWhereItStandsInTheTask) {
  for (const char* entry :
       {"kind: monopile, radius: 3", "kind: monopile, from: {depth_m: 9}, to: {depth_m: 5}",
        "kind: cable, cable: A01-A02, route: []", "kind: mooring_line, mooring: M1, anchor: {}",
        "kind: bed, outer_m: 2", "kind: water, radius_m: 9, corners: []"}) {
    const std::string turbine =
        std::string(entry).find("mooring") != std::string::npos ? "F01" : "A01";
    const std::string message = error_of([&] { return planned(entry, turbine); });
    EXPECT_NE(message.find("task.yaml:1"), std::string::npos) << entry << "\n" << message;
  }
}

TEST(LayOutSurface, RefusesWhatTheSiteDoesNotHave) {
  const auto message = [](const std::string& entry, const std::string& turbine = "A01") {
    return error_of([&] { return planned(entry, turbine); });
  };
  EXPECT_NE(message("kind: monopole").find("did you mean monopile?"), std::string::npos);
  EXPECT_NE(message("kind: mooring_line, mooring: M1").find("A01 does not have"),
            std::string::npos);
  EXPECT_NE(message("kind: cable, cable: A01-B09").find("the site has A01-A02"), std::string::npos);
  twin::WorkSite site = small_farm();
  site.turbines[0].hub_m = 0;
  for (const char* entry : {"{kind: tower}", "{kind: nacelle, rotor_faces_deg: 0}",
                            "{kind: blade, blade: 1, rotor_faces_deg: 0}"})
    EXPECT_NE(error_of([&] {
                return twin::lay_out_surface(Config::parse(entry, "task.yaml"), site,
                                             site.turbines[0]);
              }).find("hub_height_m"),
              std::string::npos)
        << entry;
  site = small_farm();
  site.turbines[0].rotor_radius_m = 0;
  EXPECT_NE(error_of([&] {
              return twin::lay_out_surface(
                  Config::parse("{kind: blade, blade: 1, rotor_faces_deg: 0}", "task.yaml"), site,
                  site.turbines[0]);
            }).find("rotor_diameter_m"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::lay_out_surface_test
