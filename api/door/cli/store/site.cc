#include "fields/site/site.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/store/site_init.h"
#include "api/door/cli/store/site_sources.h"
#include "api/pipeline/load_site_data.h"
#include "api/program/paths.h"
#include "calibration/day/daily_forecast.h"
#include "calibration/day/leading_day.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using std::chrono::days;

/// Reads the site as every command does, then says what the store offers it.
void run_site_check(const std::string& name, const Context& context) {
  const Site site = find_site(name, site_folders(context.store_folder));
  json out = {{"id", site.id},
              {"name", site.name},
              {"latitude_deg", site.point.latitude_deg()},
              {"longitude_deg", site.point.longitude_deg()},
              {"valid", true}};
  if (!context.json) {
    std::printf("%s (%s): %.4f N %.4f E\n", site.name.c_str(), site.id.c_str(),
                site.point.latitude_deg(), site.point.longitude_deg());
  }
  std::string data_line =
      "no store at " + context.store_folder.string() + ": nothing to compare with";
  out["store"] = nullptr;
  if (std::filesystem::exists(context.store_folder)) {
    store::Store store = context.open(store::OpenMode::read_only);
    const UtcTime now = context.now();
    try {
      const SiteData data =
          load_site_data(store, site, now - calibration::history_wanted, now + days(15));
      const auto day = calibration::leading_day(data, {now});
      const ColumnData& column = data.columns.front();
      out["store"] = {{"columns", data.columns.size()},
                      {"dry_columns", data.dry_columns},
                      {"water_depth_m", column.water_depth.depth_m},
                      {"water_depth_source", column.water_depth.source},
                      {"newest_whole_day", day ? json(format_day(day->day)) : json(nullptr)},
                      {"has_wind", !column.wind.pieces.empty()},
                      {"has_waves", !column.significant_height.pieces.empty()}};
      data_line = formatted(
          "{} columns ({} dry), {:.1f} m of water ({}), newest whole day of currents {}, "
          "wind {}, waves {}",
          data.columns.size(), data.dry_columns, column.water_depth.depth_m,
          column.water_depth.source, day ? format_day(day->day) : "none",
          column.wind.pieces.empty() ? "no" : "yes",
          column.significant_height.pieces.empty() ? "no" : "yes");
    } catch (const Error& problem) {
      if (problem.kind() != ErrorKind::not_found) throw;
      out["store_problem"] = problem.message();
      data_line = problem.message();
    }
  }
  std::printf("%s\n", context.json ? out.dump(2).c_str() : data_line.c_str());
}

/// A site's file in the folders, as `find_site` finds it.
std::filesystem::path file_of(const std::string& id,
                              const std::vector<std::filesystem::path>& folders) {
  for (const auto& folder : folders)
    if (auto file = folder / (id + ".yaml"); std::filesystem::exists(file)) return file;
  return {};
}

void run_site_list(const Context& context) {
  const auto folders = site_folders(context.store_folder);
  const auto ids = known_sites(folders);
  if (context.json) {
    std::printf("%s\n", json(ids).dump(2).c_str());
    return;
  }
  for (const std::string& id : ids) {
    const std::filesystem::path file = file_of(id, folders);
    std::string place;
    try {
      const Site site = find_site(id, folders);
      place = position_text(site.point) + "  " + site.name;
    } catch (const Error& problem) {
      place = problem.message();
    }
    std::printf("%-22s %s  (%s)\n", id.c_str(), place.c_str(), file.c_str());
  }
}

}  // namespace

void add_site(CLI::App& app, Context& context) {
  CLI::App* command =
      app.add_subcommand("site", "Write a site's description, check it, or list the known sites");
  command->require_subcommand(1);
  add_site_init(*command, context);
  add_site_sources(*command, context);
  auto name = std::make_shared<std::string>();
  CLI::App* check =
      command->add_subcommand("check", "Is the YAML sound, and what does the store hold for it?");
  check->add_option("site", *name, "id, or path of the YAML file")->required();
  check->add_option("--at", context.at, "the present moment (default: the clock)");
  check->callback([name, &context] { run_site_check(*name, context); });
  command->add_subcommand("list", "Known sites, with their files")->callback([&context] {
    run_site_list(context);
  });
}

}  // namespace slackwater::api
