#include "fields/base/advice.h"

#include <gtest/gtest.h>

namespace slackwater::advice_test {
namespace {

TEST(WithDecimalPoint, ReadsADecimalCommaAndNothingElse) {
  EXPECT_EQ(with_decimal_point("48,85"), "48.85");
  EXPECT_EQ(with_decimal_point("-2,55"), "-2.55");
  for (const char* text : {"48.85", "1,2,3", ",5", "5,", "1, 2", "a,b", "", "-", "1.5,2"})
    EXPECT_FALSE(with_decimal_point(text)) << text;
}

TEST(DidYouMean, NamesANearWordAndIsSilentAboutFarOnes) {
  EXPECT_EQ(did_you_mean("forcast", {"forecast", "profile"}), " (did you mean 'forecast'?)");
  EXPECT_EQ(did_you_mean("xyzzy", {"forecast", "profile"}), "");
  EXPECT_EQ(did_you_mean("forecast", {}), "");
}

}  // namespace
}  // namespace slackwater::advice_test
