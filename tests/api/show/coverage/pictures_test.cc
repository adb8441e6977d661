#include <gtest/gtest.h>

#include <cmath>

#include "api/show/coverage/raster.h"
#include "api/show/coverage/sheet.h"
#include "api/show/coverage/still.h"
#include "tests/api/show/coverage/made_up_inspection.h"

namespace slackwater::tests::pictures_test {
namespace {

using namespace api;

InspectionCoverage made_up(std::size_t pair, const MadeUpInspection& how = {}) {
  return coverage_in(made_up_inspection(how))[pair];
}

std::array<double, patch_states> shares_of(const CoverageRaster& raster) {
  std::array<double, patch_states> shares{};
  for (const auto& cell : raster.cells)
    if (cell)
      shares[static_cast<std::size_t>(*cell)] += 1 / static_cast<double>(raster.cells.size());
  return shares;
}

TEST(CoverageRaster, KeepsTheSharesToACellsRow) {
  for (const std::size_t rows : {7U, 70U, 701U}) {
    const InspectionCoverage pile = made_up(0, {.columns = 72, .rows = rows, .has_bed = false});
    const CoverageRaster raster = raster_of(pile, sheet_columns, sheet_rows);
    EXPECT_LE(raster.columns, sheet_columns);
    EXPECT_LE(raster.rows, sheet_rows);
    const auto seen = shares_of(raster), truth = pile.shares();
    for (std::size_t s = 0; s < patch_states; ++s)
      EXPECT_NEAR(seen[s], truth[s], 1.0 / static_cast<double>(raster.rows)) << rows;
  }
}

TEST(CoverageRaster, BlocksHoldEachCellOnce) {
  const CoverageRaster raster = raster_of(made_up(0), sheet_columns, sheet_rows);
  std::vector<int> times(raster.cells.size(), 0);
  for (const CoverageRaster::Block& block : raster.blocks())
    for (std::size_t r = block.row; r < block.row + block.high; ++r)
      for (std::size_t c = block.column; c < block.column + block.wide; ++c) {
        ++times[r * raster.columns + c];
        EXPECT_EQ(raster.cells[r * raster.columns + c], block.state);
      }
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_EQ(times[i], raster.cells[i] ? 1 : 0) << "cell " << i;
  EXPECT_EQ(raster.blocks().size(), 3U) << "three bands all round are three blocks";
}

TEST(CoverageRaster, APatchOverTheSeamComesInAtTheOtherEdge) {
  InspectionCoverage ring = made_up(0);
  ring.patches.resize(1);
  ring.patches[0].along_m = 0;
  ring.patches[0].width_m = ring.sheet.width_m / 2;
  ring.patches[0].down_m = ring.sheet.height_m / 2;
  ring.patches[0].height_m = ring.sheet.height_m;
  const CoverageRaster raster = raster_of(ring, 40, 40);
  EXPECT_TRUE(raster.cells.front());
  EXPECT_TRUE(raster.cells[raster.columns - 1]);
  EXPECT_FALSE(raster.cells[raster.columns / 2]) << "no surface there";
}

TEST(CoverageSheet, PicturesStaySmallHoweverManyPatches) {
  const InspectionCoverage pile = made_up(0, {.columns = 360, .rows = 300, .has_bed = false});
  ASSERT_GT(pile.patches.size(), 100000U);
  EXPECT_LT(sheet_svg(pile, {}).size(), 50000U);
  EXPECT_LT(still_svg(pile, {}).size(), 400000U);
  // The worst that a sheet can be: no cell like its neighbour.
  InspectionCoverage board = pile;
  for (std::size_t i = 0; i < board.patches.size(); ++i)
    board.patches[i].state = static_cast<PatchState>((i * 2654435761U >> 7) % 3);
  EXPECT_LT(sheet_svg(board, {}).size(), 1500000U);
}

TEST(CoverageSheet, NorthOfAFlatOneIsWhereItsPlacesGo) {
  EXPECT_FALSE(north_on_sheet_deg(made_up(0))) << "a pile stands";
  InspectionCoverage bed = made_up(1);
  ASSERT_TRUE(north_on_sheet_deg(bed));
  EXPECT_NEAR(*north_on_sheet_deg(bed), 0, 0.1) << "up the page";
  for (CoveragePatch& patch : bed.patches)  // turned a quarter: the page's up is now east
    patch.centre_m = {patch.centre_m.y(), -patch.centre_m.x(), patch.centre_m.z()};
  EXPECT_NEAR(*north_on_sheet_deg(bed), -90, 0.1) << "to the left";
}

TEST(CoverageSheet, LongSurfacesAreStretchedAndSayHowMuch) {
  InspectionCoverage cable = made_up(1);
  EXPECT_NEAR(sheet_stretch(cable.sheet), 1, 1e-9);
  cable.sheet.width_m = 500;
  cable.sheet.height_m = 1;
  const double stretch = sheet_stretch(cable.sheet);
  EXPECT_GT(stretch, 10);
  EXPECT_NE(sheet_svg(cable, {}).find("down drawn"), std::string::npos);
}

TEST(CoverageSheet, RoundLengthsAreOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(round_length(6.3), 5);
  EXPECT_DOUBLE_EQ(round_length(2), 2);
  EXPECT_DOUBLE_EQ(round_length(0.19), 0.1);
  EXPECT_DOUBLE_EQ(round_length(1000), 1000);
}

TEST(CoverageStill, QuadsLieOnTheSurfaceAndHoldItsArea) {
  for (const bool gathers : {true, false}) {
    const InspectionCoverage pile = made_up(0);
    const auto quads = quads_of(pile, gathers ? 600 : 100000);
    double area_m2 = 0;
    std::array<double, patch_states> shares{};
    for (const CoverageQuad& quad : quads) {
      area_m2 += quad.area_m2;
      shares[static_cast<std::size_t>(quad.state)] += quad.area_m2 / pile.area_m2;
      for (const auto& corner : quad.corners_m) {
        // A chord's middle lies 1 - cos(half its angle) inside, its corners as much outside.
        EXPECT_NEAR(std::hypot(corner.x(), corner.y()), 3, 0.12);
        EXPECT_GT(corner.z(), -35.3);
        EXPECT_LT(corner.z(), 0.3);
      }
    }
    EXPECT_NEAR(area_m2, pile.area_m2, 1e-6);
    EXPECT_LT(quads.size(), gathers ? 800U : 5041U);
    for (std::size_t s = 0; s < patch_states; ++s) EXPECT_NEAR(shares[s], pile.shares()[s], 0.03);
  }
}

TEST(CoverageStill, AQuadIsAsLargeAsItsPatches) {
  for (const CoverageQuad& quad : quads_of(made_up(0), 600)) {
    const auto side = [&](std::size_t a, std::size_t b) {
      const auto d = quad.corners_m[a] - quad.corners_m[b];
      return std::sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
    };
    EXPECT_NEAR(side(0, 1) * side(1, 2), quad.area_m2, 0.05 * quad.area_m2) << "an arc's chord";
  }
}

TEST(CoverageStill, APileIsSeenFromTwoSidesABedFromOne) {
  EXPECT_NE(still_svg(made_up(0), {}).find(" and from the "), std::string::npos);
  EXPECT_EQ(still_svg(made_up(1), {}).find(" and from the "), std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::pictures_test
