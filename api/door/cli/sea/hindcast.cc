#include "api/pipeline/hindcast.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <thread>

#include "api/door/cli/command.h"
#include "api/door/cli/progress.h"
#include "api/door/cli/sea/skill_options.h"
#include "api/pipeline/verify.h"
#include "api/program/paths.h"
#include "api/show/report/skill_csv.h"
#include "api/show/report/skill_json.h"
#include "api/show/report/skill_page.h"
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
  bool simulate_wind = false;
  SkillArguments skill;
};

/// The page of what was just issued: the forecasts are scored again, as the store now holds them.
void write_page(store::Store& store, const Site& site, const HindcastOptions& options,
                const HindcastReport& report, const HindcastArguments& arguments,
                const Context& context) {
  calibration::VerifyOptions verify_options = options.verify;
  verify_options.forecasts = report.forecasts;
  verify_options.traces = true;
  const calibration::Verification result = verify(store, site, verify_options);
  write_skill_page(verify_page(site, result, format_utc(context.now())), arguments.skill.html);
}

void run_hindcast(const HindcastArguments& arguments, const Context& context) {
  expect_skill_files(arguments.skill);
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
  options.verify = verify_options_of(arguments.skill);
  store::Store store = context.open(store::OpenMode::create_or_write);
  HindcastReport report;
  {
    ProgressBar bar("hindcast", context.json);
    report = hindcast(store, site, options, [&](double share) { bar.update(share); });
  }
  if (!arguments.skill.html.empty()) write_page(store, site, options, report, arguments, context);
  if (!arguments.skill.csv.empty()) write_text(arguments.skill.csv, skill_csv(report.skill));
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
    print_skill(report.skill, arguments.skill);
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
  add_skill_options(*command, arguments->skill);
  command->callback([arguments, &context] { run_hindcast(*arguments, context); });
}

}  // namespace slackwater::api
