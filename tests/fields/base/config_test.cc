#include "fields/base/config.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"

namespace slackwater {
namespace {

std::string message_of(const auto& work) {
  try {
    work();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    return error.message();
  }
  return "no error";
}

TEST(StrictConfig, AnUnknownKeyNamesItsLineAndTheNearestKnownKey) {
  const Config config = Config::parse("latitude_deg: 54\nlongitud_deg: 7\n", "site.yaml");
  static_cast<void>(config.number("latitude_deg", {-90, 90}));
  static_cast<void>(config.optional_number("longitude_deg", {-180, 360}));
  const std::string message = message_of([&] { config.expect_all_read(); });
  EXPECT_NE(message.find("site.yaml:2:"), std::string::npos) << message;
  EXPECT_NE(message.find("'longitud_deg'"), std::string::npos) << message;
  EXPECT_NE(message.find("'longitude_deg'"), std::string::npos) << message;
}

TEST(StrictConfig, AnUnknownKeyOfAChildIsSeenFromItsParent) {
  const Config config = Config::parse("columns:\n  - {latitude_deg: 1, depht: 3}\n", "f");
  for (const Config& child : config.children("columns"))
    static_cast<void>(child.number("latitude_deg", {-90, 90}));
  EXPECT_NE(message_of([&] { config.expect_all_read(); }).find("columns[0].depht"),
            std::string::npos);
}

TEST(StrictConfig, ValuesOutsideTheirRangeAreRefusedWithBoth) {
  const Config config = Config::parse("latitude_deg: 470\n", "f");
  const std::string message = message_of([&] {
    static_cast<void>(config.number("latitude_deg", {-90, 90}));
  });
  EXPECT_NE(message.find("470"), std::string::npos);
  EXPECT_NE(message.find("-90 to 90"), std::string::npos) << message;
}

TEST(StrictConfig, NotANumberIsOutsideEveryRange) {
  const Config config = Config::parse("a: .nan\nb: .inf\nc: twelve\nd: [1]\n", "f");
  for (const char* const key : {"a", "b", "c", "d"}) {
    EXPECT_NE(message_of([&] {
                static_cast<void>(config.number(key, {0, 10}));
              }),
              "no error")
        << key;
  }
}

TEST(StrictConfig, MissingDoubledAndMisshapenKeysAreRefused) {
  EXPECT_NE(
      message_of([] { static_cast<void>(Config::parse("a: 1\n", "f").text("b")); }).find("missing"),
      std::string::npos);
  EXPECT_NE(message_of([] { static_cast<void>(Config::parse("a: 1\na: 2\n", "f")); }).find("twice"),
            std::string::npos);
  EXPECT_NE(message_of([] { static_cast<void>(Config::parse("- 1\n", "f")); }).find("mapping"),
            std::string::npos);
  EXPECT_NE(message_of([] { static_cast<void>(Config::parse("a: [1\n", "f")); }).find("YAML"),
            std::string::npos);
  EXPECT_NE(message_of([] {
              static_cast<void>(Config::parse("a: 1.5\n", "f").integer("a", 0, 9));
            }).find("whole"),
            std::string::npos);
}

TEST(StrictConfig, DeepNestingIsRefusedBeforeTheParserSeesIt) {
  EXPECT_NE(message_of([] {
              static_cast<void>(Config::parse("a: " + std::string(100000, '['), "f"));
            }).find("64 levels"),
            std::string::npos);
}

TEST(FlowYaml, OnOneLineIsReadBackAsWhatItWas) {
  std::string many = "[0";
  for (int i = 1; i < 400; ++i) many += ", " + std::to_string(i * 0.125);
  const std::string yaml = "wanted:\n  text: 'it: is, {odd} #5 \"here\"'\n  many: " + many +
                           "]\n  below:\n    - {a: yes, b: ''}\n    - {a: 1e-3}\nother: 1\n";
  const Config config = Config::parse(yaml, "test.yaml");
  const std::string line = config.flow_yaml("wanted");
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  const Config again = Config::parse("wanted: " + line + "\n", "again.yaml").child("wanted");
  EXPECT_EQ(again.text("text"), "it: is, {odd} #5 \"here\"");
  const std::vector<double> numbers = again.numbers("many", {});
  ASSERT_EQ(numbers.size(), 400U);
  EXPECT_DOUBLE_EQ(numbers.back(), 399 * 0.125);
  const auto below = again.children("below");
  ASSERT_EQ(below.size(), 2U);
  EXPECT_EQ(below[0].text("b"), "");
  EXPECT_DOUBLE_EQ(below[1].number("a", {}), 1e-3);
  // All of it counts as read, the rest does not.
  EXPECT_NE(message_of([&] { config.expect_all_read(); }).find("unknown key 'other'"),
            std::string::npos);
}

TEST(QuotedYaml, IsReadBackAsTheTextItWas) {
  for (const std::string text :
       {"a01", "A: 1, {b} #c", "it's \"here\"", "C:\\x\ty", "", "yes", "näher"}) {
    const Config read = Config::parse("{a: " + quoted_yaml(text) + ", b: 1}", "test.yaml");
    EXPECT_EQ(read.text("a"), text);
  }
}

TEST(NearestWord, FindsTheSlipOfAFinger) {
  EXPECT_EQ(nearest_word("lattitude_deg", {"longitude_deg", "latitude_deg"}), "latitude_deg");
  EXPECT_EQ(nearest_word("xyz", {"longitude_deg", "latitude_deg"}), std::nullopt);
}

}  // namespace
}  // namespace slackwater
