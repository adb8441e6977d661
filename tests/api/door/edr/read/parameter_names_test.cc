#include "api/door/edr/read/parameter_names.h"

#include <gtest/gtest.h>

#include "tests/api/door/edr/refusal.h"

namespace slackwater::api::edr::parameter_names_test {
namespace {

using tests::contains;
using tests::refusal_of;

const std::vector<std::string> known{"eastward_sea_water_velocity", "northward_sea_water_velocity",
                                     "eastward_sea_water_velocity_p10"};

TEST(ParameterNames, KeepTheOrderAskedAndNoneTwice) {
  using Places = std::vector<std::size_t>;
  EXPECT_EQ(
      parse_parameter_names("northward_sea_water_velocity, eastward_sea_water_velocity", known),
      (Places{1, 0}));
  EXPECT_EQ(parse_parameter_names("eastward_sea_water_velocity_p10,"
                                  "eastward_sea_water_velocity_p10",
                                  known),
            (Places{2}));
}

TEST(ParameterNames, AnUnknownNameIsMetWithTheNearest) {
  const auto refusal = [](std::string_view text) {
    return refusal_of([&] { (void)parse_parameter_names(text, known); });
  };
  EXPECT_TRUE(contains(refusal("eastward_sea_water_velocty"),
                       "did you mean 'eastward_sea_water_velocity'?"));
  EXPECT_TRUE(contains(refusal("eastward_sea_water_velocity,x"), "found 'x'"));
  EXPECT_TRUE(contains(refusal("x"), "eastward_sea_water_velocity, northward_sea_water_velocity"));
  for (const char* text :
       {"", ",", "eastward_sea_water_velocity,", "EASTWARD_SEA_WATER_VELOCITY"}) {
    EXPECT_TRUE(contains(refusal(text), "parameter-name: found '")) << text;
  }
  EXPECT_TRUE(contains(refusal(std::string(60'000, 'e')), "parameters of this collection"));
  EXPECT_TRUE(contains(refusal(std::string(60'000, ',')), "at most 1000 names"));
  EXPECT_TRUE(contains(refusal(std::string(100'000, 'x')), "bytes"));
}

}  // namespace
}  // namespace slackwater::api::edr::parameter_names_test
