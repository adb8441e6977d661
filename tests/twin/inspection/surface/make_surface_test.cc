#include "twin/inspection/surface/make_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "tests/support/error_of.h"
#include "tests/twin/inspection/surface/surface_for_tests.h"
#include "twin/inspection/surface/rotor_axes.h"
#include "twin/inspection/surface/scour_pit.h"
#include "twin/inspection/surface/wing_section.h"

namespace slackwater::tests::make_surface_test {
namespace {

using twin::Surface;
using twin::Triple;

constexpr double pi = constants::pi;

/// Area on the sheet; the flat pieces are as large as the round surface that they stand for.
double sheet_m2(const Surface& surface) {
  double sum_m2 = 0;
  for (const twin::Patch& patch : surface.patches)
    sum_m2 += static_cast<double>(patch.width_m) * static_cast<double>(patch.height_m);
  return sum_m2;
}

/// log2 of how the error falls when patches are half as long.
double order_of(double coarse_error, double fine_error) {
  return std::log2(std::abs(coarse_error) / std::abs(fine_error));
}

TEST(MonopileSurface, HasTheMantleAndTheVolumeOfACylinderInSecondOrder) {
  const double mantle_m2 = 2 * pi * 3 * 35, volume_m3 = pi * 9 * 35;
  double area_error = 0, volume_error = 0;
  for (const double patch_m : {0.4, 0.2, 0.1}) {
    const Surface pile = surface_of(monopile_entry, patch_m);
    const double n = std::ceil(2 * pi * 3 / patch_m - 1e-6);
    // A prism over a polygon of n corners: chords, exactly.
    EXPECT_NEAR(pile.area_m2(), n * 2 * 3 * std::sin(pi / n) * 35, 1e-5 * mantle_m2);
    const double area = pile.area_m2() - mantle_m2;
    const double volume = twin::volume_m3(pile.mesh) - volume_m3;
    if (area_error != 0) {
      EXPECT_NEAR(order_of(area_error, area), 2, 0.1);
      EXPECT_NEAR(order_of(volume_error, volume), 2, 0.1);
    }
    area_error = area;
    volume_error = volume;
    // Laid flat it is the cylinder's.
    EXPECT_NEAR(sheet_m2(pile), mantle_m2, 1e-6 * mantle_m2);
  }
  EXPECT_LT(std::abs(area_error), 1e-4 * mantle_m2);
}

TEST(MonopileSurface, CoarsePatchesDoNotMakeACoarsePile) {
  const Surface pile = surface_of(monopile_entry, 10);
  EXPECT_LE(pile.patches.size(), 40U);
  EXPECT_NEAR(pile.area_m2(), 2 * pi * 3 * 35, 0.002 * 2 * pi * 3 * 35);
}

TEST(MonopileSurface, ItsSheetIsTheBearingTimesTheRadiusAndTheDepth) {
  const Surface pile = surface_of(monopile_entry, 0.5);
  EXPECT_TRUE(pile.sheet.is_all_round);
  EXPECT_DOUBLE_EQ(pile.sheet.width_m, 6 * pi);
  EXPECT_DOUBLE_EQ(pile.sheet.height_m, 35);
  EXPECT_EQ(pile.sheet.top_z_m, 0);
  EXPECT_EQ(pile.sheet.along, "clockwise from north");
  for (const twin::Patch& patch : pile.patches) {
    double bearing = std::atan2(patch.centre_m.y + 800, patch.centre_m.x - 1200);
    if (bearing < 0) bearing += 2 * pi;
    // On a chord the bearing is not even: by a tenth of the sagitta at most.
    EXPECT_NEAR(patch.along_m, 3 * bearing, 1e-3);
    EXPECT_NEAR(patch.down_m, patch.centre_m.z, 1e-5);
  }
}

TEST(MonopileSurface, ASectorIsPatchedAndTheRestStandsInTheWay) {
  const std::string sector = std::string(monopile_entry) + ", bearings_deg: [350, 440]";
  const Surface pile = surface_of(sector, 0.25);
  EXPECT_TRUE(twin::is_closed(pile.mesh));
  EXPECT_FALSE(pile.sheet.is_all_round);
  EXPECT_NEAR(pile.area_m2(), 0.5 * pi * 3 * 35, 1e-3 * pile.area_m2());
  EXPECT_NEAR(twin::volume_m3(pile.mesh), pi * 9 * 35, 2e-3 * pi * 9 * 35);
  for (const twin::Patch& patch : pile.patches) {
    const double deg = std::atan2(patch.centre_m.y + 800, patch.centre_m.x - 1200) * 180 / pi;
    EXPECT_GT(deg, -10);
    EXPECT_LT(deg, 80);
  }
}

TEST(TowerSurface, IsAFrustum) {
  const Surface tower = surface_of(tower_entry, 0.15);
  const double top = 0.645 * 3, height = 67.6, slant = std::hypot(height, 3 - top);
  EXPECT_NEAR(tower.area_m2(), pi * (3 + top) * slant, 2e-4 * tower.area_m2());
  EXPECT_NEAR(sheet_m2(tower), pi * (3 + top) * slant, 1e-6 * tower.area_m2());
  EXPECT_NEAR(twin::volume_m3(tower.mesh), pi * height / 3 * (9 + 3 * top + top * top),
              5e-4 * twin::volume_m3(tower.mesh));
  // It leans inward: its faces look up a little.
  for (const twin::Patch& patch : tower.patches)
    EXPECT_NEAR(patch.normal.z, -(3 - top) / slant, 1e-4);
}

TEST(TransitionPieceSurface, HasItsPartsWithTheirAreas) {
  const Surface whole = surface_of(transition_entry, 0.25);
  const std::string bare =
      std::string(transition_entry).substr(0, std::string(transition_entry).find(", landing_deg"));
  const Surface without = surface_of(bare, 0.25), no_bolts = surface_of(bare + ", bolts: 0", 0.25);
  EXPECT_EQ(without.patches.size() - no_bolts.patches.size(), 100U);
  EXPECT_NEAR(without.area_m2() - no_bolts.area_m2(), 100 * 0.08 * 0.12, 1e-6);
  // Two fenders, two stiles and rungs: cylinders, of which the mesh has eight corners at least.
  const double long_m = 23 - 2 * (0.1 + 0.12);
  const double rungs = std::ceil(long_m / 0.3 - 1e-6);
  const double bars_m2 = 2 * pi * (2 * 0.2 * long_m + 2 * 0.04 * long_m + rungs * 0.02 * 0.5);
  const double landing_m2 = whole.area_m2() - without.area_m2();
  EXPECT_LT(landing_m2, bars_m2);
  EXPECT_GT(landing_m2, bars_m2 * 8 / pi * std::sin(pi / 8) - 1e-6);
  // Mantle, and the flange's outer side, top and lower side.
  const double flange_m2 = 2 * pi * 3.35 * 0.1 + 2 * pi * (3.35 * 3.35 - 3.2 * 3.2);
  EXPECT_NEAR(no_bolts.area_m2(), 2 * pi * 3.2 * 23 + flange_m2, 1e-3 * no_bolts.area_m2());
  // The landing is where it is asked for: south, and nothing else stands out that far.
  double farthest_m = 0;
  for (const twin::Patch& patch : whole.patches)
    farthest_m = std::max(farthest_m, std::hypot(patch.centre_m.x - 1200, patch.centre_m.y + 800));
  EXPECT_GT(farthest_m, 4.2);
  for (const twin::Patch& patch : whole.patches)
    if (std::hypot(patch.centre_m.x - 1200, patch.centre_m.y + 800) > 3.5) {
      EXPECT_LT(patch.centre_m.x, 1200 - 3.2);
    }
}

TEST(NacelleSurface, IsABoxWithAParabolaForARoof) {
  const std::string box = std::string(nacelle_entry) +
                          ", length_m: 12, width_m: 4, tall_m: 5, ahead_m: 3, roof_rise_m: ";
  const Surface flat = surface_of(box + "0", 0.5);
  EXPECT_NEAR(flat.area_m2(), 2 * (12 * 4 + 4 * 5 + 5 * 12), 1e-4);
  EXPECT_NEAR(twin::volume_m3(flat.mesh), 12 * 4 * 5, 1e-4);
  const Surface round = surface_of(box + "0.6", 0.25);
  EXPECT_NEAR(twin::volume_m3(round.mesh), 12 * 4 * (5 + 0.6 * 2 / 3), 0.2);
  // It looks west: its front is 3 m before the tower's axis, at the hub's height.
  double west_m = 1e9, east_m = -1e9;
  for (const twin::Patch& patch : flat.patches) {
    west_m = std::min(west_m, patch.centre_m.y);
    east_m = std::max(east_m, patch.centre_m.y);
  }
  EXPECT_NEAR(west_m, -803, 1e-4);
  EXPECT_NEAR(east_m, -791, 1e-4);
}

TEST(BladeSurface, HoldsWhatItsSectionsHold) {
  const Surface blade = surface_of(blade_entry, 0.1);
  // Chord c and thickness t change evenly with s, so the volume is L times the integral of
  // k t(s) c(s)^2, which Simpson's rule gives exactly (a cubic).
  const double k = twin::wing_section_area(1), length_m = 59;
  const auto held = [&](double s) {
    const double c = 4.65 + (1.42 - 4.65) * s, t = 0.4 + (0.18 - 0.4) * s;
    return k * t * c * c;
  };
  const double volume_m3 = length_m / 6 * (held(0) + 4 * held(0.5) + held(1));
  EXPECT_NEAR(twin::volume_m3(blade.mesh), volume_m3, 0.004 * volume_m3);
}

TEST(WingSection, HasTheAreaOfItsClosedForm) {
  for (const double thickness : {0.12, 0.18, 0.4})
    for (const double camber : {0.0, 0.04}) {
      const twin::WingSection section(thickness, camber);
      double twice = 0;
      constexpr int n = 20000;
      for (int i = 0; i < n; ++i) {
        const twin::SectionPoint a = section.at(static_cast<double>(i) / n);
        const twin::SectionPoint b = section.at(static_cast<double>(i + 1) / n);
        twice += a.x * b.y - a.y * b.x;
      }
      // Chords of 240 points: a part in a few thousand.
      EXPECT_NEAR(std::abs(twice) / 2, twin::wing_section_area(thickness), 2e-4 * thickness);
      EXPECT_NEAR(section.at(0).x, 1, 1e-12);
      EXPECT_NEAR(section.at(0).y, section.at(1).y, 1e-12);
    }
  // NACA 0012: Abbott & von Doenhoff give 0.12 for the greatest thickness, at 0.3 of the chord.
  const twin::WingSection section(0.12, 0);
  double most = 0, at = 0;
  for (int i = 500; i < 1000; ++i)
    if (section.at(i / 1000.0).y > most) {
      most = section.at(i / 1000.0).y;
      at = section.at(i / 1000.0).x;
    }
  EXPECT_NEAR(most, 0.06, 1e-4);
  EXPECT_NEAR(at, 0.3, 0.01);
}

/// Where `pattern: blade` flies, so that each face looks at whoever flies by it.
TEST(BladeSurface, EachFaceLooksAtTheWayThatIsFlownAlongIt) {
  const Surface blade = surface_of(std::string(blade_entry) + ", twist_deg: 0", 0.25);
  const twin::BladeAxes axes = twin::blade_axes(1.5 * pi, 2 * pi / 3);
  const Triple<double> hub_m = Triple<double>{1200, -800, -90} + 5.0 * axes.upwind;
  double pressure_m2 = 0, suction_m2 = 0, lead_m = 0, trail_m = 0;
  for (const twin::Patch& patch : blade.patches) {
    const Triple<double> off = patch.centre_m - hub_m;
    const double out_m = twin::dot(off, axes.along);
    EXPECT_GT(out_m, 4 - 1e-6);
    EXPECT_LT(out_m, 63 + 1e-6);
    EXPECT_LT(twin::length_of(off - out_m * axes.along), 4);
    const double faces = twin::dot(patch.normal, axes.upwind);
    (faces > 0 ? pressure_m2 : suction_m2) += std::abs(faces) * patch.area_m2;
    lead_m = std::max(lead_m, twin::dot(off, axes.across));
    trail_m = std::min(trail_m, twin::dot(off, axes.across));
    // The edge that leads looks the way the rotor turns.
    if (twin::dot(off, axes.across) > 0.29 * 4.65) {
      EXPECT_GT(twin::dot(patch.normal, axes.across), 0.3);
    }
  }
  const double plan_m2 = 59 * 0.5 * (4.65 + 1.42);
  EXPECT_NEAR(pressure_m2, plan_m2, 0.01 * plan_m2);
  EXPECT_NEAR(suction_m2, plan_m2, 0.01 * plan_m2);
  EXPECT_NEAR(lead_m, 0.3 * 4.65, 0.1);
  EXPECT_NEAR(trail_m, -0.7 * 4.65, 0.2);
  // Pitched by a right angle its leading edge looks upwind.
  const Surface feathered =
      surface_of(std::string(blade_entry) + ", twist_deg: 0, pitch_deg: 90", 1);
  double ahead_m = 0;
  for (const twin::Patch& patch : feathered.patches)
    ahead_m = std::max(ahead_m, twin::dot(patch.centre_m - hub_m, axes.upwind));
  EXPECT_NEAR(ahead_m, 0.3 * 4.65, 0.4);
}

TEST(AnodesSurface, StandOffThePileWhereTheReadingsAre) {
  const Surface anodes =
      surface_of(std::string(anodes_entry) +
                     ", bars: 4, rows: 3, first_bearing_deg: 180, length_m: 1.5, "
                     "width_m: 0.25, off_m: 0.3",
                 0.5);
  // Front and two sides of each.
  EXPECT_NEAR(anodes.area_m2(), 12 * 3 * 0.25 * 1.5, 1e-4);
  EXPECT_NEAR(twin::volume_m3(anodes.mesh), 12 * 0.25 * 0.25 * 1.5, 1e-4);
  EXPECT_EQ(anodes.patches.size(), 12U * 3 * 3);
  for (const twin::Patch& patch : anodes.patches) {
    const double off_m = std::hypot(patch.centre_m.x - 1200, patch.centre_m.y + 800);
    EXPECT_GT(off_m, 3.29);
    EXPECT_LT(off_m, 3.45);
    // As `pattern: verticals` stops: at the quarters of its way.
    const double row = (patch.centre_m.z - 4) / (29.0 / 4);
    EXPECT_LT(std::abs(row - std::round(row)) * 29 / 4, 0.76);
  }
}

TEST(MooringLineSurface, IsATubeFromItsFairleadOn) {
  const Surface line = surface_of(std::string(mooring_entry) + ", share: 0.3", 0.1);
  const double length_m = std::sqrt(244.0 * 244 + 30 * 30 + 76 * 76) * 0.3;
  EXPECT_NEAR(line.area_m2(), 2 * pi * 0.2 * length_m, 0.012 * line.area_m2());
  EXPECT_NEAR(sheet_m2(line), 2 * pi * 0.2 * length_m, 1e-6 * line.area_m2());
  EXPECT_NEAR(line.sheet.width_m, length_m, 1e-9);
  for (const twin::Patch& patch : line.patches) {
    // The first piece is on the upper side.
    if (patch.down_m < 0.1) {
      EXPECT_LT(patch.normal.z, -0.5);
    }
  }
}

TEST(CableSurface, IsTheCorridorOfBedAboveIt) {
  const Surface cable = surface_of(cable_entry, 2);
  const double length_m = std::hypot(60, 350) + std::hypot(40, 350);
  // Mitres give on one side what they take on the other.
  EXPECT_NEAR(cable.area_m2(), 10 * length_m, 1e-4 * cable.area_m2());
  EXPECT_NEAR(cable.sheet.width_m, length_m, 1e-9);
  EXPECT_EQ(cable.sheet.height_m, 10);
  for (const twin::Patch& patch : cable.patches) {
    EXPECT_NEAR(patch.centre_m.z, 35, 1e-5);
    EXPECT_NEAR(patch.normal.z, -1, 1e-6);
    // The sheet is a map with the route to the right: what is to the right of it is further down.
    if (patch.along_m < 100) {
      const double right_m =
          (-350 * patch.centre_m.x + 60 * patch.centre_m.y) / std::hypot(60, 350);
      EXPECT_NEAR(patch.down_m - 5, right_m, 1e-4);
    }
  }
  // What lies below the bed is only met where the bed is not.
  double deepest_m = 0;
  for (std::size_t t = 0; t < cable.patch_of.size(); ++t)
    if (cable.patch_of[t] == twin::no_patch) {
      EXPECT_GE(cable.mesh.centroid_m(t).z, 36 - 1e-4);
      deepest_m = std::max(deepest_m, cable.mesh.centroid_m(t).z);
    }
  EXPECT_NEAR(deepest_m, 36.16, 0.02);
  const Surface shorter = surface_of(std::string(cable_entry) + ", off_ends_m: 80", 2);
  EXPECT_NEAR(shorter.sheet.width_m, length_m - 160, 1e-9);
  EXPECT_NEAR(shorter.area_m2(), 10 * (length_m - 160), 1e-4 * cable.area_m2());
}

TEST(BedSurface, HoldsTheWaterOfItsPitInSecondOrder) {
  const auto pit_m3 = [](const std::string& entry, double patch_m) {
    const Surface bed = surface_of(entry, patch_m);
    double below_m3 = 0;
    for (std::size_t t = 0; t < bed.mesh.triangles.size(); ++t)
      below_m3 -= bed.mesh.area_vector_m2(t).z * (bed.mesh.centroid_m(t).z - 35);
    return below_m3;
  };
  const double exact_m3 = 2 * pi * 2 * (3 * 4 / 2.0 + 16 / 6.0);
  twin::ScourPit pit;
  pit.pile_radius_m = 3;
  pit.depth_m = 2;
  pit.width_m = 4;
  EXPECT_NEAR(pit.volume_m3(), exact_m3, 1e-12);
  const double coarse = pit_m3(bed_entry, 0.6) - exact_m3;
  const double fine = pit_m3(bed_entry, 0.15) - exact_m3;
  EXPECT_NEAR(pit_m3(bed_entry, 0.2), exact_m3, 2e-3 * exact_m3);
  EXPECT_GT(order_of(coarse, fine) / 2, 1.5);
  // One that is deeper on one side holds as much.
  std::string skewed = bed_entry;
  skewed.insert(skewed.rfind('}'), ", skew: 0.4, deepest_deg: 80");
  EXPECT_NEAR(pit_m3(skewed, 0.2), exact_m3, 2e-3 * exact_m3);
  EXPECT_NEAR(pit.z_m(3 + 1, 0), 1.5, 1e-12);
  pit.skew = 0.4;
  EXPECT_NEAR(pit.z_m(-3, 0), 2 * 0.6, 1e-12);
}

TEST(BedSurface, ALevelOneIsARing) {
  const std::string level =
      "kind: bed, north_m: 10, east_m: 0, depth_m: 30, radius_m: 3, outer_m: 20";
  const double exact_m2 = pi * (400 - 9);
  const double coarse = surface_of(level, 0.7).area_m2() - exact_m2;
  const Surface bed = surface_of(level, 0.175);
  EXPECT_GT(order_of(coarse, bed.area_m2() - exact_m2) / 2, 1.5);
  EXPECT_NEAR(bed.area_m2(), exact_m2, 2e-4 * exact_m2);
  for (const twin::Patch& patch : bed.patches) {
    // A map: north at the top, east to the right.
    EXPECT_NEAR(patch.along_m, patch.centre_m.y + 20, 1e-5);
    EXPECT_NEAR(patch.down_m, 30 - patch.centre_m.x, 1e-5);
    const double off_m = std::hypot(patch.centre_m.x - 10, patch.centre_m.y);
    EXPECT_GT(off_m, 2.95);
    EXPECT_LT(off_m, 20);
  }
}

TEST(WaterSurface, IsADiscOrAConvexPiece) {
  const Surface disc = surface_of(water_entry, 2);
  EXPECT_NEAR(disc.area_m2(), pi * (10000 - 9), 5e-4 * disc.area_m2());
  const std::string corners =
      "kind: water, corners: [{north_m: 0, east_m: 0}, {north_m: 30, east_m: 10}, {north_m: 20, "
      "east_m: 50}, {north_m: -10, east_m: 40}]";
  const std::string turned =
      "kind: water, corners: [{north_m: -10, east_m: 40}, {north_m: 20, east_m: 50}, {north_m: 30, "
      "east_m: 10}, {north_m: 0, east_m: 0}]";
  // Shoelaces: (0 + 1300 + 1300 + 0) / 2.
  EXPECT_NEAR(surface_of(corners, 1.7).area_m2(), 1300, 1e-2);
  EXPECT_NEAR(surface_of(turned, 1.7).area_m2(), 1300, 1e-2);
}

TEST(MakeSurface, AWishForTooSmallPatchesIsMetAsFarAsItGoes) {
  const std::string sea = "kind: water, north_m: 0, east_m: 0, radius_m: 5000";
  const Surface surface = surface_of(sea, 2);
  EXPECT_GT(surface.patches.size(), 200000U);
  EXPECT_LE(surface.patches.size(), 400000U);
  EXPECT_NE(error_of([&] {
              return surface_of(sea + ", patch_m: 2", 50);
            }).find("more than 400000 patches"),
            std::string::npos);
  EXPECT_EQ(surface_of("name: \"A: 1\", patch_m: 100, " + sea, 2).name, "A: 1");
}

struct Refused {
  const char* what;
  std::string entry;
  const char* message;
};

class RefusedSurface : public testing::TestWithParam<Refused> {};

TEST_P(RefusedSurface, SaysWhatToMend) {
  const std::string message = error_of([&] { return surface_of(GetParam().entry, 0.5); });
  EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
  EXPECT_NE(message.find("surfaces.yaml:1"), std::string::npos) << message;
}

const std::string pile = "kind: monopile, north_m: 0, east_m: 0";
const std::string cable = "kind: cable, route: ";

INSTANTIATE_TEST_SUITE_P(
    Entries, RefusedSurface,
    testing::Values(
        Refused{"kind", "kind: monopole", "did you mean monopile?"},
        Refused{"no_size", pile + ", from: {height_m: 0}, to: {depth_m: 5}", "radius_m"},
        Refused{"size", pile + ", radius_m: -1, from: {height_m: 0}, to: {depth_m: 5}", "radius_m"},
        Refused{"upside_down", pile + ", radius_m: 3, from: {depth_m: 9}, to: {depth_m: 5}",
                "give the upper edge first"},
        Refused{"no_height", pile + ", radius_m: 3, from: {depth_m: 5}, to: {depth_m: 5}",
                "is not below from"},
        Refused{"two_levels",
                pile + ", radius_m: 3, from: {depth_m: 1, height_m: 1}, to: {depth_m: 5}",
                "give one of depth_m and height_m"},
        Refused{"bearings",
                pile + ", radius_m: 3, from: {height_m: 0}, to: {depth_m: 5}, bearings_deg: [350, "
                       "10]",
                "across north write [350, 370]"},
        Refused{"fine",
                pile + ", radius_m: 3, from: {height_m: 0}, to: {depth_m: 35}, patch_m: 0.01",
                "take larger ones"},
        Refused{"flange",
                "kind: transition_piece, north_m: 0, east_m: 0, radius_m: 3, from: {height_m: 1}, "
                "to: {height_m: 0.8}",
                "the flange with its bolts"},
        Refused{"bolts", std::string(transition_entry) + ", bolts: 900", "take fewer"},
        Refused{"root", std::string(blade_entry) + ", root_m: 70", "not before the tip"},
        Refused{"blade",
                "kind: blade, north_m: 0, east_m: 0, height_m: 90, rotor_faces_deg: 0, "
                "tip_m: 63, blade: 4",
                "blade"},
        Refused{"inside", std::string(anodes_entry) + ", off_m: 0.05", "half their width"},
        Refused{"crowded", std::string(anodes_entry) + ", rows: 100", "take fewer"},
        Refused{"one_point", cable + "[{north_m: 0, east_m: 0, depth_m: 9}]", "at least two"},
        Refused{"short_route",
                cable + "[{north_m: 0, east_m: 0, depth_m: 9}, {north_m: 0.3, east_m: 0, depth_m: "
                        "9}]",
                "less than a patch"},
        Refused{"ends",
                cable + "[{north_m: 0, east_m: 0, depth_m: 9}, {north_m: 99, east_m: 0, depth_m: "
                        "9}], off_ends_m: 50",
                "less than a patch"},
        Refused{"hairpin",
                cable + "[{north_m: 0, east_m: 0, depth_m: 9}, {north_m: 99, east_m: 0, depth_m: "
                        "9}, {north_m: 0, east_m: 1, depth_m: 9}]",
                "more than 120 degrees"},
        Refused{"wide_bend",
                cable + "[{north_m: 0, east_m: 0, depth_m: 9}, {north_m: 9, east_m: 0, depth_m: "
                        "9}, {north_m: 9, east_m: 9, depth_m: 9}], corridor_m: 60",
                "take a narrower one"},
        Refused{"short_line",
                "kind: mooring_line, fairlead: {north_m: 0, east_m: 0, depth_m: 9}, anchor: "
                "{north_m: 0.1, east_m: 0, depth_m: 9}",
                "less than a patch"},
        Refused{"deep_pit",
                "kind: bed, north_m: 0, east_m: 0, depth_m: 30, radius_m: 3, outer_m: 60, scour: "
                "{depth_m: 17}",
                "2.7 diameters"},
        Refused{"wide_pit",
                "kind: bed, north_m: 0, east_m: 0, depth_m: 30, radius_m: 3, outer_m: 6, scour: "
                "{depth_m: 3}",
                "the scour pit reaches"},
        Refused{"no_bed", "kind: bed, north_m: 0, east_m: 0, depth_m: 30, radius_m: 3, outer_m: 2",
                "a radius beyond it"},
        Refused{"dry_bed", "kind: bed, north_m: 0, east_m: 0, height_m: 3, radius_m: 3",
                "above the sea"},
        Refused{"no_water", "kind: water, north_m: 0, east_m: 0, radius_m: 10, inner_m: 10",
                "less than radius_m"},
        Refused{"concave",
                "kind: water, corners: [{north_m: 0, east_m: 0}, {north_m: 9, east_m: 9}, "
                "{north_m: 0, east_m: 3}, {north_m: -9, east_m: 9}]",
                "not convex"},
        Refused{"two_waters", "kind: water, radius_m: 9, corners: [{north_m: 0, east_m: 0}]",
                "one of radius_m and corners"}),
    [](const auto& tested) { return std::string(tested.param.what); });

TEST(MakeSurface, AKeyThatNobodyKnowsIsRefused) {
  EXPECT_NE(error_of([] {
              return surface_of(std::string(tower_entry) + ", top_radius: 2", 1);
            }).find("top_radius_m"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::make_surface_test
