#include "twin/inspection/instrument/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <set>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "tests/bench/counted_allocations.h"
#include "tests/twin/inspection/meshes_for_tests.h"
#include "twin/inspection/instrument/footprint.h"
#include "twin/inspection/instrument/pose.h"

namespace slackwater::twin::view_test {
namespace {

constexpr double degree = constants::pi / 180;

/// A patch for each square of two triangles.
Surface surface_of(TriangleMesh mesh, double side_m) {
  Surface made;
  made.mesh = std::move(mesh);
  for (std::uint32_t t = 0; t < made.mesh.triangles.size(); ++t) {
    made.patch_of.push_back(t / 2);
    if (t % 2 != 0) continue;
    const auto corner = [&](std::uint32_t i) -> Triple<double> {
      const auto& c = made.mesh.corners[made.mesh.triangles[t][i]];
      return made.mesh.origin_m + Triple<double>{c[0], c[1], c[2]};
    };
    Patch patch;
    // On the diagonal that both triangles share: the first and the last corner, or the middle one.
    const bool is_level = corner(0).z == corner(1).z && corner(1).z == corner(2).z;
    patch.centre_m = 0.5 * (corner(0) + (is_level ? corner(1) : corner(2)));
    patch.normal = unit(cross(corner(1) - corner(0), corner(2) - corner(0)));
    patch.width_m = patch.height_m = static_cast<float>(side_m);
    made.patches.push_back(patch);
  }
  return made;
}

/// A surface among other meshes, ready to be looked at.
struct Stage {
  Surface surface;
  ViewIndex index;
  std::unique_ptr<RayCaster> caster;
  Clarity clarity{};

  explicit Stage(Surface made, std::vector<TriangleMesh> others = {})
      : surface(std::move(made)), index(view_index(surface)) {
    others.insert(others.begin(), surface.mesh);
    caster = std::make_unique<RayCaster>(others);
  }
  [[nodiscard]] std::vector<SeenPatch> seen(const Instrument& instrument, const Pose& before,
                                            const Pose& now, RayBudget budget = {100000, 0}) const {
    ViewScratch scratch;
    std::vector<SeenPatch> out;
    view(instrument, before, now, {surface, index, *caster, 0}, clarity, budget, scratch, out);
    return out;
  }
};

std::set<std::uint32_t> patches_of(const std::vector<SeenPatch>& seen) {
  std::set<std::uint32_t> patches;
  for (const SeenPatch& s : seen) patches.insert(s.patch);
  EXPECT_EQ(patches.size(), seen.size()) << "each once";
  return patches;
}
template <typename Keep>
std::set<std::uint32_t> patches_where(const Surface& surface, const Keep& keep) {
  std::set<std::uint32_t> patches;
  for (std::uint32_t i = 0; i < surface.patches.size(); ++i)
    if (keep(surface.patches[i].centre_m)) patches.insert(i);
  return patches;
}

Instrument camera(double horizontal_deg, double vertical_deg) {
  Instrument made;
  made.kind = InstrumentKind::rgb;
  made.footprint =
      FrameFootprint{horizontal_deg * degree, vertical_deg * degree, 4000, 3000, 0.001};
  made.most_range_m = 100;
  return made;
}
Instrument fan(double across_deg, double blind_deg = 0) {
  Instrument made;
  made.kind = InstrumentKind::multibeam;
  made.footprint = FanFootprint{across_deg * degree, blind_deg * degree, 0.01, 0.01, 20};
  made.axis = {0, 0, 1};
  made.most_range_m = 100;
  return made;
}
/// Straight down, heading north.
Pose down_from(const Triple<double>& at_m) { return {at_m, {0, 0, 1}, {0, 1, 0}, {}, {}}; }
Pose looking(const Triple<double>& from_m, const Triple<double>& axis) {
  return {from_m, axis, unit(cross({0, 0, 1}, axis)), {}, {}};
}

/// 60 x 60 m of bed, 30 m deep, in patches of half a metre.
Surface bed() { return surface_of(level_mesh({-30, -30, 30}, 0.5, 120, 120), 0.5); }

TEST(View, ACameraOverABedSeesItsRectangle) {
  const Stage stage(bed());
  const auto seen = stage.seen(camera(60, 40), {}, down_from({1.1, -2.3, 17}));
  const double wide_m = 13 * std::tan(30 * degree), high_m = 13 * std::tan(20 * degree);
  EXPECT_EQ(patches_of(seen), patches_where(stage.surface, [&](const Triple<double>& c) {
              return std::abs(c.y + 2.3) <= wide_m && std::abs(c.x - 1.1) <= high_m;
            }));
  EXPECT_NEAR(static_cast<double>(seen.size()) * 0.25, 4 * wide_m * high_m, 5);
  for (const SeenPatch& s : seen)
    EXPECT_NEAR(s.quality.ground_sampling_m, std::max(2 * wide_m / 4000, 2 * high_m / 3000), 1e-12);
}

TEST(View, RangeCutsACircle) {
  const Stage stage(bed());
  Instrument near = camera(150, 150);
  near.least_range_m = 4;
  near.most_range_m = 6;
  const auto seen = stage.seen(near, {}, down_from({0.1, 0.1, 27}));
  EXPECT_EQ(patches_of(seen), patches_where(stage.surface, [](const Triple<double>& c) {
              const double r = std::hypot(c.x - 0.1, c.y - 0.1, 3.0);
              return r >= 4 && r <= 6;
            }));
}

// From d off a cylinder the line of sight touches it at acos(R/(R + d)) to either side.
TEST(View, ACylinderIsSeenUpToItsTangents) {
  constexpr double radius_m = 4, off_m = 6;
  const std::uint32_t round = 720;
  const Stage stage(surface_of(cylinder_mesh({0, 0, 0}, radius_m, 20, round, 10), 0.035));
  const double tangent = std::acos(radius_m / (radius_m + off_m));
  const auto half_arc = [&](double horizontal_deg) {
    double widest = 0;
    for (const SeenPatch& s :
         stage.seen(camera(horizontal_deg, 120), {}, looking({10, 0, 10}, {-1, 0, 0}))) {
      const Triple<double>& c = stage.surface.patches[s.patch].centre_m;
      widest = std::max(widest, std::abs(std::atan2(c.y, c.x)));
    }
    return widest;
  };
  const double facet = 2 * constants::pi / round;
  EXPECT_NEAR(half_arc(120), tangent, 1.01 * facet);
  // A narrow lens: the ray at its edge meets the cylinder at asin((R + d) sin(v) / R) - v.
  const double half = 10 * degree;
  EXPECT_NEAR(half_arc(20), std::asin(10 * std::sin(half) / 4) - half, 1.01 * facet);
}

TEST(View, AnOccluderTakesItsShadow) {
  // A plate of 2 x 2 m, 5 m under a lamp-like camera at 15 m over the bed: a shadow of 6 x 6 m.
  const TriangleMesh plate = level_mesh({-1, -1, 20}, 1, 2, 2);
  const Stage open(bed());
  const Stage shaded(bed(), {plate});
  const Pose pose = down_from({0, 0, 15});
  const auto all = patches_of(open.seen(camera(70, 70), {}, pose));
  const auto seen = patches_of(shaded.seen(camera(70, 70), {}, pose));
  std::set<std::uint32_t> hidden;
  std::set_difference(all.begin(), all.end(), seen.begin(), seen.end(),
                      std::inserter(hidden, hidden.end()));
  EXPECT_EQ(hidden, patches_where(open.surface, [](const Triple<double>& c) {
              return std::abs(c.x) <= 3 && std::abs(c.y) <= 3;
            }));
  EXPECT_EQ(hidden.size(), 144U);
}

TEST(View, AFanSweepsItsSwath) {
  const Stage stage(bed());
  const Pose before = down_from({-7.1, 0.2, 20}), now = down_from({6.3, 0.2, 20});
  const auto seen = stage.seen(fan(90), before, now);
  EXPECT_EQ(patches_of(seen), patches_where(stage.surface,
                                            [](const Triple<double>& c) {
                                              return c.x > -7.1 && c.x <= 6.3 &&
                                                     std::abs(c.y - 0.2) <=
                                                         10 * std::tan(45 * degree);
                                            }))
      << "2 h tan(across/2) wide";
  for (const SeenPatch& s : seen)
    EXPECT_NEAR(s.share, (stage.surface.patches[s.patch].centre_m.x + 7.1) / 13.4, 1e-12);
}

TEST(View, AFanLeavesItsBlindZoneOut) {
  const Stage stage(bed());
  const auto seen = stage.seen(fan(120, 40), down_from({-3.1, 0.2, 25}), down_from({3.2, 0.2, 25}));
  EXPECT_EQ(patches_of(seen), patches_where(stage.surface, [](const Triple<double>& c) {
              const double aside = std::abs(c.y - 0.2);
              return c.x > -3.1 && c.x <= 3.2 && aside >= 5 * std::tan(20 * degree) &&
                     aside <= 5 * std::tan(60 * degree);
            }));
}

// Whatever the steps: a way in one step, in many, and with a turn in place at the end of each.
TEST(View, AFanCrossesEachPatchOnceHoweverTheWayIsCut) {
  const Stage stage(bed());
  const auto whole =
      patches_of(stage.seen(fan(80), down_from({-10.03, 0.2, 22}), down_from({10.03, 0.2, 22})));
  std::multiset<std::uint32_t> pieces;
  Pose before = down_from({-10.03, 0.2, 22});
  for (int i = 1; i <= 17; ++i) {
    const Pose now = down_from({-10.03 + 20.06 * i / 17, 0.2, 22});
    for (const SeenPatch& s : stage.seen(fan(80), before, now)) pieces.insert(s.patch);
    before = now;
    before.right = -1.0 * before.right;  // a fan has no front
  }
  EXPECT_EQ(std::set<std::uint32_t>(pieces.begin(), pieces.end()), whole);
  EXPECT_EQ(pieces.size(), whole.size());
  EXPECT_TRUE(stage.seen(fan(80), before, before).empty()) << "who stands still sweeps nothing";
}

TEST(View, AProbeTouchesThePatchBeforeIt) {
  const Stage stage(surface_of(cylinder_mesh({0, 0, 0}, 4, 20, 40, 20), 0.63));
  Instrument probe;
  probe.kind = InstrumentKind::thickness;
  probe.footprint = SpotFootprint{0.01, 2};
  probe.most_range_m = 0.2;
  const double bearing = 31 * degree;
  const Triple<double> out{std::cos(bearing), std::sin(bearing), 0};
  const auto at = [&](double off_m) {
    return looking(off_m * out + Triple<double>{0, 0, 7.3}, -1.0 * out);
  };
  const auto seen = stage.seen(probe, {}, at(4.1));
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].patch, 7U * 40 + 3) << "the row from 7 to 8 m, the facet from 27 to 36 degrees";
  EXPECT_NEAR(seen[0].quality.range_m, 0.1, 0.013) << "sagitta R (1 - cos 4.5 deg)";
  EXPECT_EQ(seen[0].quality.ground_sampling_m, 0.01);
  EXPECT_TRUE(stage.seen(probe, {}, at(4.3)).empty());
}

TEST(View, AReadingStandsForThePatchesAboutIt) {
  const Stage stage(surface_of(cylinder_mesh({0, 0, 0}, 4, 20, 40, 20), 0.63));
  Instrument probe;
  probe.kind = InstrumentKind::potential;
  probe.footprint = SpotFootprint{0.01, 2, 1.5};
  probe.most_range_m = 0.2;
  const double bearing = 31 * degree;
  const Triple<double> out{std::cos(bearing), std::sin(bearing), 0};
  const Pose pose = looking(4.1 * out + Triple<double>{0, 0, 7.3}, -1.0 * out);
  const auto seen = stage.seen(probe, {}, pose);
  const Triple<double> touched_m = pose.position_m + seen.front().quality.range_m * pose.axis;
  EXPECT_EQ(seen.front().patch, 7U * 40 + 3);
  EXPECT_EQ(patches_of(seen), patches_where(stage.surface, [&](const Triple<double>& centre_m) {
              return length_of(centre_m - touched_m) <= 1.5;
            }));
}

TEST(View, AProbeOnWhatOnlyStandsInTheWayReadsNothing) {
  Surface pile = surface_of(cylinder_mesh({0, 0, 0}, 4, 20, 40, 20), 0.63);
  std::fill(pile.patch_of.begin(), pile.patch_of.end(), no_patch);
  const Stage stage(std::move(pile));
  Instrument probe;
  probe.kind = InstrumentKind::thickness;
  probe.footprint = SpotFootprint{0.01, 2, 0.5};
  probe.most_range_m = 0.2;
  EXPECT_TRUE(stage.seen(probe, {}, looking({4.1, 0, 7.3}, {-1, 0, 0})).empty());
}

TEST(View, AWatchSeesAllRound) {
  const Stage stage(bed());
  Instrument watch;
  watch.kind = InstrumentKind::radar;
  watch.footprint = RoundFootprint{10};
  watch.most_range_m = 20;
  EXPECT_EQ(patches_of(stage.seen(watch, {}, down_from({3, 3, 29.9}))),
            patches_where(stage.surface, [](const Triple<double>& c) {
              return std::hypot(c.x - 3, c.y - 3, 0.1) <= 20;
            }));
}

// With a budget, each look casts its rays at others, and n/m looks at all.
TEST(View, ABudgetIsKeptAndGoesRound) {
  const Stage stage(bed());
  const Pose pose = down_from({0, 0, 18});
  const auto all = patches_of(stage.seen(camera(60, 50), {}, pose));
  ASSERT_GT(all.size(), 400U);
  std::set<std::uint32_t> together;
  const std::uint64_t looks = (all.size() + 79) / 80;
  for (std::uint64_t look = 0; look < looks; ++look) {
    const auto some = patches_of(stage.seen(camera(60, 50), {}, pose, {80, look}));
    EXPECT_EQ(some.size(), 80U);
    together.insert(some.begin(), some.end());
    EXPECT_EQ(some, patches_of(stage.seen(camera(60, 50), {}, pose, {80, look})));
  }
  EXPECT_EQ(together, all);
  // Evenly: each quarter of the picture has its share.
  std::size_t north_east = 0;
  for (const SeenPatch& s : stage.seen(camera(60, 50), {}, pose, {80, 3})) {
    const Triple<double>& c = stage.surface.patches[s.patch].centre_m;
    north_east += c.x > 0 && c.y > 0 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(north_east), 20, 4);
}

TEST(View, TheIndexLeavesNothingOut) {
  const Stage stage(surface_of(cylinder_mesh({5, 7, -3}, 3, 20, 60, 30), 0.4));
  const ViewIndex all{
      [&] {
        std::vector<std::uint32_t> n(stage.surface.patches.size());
        for (std::uint32_t i = 0; i < n.size(); ++i) n[i] = i;
        return n;
      }(),
      {{{5, 7, 7}, 1e6, 0, static_cast<std::uint32_t>(stage.surface.patches.size())}}};
  for (const auto& block : stage.index.blocks) EXPECT_LE(block.end - block.first, 32U);
  Rng rng(4, "test/view");
  std::size_t count = 0;
  for (int i = 0; i < 300; ++i) {
    Instrument instrument = i % 2 == 0 ? camera(rng.uniform(5, 120), rng.uniform(5, 100))
                                       : fan(rng.uniform(5, 200), rng.uniform(0, 4));
    instrument.least_range_m = rng.uniform(0, 5);
    instrument.most_range_m = rng.uniform(5, 15);
    const double bearing = rng.uniform(0, 2 * constants::pi), off = rng.uniform(4, 12);
    const Triple<double> at{5 + off * std::cos(bearing), 7 + off * std::sin(bearing),
                            rng.uniform(-5, 20)};
    const Triple<double> axis = unit(
        {rng.normal() - std::cos(bearing) * 2, rng.normal() - std::sin(bearing) * 2, rng.normal()});
    const Pose before = looking(at, axis);
    const Pose now =
        looking(at + Triple<double>{rng.normal(), rng.normal(), rng.normal()},
                unit(axis + Triple<double>{0.1 * rng.normal(), 0, 0.1 * rng.normal()}));
    ViewScratch scratch;
    std::vector<SeenPatch> seen;
    view(instrument, before, now, {stage.surface, all, *stage.caster, 0}, {}, {100000, 0}, scratch,
         seen);
    EXPECT_EQ(patches_of(stage.seen(instrument, before, now)), patches_of(seen));
    count += seen.size();
  }
  EXPECT_GT(count, 1000U);
}

TEST(View, ALookAfterTheFirstAsksNothingOfTheHeap) {
  const Stage stage(bed());
  ViewScratch scratch;
  std::vector<SeenPatch> seen;
  const ViewedSurface viewed{stage.surface, stage.index, *stage.caster, 0};
  const Instrument lens = camera(60, 50), sonar = fan(120);
  const Pose a = down_from({-5, 0, 18}), b = down_from({5, 0, 18});
  const auto look = [&] {
    view(lens, a, b, viewed, {}, {2000, 1}, scratch, seen);
    view(sonar, a, b, viewed, {}, {2000, 1}, scratch, seen);
  };
  look();
  const std::size_t before = bench::allocations();
  look();
  EXPECT_FALSE(seen.empty());
  EXPECT_EQ(bench::allocations(), before);
}

TEST(View, SeesNothingOfASurfaceWithoutPatches) {
  const Stage stage(Surface{});
  EXPECT_TRUE(stage.index.blocks.empty());
  EXPECT_TRUE(stage.seen(camera(60, 50), {}, down_from({0, 0, 0})).empty());
}

}  // namespace
}  // namespace slackwater::twin::view_test
