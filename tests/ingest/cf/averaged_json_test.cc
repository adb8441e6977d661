#include "ingest/cf/forecast/averaged_json.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"

namespace slackwater::ingest::averaged_json_test {
namespace {

using std::chrono::hours;

TEST(AveragedJson, ReadsBackWhatItWrote) {
  AveragedCurrents known{hours(24), false, 0.1 + 0.2, "NWSHELF_ANALYSISFORECAST_PHY_004_013"};
  AveragedCurrents unknown{hours(6), true, std::nullopt, ""};
  for (const AveragedCurrents& averaged : {known, unknown})
    EXPECT_EQ(averaged_from(averaged_json(averaged)), averaged);
  EXPECT_EQ(averaged_json(std::nullopt), "null");
  EXPECT_EQ(averaged_from("null"), std::nullopt);
}

TEST(AveragedJson, WhatIsNoSuchObjectIsRefusedNotPassedOver) {
  for (const char* text :
       {"", "24", "{}", "[]", R"({"mean_h": "day"})", R"({"mean_h": -1})",
        R"({"mean_h": 24, "holds_part_of_the_tide": 1, "unresolved_tide_m_s": 0})"}) {
    try {
      (void)averaged_from(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input) << text;
    }
  }
}

}  // namespace
}  // namespace slackwater::ingest::averaged_json_test
