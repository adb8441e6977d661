// Factors of practice for several variables beside each other. The factors for wind are made up: no
// source that could be read has any.
#include "api/ask/windows/alpha_practice.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::alpha_practice_test {
namespace {

using api::AlphaPractice;

twin::Limit at_most(twin::LimitVariable variable, double bound) {
  twin::Limit limit;
  limit.variable = variable;
  limit.bound = bound;
  return limit;
}
const twin::Limit waves = at_most(twin::LimitVariable::significant_wave_height, 2);
const twin::Limit wind = at_most(twin::LimitVariable::wind_speed_10m, 12);

std::string table_of(const StoreForTests& made, const std::string& name,
                     const std::string& variable, const std::string& limits) {
  return made.write(name, "name: " + name + "\nsource: our surveyor\nvariable: " + variable +
                              "\nlimits: " + limits +
                              "\nrows: [{up_to_h: 24, alpha: [0.8, 0.9]}]\n");
}

std::string refusal_of(const std::vector<std::filesystem::path>& files, bool by_errors) {
  try {
    static_cast<void>(by_errors ? AlphaPractice::of_errors(api::published_height_errors(), files)
                                : AlphaPractice::of_tables(files));
  } catch (const Error& error) {
    return error.message();
  }
  return "taken";
}

TEST(AlphaPractice, OfWindIsAUsersOwnBesideThatOfWaves) {
  const StoreForTests made;
  const std::string mine = table_of(made, "wind.yaml", "wind_speed_10m_m_s", "[10, 15]");
  const AlphaPractice ours = AlphaPractice::of_tables({}), both = AlphaPractice::of_tables({mine});
  EXPECT_FALSE(ours.at(wind, wind.bound, 24)) << "none is shipped";
  // By hand: 12 m/s lie two fifths of the way from 0.8 to 0.9.
  EXPECT_NEAR(*both.at(wind, 12, 24)->value, 0.84, 1e-12);
  EXPECT_EQ(*both.at(waves, 2, 24)->value, *ours.at(waves, 2, 24)->value);
  EXPECT_NEAR(*ours.at(waves, 2, 24)->value, 0.73, 1e-12) << "DNV-OS-H101 table 4-1";
  EXPECT_FALSE(both.at(wind, 12, 30)->value) << "beyond its last row";
  EXPECT_TRUE(contains(both.name(), "DNV-OS-H101")) << both.name();
  EXPECT_TRUE(contains(both.name(), "(significant wave height); wind.yaml (wind at 10 m)"));
  EXPECT_TRUE(contains(both.source(), "our surveyor")) << both.source();
  EXPECT_FALSE(contains(ours.name(), "(significant wave height)")) << "one alone needs no word";
}

TEST(AlphaPractice, OfWindStandsBesideErrorsOfWavesToo) {
  const StoreForTests made;
  const std::string mine = table_of(made, "wind.yaml", "wind_speed_10m_m_s", "[10, 15]");
  const AlphaPractice errors = AlphaPractice::of_errors(api::published_height_errors());
  const AlphaPractice both = AlphaPractice::of_errors(api::published_height_errors(), {mine});
  EXPECT_FALSE(errors.at(wind, 12, 24));
  EXPECT_NEAR(*both.at(wind, 12, 24)->value, 0.84, 1e-12);
  EXPECT_EQ(*both.at(waves, 2, 24)->value, *errors.at(waves, 2, 24)->value);
  EXPECT_TRUE(contains(both.name(), "forecast errors")) << both.name();
  EXPECT_TRUE(contains(both.name(), "wind.yaml (wind at 10 m)")) << both.name();
}

TEST(AlphaPractice, HasOneTableForAVariable) {
  const StoreForTests made;
  const std::string wind_table = table_of(made, "wind.yaml", "wind_speed_10m_m_s", "[10, 15]");
  const std::string wave_table = table_of(made, "hs.yaml", "significant_wave_height_m", "[1, 2]");
  EXPECT_EQ(AlphaPractice::of_tables({wave_table}).name(), "hs.yaml");
  EXPECT_TRUE(contains(refusal_of({wind_table, wind_table}, false), "second table"));
  EXPECT_TRUE(contains(refusal_of({wind_table, wind_table}, true), "second table"));
  EXPECT_TRUE(contains(refusal_of({wave_table}, true), "errors beside the table"));
}

/// Of a limit with a table the factor is that of the bound which the sea has then.
TEST(AlphaPractice, GoesByTheBoundThen) {
  const AlphaPractice ours = AlphaPractice::of_tables({});
  EXPECT_NEAR(*ours.at(waves, 1.5, 12)->value, 0.705, 1e-12);
  EXPECT_FALSE(ours.at(waves, 0.8, 12)->value) << "the table begins at 1 m";
}

}  // namespace
}  // namespace slackwater::tests::alpha_practice_test
