#include "api/show/traffic/traffic_words.h"

#include <gtest/gtest.h>

namespace slackwater::tests::traffic_words_test {
namespace {

using api::approach_words;
using api::Passing;

TEST(TrafficWords, SayWhetherAVesselComesOrIsPast) {
  EXPECT_EQ(approach_words({"A01", Passing::closing, 210, 720}), "passes 210 m from A01 in 12 min");
  EXPECT_EQ(approach_words({"", Passing::past, 210, -40}),
            "goes away, past at 210 m from the site 40 s ago");
  EXPECT_EQ(approach_words({"A01", Passing::still, 210, 0}), "lies 210 m from A01");
  EXPECT_EQ(approach_words({"", Passing::closing, 12'340, 7500}),
            "passes 12.3 km from the site in 2 h 5 min");
}

}  // namespace
}  // namespace slackwater::tests::traffic_words_test
