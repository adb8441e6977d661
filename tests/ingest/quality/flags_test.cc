#include "ingest/quality/flags.h"

#include <gtest/gtest.h>

#include <array>

namespace slackwater::ingest::flags_test {
namespace {

constexpr std::array<double, 10> zero_to_nine{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
using enum SampleStatus;

TEST(FlagScheme, NobodyLookedIsNotGood) {
  for (const char* conventions :
       {"OceanSITES reference table 2", "Copernicus Marine In Situ reference table 2",
        "IMOS standard flags", "BODC SeaDataNet"}) {
    const auto scheme = FlagScheme::from_attributes({}, "", conventions);
    ASSERT_TRUE(scheme) << conventions;
    EXPECT_EQ(scheme->status_of(0), not_checked);
    EXPECT_EQ(scheme->status_of(1), ok);
    EXPECT_EQ(scheme->status_of(2), ok);
    EXPECT_EQ(scheme->status_of(3), suspect);
    EXPECT_EQ(scheme->status_of(4), suspect);
    EXPECT_EQ(scheme->status_of(9), missing);
    EXPECT_EQ(scheme->status_of(-127), not_checked);  // a fill value is no verdict
  }
}

TEST(FlagScheme, MeaningsAgreeWithTheTableOfTheirConvention) {
  const auto by_words = FlagScheme::from_attributes(
      zero_to_nine,
      "no_qc_performed good_data probably_good_data bad_data_that_are_potentially_correctable "
      "bad_data value_changed "
      "not_used nominal_value interpolated_value missing_value",
      "");
  const auto by_name = FlagScheme::from_attributes({}, "", "OceanSITES reference table 2");
  for (long flag = 0; flag <= 9; ++flag)
    EXPECT_EQ(by_words->status_of(flag), by_name->status_of(flag)) << flag;

  const auto bodc_words = FlagScheme::from_attributes(
      zero_to_nine,
      "no_quality_control good_value probably_good_value probably_bad_value bad_value "
      "changed_value "
      "value_below_detection value_in_excess interpolated_value missing_value",
      "");
  const auto bodc_name = FlagScheme::from_attributes({}, "", "BODC SeaDataNet");
  for (long flag = 0; flag <= 9; ++flag)
    EXPECT_EQ(bodc_words->status_of(flag), bodc_name->status_of(flag)) << flag;
}

TEST(FlagScheme, TheWordsOfTheFileWinOverTheNumbersWeKnow) {
  const std::array<double, 4> values{1, 2, 3, 4};  // QARTOD: 2 is "nobody looked" here
  const auto scheme = FlagScheme::from_attributes(values, "PASS NOT_EVALUATED SUSPECT FAIL",
                                                  "OceanSITES reference table 2");
  EXPECT_EQ(scheme->status_of(1), ok);
  EXPECT_EQ(scheme->status_of(2), not_checked);
  EXPECT_EQ(scheme->status_of(3), suspect);
  EXPECT_EQ(scheme->status_of(4), suspect);
}

TEST(FlagScheme, UnnamedNumbersMeanNothing) {
  EXPECT_FALSE(FlagScheme::from_attributes({}, "", ""));
  EXPECT_FALSE(FlagScheme::from_attributes(zero_to_nine, "good bad", "home-made"));
}

}  // namespace
}  // namespace slackwater::ingest::flags_test
