#pragma once
#include <string>
#include <vector>

#include "api/door/cli/command.h"
#include "calibration/verify/skill_entry.h"

namespace slackwater::api {

/// What is scored and how it is told, as the options of `hindcast` and `verify` say.
struct SkillArguments {
  std::string bands;
  std::string levels = "native";
  std::string html;
  std::string csv;
  bool per_column = false;
  bool by_hour = false;
  bool full = false;
};

void add_skill_options(CLI::App& command, SkillArguments& arguments);

/// @throws Error(usage) for a file that cannot be one of its kind
void expect_skill_files(const SkillArguments& arguments);

/// On all processors. @throws Error for bands that cannot be
[[nodiscard]] calibration::VerifyOptions verify_options_of(const SkillArguments& arguments);

/// Prints skill for people: one verdict and one table, with `full` every verdict and table, with
/// `by_hour` a table of the hours.
void print_skill(const std::vector<calibration::SkillEntry>& entries,
                 const SkillArguments& arguments);

}  // namespace slackwater::api
