#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>

#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/point_list.h"
#include "api/door/cli/sea/sample_write.h"
#include "api/issued/in_force.h"
#include "api/program/paths.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"
#include "fields/site/site.h"

namespace slackwater::api {
namespace {

struct SampleArguments {
  std::string site;
  std::string instance = "newest";
  std::filesystem::path points;
  std::string from;
  std::string to;
  std::string step = "1h";
  std::string depths;
  bool members = false;
  std::filesystem::path out;
};

/// More values than this want several runs: 9 GB of a file.
constexpr std::size_t most_values = 1'000'000'000;

store::ForecastRow find_instance(store::Store& store, const Site& site, const std::string& wanted) {
  if (wanted == "newest") {
    InForce in_force = forecast_in_force(store, {site.id, {}, {}});
    for (const std::string& damage : in_force.passed_over)
      std::fprintf(stderr, "slackwater: %s; an older forecast is used\n", damage.c_str());
    return std::move(in_force.row);
  }
  std::int64_t id = 0;
  const char* const end = wanted.data() + wanted.size();
  const auto [stop, problem] = std::from_chars(wanted.data(), end, id);
  if (problem != std::errc{} || stop != end) {
    throw Error(ErrorKind::usage, "found --instance " + wanted +
                                      ", expected newest or the id of an issued forecast "
                                      "(`slackwater store list` shows them)");
  }
  std::vector<store::ForecastRow> rows = by_force(store, {site.id, {}, {}});
  for (store::ForecastRow& row : rows) {
    if (row.id == id) return std::move(row);
  }
  if (rows.empty()) static_cast<void>(forecast_in_force(store, {site.id, {}, {}}));
  throw Error(ErrorKind::not_found, "found no forecast " + wanted + " of site " + site.id +
                                        "; its newest is " + std::to_string(rows.front().id) +
                                        " (`slackwater store list` shows all)");
}

std::vector<UtcTime> times_of(const SampleArguments& arguments, const Snapshot& snapshot) {
  const Duration step = option_value("--step", arguments.step, parse_duration);
  if (step <= Duration(0))
    throw Error(ErrorKind::usage, "found --step " + arguments.step + ", expected more than 0");
  const UtcTime from = arguments.from.empty() ? snapshot.time.front()
                                              : option_value("--from", arguments.from, parse_utc);
  const UtcTime to =
      arguments.to.empty() ? snapshot.time.back() : option_value("--to", arguments.to, parse_utc);
  if (to < from) {
    throw Error(ErrorKind::usage, "found --from " + format_utc(from) + " after --to " +
                                      format_utc(to) + ", expected them the other way round");
  }
  if (static_cast<std::size_t>((to - from) / step) >= most_values)
    throw Error(ErrorKind::usage, "--step " + arguments.step + " is too short for such a time");
  std::vector<UtcTime> times;
  for (UtcTime time = from; time <= to; time += step) times.push_back(time);
  return times;
}

void expect_bounded(const SampleGrid& grid, std::size_t members) {
  const double values = static_cast<double>(grid.points.size()) *
                        static_cast<double>(grid.per_point()) * static_cast<double>(members);
  if (values <= static_cast<double>(most_values)) return;
  throw Error(ErrorKind::usage,
              formatted("{} points x {} times x {} depths x {} members are {:.2g} values, expected "
                        "at most {:.0e}; give them in several runs",
                        grid.points.size(), grid.time.size(), grid.depth_m.size(), members, values,
                        static_cast<double>(most_values)));
}

void expect_writable(const SampleArguments& arguments) {
  expect_output("--out", arguments.out, {".nc", ".csv"});
  std::error_code ignored;
  if (!std::filesystem::equivalent(arguments.out, arguments.points, ignored)) return;
  throw Error(ErrorKind::usage, "found --out " + arguments.out.string() +
                                    ", which is the file of points; expected another name");
}

void run_sample(const SampleArguments& arguments, const Context& context) {
  expect_writable(arguments);
  Samples s;
  PointList list = read_points(arguments.points);
  s.grid.points = std::move(list.points);
  s.names = std::move(list.names);
  store::Store store = context.open(store::OpenMode::read_only);
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  s.row = find_instance(store, site, arguments.instance);
  s.field =
      read_field(store, s.row, arguments.members ? ingest::Members::all : ingest::Members::none);
  const Snapshot& snapshot = s.field->snapshot();
  if (snapshot.depth_m.empty()) {
    throw Error(ErrorKind::not_found, "forecast " + std::to_string(s.row.id) +
                                          " holds no currents: " + snapshot.headline);
  }
  s.grid.time = times_of(arguments, snapshot);
  s.grid.depth_m = arguments.depths.empty()
                       ? snapshot.depth_m
                       : option_value("--depths", arguments.depths, parse_depths);
  if (arguments.members) s.members = snapshot.members;
  expect_bounded(s.grid, s.members);
  s.range = s.field->range();
  const auto write = arguments.out.extension() == ".nc" ? write_netcdf : write_csv;
  write_beside(arguments.out, [&](const std::filesystem::path& partial) {
    write(partial, s, context.json);
    if (with_value(s.counts) == 0)
      throw Error(ErrorKind::not_found, "found no current at any of these places (" +
                                            counts_text(s.counts) + "); the forecast is for " +
                                            s.range.text());
  });
  if (context.json) {
    print_samples_json(s, arguments.out);
  } else {
    print_samples(s, arguments.out);
  }
}

}  // namespace

void add_sample(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<SampleArguments>();
  CLI::App* command = app.add_subcommand(
      "sample", "Currents of an issued forecast at many points x times x depths, into a file");
  command->add_option("--site", arguments->site, "id of data/sites, or path of a site's YAML file")
      ->required();
  command->add_option("--instance", arguments->instance,
                      "id of an issued forecast, or newest (default newest)");
  command
      ->add_option(
          "--points", arguments->points,
          "CSV file whose first line names latitude_deg and longitude_deg, and perhaps name")
      ->required();
  command->add_option("--from", arguments->from, "first time (default: the forecast's)");
  command->add_option("--to", arguments->to, "last time (default: the forecast's)");
  command->add_option("--step", arguments->step, "between times (default 1h)");
  command->add_option("--depths", arguments->depths,
                      "metres below mean sea level: a list 0,5,12.5 or from/to/count 0/80/50 "
                      "(default: the forecast's levels)");
  command->add_flag("--members", arguments->members, "every member of the ensemble too");
  command->add_option("--out", arguments->out, "FILE.nc (CF NetCDF) or FILE.csv")->required();
  command->callback([arguments, &context] { run_sample(*arguments, context); });
}

}  // namespace slackwater::api
