#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/twin/inspection/defect/defects_for_tests.h"
#include "twin/inspection/defect/defect_plan.h"

namespace slackwater::tests::plant_test {
namespace {

using twin::Defect;
using twin::DefectKind;
using twin::Surface;
using twin::SurfaceKind;

twin::DefectPlan plan(const std::string& entries) {
  return twin::read_defect_plan(Config::parse("defects:\n" + entries, "plan.yaml"));
}

std::vector<Surface> pile_and_tower() {
  return {sheet_of("A01/monopile", SurfaceKind::monopile, {1, 2, 0.5F, 4}, {0.5F, 3}),
          squares("A01/blade_1", SurfaceKind::blade, 5, 5, 3),
          sheet_of("A01/tower", SurfaceKind::tower, {2.5F, 1.5F}, {1, 2, 0.25F}),
          squares("A01/bed", SurfaceKind::bed, 20, 20)};
}

std::vector<Defect> planted(const std::string& entries, std::uint64_t seed = 1) {
  const auto surfaces = pile_and_tower();
  return twin::plant(plan(entries), surfaces, facts(), seed);
}

bool same(const Defect& a, const Defect& b) {
  return a.kind == b.kind && a.surface == b.surface && a.patch == b.patch && a.size_m == b.size_m &&
         a.severity == b.severity;
}

TEST(PlantedDefects, AreAsLikelyOnEachSquareMetreOfTheirSurfaces) {
  const auto surfaces = pile_and_tower();
  const double area_m2 = 7.5 * 3.5 + 4 * 3.25;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto defects = planted("  - {kind: crack, count: 10000}\n", seed);
    std::map<std::pair<std::size_t, std::size_t>, double> counts;
    for (const Defect& defect : defects) ++counts[{defect.surface, defect.patch}];
    double chi_square = 0;
    for (const std::size_t s : {0U, 2U})
      for (std::size_t p = 0; p < surfaces[s].patches.size(); ++p) {
        const double expected = 1e4 * surfaces[s].patches[p].area_m2 / area_m2;
        const double off = counts[{s, p}] - expected;
        chi_square += off * off / expected;
        counts.erase({s, p});
      }
    // 14 patches; 34.5 is passed once in a thousand times with 13 degrees of freedom.
    EXPECT_LT(chi_square, 34.5) << seed;
    EXPECT_TRUE(counts.empty()) << "some sit on surfaces that have no cracks";
  }
}

TEST(PlantedDefects, AreSpreadEvenlyOverTheLogarithmOfTheirSizes) {
  const auto defects =
      planted("  - {kind: crack, count: 10000, size_m: [0.01, 1], severity_m: [0.001, 0.008]}\n");
  std::array<double, 10> sizes{}, severities{};
  for (const Defect& defect : defects) {
    ASSERT_TRUE(defect.size_m >= 0.01 && defect.size_m <= 1) << defect.size_m;
    ASSERT_TRUE(defect.severity >= 0.001 && defect.severity <= 0.008) << defect.severity;
    ++sizes[static_cast<std::size_t>(std::min(9.0, 5 * std::log10(defect.size_m / 0.01)))];
    ++severities[static_cast<std::size_t>(
        std::min(9.0, 10 * std::log(defect.severity / 0.001) / std::log(8.0)))];
  }
  // 27.9: one in a thousand at 9 degrees of freedom.
  for (const auto& counts : {sizes, severities}) {
    double chi_square = 0;
    for (const double count : counts) chi_square += (count - 1000) * (count - 1000) / 1000;
    EXPECT_LT(chi_square, 27.9);
  }
}

TEST(PlantedDefects, AreTheSameForASeedAndOthersForAnother) {
  const std::string entries = "  - {kind: crack, count: 20}\n  - {kind: scour, count: 3}\n";
  const auto once = planted(entries, 5), again = planted(entries, 5), other = planted(entries, 6);
  ASSERT_EQ(once.size(), 23U);
  std::size_t alike = 0;
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].number, i);
    EXPECT_TRUE(same(once[i], again[i])) << i;
    alike += same(once[i], other[i]) ? 1 : 0;
  }
  EXPECT_EQ(alike, 0U);
}

TEST(PlantedDefects, StayWhereTheyAreWhateverElseIsPlanted) {
  const auto few = planted("  - {kind: scour, count: 3}\n");
  const auto after = planted("  - {kind: crack, count: 20}\n  - {kind: scour, count: 8}\n");
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_TRUE(same(few[i], after[20 + i])) << i;
}

TEST(PlantedDefects, LieAtThePlaceThatThePlanNames) {
  const auto defects = planted(
      "  - {kind: crack, on: A01/monopile, along_m: 2.2, down_m: 0.4, size_m: 0.05}\n"
      "  - {kind: scour, on: A01/bed, along_m: 19.9, down_m: 0.1, size_m: 2, severity_m: 1.2}\n");
  ASSERT_EQ(defects.size(), 2U);
  EXPECT_EQ(defects[0].surface, 0U);
  EXPECT_EQ(defects[0].patch, 1U);
  EXPECT_EQ(defects[0].size_m, 0.05);
  EXPECT_EQ(defects[1].surface, 3U);
  EXPECT_EQ(defects[1].patch, 19U);
  EXPECT_EQ(defects[1].severity, 1.2);
}

TEST(PlantedDefects, GoByBearingAndDepthOnWhatGoesRound) {
  // 36 columns of 10 degrees from a bearing of 100 degrees on; its top is 2 m above the sea.
  std::vector<Surface> surfaces{squares("pile", SurfaceKind::monopile, 36, 12)};
  surfaces[0].sheet.is_all_round = true;
  surfaces[0].sheet.first_bearing_rad = 100 * constants::pi / 180;
  surfaces[0].sheet.top_z_m = -2;
  const auto patch = [&](const std::string& place) {
    const std::string entry = "  - {kind: crack, on: pile, size_m: 0.05, " + place + "}\n";
    return twin::plant(plan(entry), surfaces, facts(), 1).at(0).patch;
  };
  EXPECT_EQ(patch("bearing_deg: 105, height_m: 1.5"), 0U);
  EXPECT_EQ(patch("bearing_deg: 115, depth_m: 0.5"), 2 * 36U + 1);
  EXPECT_EQ(patch("bearing_deg: 95, depth_m: 0.5"), 2 * 36U + 35);
  EXPECT_EQ(patch("bearing_deg: -265, depth_m: 9.5"), 11 * 36U + 35);
}

TEST(PlantedDefects, GrowAndAreMissingWhereThatCanBe) {
  // One metre a row down from 5 m above the sea: growth up to 2 m above, bolts in the first half.
  std::vector<Surface> surfaces{squares("tp", SurfaceKind::transition_piece, 4, 10)};
  for (twin::Patch& patch : surfaces[0].patches) patch.centre_m.z = patch.down_m - 5;
  const auto defects = twin::plant(
      plan("  - {kind: marine_growth, count: 300}\n  - {kind: missing_fastener, count: 50}\n"),
      surfaces, facts(), 3);
  std::array<std::size_t, 10> growth{};
  for (const Defect& defect : defects)
    if (defect.kind == DefectKind::marine_growth)
      ++growth[defect.patch / 4];
    else
      EXPECT_EQ(defect.patch / 4, 0U);
  for (std::size_t row = 0; row < 10; ++row) EXPECT_EQ(growth[row] > 0, row >= 3) << row;
}

TEST(PlantedDefects, RefuseWhatCannotBe) {
  struct Case {
    const char* entry;
    const char* says;
  };
  for (const Case& c : {
           Case{"{kind: crack, on: A01/blade_1, count: 2}", "found it on A01/blade_1, a blade"},
           Case{"{kind: scour, on: A01/monopile, along_m: 1, down_m: 1}", "one of: bed"},
           Case{"{kind: crack, on: A02/monopile, count: 2}", "found no surface A02/monopile"},
           Case{"{kind: anode_loss, count: 2}", "no surface of this run has room for it"},
           Case{"{kind: crack, on: A01/monopile, along_m: 8, down_m: 1}", "off A01/monopile"},
           Case{"{kind: crack, on: A01/monopile, along_m: 1, down_m: -0.1}", "off A01/monopile"},
           Case{"{kind: crack, on: A01/monopile, bearing_deg: 8, depth_m: 1}", "no bearings"},
           Case{"{kind: crack, on: A01/monopile, along_m: 1, down_m: 1, size_m: 9}",
                "larger than A01/monopile"},
           Case{"{kind: crakc, count: 2}", "did you mean 'crack'"},
           Case{"{kind: crack}", "count"},
           Case{"{kind: crack, count: -1}", "count"},
           Case{"{kind: crack, count: 1.5}", "count"},
           Case{"{kind: crack, count: 2, size_m: [0.2, 0.02]}", "give the smaller one first"},
           Case{"{kind: crack, count: 2, size_m: [0.1, 0.2, 0.3]}", "found 3 numbers"},
           Case{"{kind: crack, count: 2, size_m: 0}", "found 0, expected more"},
           Case{"{kind: crack, count: 2, severity_share: 0.3}", "is told as severity_m"},
           Case{"{kind: chain_wear, count: 2, severity_share: 1.3}", "severity_share"},
           Case{"{kind: crack, along_m: 1, down_m: 1}", "needs the surface it is on"},
           Case{"{kind: crack, on: A01/monopile, along_m: 1}", "down_m"},
           Case{"{kind: crack, on: A01/monopile, along_m: 1, down_m: 1, count: 2}",
                "give count or a place"},
           Case{"{kind: crack, on: A01/monopile, along_m: 1, down_m: 1, depth_m: 2}", "not both"},
           Case{"{kind: crack, on: A01/monopile, bearing_deg: 1, depth_m: 1, height_m: 1}",
                "one of depth_m and height_m"},
           Case{"{kind: crack, count: 2, sise_m: 0.1}", "sise_m"},
       }) {
    const std::string yaml = formatted("defects:\n  - {}\n", c.entry);
    const std::string message = message_of([&] {
      const Config config = Config::parse(yaml, "plan.yaml");
      const auto read = twin::read_defect_plan(config);
      config.expect_all_read();
      const auto surfaces = pile_and_tower();
      (void)twin::plant(read, surfaces, facts(), 1);
    });
    EXPECT_NE(message.find(c.says), std::string::npos) << c.entry << "\n  " << message;
  }
}

}  // namespace
}  // namespace slackwater::tests::plant_test
