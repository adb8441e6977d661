#include "api/door/cli/sea/skill_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <thread>

#include "api/door/cli/output_file.h"
#include "api/show/report/skill_table.h"
#include "api/show/report/verdict_text.h"

namespace slackwater::api {

void add_skill_options(CLI::App& command, SkillArguments& arguments) {
  command.add_option("--bands", arguments.bands, "edges of depth bands in metres, e.g. 0,150");
  command.add_option("--levels", arguments.levels, "native: score on the truth's own levels")
      ->check(CLI::IsMember({"native"}));
  command.add_option("--html", arguments.html,
                     "write a page of plots: skill by lead, reliability, hodographs, misfit");
  command.add_option("--csv", arguments.csv, "the scores as FILE.csv, a row each");
  command.add_flag("--full", arguments.full,
                   "print every depth band, day of lead, wind policy, wind and waves");
  command.add_flag("--by-hour", arguments.by_hour,
                   "also print the error of each hour of lead (always in --json and --html)");
  command.add_flag("--per-column", arguments.per_column, "also score each column of the site");
}

void expect_skill_files(const SkillArguments& arguments) {
  expect_output("--html", arguments.html, {".html"});
  expect_output("--csv", arguments.csv, {".csv"});
}

calibration::VerifyOptions verify_options_of(const SkillArguments& arguments) {
  calibration::VerifyOptions options;
  if (!arguments.bands.empty()) options.bands = calibration::parse_bands(arguments.bands);
  options.per_column = arguments.per_column;
  options.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return options;
}

namespace {

void print_entries(const std::vector<calibration::SkillEntry>& entries, bool full) {
  if (full) {
    std::printf("%s%s", verdict_lines(entries).c_str(), skill_table(entries).c_str());
    return;
  }
  const auto verdict = calibration::main_verdict(entries);
  if (!verdict) {  // scores of wind and waves alone
    std::printf("%s", skill_table(entries).c_str());
    return;
  }
  std::printf("%s %s\n%s\n", verdict_text(*verdict).c_str(), outcome_text(*verdict).c_str(),
              short_skill_table(entries, verdict->wind, verdict->origin).c_str());
  const auto is_other = [&](const calibration::SkillEntry& e) {
    return e.origin != verdict->origin;
  };
  if (std::any_of(entries.begin(), entries.end(), is_other))
    std::printf("Days that were not forecast then but hindcast are scored apart.\n");
  std::printf("`--full` prints every depth band, lead and wind policy, wind and waves.\n");
}

}  // namespace

void print_skill(const std::vector<calibration::SkillEntry>& entries,
                 const SkillArguments& arguments) {
  print_entries(entries, arguments.full);
  if (arguments.by_hour) std::printf("%s", hourly_table(entries).c_str());
}

}  // namespace slackwater::api
