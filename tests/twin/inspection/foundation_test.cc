#include <gtest/gtest.h>

#include "tests/twin/inspection/foundation_for_tests.h"

namespace slackwater::tests::foundation_test {
namespace {

TEST(FoundationForTests, HasFiftyThousandTrianglesAndIsClosed) {
  const std::vector<twin::Surface> surfaces = foundation_for_tests();
  EXPECT_NEAR(static_cast<double>(triangles_of(surfaces)), 50000, 2500);
  for (const twin::Surface& surface : surfaces) EXPECT_TRUE(twin::is_closed(surface.mesh));
  EXPECT_GT(triangles_of(foundation_for_tests(0.1)), 150000U);
}

}  // namespace
}  // namespace slackwater::tests::foundation_test
