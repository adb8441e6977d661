#include "data/store/store.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/pipeline/stored_pieces.h"
#include "api/program/paths.h"
#include "fields/base/text.h"
#include "fields/site/site.h"
#include "ingest/pieces.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

json time_or_null(const std::optional<UtcTime>& time) {
  return time ? json(format_utc(*time)) : json(nullptr);
}

std::string dumped(const json& document) {
  return document.dump(2, ' ', false, json::error_handler_t::replace);
}

void run_check(const Context& context, bool quick) {
  const store::CheckReport report = store::check_store(context.store_folder, !quick);
  if (context.json) {
    json findings = json::array();
    for (const store::CheckFinding& finding : report.findings) {
      findings.push_back(
          {{"harmful", finding.harmful}, {"found", finding.found}, {"advice", finding.advice}});
    }
    std::printf("%s\n", dumped({{"sound", report.sound},
                                {"findings", findings},
                                {"sources", report.sources},
                                {"granules", report.granules},
                                {"forecasts", report.forecasts},
                                {"decisions", report.decisions},
                                {"content_files", report.content_files},
                                {"content_bytes", report.content_bytes}})
                            .c_str());
    context.answered = true;
  } else {
    for (const store::CheckFinding& finding : report.findings) {
      std::printf("%s %s\n    %s\n", finding.harmful ? "PROBLEM:" : "note:", finding.found.c_str(),
                  finding.advice.c_str());
    }
    std::printf(
        "%s: %zu sources, %zu granules, %zu forecasts, %zu decisions, %.1f MB in %zu files\n",
        report.sound ? "sound" : "NOT SOUND", report.sources, report.granules, report.forecasts,
        report.decisions, static_cast<double>(report.content_bytes) / 1e6, report.content_files);
  }
  if (!report.sound)
    throw Error(ErrorKind::invalid_input, "the store is not sound; follow the advice above");
}

struct ListArguments {
  std::string site;
  bool forecasts = false;
};

/// What is listed: all, what lies around one site, or forecasts alone.
struct Listing {
  std::vector<store::SourceFile> sources;
  std::vector<store::GranuleRow> granules;
  std::vector<store::ForecastRow> forecasts;
};

Listing listing_of(store::Store& store, const ListArguments& arguments, const Context& context) {
  store::GranuleQuery near;
  store::ForecastQuery of_site;
  std::optional<Site> site;
  if (!arguments.site.empty()) {
    site = find_site(arguments.site, site_folders(context.store_folder));
    near.box = site->box(0);
    near.margin_km = ingest::farthest_granule_km;
    of_site.site_id = site->id;
  }
  Listing listing;
  listing.forecasts = store.find_forecasts(of_site);
  if (arguments.forecasts) return listing;
  listing.granules = store.find_granules(near);
  listing.sources = store.list_sources();
  if (!site) return listing;
  listing.granules = near_site(std::move(listing.granules), *site);
  std::erase_if(listing.sources, [&](const store::SourceFile& source) {
    return std::none_of(listing.granules.begin(), listing.granules.end(), [&](const auto& granule) {
      return granule.source_sha256 == source.sha256 && granule.cut_key == source.cut_key;
    });
  });
  return listing;
}

void run_list(const Context& context, const ListArguments& arguments) {
  store::Store store = context.open(store::OpenMode::read_only);
  const auto [sources, granules, forecasts] = listing_of(store, arguments, context);
  if (context.json) {
    json document = {
        {"sources", json::array()}, {"granules", json::array()}, {"forecasts", json::array()}};
    for (const auto& s : sources) {
      document["sources"].push_back({{"name", s.name},
                                     {"sha256", s.sha256},
                                     {"cut", s.cut_key},
                                     {"bytes", s.bytes},
                                     {"product", s.product_id},
                                     {"dataset", s.dataset_id},
                                     {"attribution", s.attribution},
                                     {"ingested_at", format_utc(s.ingested_at)},
                                     {"published_at", time_or_null(s.published_at)},
                                     {"warnings", s.warnings}});
    }
    for (const auto& g : granules) {
      document["granules"].push_back(
          {{"id", g.id},
           {"source_sha256", g.source_sha256},
           {"content_sha256", g.content_sha256},
           {"standard_names", g.standard_names},
           {"status", std::string(name_of(g.status))},
           {"reference_time", time_or_null(g.reference_time)},
           {"published_at", time_or_null(g.published_at)},
           {"from", time_or_null(g.first_time)},
           {"to", time_or_null(g.last_time)},
           {"times", g.times},
           {"bbox", {g.bounds.west_deg, g.bounds.south_deg, g.bounds.east_deg, g.bounds.north_deg}},
           {"station", g.station},
           {"product", g.product_id}});
    }
    for (const auto& f : forecasts) {
      document["forecasts"].push_back({{"id", f.id},
                                       {"site", f.site_id},
                                       {"day", format_day(f.day)},
                                       {"issued", format_utc(f.issued)},
                                       {"valid_from", format_utc(f.valid_from)},
                                       {"valid_to", format_utc(f.valid_to)},
                                       {"wind", name_of(f.wind_policy)},
                                       {"origin", name_of(f.origin)},
                                       {"degraded", f.degraded},
                                       {"headline", f.headline},
                                       {"content_sha256", f.content_sha256},
                                       {"code_version", f.code_version}});
    }
    std::printf("%s\n", dumped(document).c_str());
    return;
  }
  if (!arguments.forecasts) std::printf("%zu product files\n", sources.size());
  for (const auto& g : granules) {
    const std::string names = joined(g.standard_names, ", ");
    std::printf("  %-11s %s to %s  %-40s %s\n", std::string(name_of(g.status)).c_str(),
                g.first_time ? format_utc(*g.first_time).c_str() : "static              ",
                g.last_time ? format_utc(*g.last_time).c_str() : "", g.product_id.c_str(),
                names.c_str());
  }
  std::printf("%zu forecasts\n", forecasts.size());
  for (const auto& f : forecasts) {
    std::printf("  %-6lld %-22s day %s issued %s wind %-8s %s%s\n", static_cast<long long>(f.id),
                f.site_id.c_str(), format_day(f.day).c_str(), format_utc(f.issued).c_str(),
                std::string(name_of(f.wind_policy)).c_str(), std::string(name_of(f.origin)).c_str(),
                f.degraded ? " DEGRADED" : "");
  }
}

struct PruneArguments {
  std::string older_than;
  bool forecasts = false;
  bool orphans = false;
  bool dry_run = false;
};

void run_prune(const Context& context, const PruneArguments& arguments) {
  store::PruneOptions options;
  if (!arguments.older_than.empty())
    options.older_than = UtcTime(option_value("--older-than", arguments.older_than, parse_day));
  options.forecasts = arguments.forecasts;
  options.orphans = arguments.orphans;
  options.dry_run = arguments.dry_run;
  if (!options.older_than && !options.orphans) {
    throw Error(ErrorKind::usage, "say what to prune: --older-than DAY, --orphans, or both");
  }
  store::Store store = context.open(store::OpenMode::create_or_write);
  const store::PruneReport report = store.prune(options);
  if (context.json) {
    std::printf("%s\n", dumped({{"dry_run", options.dry_run},
                                {"sources", report.sources},
                                {"granules", report.granules},
                                {"forecasts", report.forecasts},
                                {"content_files", report.content_files},
                                {"bytes", report.bytes},
                                {"staging_folders", report.staging_folders},
                                {"kept_sources", report.kept_sources},
                                {"kept_forecasts", report.kept_forecasts}})
                            .c_str());
  } else {
    std::printf("%s %zu sources, %zu forecasts, %zu files (%.1f MB)\n",
                options.dry_run ? "would remove" : "removed", report.sources, report.forecasts,
                report.content_files, static_cast<double>(report.bytes) / 1e6);
    if (report.kept_sources + report.kept_forecasts > 0)
      std::printf(
          "kept %zu sources and %zu forecasts of that age, which decisions rest on or which "
          "show what came of them (`slackwater decisions`)\n",
          report.kept_sources, report.kept_forecasts);
  }
}

}  // namespace

void add_store(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand("store", "Look after the store: check, list, prune");
  command->require_subcommand(1);
  auto quick = std::make_shared<bool>(false);
  CLI::App* check =
      command->add_subcommand("check", "Is every row and every file whole? With advice where not");
  check->add_flag("--quick", *quick, "sizes only, no checksums");
  check->callback([quick, &context] { run_check(context, *quick); });
  auto listed = std::make_shared<ListArguments>();
  CLI::App* list = command->add_subcommand("list", "What the store holds");
  list->add_option("--site", listed->site, "only what lies around this site, and its forecasts");
  list->add_flag("--forecasts", listed->forecasts, "only issued forecasts");
  list->callback([listed, &context] { run_list(context, *listed); });
  auto arguments = std::make_shared<PruneArguments>();
  CLI::App* prune = command->add_subcommand(
      "prune",
      "Remove old product files; never an issued forecast without --forecasts, nor what decisions "
      "rest on");
  prune->add_option("--older-than", arguments->older_than,
                    "remove what was ingested before this day, e.g. 2025-01-01");
  prune->add_flag("--forecasts", arguments->forecasts, "issued forecasts too");
  prune->add_flag("--orphans", arguments->orphans, "remove files that no row names");
  prune->add_flag("--dry-run", arguments->dry_run, "say what would go, and remove nothing");
  prune->callback([arguments, &context] { run_prune(context, *arguments); });
}

}  // namespace slackwater::api
