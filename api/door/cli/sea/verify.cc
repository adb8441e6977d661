#include "api/pipeline/verify.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "api/door/cli/command.h"
#include "api/door/cli/sea/skill_options.h"
#include "api/program/paths.h"
#include "api/show/report/skill_csv.h"
#include "api/show/report/skill_json.h"
#include "api/show/report/skill_page.h"
#include "api/show/report/verify_page.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

struct VerifyArguments {
  std::string site;
  std::string from;
  std::string to;
  SkillArguments skill;
};

void run_verify(const VerifyArguments& arguments, const Context& context) {
  expect_skill_files(arguments.skill);
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  calibration::VerifyOptions options = verify_options_of(arguments.skill);
  options.traces = !arguments.skill.html.empty();
  if (!arguments.from.empty()) options.from = option_value("--from", arguments.from, parse_day);
  if (!arguments.to.empty()) options.to = option_value("--to", arguments.to, parse_day);
  store::Store store = context.open(store::OpenMode::read_only);
  const calibration::Verification result = verify(store, site, options);
  for (const std::string& line : result.unscored)
    std::fprintf(stderr, "not scored: %s\n", line.c_str());
  if (!arguments.skill.html.empty())
    write_skill_page(verify_page(site, result, format_utc(context.now())), arguments.skill.html);
  if (!arguments.skill.csv.empty()) write_text(arguments.skill.csv, skill_csv(result.entries));
  if (context.json) {
    std::printf("%s\n", skill_json(result.entries).c_str());
  } else if (result.entries.empty()) {
    std::printf("%s: the truth of the issued forecasts is not in the store yet\n",
                site.name.c_str());
  } else {
    std::printf("%s: skill of issued forecasts\n", site.name.c_str());
    print_skill(result.entries, arguments.skill);
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
  add_skill_options(*command, arguments->skill);
  command->callback([arguments, &context] { run_verify(*arguments, context); });
}

}  // namespace slackwater::api
