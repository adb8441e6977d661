#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/ask/vehicle/read_trial.h"
#include "api/ask/vehicle/vehicle_check.h"
#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/program/paths.h"
#include "api/show/report/assets.h"
#include "api/show/report/html_page.h"
#include "api/show/vehicle/check_json.h"
#include "api/show/vehicle/check_page.h"
#include "api/show/vehicle/check_tables.h"
#include "api/show/vehicle/trial_report.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct CheckArguments {
  std::string model;
  std::filesystem::path html;
  std::filesystem::path against;
  std::vector<std::string> columns;
  std::vector<double> current_m_s;
  std::optional<double> first_depth_m;
  std::vector<std::string> fit;
  int threads = 2;
};

/// A trial beside the vehicle of the file, for people and for programs.
struct BesideTrial {
  std::string text;
  json trial;
  json fit;
};

BesideTrial beside_trial(const CheckArguments& arguments, const VehicleCheck& check) {
  TrialOptions options;
  for (const std::string& column : arguments.columns)
    options.columns.push_back(parse_trial_column(column));
  if (!arguments.current_m_s.empty())
    options.current_m_s = {arguments.current_m_s[0], arguments.current_m_s[1], 0};
  options.first_depth_m = arguments.first_depth_m;
  const twin::Trial trial = read_trial(arguments.against, check.vehicle, options);
  const twin::TrialRun run = twin::replayed(check.vehicle, trial);
  const twin::TrialErrors errors = twin::errors_of(trial, run);
  BesideTrial out{trial_text(trial, run, errors), trial_json(trial, run, errors), nullptr};
  // There small differences grow, whatever the numbers of the file are.
  if (!check.open_loop.is_stable())
    out.text += "\nNobody steers it in a trial: " + twin::words_of(check.open_loop) + ".\n";
  if (arguments.fit.empty()) return out;
  calibration::FitOptions fitting;
  fitting.threads = arguments.threads;
  const TrialFit fit = fit_trial(check.file, data_folder(), trial, arguments.fit, fitting);
  out.text += "\n" + fit_text(fit);
  out.fit = fit_json(fit);
  return out;
}

void expect_a_trial(const CheckArguments& arguments) {
  if (!arguments.against.empty()) return;
  if (!arguments.columns.empty() || !arguments.current_m_s.empty() || arguments.first_depth_m ||
      !arguments.fit.empty())
    throw Error(ErrorKind::usage,
                "found --column, --current, --first-depth or --fit without --against TRIAL.csv, to "
                "which they belong: name the trial");
}

void print_check(const VehicleCheck& check, const BesideTrial& beside) {
  std::printf("%s, %s: %s\n\n%s", check.vehicle.name.c_str(),
              check.file.filename().string().c_str(), check_verdict(check).c_str(),
              tables_text(check_tables(check)).c_str());
  for (const FlownManoeuvre& one : check.manoeuvres)
    std::printf("%s: %s\n", one.name.c_str(), figures_of(one).c_str());
  if (!beside.text.empty()) std::printf("\n%s", beside.text.c_str());
}

void run_check(const CheckArguments& arguments, const Context& context) {
  expect_output("--html", arguments.html, {".html"});
  expect_a_trial(arguments);
  const VehicleCheck check = check_vehicle(arguments.model, data_folder());
  const BesideTrial beside =
      arguments.against.empty() ? BesideTrial{} : beside_trial(arguments, check);
  if (!arguments.html.empty())
    write_page(check_page_html(check, beside.text, report_plotting_library()), arguments.html);
  for (const std::string& warning : check.vehicle.warnings)
    std::fprintf(stderr, "slackwater: warning: %s\n", warning.c_str());
  if (!context.json) return print_check(check, beside);
  json out = check_json(check);
  out["trial"] = beside.trial;
  out["fit"] = beside.fit;
  std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
}

}  // namespace

void add_vehicle(CLI::App& app, Context& context) {
  CLI::App* vehicle = app.add_subcommand("vehicle", "What a vehicle's file makes of it");
  vehicle->require_subcommand(1);
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = vehicle->add_subcommand(
      "check",
      "How a vehicle lies and goes: trim, stability, top speed, endurance, eigenvalues, turning "
      "circle, zig-zags; how far it is from a trial");
  command->add_option("vehicle", arguments->model, "of the catalogue, or a YAML file")->required();
  command->add_option("--against", arguments->against,
                      "a trial as comma-separated values: how far the vehicle of the file is off");
  command->add_option("--column", arguments->columns,
                      "COLUMN=NAME: what a column of the trial is; NAME none leaves it out");
  command
      ->add_option("--current", arguments->current_m_s,
                   "NORTH EAST of the water in the trial, m/s (default: still)")
      ->expected(2);
  command->add_option("--first-depth", arguments->first_depth_m,
                      "m, where a trial began whose down counts from elsewhere");
  command
      ->add_option(
          "--fit", arguments->fit,
          "KEY,KEY...: numbers of the file to be fitted to the trial; the file stays as it "
          "is")
      ->delimiter(',');
  command->add_option("--threads", arguments->threads, "of a fit, 1 to 64 (default 2)")
      ->check(CLI::Range(1, 64));
  command->add_option("--html", arguments->html, "a page of it");
  command->callback([arguments, &context] { run_check(*arguments, context); });
}

}  // namespace slackwater::api
