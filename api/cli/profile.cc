#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "api/cli/command.h"
#include "api/cli/profile_print.h"
#include "api/program/paths.h"
#include "fields/site/site.h"
#include "ingest/cf/forecast_file.h"

namespace slackwater::api {
namespace {

struct ProfileArguments {
  std::string site;
  std::optional<double> latitude;
  std::optional<double> longitude;
  std::string time;
  std::vector<double> depths;
  bool csv = false;
  std::size_t member = 0;
  bool members = false;  ///< list them all
};

/// A point within this distance of a forecast column is answered by that column.
constexpr double column_reach_m = 5000.0;

std::size_t nearest_column(const Snapshot& snapshot, const GeoPoint& point, double& distance) {
  std::size_t best = 0;
  distance = distance_m(snapshot.columns[0].point, point);
  for (std::size_t i = 1; i < snapshot.columns.size(); ++i) {
    const double d = distance_m(snapshot.columns[i].point, point);
    if (d < distance) {
      distance = d;
      best = i;
    }
  }
  return best;
}

/// Without its members: most questions do not need them, and they are most of the file.
Snapshot read(store::Store& store, const store::ForecastRow& row) {
  return ingest::read_forecast(store.content_path(row.content_sha256), ingest::Members::none);
}

/// The members that the question is about, in the snapshot's column.
void add_members(ProfileAnswer& answer, store::Store& store, const ProfileArguments& arguments) {
  if (arguments.member >= answer.snapshot.members) {
    const std::size_t last = answer.snapshot.members - 1;
    throw Error(ErrorKind::not_found,
                "found no member " + std::to_string(arguments.member) + "; this forecast has " +
                    (last == 0 ? "member 0, the central one, alone"
                               : "members 0 (the central one) to " + std::to_string(last)));
  }
  answer.member = arguments.member;
  if (arguments.member == 0 && !arguments.members) return;
  ingest::read_members(store.content_path(answer.row.content_sha256), answer.snapshot,
                       answer.column);
}

/// Samples the central forecast and what was asked for of the others.
void sample(ProfileAnswer& answer, bool all_members) {
  const auto of_member = [&](std::size_t member) {
    std::vector<CurrentSample> samples(answer.depth_m.size());
    sample_profile(answer.snapshot, answer.column, answer.time, answer.depth_m, samples, member);
    return samples;
  };
  answer.central = of_member(0);
  answer.samples = of_member(answer.member);
  if (!all_members) return;
  for (std::size_t m = 0; m < answer.snapshot.members; ++m) answer.members.push_back(of_member(m));
}

/// The newest forecast that covers the time, of the site or of whichever site has a column near the
/// point.
ProfileAnswer find_answer(store::Store& store, const ProfileArguments& arguments,
                          const Context& context) {
  ProfileAnswer answer;
  answer.time = option_value("--time", arguments.time, parse_utc);
  store::ForecastQuery query;
  std::optional<GeoPoint> point;
  if (!arguments.site.empty()) {
    const Site site = find_site(arguments.site, site_folders(context.store_folder));
    query.site_id = site.id;
    if (arguments.latitude)
      point = GeoPoint::from_degrees(*arguments.latitude, *arguments.longitude);
  } else {
    point = GeoPoint::from_degrees(*arguments.latitude, *arguments.longitude);
  }
  std::vector<store::ForecastRow> rows = store.find_forecasts(query);
  std::reverse(rows.begin(), rows.end());  // newest day, then latest issue, first
  if (rows.empty()) {
    throw Error(ErrorKind::not_found,
                "found no issued forecast" +
                    (query.site_id.empty() ? std::string() : " for site " + query.site_id) +
                    "; run `slackwater forecast` first");
  }
  const auto covers = [&](const store::ForecastRow& row) {
    return answer.time >= row.valid_from && answer.time <= row.valid_to;
  };
  double nearest_m = 1e12;
  for (const store::ForecastRow& row : rows) {
    if (!covers(row)) continue;
    Snapshot snapshot = read(store, row);
    double distance = 0;
    std::size_t column = 0;
    if (point) {
      column = nearest_column(snapshot, *point, distance);
      nearest_m = std::min(nearest_m, distance);
      if (distance > column_reach_m) continue;
    }
    answer.row = row;
    answer.snapshot = std::move(snapshot);
    answer.column = column;
    return answer;
  }
  if (nearest_m < 1e12) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "the nearest forecast column lies %.1f km away; forecasts answer within %.0f km",
                  nearest_m / 1000, column_reach_m / 1000);
    throw Error(ErrorKind::not_found, text);
  }
  throw Error(ErrorKind::not_found,
              "no forecast covers " + arguments.time + "; the newest one is valid from " +
                  format_utc(rows.front().valid_from) + " to " + format_utc(rows.front().valid_to));
}

void run_profile(const ProfileArguments& arguments, const Context& context) {
  if (arguments.site.empty() && !arguments.latitude) {
    throw Error(ErrorKind::usage, "give --site, or --lat and --lon");
  }
  if (arguments.latitude.has_value() != arguments.longitude.has_value()) {
    throw Error(ErrorKind::usage, "--lat and --lon go together");
  }
  for (const double depth : arguments.depths) {
    if (!std::isfinite(depth))
      throw Error(ErrorKind::usage, "--depth: expected metres below mean sea level");
  }
  if (arguments.csv && context.json)
    throw Error(ErrorKind::usage, "give --csv or --json, not both");
  if (arguments.members && !context.json)
    throw Error(ErrorKind::usage,
                "--members lists all members in --json only; --member N shows one");
  store::Store store = context.open(store::OpenMode::read_only);
  ProfileAnswer answer = find_answer(store, arguments, context);
  add_members(answer, store, arguments);
  const ForecastColumn& column = answer.snapshot.columns[answer.column];
  answer.depth_m = arguments.depths;
  if (answer.depth_m.empty()) {
    for (const double depth : answer.snapshot.depth_m) {
      if (depth <= column.water_depth_m) answer.depth_m.push_back(depth);
    }
  }
  sample(answer, arguments.members);
  if (context.json) {
    print_profile_json(answer);
  } else if (arguments.csv) {
    print_profile_csv(answer);
  } else {
    print_profile_table(answer);
  }
}

}  // namespace

void add_profile(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<ProfileArguments>();
  CLI::App* command =
      app.add_subcommand("profile", "The current profile at a place and time, with quantiles");
  command->add_option("--site", arguments->site, "id of data/sites, or path of a site's YAML file");
  command->add_option("--lat", arguments->latitude, "latitude, degrees north")
      ->check(CLI::Range(-90.0, 90.0));
  command->add_option("--lon", arguments->longitude, "longitude, degrees east")
      ->check(CLI::Range(-360.0, 360.0));
  command->add_option("--time", arguments->time, "e.g. 2025-03-10T06:00:00Z")->required();
  command
      ->add_option("--depth", arguments->depths,
                   "depths in metres below mean sea level (default: native levels)")
      ->delimiter(',');
  command->add_flag("--csv", arguments->csv, "comma-separated values");
  command
      ->add_option("--member", arguments->member,
                   "one member of the ensemble, 0 the central one (default: 0)")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--members", arguments->members, "list every member, with --json");
  command->callback([arguments, &context] { run_profile(*arguments, context); });
}

}  // namespace slackwater::api
