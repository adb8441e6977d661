#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/traffic_options.h"
#include "api/program/paths.h"
#include "api/show/traffic/traffic_json.h"
#include "api/show/traffic/traffic_words.h"
#include "fields/base/encode/csv.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"
#include "fields/base/whole_file.h"
#include "fields/site/site.h"
#include "ingest/ais/read_ais.h"

namespace slackwater::api {
namespace {

using ingest::AisPosition;
using ingest::AisTrack;
using nlohmann::json;

/// What one line of the list says of a vessel.
struct Summary {
  std::optional<double> mean_speed_m_s;  ///< of the speeds over ground that it reported
  BoundingBox extent;                    ///< the short way round where it crosses the antimeridian
};

Summary summary_of(const std::vector<AisPosition>& positions) {
  Summary summary;
  double sum = 0;
  std::size_t speeds = 0;
  double east = -180, west = 180, east_0_360 = 0, west_0_360 = 360;
  BoundingBox& box = summary.extent;
  box.south_deg = 90;
  box.north_deg = -90;
  for (const AisPosition& position : positions) {
    if (position.speed_over_ground_m_s) {
      sum += *position.speed_over_ground_m_s;
      ++speeds;
    }
    const double longitude = position.point.longitude_deg();
    const double positive = compass_deg(longitude);
    west = std::min(west, longitude);
    east = std::max(east, longitude);
    west_0_360 = std::min(west_0_360, positive);
    east_0_360 = std::max(east_0_360, positive);
    box.south_deg = std::min(box.south_deg, position.point.latitude_deg());
    box.north_deg = std::max(box.north_deg, position.point.latitude_deg());
  }
  const bool crosses = east_0_360 - west_0_360 < east - west;
  box.west_deg = crosses ? normalised_longitude_deg(west_0_360) : west;
  box.east_deg = crosses ? normalised_longitude_deg(east_0_360) : east;
  if (speeds > 0) summary.mean_speed_m_s = sum / static_cast<double>(speeds);
  return summary;
}

template <typename Value>
json value_or_null(const std::optional<Value>& value) {
  return value ? json(*value) : json(nullptr);
}

json vessel_json(const AisTrack& track) {
  json vessel = {{"mmsi", track.mmsi},
                 {"name", value_or_null(track.identity.name)},
                 {"class", std::string(name_of(track.speaker))},
                 {"ship_type", value_or_null(track.identity.ship_type)},
                 {"length_m", value_or_null(track.identity.length_m)},
                 {"beam_m", value_or_null(track.identity.beam_m)},
                 {"reports", track.reports},
                 {"positions", track.positions.size()}};
  for (const char* key : {"first", "last", "mean_speed_m_s", "bbox"}) vessel[key] = nullptr;
  if (track.positions.empty()) return vessel;
  const Summary summary = summary_of(track.positions);
  const BoundingBox& box = summary.extent;
  vessel["first"] = format_utc(track.positions.front().time);
  vessel["last"] = format_utc(track.positions.back().time);
  vessel["mean_speed_m_s"] = value_or_null(summary.mean_speed_m_s);
  vessel["bbox"] = {box.west_deg, box.south_deg, box.east_deg, box.north_deg};
  return vessel;
}

void print_vessel(const AisTrack& track) {
  std::printf("%9u  %-20s  %-12s %7zu", track.mmsi, track.identity.name.value_or("-").c_str(),
              std::string(name_of(track.speaker)).c_str(), track.reports);
  if (track.positions.empty()) {
    std::printf("  no position\n");
    return;
  }
  const Summary summary = summary_of(track.positions);
  const BoundingBox& box = summary.extent;
  const std::string speed =
      summary.mean_speed_m_s ? formatted("{:.1f}", *summary.mean_speed_m_s) : "-";
  std::printf("  %-20.20s  %-20.20s  %6s  %.4f..%.4f N  %.4f..%.4f E\n",
              format_utc(track.positions.front().time).c_str(),
              format_utc(track.positions.back().time).c_str(), speed.c_str(), box.south_deg,
              box.north_deg, box.west_deg, box.east_deg);
}

json reading_json(const std::string& file, const ingest::AisReading& reading) {
  json by_type = json::object();
  for (std::size_t type = 0; type < reading.reports_of_type.size(); ++type) {
    if (reading.reports_of_type[type] > 0) {
      by_type[std::to_string(type)] = reading.reports_of_type[type];
    }
  }
  json others = json::object();
  for (std::size_t type = 0; type < reading.others_of_type.size(); ++type) {
    if (reading.others_of_type[type] > 0)
      others[std::to_string(type)] = reading.others_of_type[type];
  }
  return {{"file", file},
          {"lines", reading.lines.lines},
          {"messages", reading.messages},
          {"reports_by_type", by_type},
          {"other_types", reading.other_types},
          {"other_by_type", others},
          {"warnings", reading.warnings()}};
}

constexpr const char* csv_head =
    "file,mmsi,name,class,ship_type,length_m,beam_m,reports,positions,first,last,mean_speed_m_s,"
    "west_deg,south_deg,east_deg,north_deg\n";

/// A vessel as a row, the numbers of `vessel_json`; what it never said is an empty cell.
std::string vessel_csv(const std::string& file, const AisTrack& track) {
  const json vessel = vessel_json(track);
  std::string line = csv_cell(file);
  const auto add = [&](const json& value) {
    line += ",";
    if (value.is_string()) line += csv_cell(value.get<std::string>());
    if (value.is_number()) line += value.dump();
  };
  for (const char* key : {"mmsi", "name", "class", "ship_type", "length_m", "beam_m", "reports",
                          "positions", "first", "last", "mean_speed_m_s"})
    add(vessel.at(key));
  for (std::size_t i = 0; i < 4; ++i)
    add(vessel.at("bbox").is_array() ? vessel.at("bbox").at(i) : json());
  return line + "\n";
}

struct AboutSite {
  std::string site;
  AlarmWords alarm;
};

/// Who is about a site, by all that the logs hold up to a time.
void run_about_site(const std::vector<std::string>& files, const AboutSite& about, bool assume_utc,
                    const Context& context) {
  const Site site = find_site(about.site, site_folders(context.store_folder));
  TrafficQuestion question{site.id, site.point, site.turbines, {}, traffic_rule(about.alarm)};
  question.at =
      context.at.empty() ? std::chrono::floor<std::chrono::seconds>(context.now()) : context.now();
  HeardVessels vessels;
  TrafficHeard heard;
  for (const std::string& file : files) {
    const ingest::AisReading reading = ingest::read_ais(
        file, [&](const ingest::AisReport& report) { vessels.add(report); },
        ingest::gpsdecode_program(), assume_utc);
    for (const std::string& warning : reading.warnings())
      std::fprintf(stderr, "slackwater: %s: %s\n", file.c_str(), warning.c_str());
    heard.sources.push_back({std::filesystem::path(file).filename().string(), {}});
  }
  heard.vessels = vessels.known_at(question.at);
  heard.last = vessels.last_received(question.at);
  heard.first = vessels.first();
  const TrafficAnswer answer = traffic_about(question, heard);
  const std::string text = context.json
                               ? traffic_json(question, heard, answer)
                                         .dump(2, ' ', false, json::error_handler_t::replace) +
                                     "\n"
                               : traffic_text(question, heard, answer);
  std::fputs(text.c_str(), stdout);
}

void run_ais(const std::vector<std::string>& files, const ingest::AisTrackOptions& options,
             const std::filesystem::path& csv, const Context& context) {
  expect_output("--csv", csv, {".csv"});
  std::string rows = csv_head;
  json out = {{"files", json::array()}};
  if (!context.json) {
    std::printf("%9s  %-20s  %-12s %7s  %-20s  %-20s  %6s  %s\n", "MMSI", "name", "class",
                "reports", "first", "last", "m/s", "extent");
  }
  for (const std::string& file : files) {
    const ingest::AisTracks read = ingest::read_ais_tracks(file, options);
    json of_file = reading_json(file, read.reading);
    of_file["vessels"] = json::array();
    for (const AisTrack& track : read.tracks) {
      if (!csv.empty()) rows += vessel_csv(file, track);
      if (context.json) {
        of_file["vessels"].push_back(vessel_json(track));
      } else {
        print_vessel(track);
      }
    }
    if (!context.json) {
      std::printf("%s: %s in %s of %s\n", file.c_str(),
                  counted(read.tracks.size(), "vessel").c_str(),
                  counted(read.reading.messages, "message").c_str(),
                  counted(read.reading.lines.lines, "line").c_str());
      for (const std::string& warning : read.reading.warnings()) {
        std::fprintf(stderr, "slackwater: %s: %s\n", file.c_str(), warning.c_str());
      }
      if (const std::string passed = read.reading.passed_over(); !passed.empty())
        std::fprintf(stderr, "slackwater: %s: %s\n", file.c_str(), passed.c_str());
    }
    out["files"].push_back(std::move(of_file));
  }
  if (!csv.empty()) write_text(csv, rows);
  if (context.json) {
    std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
  }
}

}  // namespace

void add_ais(CLI::App& app, Context& context) {
  struct Arguments {
    std::vector<std::string> files;
    std::vector<double> box;
    std::string from;
    std::string to;
    std::uint32_t mmsi = 0;
    bool assume_utc = false;
    std::filesystem::path csv;
    AboutSite about;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("ais", "The vessels in logs of AIS");
  command
      ->add_option(
          "file", arguments->files,
          "NMEA 0183 with times, or CSV of MarineCadastre or the Danish Maritime Authority")
      ->required();
  command->add_option("--bbox", arguments->box, "W,S,E,N: positions inside")
      ->delimiter(',')
      ->expected(4);
  command->add_option("--from", arguments->from, "positions from this time on");
  command->add_option("--to", arguments->to, "and up to this time");
  command->add_flag("--assume-utc", arguments->assume_utc,
                    "times that a log states without a zone are UTC");
  command->add_option("--mmsi", arguments->mmsi, "one vessel");
  command->add_option("--csv", arguments->csv, "the list as FILE.csv, a row a vessel");
  CLI::Option* site =
      command->add_option("--site", arguments->about.site,
                          "who is about this site, with closest approaches (id, or FILE.yaml)");
  command->add_option("--at", context.at, "at this time, UTC (with --site; default: the clock)")
      ->needs(site);
  add_alarm_options(*command, arguments->about.alarm);
  for (const char* name : {"--bbox", "--from", "--to", "--mmsi", "--csv"})
    site->excludes(command->get_option(name));
  command->callback([arguments, &context] {
    if (!arguments->about.site.empty()) {
      run_about_site(arguments->files, arguments->about, arguments->assume_utc, context);
      return;
    }
    ingest::AisTrackOptions options;
    if (!arguments->box.empty()) {
      const auto& b = arguments->box;
      options.cut = option_value("--bbox", std::string(), [&](const std::string&) {
        return BoundingBox::from_degrees(b[0], b[1], b[2], b[3]);
      });
    }
    if (!arguments->from.empty()) options.from = option_value("--from", arguments->from, parse_utc);
    if (!arguments->to.empty()) options.to = option_value("--to", arguments->to, parse_utc);
    if (options.from && options.to && *options.from > *options.to) {
      throw Error(ErrorKind::usage,
                  "found --from " + arguments->from + " after --to " + arguments->to);
    }
    if (arguments->mmsi != 0) options.mmsi = arguments->mmsi;
    options.assume_utc = arguments->assume_utc;
    run_ais(arguments->files, options, arguments->csv, context);
  });
}

}  // namespace slackwater::api
