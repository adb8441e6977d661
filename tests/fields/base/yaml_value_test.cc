// What is written as YAML is read as the value that it was.
#include "fields/base/yaml_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "fields/base/config.h"

namespace slackwater::yaml_value_test {
namespace {

/// Through the text of a file.
YamlValue again(const YamlValue& value) {
  return Config::parse(yaml_of(YamlValue().put("wanted", value)), "again.yaml").value("wanted");
}

TEST(YamlValue, AWordIsThatWordHoweverOddItLooks) {
  for (const std::string word : {"a01",
                                 "A: 1, {b} #c",
                                 "it's \"here\"",
                                 "C:\\x\ty",
                                 "",
                                 "yes",
                                 "null",
                                 "~",
                                 "näher",
                                 "05",
                                 "5.0",
                                 "-",
                                 "- a",
                                 "a\nb: c",
                                 "#",
                                 "2025-06-02T06:00:00Z",
                                 "&a",
                                 "*a",
                                 "!a",
                                 "%"}) {
    EXPECT_EQ(again(word), YamlValue(word)) << word;
    EXPECT_EQ(Config::parse(yaml_of(YamlValue().put(word, 1.0)), "f").number(word, {}), 1) << word;
    EXPECT_EQ(Config::parse("{a: " + quoted_yaml(word) + ", b: 1}", "f").text("a"), word);
  }
}

TEST(YamlValue, ANumberComesBackToTheBit) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t bits = random();
    double number = 0;
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isfinite(number) || (number != 0 && std::abs(number) < 1e-300)) continue;
    EXPECT_EQ(Config::parse(yaml_of(YamlValue().put("n", number)), "f").number("n", {}), number);
    EXPECT_EQ(Config::of(YamlValue().put("n", number), "f").number("n", {}), number);
  }
  EXPECT_EQ(yaml_of(YamlValue().put("n", 600.0)), "n: 600\n");
  EXPECT_EQ(yaml_of(YamlValue().put("n", 0.1)), "n: 0.1\n");
}

TEST(YamlValue, ListsAndMappingsComeBackWhateverTheirDepth) {
  YamlValue value = std::vector<YamlValue>{};
  EXPECT_EQ(again(value), value);
  EXPECT_EQ(again(YamlValue()), YamlValue());
  for (int depth = 0; depth < 12; ++depth) {
    value = std::vector<YamlValue>{value, YamlValue().put("a b", value).put("c", 1.0), "word"};
    if (depth % 2 == 0) value = YamlValue().put("list", value).put("empty", YamlValue());
    if (depth < 5) {
      EXPECT_EQ(again(value), value) << yaml_of(value);
      EXPECT_EQ(Config::parse(in_line(YamlValue().put("x", value)), "f").value("x"), value);
    }
  }
}

TEST(YamlValue, OfAFileIsAllThatStandsThereAndCountsAsRead) {
  const Config config =
      Config::parse("wanted:\n  text: 'it: is'\n  below: [{a: yes, b: ''}, {a: 1e-3}]\n", "f");
  const YamlValue value = config.value();
  config.expect_all_read();
  const Config read = Config::of(value, "again").child("wanted");
  EXPECT_EQ(read.text("text"), "it: is");
  const auto below = read.children("below");
  ASSERT_EQ(below.size(), 2U);
  EXPECT_EQ(below[0].text("b"), "");
  EXPECT_DOUBLE_EQ(below[1].number("a", {}), 1e-3);
}

}  // namespace
}  // namespace slackwater::yaml_value_test
