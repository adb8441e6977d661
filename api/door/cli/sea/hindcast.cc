#include "api/pipeline/hindcast.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <thread>

#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/progress.h"
#include "api/door/cli/sea/skill_print.h"
#include "api/pipeline/verify.h"
#include "api/program/paths.h"
#include "api/show/report/skill_csv.h"
#include "api/show/report/skill_json.h"
#include "api/show/report/skill_page.h"
#include "api/show/report/skill_table.h"
#include "api/show/report/verify_page.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

struct HindcastArguments {
  std::string site;
  std::string from;
  std::string to;
  std::string wind = "best";
  std::string latency = "0h";
  std::string horizon = "72h";
  std::string bands;
  std::string levels = "native";
  std::string html;
  std::string csv;
  bool per_column = false;
  bool simulate_wind = false;
  bool by_hour = false;
  bool full = false;
};

/// The page of what was just issued: the forecasts are scored again, as the store now holds them.
void write_page(store::Store& store, const Site& site, const HindcastOptions& options,
                const HindcastReport& report, const HindcastArguments& arguments,
                const Context& context) {
  calibration::VerifyOptions verify_options = options.verify;
  verify_options.forecasts = report.forecasts;
  verify_options.traces = true;
  const calibration::Verification result = verify(store, site, verify_options);
  write_skill_page(verify_page(site, result, format_utc(context.now())), arguments.html);
}

void run_hindcast(const HindcastArguments& arguments, const Context& context) {
  expect_output("--html", arguments.html, {".html"});
  expect_output("--csv", arguments.csv, {".csv"});
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  HindcastOptions options;
  options.from = option_value("--from", arguments.from, parse_day);
  options.to = option_value("--to", arguments.to, parse_day);
  options.simulate_wind = arguments.simulate_wind;
  options.wind = option_value("--wind", arguments.wind, wind_policy_from);
  if (options.simulate_wind && options.wind != WindPolicy::forecast) {
    throw Error(ErrorKind::usage,
                "found --simulate-wind with --wind " + arguments.wind +
                    "; it works only with --wind forecast: add that, or leave it out");
  }
  options.latency = option_value("--latency", arguments.latency, parse_duration);
  options.horizon = horizon_from(arguments.horizon);
  options.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  if (!arguments.bands.empty()) options.verify.bands = calibration::parse_bands(arguments.bands);
  options.verify.per_column = arguments.per_column;
  options.verify.threads = options.threads;
  store::Store store = context.open(store::OpenMode::create_or_write);
  HindcastReport report;
  {
    ProgressBar bar("hindcast", context.json);
    report = hindcast(store, site, options, [&](double share) { bar.update(share); });
  }
  if (!arguments.html.empty()) write_page(store, site, options, report, arguments, context);
  if (!arguments.csv.empty()) write_text(arguments.csv, skill_csv(report.skill));
  if (context.json) {
    std::printf("%s\n", skill_json(report.skill).c_str());
  } else {
    std::printf("%s: %zu forecasts issued as of their days\n", site.name.c_str(),
                report.forecasts.size());
    if (report.simulated_winds > 0) {
      std::printf(
          "wind simulated for %zu of them: no wind run published by their issue time is stored, so "
          "the analysis with a random forecast error is used\n",
          report.simulated_winds);
    }
    print_skill(report.skill, arguments.full);
    if (arguments.by_hour) std::printf("%s", hourly_table(report.skill).c_str());
  }
  for (const std::string& line : report.skipped) std::fprintf(stderr, "skipped %s\n", line.c_str());
  for (const std::string& line : report.unscored)
    std::fprintf(stderr, "not scored: %s\n", line.c_str());
}

}  // namespace

void add_hindcast(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<HindcastArguments>();
  CLI::App* command =
      app.add_subcommand("hindcast", "The daily job over a past period as if live, then its skill");
  command->add_option("--site", arguments->site, "id of data/sites, or path of a site's YAML file")
      ->required();
  command->add_option("--from", arguments->from, "first day D")->required();
  command->add_option("--to", arguments->to, "last day D")->required();
  command->add_option("--wind", arguments->wind, "best | forecast | persist (default best)");
  command->add_flag("--simulate-wind", arguments->simulate_wind,
                    "with --wind forecast, where no wind run published by then is stored: use the "
                    "analysis with a random forecast error, marked as simulated");
  command->add_option("--latency", arguments->latency,
                      "how long after its end the data of a day arrive (default 0h)");
  command->add_option("--horizon", arguments->horizon, "how far beyond the end of D (default 72h)");
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
  command->callback([arguments, &context] { run_hindcast(*arguments, context); });
}

}  // namespace slackwater::api
