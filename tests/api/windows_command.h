#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "tests/support/farm_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests {

/// A look at a pile of an hour and a half, with limits of its own.
inline std::string peek(const std::string& limits, const std::string& more = "") {
  return "id: peek\nname: A peek at a pile\nduration_h: {value: 1.5, per: foundation}\n"
         "min_window_h: 2\n" +
         more + eye_yaml + "    launch_s: 120\n    recovery_s: 120\n    conduct:\n      limits: [" +
         limits + "]\n" + eyes_work_yaml;
}

/// Of the current alone: nobody forecast the wind of these days, nor the waves that it raises.
inline constexpr const char* loose = "{current_speed_m_s: 9}";
inline constexpr const char* never = "{current_speed_m_s: 0.02}";
inline constexpr const char* loose_waves = "{significant_wave_height_m: 19}";

using nlohmann::json;
using Arguments = std::vector<std::string>;

/// One forecast of three days after 2025-03-03, issued the morning after, for all tests.
class WindowsCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<StoreForTests>();
    made_->ingest_days(parse_day("2025-03-01"), 3);
    write_farm("farm.yaml", "");
    const ProgramResult issued = made_->run({"forecast", "--site", path("farm.yaml"), "--at",
                                             "2025-03-04T05:00:00Z", "--out", path("issued.nc")});
    ASSERT_EQ(issued.exit_code, 0) << issued.err;
  }
  static void TearDownTestSuite() { made_.reset(); }
  void SetUp() override { ASSERT_TRUE(made_ && std::filesystem::exists(path("issued.nc"))); }

  static std::string path(const std::string& name) { return made_->path(name); }
  static std::string write(const std::string& name, const std::string& text) {
    return made_->write(name, text);
  }
  /// The site of the test products with a turbine at its point.
  static void write_farm(const std::string& name, const std::string& more) {
    write(name, farm_at_the_site(*made_, more));
  }
  static ProgramResult run(Arguments arguments) {
    arguments.insert(arguments.begin(), {"windows"});
    if (std::find(arguments.begin(), arguments.end(), "--site") == arguments.end())
      arguments.insert(arguments.end(), {"--site", path("farm.yaml")});
    return made_->run(arguments);
  }
  static json answer(Arguments arguments) {
    arguments.emplace_back("--json");
    const ProgramResult result = run(std::move(arguments));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::accept(result.out) ? json::parse(result.out) : json();
  }
  static json task_of(Arguments arguments) { return answer(std::move(arguments)).at("tasks")[0]; }
  static void expect_refused(const Arguments& arguments, int exit_code,
                             const std::vector<std::string>& words) {
    expect_refusal(run(arguments), exit_code, words);
  }

  inline static std::unique_ptr<StoreForTests> made_;
};

}  // namespace slackwater::tests
