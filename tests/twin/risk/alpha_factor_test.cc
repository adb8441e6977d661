#include "twin/risk/alpha_factor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "fields/wave/height_error.h"
#include "tests/support/shared_data.h"
#include "twin/risk/height_errors.h"

namespace slackwater::tests::alpha_factor_test {
namespace {

using twin::AlphaTable;

AlphaTable published() {
  return twin::read_alpha_table(
      Config::load(source_folder() / "data" / "alpha" / "dnv_os_h101_table_4_1.yaml"));
}
twin::HeightErrors record() {
  return twin::read_height_errors(
      Config::load(source_folder() / "data" / "alpha" / "height_errors.yaml"));
}

/// twin/docs/operations.md, section 4.
TEST(AlphaTable, TheReferencesWorkedExamples) {
  const AlphaTable table = published();
  EXPECT_NEAR(*table.at(12, 1.5).value, 0.705, 1e-12);
  EXPECT_NEAR(1.5 * *table.at(12, 1.5).value, 1.0575, 1e-12);
  EXPECT_NEAR(2.0 * *table.at(24, 2.0).value, 1.46, 1e-12);
}

TEST(AlphaTable, TakesTheNextLongerPeriodAndTheLastColumnBeyondIt) {
  const AlphaTable table = published();
  EXPECT_EQ(*table.at(12.01, 2).value, 0.73);
  EXPECT_EQ(*table.at(0.5, 2).value, 0.76);
  EXPECT_EQ(*table.at(72, 6).value, 0.72);
  EXPECT_EQ(*table.at(72, 9).value, 0.72);
}

TEST(AlphaTable, OutsideItNothingIsGuessed) {
  const AlphaTable table = published();
  const twin::AlphaFactor low = table.at(12, 0.9), late = table.at(73, 2);
  EXPECT_FALSE(low.value);
  EXPECT_NE(low.why.find("the table has no factor for limits below"), std::string::npos);
  EXPECT_FALSE(late.value);
  EXPECT_NE(late.why.find("72 h"), std::string::npos);
}

TEST(AlphaTable, RefusesWhatIsNoTable) {
  const std::string head = "name: a\nsource: b\nvariable: significant_wave_height_m\n";
  const auto text_of = [&](const std::string& rest, const std::string& top) {
    try {
      (void)twin::read_alpha_table(Config::parse(top + rest, "mine.yaml"));
    } catch (const Error& error) {
      return error.message();
    }
    return std::string("no error");
  };
  EXPECT_NE(text_of("limits: [1, 2]\nrows: [{up_to_h: 12, alpha: [0.6]}]\n", head)
                .find("found 1 factors, expected 2"),
            std::string::npos);
  EXPECT_NE(
      text_of("limits: [2, 1]\nrows: [{up_to_h: 12, alpha: [0.6, 0.7]}]\n", head).find("ascending"),
      std::string::npos);
  EXPECT_NE(text_of("limits: [1]\nrows: [{up_to_h: 12, alpha: [1.6]}]\n", head).find("alpha"),
            std::string::npos);
  EXPECT_NE(
      text_of("limits: [1]\nrows: [{up_to_h: 24, alpha: [0.6]}, {up_to_h: 12, alpha: [0.5]}]\n",
              head)
          .find("ascend"),
      std::string::npos);
  EXPECT_NE(text_of("limits: [1]\n", head).find("rows"), std::string::npos);
  EXPECT_NE(text_of("limits: [1]\nrows: [{up_to_h: 12, alpha: [0.6]}]\n",
                    "name: a\nsource: b\nvariable: height\n")
                .find("significant_wave_height_m"),
            std::string::npos);
}

TEST(HeightErrors, AreThoseOfThePageOfAForecast) {
  const twin::HeightErrors errors = record();
  for (const double height_m : {0.5, 1.0, 1.7, 3.0, 5.0, 8.0})
    for (const double lead_h : {6.0, 12.0, 30.0, 60.0, 90.0})
      EXPECT_NEAR(errors.at(height_m, lead_h).sigma_m, wave_height_sigma_m(height_m, lead_h), 1e-12)
          << height_m << " m, " << lead_h << " h";
  EXPECT_DOUBLE_EQ(errors.at(2, 24).bias_m, 0.23);
}

TEST(HeightErrors, TheMethodMakesThePublishedTableOutOfItsStatistics) {
  const AlphaTable table = published();
  const twin::HeightErrors errors = record();
  int within = 0;
  for (const double limit_m : table.limits)
    for (const AlphaTable::Row& row : table.rows) {
      const double made = twin::alpha_by_errors(limit_m, errors.at(limit_m, row.period_h));
      const double off = std::abs(made - *table.at(row.period_h, limit_m).value);
      within += off <= 0.02 ? 1 : 0;
      EXPECT_LT(off, 0.025) << limit_m << " m, " << row.period_h << " h: " << made;
    }
  EXPECT_GE(within, 16);
}

TEST(HeightErrors, AForecastWithoutErrorsNeedsNoMargin) {
  EXPECT_NEAR(twin::alpha_by_errors(1.5, {0, 0}), 1, 1e-9);
  EXPECT_EQ(twin::alpha_by_errors(1.5, {0.4, 0}), 1) << "one that says too much is not rewarded";
  EXPECT_LT(twin::alpha_by_errors(1.5, {-0.2, 0.3}), twin::alpha_by_errors(1.5, {0, 0.3}));
  EXPECT_LT(twin::alpha_by_errors(1.5, {0, 0.4}), twin::alpha_by_errors(1.5, {0, 0.3}));
}

TEST(HeightErrors, OwnForecastsTakeTheirPlaceWhereEnoughAreVerified) {
  const twin::HeightErrors prior = record();
  const twin::HeightError there = prior.at(1.5, 12);
  // The first day twice as good as published, the second with too few.
  twin::VerifiedHeights first{0, 24, 30, 720, 0.05, 0.5 * there.sigma_m, 1.5};
  twin::VerifiedHeights second{24, 48, 19, 456, 1, 1, 1.5};
  const twin::HeightErrors own = twin::with_verified(prior, {first, second});
  EXPECT_NEAR(own.at(1.5, 12).sigma_m, 0.5 * there.sigma_m, 1e-12);
  EXPECT_NEAR(own.at(1.5, 12).bias_m, 0.05, 1e-12);
  EXPECT_NEAR(own.at(4, 24).sigma_m, 0.5 * prior.at(4, 24).sigma_m, 1e-12);
  EXPECT_EQ(own.at(2, 36).sigma_m, prior.at(2, 36).sigma_m);
  EXPECT_EQ(own.at(2, 72).bias_m, prior.at(2, 72).bias_m);
  EXPECT_NE(own.name.find("30 own forecasts at 0 to 24 h"), std::string::npos) << own.name;
  EXPECT_EQ(own.name.find("19 own"), std::string::npos);
  EXPECT_GT(twin::alpha_by_errors(1.5, own.at(1.5, 12)),
            twin::alpha_by_errors(1.5, prior.at(1.5, 12)));
  const twin::HeightErrors none = twin::with_verified(prior, {second});
  EXPECT_NE(none.name.find("fewer than 20"), std::string::npos);
  EXPECT_EQ(none.at(1, 12).sigma_m, prior.at(1, 12).sigma_m);
}

}  // namespace
}  // namespace slackwater::tests::alpha_factor_test
