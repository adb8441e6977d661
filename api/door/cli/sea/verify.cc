#include "api/pipeline/verify.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <thread>

#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/sea/skill_print.h"
#include "api/program/paths.h"
#include "api/show/report/skill_csv.h"
#include "api/show/report/skill_json.h"
#include "api/show/report/skill_page.h"
#include "api/show/report/skill_table.h"
#include "api/show/report/verify_page.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

struct VerifyArguments {
  std::string site;
  std::string from;
  std::string to;
  std::string bands;
  std::string levels = "native";
  std::string html;
  std::string csv;
  bool per_column = false;
  bool by_hour = false;
  bool full = false;
};

void run_verify(const VerifyArguments& arguments, const Context& context) {
  expect_output("--html", arguments.html, {".html"});
  expect_output("--csv", arguments.csv, {".csv"});
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  calibration::VerifyOptions options;
  if (!arguments.from.empty()) options.from = option_value("--from", arguments.from, parse_day);
  if (!arguments.to.empty()) options.to = option_value("--to", arguments.to, parse_day);
  if (!arguments.bands.empty()) options.bands = calibration::parse_bands(arguments.bands);
  options.per_column = arguments.per_column;
  options.traces = !arguments.html.empty();
  options.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  store::Store store = context.open(store::OpenMode::read_only);
  const calibration::Verification result = verify(store, site, options);
  for (const std::string& line : result.unscored)
    std::fprintf(stderr, "not scored: %s\n", line.c_str());
  if (!arguments.html.empty())
    write_skill_page(verify_page(site, result, format_utc(context.now())), arguments.html);
  if (!arguments.csv.empty()) write_text(arguments.csv, skill_csv(result.entries));
  if (context.json) {
    std::printf("%s\n", skill_json(result.entries).c_str());
  } else if (result.entries.empty()) {
    std::printf("%s: the truth of the issued forecasts is not in the store yet\n",
                site.name.c_str());
  } else {
    std::printf("%s: skill of issued forecasts\n", site.name.c_str());
    print_skill(result.entries, arguments.full);
    if (arguments.by_hour) std::printf("%s", hourly_table(result.entries).c_str());
  }
}

}  // namespace

void add_verify(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* command =
      app.add_subcommand("verify", "Skill of issued forecasts by lead, depth and baseline");
  command->add_option("--site", arguments->site, "id of data/sites, or path of a site's YAML file")
      ->required();
  command->add_option("--from", arguments->from, "first day D");
  command->add_option("--to", arguments->to, "last day D");
  command->add_option("--bands", arguments->bands, "edges of depth bands in metres, e.g. 0,150");
  command->add_option("--levels", arguments->levels, "native: score on the truth's own levels")
      ->check(CLI::IsMember({"native"}));
  command->add_option("--html", arguments->html,
                      "write a page of plots: skill by lead, reliability, hodographs, misfit");
  command->add_option("--csv", arguments->csv, "the scores as FILE.csv, a row each");
  command->add_flag("--full", arguments->full,
                    "print every depth band, day of lead, wind policy, wind and waves");
  command->add_flag("--by-hour", arguments->by_hour,
                    "also print the error of each hour of lead (always in --json and --html)");
  command->add_flag("--per-column", arguments->per_column, "also score each column of the site");
  command->callback([arguments, &context] { run_verify(*arguments, context); });
}

}  // namespace slackwater::api
