#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "api/cli/command.h"
#include "api/cli/progress.h"
#include "api/pipeline/paths.h"
#include "api/pipeline/point_list.h"
#include "api/pipeline/sample_points.h"
#include "api/pipeline/site.h"
#include "ingest/cf/forecast_file.h"
#include "ingest/cf/point_samples_writer.h"

namespace slackwater::api {
namespace {

using ingest::PointSamplesWriter;
using nlohmann::json;

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

/// What is written, and from where.
struct Samples {
  store::ForecastRow row;
  std::shared_ptr<const Snapshot> snapshot;
  SampleGrid grid;
  std::size_t members = 1;  ///< the central one among them
  ValidRange range;
  StatusCounts counts{};
};

store::ForecastRow find_instance(store::Store& store, const Site& site, const std::string& wanted) {
  store::ForecastQuery query;
  query.site_id = site.id;
  query.latest_only = wanted == "newest";
  std::int64_t id = 0;
  const char* const end = wanted.data() + wanted.size();
  const auto [stop, problem] = std::from_chars(wanted.data(), end, id);
  if (!query.latest_only && (problem != std::errc{} || stop != end)) {
    throw Error(ErrorKind::usage, "found --instance " + wanted +
                                      ", expected newest or the id of an issued forecast "
                                      "(`slackwater store list` shows them)");
  }
  const std::vector<store::ForecastRow> rows = store.find_forecasts(query);
  if (rows.empty()) {
    throw Error(ErrorKind::not_found, "found no issued forecast for site " + site.id +
                                          "; run `slackwater forecast` first");
  }
  if (query.latest_only) return rows.back();
  for (const store::ForecastRow& row : rows) {
    if (row.id == id) return row;
  }
  throw Error(ErrorKind::not_found, "found no forecast " + wanted + " of site " + site.id +
                                        "; its newest is " + std::to_string(rows.back().id) +
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
  char text[160];
  std::snprintf(text, sizeof text,
                "%zu points x %zu times x %zu depths x %zu members are %.2g values, expected at "
                "most %.0e; give them in several runs",
                grid.points.size(), grid.time.size(), grid.depth_m.size(), members, values,
                static_cast<double>(most_values));
  throw Error(ErrorKind::usage, text);
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

ingest::PointSamplesHead head_of(const Samples& s) {
  const Snapshot& f = *s.snapshot;
  const std::string credit = joined(f.attributions);
  return {s.grid.points,
          s.grid.time,
          s.grid.depth_m,
          UtcTime(f.day) + std::chrono::days(1),
          s.members,
          {{"title", "Currents of the Slackwater forecast for " + f.site_name},
           {"institution", "Slackwater"},
           {"source", "Slackwater forecast " + std::to_string(s.row.id) + " from day " +
                          format_day(f.day) + ", " + s.row.code_version},
           {"history", format_utc(f.issued) + " issued by Slackwater"},
           {"references", credit.empty() ? "none" : credit},
           {"comment", f.headline.empty() ? "none" : f.headline},
           {"slackwater_site_id", f.site_id},
           {"slackwater_instance", std::to_string(s.row.id)},
           {"slackwater_issued", format_utc(f.issued)},
           {"slackwater_day", format_day(f.day)},
           {"slackwater_degraded", f.degraded ? "true" : "false"},
           {"slackwater_contains_stokes", f.contains_stokes ? "true" : "false"},
           {"slackwater_attributions", credit},
           {"slackwater_provenance", f.provenance_json}}};
}

/// Shows how far the work is, block by block.
class Progress {
 public:
  Progress(const Samples& s, bool quiet)
      : bar_("sampling", quiet), s_(s), all_(s.grid.points.size() * s.members) {}
  void took(const SampleBlock& block) {
    done_ += block.east_m_s.size() / s_.grid.per_point();
    bar_.update(static_cast<double>(done_) / static_cast<double>(all_));
  }

 private:
  ProgressBar bar_;
  const Samples& s_;
  std::size_t all_;
  std::size_t done_ = 0;
};

void write_netcdf(const std::filesystem::path& file, const Field& field, Samples& s, bool quiet) {
  PointSamplesWriter out(file, head_of(s));
  Progress progress(s, quiet);
  s.counts = sample_points(
      field, s.grid, s.members, PointSamplesWriter::fill, [&](const SampleBlock& block) {
        out.write(block.member, block.first_point, block.east_m_s, block.north_m_s);
        if (block.member == 0) out.write_status(block.first_point, block.status);
        progress.took(block);
      });
  out.close();
}

void write_rows(std::ostream& out, const SampleBlock& block, const SampleGrid& grid) {
  std::vector<std::string> stamp;
  for (const UtcTime time : grid.time) stamp.push_back(format_utc(time));
  char text[200];
  for (std::size_t i = 0; i < block.east_m_s.size(); ++i) {
    const std::size_t point = block.first_point + i / grid.per_point();
    const std::size_t time = i / grid.depth_m.size() % grid.time.size();
    const auto status = static_cast<SampleStatus>(block.status[i]);
    const bool is_there = has_value(status) && block.east_m_s[i] != PointSamplesWriter::fill;
    char values[48] = ",";
    if (is_there) {
      std::snprintf(values, sizeof values, "%.4f,%.4f", static_cast<double>(block.east_m_s[i]),
                    static_cast<double>(block.north_m_s[i]));
    }
    std::snprintf(
        text, sizeof text, "%zu,%.6f,%.6f,%s,%g,%zu,%s,%s\n", point + 1,
        grid.points[point].longitude_deg(), grid.points[point].latitude_deg(), stamp[time].c_str(),
        grid.depth_m[i % grid.depth_m.size()], block.member, values,
        std::string(name_of(has_value(status) && !is_there ? SampleStatus::missing : status))
            .c_str());
    out << text;
  }
}

void write_csv(const std::filesystem::path& file, const Field& field, Samples& s, bool quiet) {
  std::ofstream out(file);
  out << "point,longitude_deg,latitude_deg,time,depth_m,member,east_m_s,north_m_s,status\n";
  Progress progress(s, quiet);
  s.counts = sample_points(field, s.grid, s.members, PointSamplesWriter::fill,
                           [&](const SampleBlock& block) {
                             if (out) write_rows(out, block, s.grid);
                             progress.took(block);
                           });
  out.close();
  if (out) return;
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  throw Error(ErrorKind::unavailable,
              "cannot write " + file.string() + "; check free space and permissions");
}

std::size_t with_value(const StatusCounts& counts) {
  std::size_t count = 0;
  for (std::size_t s = 0; s < counts.size(); ++s)
    count += has_value(static_cast<SampleStatus>(s)) ? counts[s] : 0;
  return count;
}

std::string counts_text(const StatusCounts& counts) {
  std::string text;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    if (counts[s] == 0) continue;
    text += (text.empty() ? "" : ", ") + std::string(name_of(static_cast<SampleStatus>(s))) + " " +
            std::to_string(counts[s]);
  }
  return text;
}

void print_json(const Samples& s, const std::filesystem::path& out) {
  json status = json::object();
  for (std::size_t i = 0; i < s.counts.size(); ++i)
    status[std::string(name_of(static_cast<SampleStatus>(i)))] = s.counts[i];
  const Snapshot& f = *s.snapshot;
  const json document = {{"site", f.site_id},
                         {"instance", s.row.id},
                         {"issued", format_utc(f.issued)},
                         {"day", format_day(f.day)},
                         {"degraded", f.degraded},
                         {"headline", f.headline},
                         {"out", out.string()},
                         {"points", s.grid.points.size()},
                         {"times", s.grid.time.size()},
                         {"from", format_utc(s.grid.time.front())},
                         {"to", format_utc(s.grid.time.back())},
                         {"depth_m", s.grid.depth_m},
                         {"members", s.members},
                         {"status", status},
                         {"valid",
                          {{"bbox",
                            {s.range.box.west_deg, s.range.box.south_deg, s.range.box.east_deg,
                             s.range.box.north_deg}},
                           {"from", format_utc(s.range.from)},
                           {"to", format_utc(s.range.to)},
                           {"deepest_m", s.range.deepest_m}}},
                         {"attributions", f.attributions}};
  std::printf("%s\n", document.dump(2, ' ', false, json::error_handler_t::replace).c_str());
}

void print_text(const Samples& s, const std::filesystem::path& out) {
  const Snapshot& f = *s.snapshot;
  std::printf("%s, forecast %lld issued %s from day %s\n", f.site_name.c_str(),
              static_cast<long long>(s.row.id), format_utc(f.issued).c_str(),
              format_day(f.day).c_str());
  if (f.degraded) std::printf("DEGRADED: %s\n", f.headline.c_str());
  std::printf("%zu points x %zu times x %zu depths, %zu member%s: %s\n%s\n", s.grid.points.size(),
              s.grid.time.size(), s.grid.depth_m.size(), s.members, s.members == 1 ? "" : "s",
              counts_text(s.counts).c_str(), out.c_str());
  for (const std::string& line : f.attributions) std::printf("%s\n", line.c_str());
}

void expect_writable(const std::filesystem::path& out) {
  if (out.extension() != ".nc" && out.extension() != ".csv") {
    throw Error(ErrorKind::usage,
                "found --out " + out.string() + ", expected a file name that ends in .nc or .csv");
  }
  const auto folder = std::filesystem::absolute(out).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw Error(ErrorKind::usage,
                "found no folder " + folder.string() + " for --out; make it, or name another");
  }
}

void run_sample(const SampleArguments& arguments, const Context& context) {
  expect_writable(arguments.out);
  Samples s;
  s.grid.points = read_points(arguments.points);
  store::Store store = context.open(store::OpenMode::read_only);
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  s.row = find_instance(store, site, arguments.instance);
  s.snapshot = std::make_shared<const Snapshot>(
      ingest::read_forecast(store.content_path(s.row.content_sha256),
                            arguments.members ? ingest::Members::all : ingest::Members::none));
  if (s.snapshot->depth_m.empty()) {
    throw Error(ErrorKind::not_found, "forecast " + std::to_string(s.row.id) +
                                          " holds no currents: " + s.snapshot->headline);
  }
  s.grid.time = times_of(arguments, *s.snapshot);
  s.grid.depth_m = arguments.depths.empty()
                       ? s.snapshot->depth_m
                       : option_value("--depths", arguments.depths, parse_depths);
  if (arguments.members) s.members = s.snapshot->members;
  expect_bounded(s.grid, s.members);
  const Field field(s.snapshot);
  s.range = field.range();
  const std::filesystem::path partial = arguments.out.string() + ".partial";
  const auto write = arguments.out.extension() == ".nc" ? write_netcdf : write_csv;
  write(partial, field, s, context.json);
  if (with_value(s.counts) == 0) {
    std::filesystem::remove(partial);
    throw Error(ErrorKind::not_found, "found no current at any of these places (" +
                                          counts_text(s.counts) + "); the forecast is for " +
                                          s.range.text());
  }
  std::filesystem::rename(partial, arguments.out);
  if (context.json) {
    print_json(s, arguments.out);
  } else {
    print_text(s, arguments.out);
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
      ->add_option("--points", arguments->points,
                   "CSV file whose first line names latitude_deg and longitude_deg")
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
