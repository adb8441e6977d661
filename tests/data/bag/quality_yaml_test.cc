#include "data/bag/quality_yaml.h"

#include <gtest/gtest.h>

namespace slackwater::bag::tests::quality_yaml_test {
namespace {

TEST(QualityYaml, ComesBackAsItWas) {
  for (const bool is_reliable : {true, false})
    for (const bool is_transient_local : {true, false}) {
      const Quality quality{is_reliable, is_transient_local, 42};
      EXPECT_EQ(quality_of(yaml_of(quality)), quality);
    }
}

TEST(QualityYaml, IsReadWithNamesToo) {
  // As Jazzy and later write it.
  EXPECT_EQ(quality_of("- history: keep_last\n  depth: 7\n  reliability: best_effort\n"
                       "  durability: transient_local\n"),
            (Quality{false, true, 7}));
  EXPECT_EQ(quality_of("[{depth: 3, durability: 2, reliability: 1}]"), (Quality{true, false, 3}));
}

TEST(QualityYaml, WhatMakesNoSenseIsTheDefault) {
  for (const char* yaml : {"", "]", "- 3", "x: y", "- depth: many", "\"\n\n"})
    EXPECT_EQ(quality_of(yaml), Quality()) << yaml;
}

}  // namespace
}  // namespace slackwater::bag::tests::quality_yaml_test
