#include "api/door/cli/sea/history_options.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace slackwater::api {
namespace {

[[noreturn]] void refuse_use(const std::string& why) { throw Error(ErrorKind::usage, why); }

}  // namespace

void add_history_series(CLI::App& command, HistoryArguments& arguments) {
  command.add_option("series", arguments.files,
                     "CSV tables or CF NetCDF files, each of one place; several are joined");
  command.add_option("--site", arguments.site,
                     "instead of files: what the store holds at a site, analysed and observed");
}

void add_history_place(CLI::App& command, HistoryArguments& arguments) {
  command.add_option("--lat", arguments.latitude, "of the place, degrees north");
  command.add_option("--lon", arguments.longitude, "of the place, degrees east");
}

void add_history_options(CLI::App& command, HistoryArguments& arguments) {
  command
      .add_option("--column", arguments.columns,
                  "NAME=STANDARD_NAME:UNIT, what a column is; as often as wanted")
      ->allow_extra_args(false);
  command.add_option("--time-column", arguments.time_column, "the column of times");
  command.add_flag("--assume-utc", arguments.assume_utc, "times without a zone are UTC");
  command.add_option("--depth", arguments.depth_m, "metres below the surface, of currents")
      ->check(CLI::Range(0.0, 12000.0));
  command
      .add_option("--missing", arguments.missing,
                  "a number that stands for 'not measured', e.g. 99; as often as wanted")
      ->allow_extra_args(false);
  command.add_option("--from", arguments.from, "first day, e.g. 2002-01-01");
  command.add_option("--to", arguments.to, "last day");
}

HistorySource source_of(const HistoryArguments& arguments, const Context& context) {
  HistorySource source;
  source.files = arguments.files;
  source.site = arguments.site;
  source.store_folder = context.store_folder;
  if (source.files.empty() == source.site.empty())
    refuse_use(source.files.empty()
                   ? "found no series; expected files, or --site S for those stored"
                   : "found files and --site; expected one of them");
  for (const std::string& text : arguments.columns)
    source.options.columns.push_back(ingest::parse_named_column(text));
  source.options.time_column = arguments.time_column;
  source.options.assume_utc = arguments.assume_utc;
  source.options.depth_m = arguments.depth_m;
  source.options.missing = arguments.missing;
  if (!source.options.missing.empty() && !source.site.empty())
    refuse_use("found --missing beside --site; what is stored has its missing values already");
  if (arguments.latitude.has_value() != arguments.longitude.has_value())
    refuse_use("found one of --lat and --lon, expected both or neither");
  if (arguments.latitude)
    source.place = option_value("--lat, --lon", std::string(), [&](const std::string&) {
      return GeoPoint::from_degrees(*arguments.latitude, *arguments.longitude);
    });
  if (!arguments.from.empty()) source.from = option_value("--from", arguments.from, parse_day);
  if (!arguments.to.empty()) source.to = option_value("--to", arguments.to, parse_day);
  if (source.from && source.to && *source.to < *source.from)
    refuse_use("found --from " + arguments.from + " after --to " + arguments.to);
  return source;
}

void print_history_answer(const nlohmann::json& document, const std::string& text,
                          const Context& context) {
  if (context.json) {
    std::printf("%s\n",
                document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return;
  }
  std::fputs(text.c_str(), stdout);
  for (const nlohmann::json& note : document.at("notes"))
    std::fprintf(stderr, "slackwater: %s\n", note.get<std::string>().c_str());
}

}  // namespace slackwater::api
