// `slackwater windows` with a limit whose bound goes by period and heading, and with factors of
// practice for wind.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/api/windows_command.h"
#include "tests/support/contains.h"

namespace slackwater::tests::cli_windows_table_test {
namespace {

/// The same bound everywhere, or one that falls with the period.
std::string table_of(double short_m, double long_m) {
  const std::string row = "[" + std::to_string(short_m) + ", " + std::to_string(long_m) + "]";
  return "{significant_wave_height_m: {peak_period_s: [3, 15], rows: [{from_bow_deg: 0, at_most: " +
         row + "}, {from_bow_deg: 180, at_most: " + row + "}]}}";
}

/// A table of one number everywhere is that number, in each way of answering.
TEST_F(WindowsCommand, ATableOfTheSameBoundEverywhereIsThatBound) {
  const std::string plain = write("plain.yaml", peek("{significant_wave_height_m: 1.5}"));
  const std::string table = write("table.yaml", peek(table_of(1.5, 1.5)));
  for (const Arguments& more :
       {Arguments{}, Arguments{"--alpha", "errors"}, Arguments{"--waves", "forecast"}}) {
    Arguments of_plain{"--task", plain}, of_table{"--task", table};
    of_plain.insert(of_plain.end(), more.begin(), more.end());
    of_table.insert(of_table.end(), more.begin(), more.end());
    const json a = task_of(of_plain), b = task_of(of_table);
    EXPECT_EQ(a.at("windows"), b.at("windows"));
    EXPECT_EQ(a.at("windows_by_alpha"), b.at("windows_by_alpha"));
    EXPECT_EQ(a.at("verdict"), b.at("verdict"));
    ASSERT_EQ(a.at("starts").size(), b.at("starts").size());
    for (std::size_t i = 0; i < a.at("starts").size(); ++i) {
      const json &one = a.at("starts")[i], &other = b.at("starts")[i];
      for (const char* const key : {"futures_held", "probability", "threshold", "alpha"})
        EXPECT_EQ(one.at(key), other.at(key)) << key << " of start " << i;
      EXPECT_EQ(one.at("binding").at("exceeded"), other.at("binding").at("exceeded"));
      EXPECT_EQ(one.at("binding").at("time"), other.at("binding").at("time"));
      EXPECT_NEAR(one.at("binding").at("share").get<double>(),
                  other.at("binding").at("share").get<double>(), 1e-5);
    }
  }
}

TEST_F(WindowsCommand, ATableTellsTheBoundThatAppliesThen) {
  const std::string task = write("falls.yaml", peek(table_of(2.0, 0.8)));
  const json answer = task_of({"--task", task});
  const json& limit = answer.at("limits")[0];
  EXPECT_TRUE(limit.at("bound").is_null()) << "no single number counts";
  EXPECT_EQ(limit.at("table").at("peak_period_s"), json::parse("[3.0, 15.0]"));
  EXPECT_EQ(limit.at("table").at("from_bow_deg"), json::parse("[0.0, 180.0]"));
  EXPECT_EQ(limit.at("table").at("at_most").size(), 2U);
  for (const json& start : answer.at("starts")) {
    const json& then = start.at("binding").at("bound_then");
    ASSERT_FALSE(then.is_null());
    const auto period_s = then.at("peak_period_s").get<double>();
    EXPECT_NEAR(then.at("at_most").get<double>(), 2 - 1.2 * (std::max(period_s, 3.0) - 3) / 12,
                1e-4);
    EXPECT_GE(then.at("from_bow_deg").get<double>(), 0);
    EXPECT_LE(then.at("from_bow_deg").get<double>(), 180);
  }
  const ProgramResult text = run({"--task", task});
  EXPECT_TRUE(contains(text.out, "significant wave height at most 0.8 to 2 m by peak period"))
      << text.out;
  EXPECT_TRUE(contains(text.out, " m at a peak period of ")) << text.out;
  EXPECT_TRUE(contains(text.out, " degrees off the bow at ")) << text.out;
  // Beside it, a limit of one number has no such thing.
  const json plain = task_of({"--task", write("one.yaml", peek(loose_waves))});
  EXPECT_TRUE(plain.at("limits")[0].at("table").is_null());
  EXPECT_TRUE(plain.at("starts")[0].at("binding").at("bound_then").is_null());
}

/// Worse by its table is never better, start by start.
TEST_F(WindowsCommand, AStricterTableNeverAllowsMore) {
  const json loose_task = task_of({"--task", write("wide.yaml", peek(table_of(2.0, 1.2)))});
  const json strict = task_of({"--task", write("strict.yaml", peek(table_of(1.6, 0.9)))});
  std::size_t less = 0;
  for (std::size_t i = 0; i < strict.at("starts").size(); ++i) {
    const auto a = loose_task.at("starts")[i].at("futures_held").get<int>();
    const auto b = strict.at("starts")[i].at("futures_held").get<int>();
    EXPECT_LE(b, a) << i;
    less += b < a ? 1 : 0;
  }
  EXPECT_GT(less, 0U);
}

TEST_F(WindowsCommand, PracticeForWindStandsBesideThatOfWaves) {
  const std::string factors =
      write("wind_alpha.yaml",
            "name: ours\nsource: us\nvariable: wind_speed_10m_m_s\nlimits: [1]\n"
            "rows: [{up_to_h: 72, alpha: [0.01]}]\n");
  const std::string windy = write("windy.yaml", peek("{wind_speed_10m_m_s: 40}"));
  const json without = task_of({"--task", windy});
  EXPECT_TRUE(without.at("windows_by_alpha").is_null());
  EXPECT_TRUE(contains(without.at("no_alpha").get<std::string>(), "no factor for any limit"));
  const json with = answer({"--task", windy, "--alpha", factors});
  EXPECT_EQ(with.at("tasks")[0].at("windows_by_alpha").size(), 0U) << "no wind is below 0.4 m/s";
  const auto rule = with.at("rules").at("alpha").get<std::string>();
  EXPECT_TRUE(contains(rule, "DNV-OS-H101") && contains(rule, "ours (wind at 10 m)")) << rule;
  // Waves alone are judged as before.
  const std::string waves = write("waves_alone.yaml", peek("{significant_wave_height_m: 1.5}"));
  EXPECT_EQ(task_of({"--task", waves, "--alpha", factors}).at("windows_by_alpha"),
            task_of({"--task", waves}).at("windows_by_alpha"));
}

}  // namespace
}  // namespace slackwater::tests::cli_windows_table_test
