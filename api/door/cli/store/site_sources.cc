#include "api/door/cli/store/site_sources.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/pipeline/load_site_data.h"
#include "api/pipeline/sources_json.h"
#include "api/program/paths.h"
#include "calibration/day/sources.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using std::chrono::days;

struct SourcesArguments {
  std::string site;
  std::string day;
  std::string horizon = "72h";
  std::string wind = "best";
};

void run_site_sources(const SourcesArguments& arguments, const Context& context) {
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  calibration::ForecastOptions options;
  options.issued = context.now();
  options.seen_by = options.issued;
  options.horizon = horizon_from(arguments.horizon);
  options.wind = option_value("--wind", arguments.wind, wind_policy_from);
  if (!arguments.day.empty()) options.day = option_value("--day", arguments.day, parse_day);
  store::Store store = context.open(store::OpenMode::read_only);
  const SiteData data = load_site_data(store, site, options);
  const calibration::Inputs inputs = calibration::inputs_of(data, options);
  if (context.json) {
    const json out = {{"site", site.id},
                      {"issued", format_utc(options.issued)},
                      {"day", format_day(inputs.day)},
                      {"sources", sources_json(inputs.sources)}};
    std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
    return;
  }
  std::printf("%s at %s, day D %s\n", site.name.c_str(), format_utc(options.issued).c_str(),
              format_day(inputs.day).c_str());
  for (const SourceUse& use : inputs.sources) std::printf("  %s\n", text_of(use).c_str());
  if (inputs.sources.empty()) std::printf("  the store holds nothing that a forecast could use\n");
}

}  // namespace

void add_site_sources(CLI::App& site, Context& context) {
  auto arguments = std::make_shared<SourcesArguments>();
  CLI::App* command = site.add_subcommand(
      "sources", "Whose currents, wind and waves a forecast would use, and why, before it is made");
  command->add_option("site", arguments->site, "id, or path of the YAML file")->required();
  command->add_option("--at", context.at, "issue time (default: the clock)");
  command->add_option("--day", arguments->day, "day D (default: the newest whole day)");
  command->add_option("--horizon", arguments->horizon, "beyond the end of D (default 72h)");
  command->add_option("--wind", arguments->wind, "best | forecast | persist (default best)");
  command->callback([arguments, &context] { run_site_sources(*arguments, context); });
}

}  // namespace slackwater::api
