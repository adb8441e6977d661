#include "ingest/history/offer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"

namespace slackwater::ingest::offer_test {
namespace {

TEST(PartsOfAVector, AWindFromTheNorthBlowsToTheSouth) {
  EXPECT_EQ(part_of(VectorPart::speed, 3, -4), 5);
  EXPECT_NEAR(part_of(VectorPart::from_direction, 0, -4), 0, 1e-12);
  EXPECT_NEAR(part_of(VectorPart::to_direction, 0, -4), 180, 1e-12);
  EXPECT_NEAR(part_of(VectorPart::from_direction, 4, 0), 270, 1e-12);
  EXPECT_NEAR(part_of(VectorPart::to_direction, 4, 0), 90, 1e-12);
  EXPECT_NEAR(part_of(VectorPart::to_direction, -1, 1), 315, 1e-12);
  EXPECT_TRUE(std::isnan(part_of(VectorPart::to_direction, 0, 0)));
  EXPECT_TRUE(std::isnan(part_of(VectorPart::from_direction, NAN, 1)));
}

TEST(PartsOfAVector, DirectionsComeFromBothComponentsAlone) {
  const Vocabulary words =
      Vocabulary::load(slackwater::tests::source_folder() / "data" / "products" / "variables.yaml");
  const std::vector<Offer> offers{{"u", "eastward_wind", "m s-1"},
                                  {"hs", "sea_surface_wave_significant_height", "m"},
                                  {"v", "northward_wind", "m s-1"}};
  const auto made = making_of("wind_from_direction", offers, words);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->first, 0U);
  EXPECT_EQ(made->second, 2U);
  EXPECT_EQ(made->part, VectorPart::from_direction);
  EXPECT_EQ(made->standard_name, "wind_from_direction");
  EXPECT_FALSE(making_of("sea_water_velocity_to_direction", offers, words));
  EXPECT_FALSE(making_of("wind_from_direction", {offers[0], offers[1]}, words));
}

TEST(SeveralOfOneQuantity, TheOneThatTheUserNamesIsMeant) {
  const Vocabulary words =
      Vocabulary::load(slackwater::tests::source_folder() / "data" / "products" / "variables.yaml");
  std::vector<Offer> offers{{"ff10", "wind_speed", "m s-1"},
                            {"ff100", "wind_speed", "m s-1"},
                            {"ff250", "wind_speed", "m s-1"}};
  EXPECT_THROW(static_cast<void>(making_of("wind_speed", offers, words)), Error);
  EXPECT_EQ(making_of("ff250", offers, words)->first, 2U);
  for (std::size_t i = 0; i < offers.size(); ++i) {
    offers[i].is_named = true;
    EXPECT_EQ(making_of("wind_speed", offers, words)->first, i);
    offers[i].is_named = false;
  }
  offers[0].is_named = offers[2].is_named = true;
  EXPECT_THROW(static_cast<void>(making_of("wind_speed", offers, words)), Error);
}

/// A wind at 10 m and at 100 m: a vector is never mixed of both.
TEST(SeveralOfOneQuantity, OfAVectorBothComponentsAreNamed) {
  const Vocabulary words =
      Vocabulary::load(slackwater::tests::source_folder() / "data" / "products" / "variables.yaml");
  std::vector<Offer> offers{{"eastward_wind", "eastward_wind", "m s-1"},
                            {"northward_wind", "northward_wind", "m s-1"},
                            {"u100", "eastward_wind", "m s-1", true}};
  try {
    static_cast<void>(making_of("wind_speed", offers, words));
    ADD_FAILURE() << "u100 met the northward wind of another height";
  } catch (const Error& error) {
    EXPECT_TRUE(slackwater::tests::contains(
        error.message(), "found 'u100' named as eastward_wind and 'northward_wind' not named"))
        << error.message();
  }
  offers.push_back({"v100", "northward_wind", "m s-1", true});
  const auto made = making_of("wind_speed", offers, words);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->first, 2U);
  EXPECT_EQ(made->second, 3U);
}

TEST(SeveralOfOneQuantity, ASpeedBesideADirectionMadeOfComponentsIsPointedOut) {
  const Vocabulary words =
      Vocabulary::load(slackwater::tests::source_folder() / "data" / "products" / "variables.yaml");
  std::vector<Offer> offers{{"wind_speed", "wind_speed", "m s-1"},
                            {"u100", "eastward_wind", "m s-1", true},
                            {"v100", "northward_wind", "m s-1", true}};
  const std::vector<std::string> both{"wind_speed", "wind_from_direction"};
  EXPECT_EQ(made_apart(both, offers, words),
            (std::vector<std::string>{"wind_speed is of 'wind_speed' and wind_from_direction of "
                                      "'u100' and 'v100': make sure that both are of one height"}));
  EXPECT_TRUE(made_apart({"wind_speed"}, offers, words).empty());
  offers.erase(offers.begin());
  EXPECT_TRUE(made_apart(both, offers, words).empty());
}

TEST(PartsOfAVector, ComponentsOfOtherUnitsAreRefused) {
  HistorySeries east;
  east.unit = "m s-1";
  HistorySeries north = east;
  north.unit = "kt";
  EXPECT_THROW(make_of_components(east, north, {}), Error);
}

}  // namespace
}  // namespace slackwater::ingest::offer_test
