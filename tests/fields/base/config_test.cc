#include "fields/base/config.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"

namespace slackwater::config_test {
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
  // In what is handed on unread too.
  EXPECT_NE(message_of([] {
              static_cast<void>(Config::parse("a: [{b: 1, b: 2}]\n", "f").value("a"));
            }).find("found 'b' twice"),
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

Config merged_for_tests() {
  const Config task = Config::parse("a: 1\nlimits: {b: 2}\nsub: {e: 9}\n", "task.yaml");
  const Config mission = Config::parse("\nsub: {c: 7}\nd: 4\nmodel: x\n", "mission.yaml");
  return mission.merged_over(task, {"model"});
}

TEST(StrictConfig, OneMappingGoesBeforeAnotherKeyByKey) {
  const Config merged = merged_for_tests();
  EXPECT_EQ(merged.number("a", {}), 1);
  EXPECT_EQ(merged.child("sub").number("c", {}), 7);
  EXPECT_FALSE(merged.child("sub").has("e"));
  EXPECT_EQ(merged.child("limits").number("b", {}), 2);
  EXPECT_FALSE(merged.has("model"));
  EXPECT_NE(message_of([&] { merged.expect_all_read(); }).find("mission.yaml:3: unknown key 'd'"),
            std::string::npos);
}

TEST(StrictConfig, WhatIsMergedIsRefusedWhereItStands) {
  const Config merged = merged_for_tests();
  EXPECT_NE(message_of([&] {
              (void)merged.number("a", {5, 6});
            }).find("task.yaml:1: a: found 1"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              (void)merged.number("d", {5, 6});
            }).find("mission.yaml:3: d: found"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              (void)merged.child("limits").number("b", {5, 6});
            }).find("task.yaml:2: limits.b: found 2"),
            std::string::npos);
  EXPECT_NE(message_of([&] { merged.refuse("limits", "no"); }).find("task.yaml:2: limits: no"),
            std::string::npos);
}

TEST(NearestWord, FindsTheSlipOfAFinger) {
  EXPECT_EQ(nearest_word("lattitude_deg", {"longitude_deg", "latitude_deg"}), "latitude_deg");
  EXPECT_EQ(nearest_word("xyz", {"longitude_deg", "latitude_deg"}), std::nullopt);
}

}  // namespace
}  // namespace slackwater::config_test
