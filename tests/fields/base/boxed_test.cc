#include "fields/base/boxed.h"

#include <gtest/gtest.h>

#include <array>
#include <variant>

namespace slackwater::boxed_test {
namespace {

using Large = std::array<int, 100>;

TEST(Boxed, IsCopiedWithItsOwner) {
  const Boxed<Large> first(Large{1, 2});
  Boxed<Large> second = first;
  second = Boxed<Large>(Large{3});
  EXPECT_EQ((*first)[0], 1);
  EXPECT_EQ((*second)[0], 3);
  second = first;
  EXPECT_EQ(second->at(1), 2);
  EXPECT_NE(&*second, &*first);
}

TEST(Boxed, KeepsAVariantSmall) { EXPECT_LE(sizeof(std::variant<int, Boxed<Large>>), 16U); }

}  // namespace
}  // namespace slackwater::boxed_test
