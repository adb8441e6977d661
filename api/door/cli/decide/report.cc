#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/progress.h"
#include "api/door/cli/windows_options.h"
#include "api/door/morning/make_morning.h"
#include "api/program/paths.h"
#include "api/show/morning/morning_json.h"
#include "api/show/morning/morning_text.h"
#include "api/show/morning/page_pdf.h"
#include "api/show/morning/verified_text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct ReportArguments {
  WindowsArguments windows;
  std::string plan, html, pdf;
  double plan_limit_s = 20;
};

/// "none", a file, or where nothing is said that of the site.
std::filesystem::path plan_of(const ReportArguments& arguments, const Site& site,
                              const Context& context) {
  if (arguments.plan == "none") return {};
  return arguments.plan.empty() ? plan_of_site(site.id, context.store_folder)
                                : std::filesystem::path(arguments.plan);
}

/// Whether it is asked about all tasks on the day after the issue.
bool is_of_the_day(const WindowsArguments& asked) {
  return asked.tasks.empty() && asked.turbines.empty() && asked.from.empty() && asked.to.empty() &&
         asked.forecast.empty();
}

void run_report(const ReportArguments& arguments, const Context& context) {
  expect_output("--html", arguments.html, {".html"});
  expect_output("--pdf", arguments.pdf, {".pdf"});
  const Site site = find_site(arguments.windows.site, site_folders(context.store_folder));
  if (arguments.html.empty() && !is_of_the_day(arguments.windows))
    throw Error(
        ErrorKind::usage,
        "found --task, --turbine, --from, --to or --forecast without --html; the store keeps only "
        "the report of all tasks, so this page needs its own file: add --html FILE.html");
  MakeMorning how;
  how.question.windows = windows_question(arguments.windows, context);
  // Who names a day asks as on its morning.
  if (!how.question.windows.day) how.question.now = context.now();
  how.question.plan = plan_of(arguments, site, context);
  how.question.plan_limit_s = arguments.plan_limit_s;
  how.fly = flights_wanted(arguments.windows);
  how.html = arguments.html;
  how.generated = made_by(context);
  ProgressBar progress("flying " + site.name, context.json);
  how.on_first_page = [&](const MadeMorning& first) {
    if (!context.json)
      std::fprintf(stderr, "%sfirst page: %s; flying what is left open\n",
                   morning_text(first.morning).c_str(), first.html.c_str());
  };
  how.on_progress = [&](double share) { progress.update(share); };
  const MadeMorning made = make_morning(how, site, context.store_folder);
  if (context.json) {
    json out = morning_json(made.morning, made.known.past.entries, verified_text(made.known.past));
    out["page"] = made.html.string();
    std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
    context.answered = true;
  } else {
    std::printf("%sThe page: %s\n", morning_text(made.morning).c_str(), made.html.c_str());
  }
  for (const std::string& note : made.morning.windows.notes)
    std::fprintf(stderr, "slackwater: %s\n", note.c_str());
  if (!arguments.pdf.empty()) print_page(made.html, arguments.pdf);
  if (arguments.windows.verdict_exit)
    context.exit_code = exit_code_of(made.morning.windows.verdict);
}

}  // namespace

void add_report(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand(
      "report", "The morning report: go or no-go for the site's tasks, on one page");
  add_windows_options(*command, arguments->windows);
  command->add_option("--plan", arguments->plan,
                      "PLAN.yaml of the day (default: plans/SITE.yaml in the store, if it is "
                      "there), or: none");
  command
      ->add_option("--plan-time-limit", arguments->plan_limit_s,
                   "of the search for the plan, s (default 20)")
      ->check(CLI::Range(0.01, 86400.0));
  command->add_option(
      "--html", arguments->html,
      "the page (default: reports/SITE/DAY.html in the store, where all tasks of the "
      "site are asked about)");
  command->add_option("--pdf", arguments->pdf, "also print the page as FILE.pdf (with Chromium)");
  command->callback([arguments, &context] { run_report(*arguments, context); });
}

}  // namespace slackwater::api
