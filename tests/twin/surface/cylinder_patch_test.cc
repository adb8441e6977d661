#include "twin/surface/cylinder_patch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::tests::cylinder_patch_test {
namespace {

using twin::CylinderPatch;
using twin::Triple;

constexpr double pi = constants::pi;
const twin::Cylinder pile{100, -50, 3, -20, 35};

Triple<double> beside(double bearing_rad, double off_m, double down_m) {
  return {100 + (3 + off_m) * std::cos(bearing_rad), -50 + (3 + off_m) * std::sin(bearing_rad),
          down_m};
}

TEST(CylinderPatch, HasTheAreaOfThePartOfTheMantle) {
  const CylinderPatch round = twin::cut_open(pile, 0, 2 * pi, 4, 10, 0.1);
  EXPECT_NEAR(static_cast<double>(round.cells()) * round.cell_m2(), 2 * pi * 3 * 6, 1e-9);
  EXPECT_TRUE(round.is_all_round());
  const CylinderPatch quarter = twin::cut_open(pile, 1, pi / 2, 4, 10, 0.13);
  EXPECT_NEAR(static_cast<double>(quarter.cells()) * quarter.cell_m2(), pi / 2 * 3 * 6, 1e-9);
  EXPECT_FALSE(quarter.is_all_round());
  for (const CylinderPatch& patch : {round, quarter}) {
    EXPECT_LE(patch.column_m(), 0.13 + 1e-12);
    EXPECT_LE(patch.row_m(), 0.13 + 1e-12);
    // One column or row fewer would be too few.
    EXPECT_GT(patch.width_m() / static_cast<double>(patch.columns - 1), 0.1);
  }
  EXPECT_EQ(round.rows, 60U);
}

TEST(CylinderPatch, FindsThePlaceOnTheFaceThatIsNearest) {
  Rng rng(3, "patch");
  for (int i = 0; i < 1000; ++i) {
    const double from = rng.uniform(-7, 7), arc = rng.uniform(0.1, 2 * pi);
    const CylinderPatch patch = twin::cut_open(pile, from, arc, 4, 10, 0.5);
    const double round = rng.uniform(0, 2 * pi), off_m = rng.uniform(-0.5, 3),
                 down_m = rng.uniform(-2, 20);
    const twin::FacePlace place = face_place(patch, beside(from + round, off_m, down_m));
    // The seam is one place with two numbers.
    EXPECT_NEAR(std::remainder(place.along_m - 3 * round, 6 * pi), 0, 1e-9);
    EXPECT_GE(place.along_m, 0);
    EXPECT_LT(place.along_m, 6 * pi);
    EXPECT_NEAR(place.off_m, off_m, 1e-9);
    EXPECT_EQ(place.down_m, down_m - 4);
  }
}

}  // namespace
}  // namespace slackwater::tests::cylinder_patch_test
