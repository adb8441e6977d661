#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/ask/vehicle/vehicle_check.h"
#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/program/paths.h"
#include "api/show/report/assets.h"
#include "api/show/report/html_page.h"
#include "api/show/vehicle/check_json.h"
#include "api/show/vehicle/check_page.h"
#include "api/show/vehicle/check_tables.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

struct CheckArguments {
  std::string model;
  std::filesystem::path html;
};

void run_check(const CheckArguments& arguments, const Context& context) {
  expect_output("--html", arguments.html, {".html"});
  const VehicleCheck check = check_vehicle(arguments.model, data_folder());
  if (!arguments.html.empty())
    write_page(check_page_html(check, report_plotting_library()), arguments.html);
  for (const std::string& warning : check.vehicle.warnings)
    std::fprintf(stderr, "slackwater: warning: %s\n", warning.c_str());
  if (context.json) {
    std::printf(
        "%s\n",
        check_json(check).dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return;
  }
  std::printf("%s, %s: %s\n\n%s", check.vehicle.name.c_str(),
              check.file.filename().string().c_str(), check_verdict(check).c_str(),
              tables_text(check_tables(check)).c_str());
  for (const FlownManoeuvre& one : check.manoeuvres)
    std::printf("%s: %s\n", one.name.c_str(), figures_of(one).c_str());
}

}  // namespace

void add_vehicle(CLI::App& app, Context& context) {
  CLI::App* vehicle = app.add_subcommand("vehicle", "What a vehicle's file makes of it");
  vehicle->require_subcommand(1);
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = vehicle->add_subcommand(
      "check",
      "How a vehicle lies and goes: trim, stability, top speed, endurance, eigenvalues, turning "
      "circle, zig-zags");
  command->add_option("vehicle", arguments->model, "of the catalogue, or a YAML file")->required();
  command->add_option("--html", arguments->html, "a page of it");
  command->callback([arguments, &context] { run_check(*arguments, context); });
}

}  // namespace slackwater::api
