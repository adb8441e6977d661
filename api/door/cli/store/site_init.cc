#include "api/door/cli/store/site_init.h"

#include <CLI/CLI.hpp>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/pipeline/load_site_data.h"
#include "api/program/paths.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"
#include "fields/site/write_site.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct InitArguments {
  double latitude_deg = 0;
  double longitude_deg = 0;
  std::string name;
  std::string id;
  std::optional<double> water_depth_m;
  std::string time_zone;
};

/// "Parc éolien, Saint-Brieuc 2" becomes "parc_olien_saint_brieuc_2": letters and digits of ASCII,
/// one '_' for what stands between words.
std::string id_from(const std::string& name) {
  std::string id;
  for (const unsigned char c : name) {
    if (std::isalnum(c) != 0) {
      id += static_cast<char>(std::tolower(c));
    } else if (c < 128 && !id.empty() && id.back() != '_') {
      id += '_';
    }
  }
  while (id.ends_with('_')) id.pop_back();
  return id.substr(0, 64);
}

void check_place(const InitArguments& arguments) {
  const double latitude = arguments.latitude_deg;
  const double longitude = arguments.longitude_deg;
  if (std::abs(latitude) <= 90 && longitude >= -180 && longitude <= 360) return;
  std::string message =
      formatted("found latitude {:g} and longitude {:g}, expected -90 to 90 and -180 to 360",
                latitude, longitude);
  if (std::abs(longitude) <= 90 && std::abs(latitude) <= 360)
    message += "; did you swap --lat and --lon?";
  throw Error(ErrorKind::usage, message);
}

/// The depth there, where the store holds bathymetry.
std::optional<double> stored_depth_m(const Site& site, const Context& context) {
  if (!std::filesystem::exists(context.store_folder / "catalogue.sqlite")) return std::nullopt;
  store::Store store = context.open(store::OpenMode::read_only);
  return bathymetry_at(store, site);
}

void run_site_init(const InitArguments& arguments, const Context& context) {
  check_place(arguments);
  const std::string id = arguments.id.empty() ? id_from(arguments.name) : arguments.id;
  if (id.empty()) {
    throw Error(ErrorKind::usage, "--name: found '" + arguments.name +
                                      "', which has no letter or digit of ASCII to make an id of; "
                                      "give --id");
  }
  if (!is_site_id(id))
    throw Error(ErrorKind::invalid_input,
                "--id: found '" + id + "', expected at most 64 letters, digits, '-', '_' or '.'");
  const std::filesystem::path file = context.store_folder / "sites" / (id + ".yaml");
  const std::vector<std::string> known = known_sites(site_folders(context.store_folder));
  if (std::find(known.begin(), known.end(), id) != known.end()) {
    throw Error(ErrorKind::usage,
                "found a site '" + id + "' already; give another --name or --id" +
                    (std::filesystem::exists(file) ? ", or edit " + file.string() : ""));
  }
  Site site;
  site.id = id;
  site.name = arguments.name;
  site.point = GeoPoint::from_degrees(arguments.latitude_deg, arguments.longitude_deg);
  site.water_depth_m = arguments.water_depth_m;
  if (!arguments.time_zone.empty())
    site.time_zone = option_value("--timezone", arguments.time_zone, TimeZone::named);
  std::string source = "as given";
  if (!site.water_depth_m) {
    site.water_depth_m = stored_depth_m(site, context);
    source = "from the bathymetry in the store";
  }
  std::filesystem::create_directories(file.parent_path());
  write_text(file, new_site_yaml(site, source));
  if (context.json) {
    std::printf("%s\n", json{{"id", id},
                             {"file", file.string()},
                             {"water_depth_m",
                              site.water_depth_m ? json(*site.water_depth_m) : json(nullptr)}}
                            .dump(2, ' ', false, json::error_handler_t::replace)
                            .c_str());
    return;
  }
  std::printf("%s: %s at %s, %s\n", file.c_str(), site.name.c_str(),
              position_text(site.point).c_str(),
              site.water_depth_m
                  ? formatted("{:.1f} m of water ({})", *site.water_depth_m, source).c_str()
                  : "water depth not known yet: it will be taken from bathymetry, or from the "
                    "deepest wet level of the currents");
  std::printf("Next:  slackwater forecast --site %s --print-downloads\n", id.c_str());
}

}  // namespace

void add_site_init(CLI::App& site, Context& context) {
  auto arguments = std::make_shared<InitArguments>();
  CLI::App* init = site.add_subcommand("init", "Write the file of a new site into the store");
  init->add_option("--lat", arguments->latitude_deg, "latitude, degrees north")->required();
  init->add_option("--lon", arguments->longitude_deg, "longitude, degrees east")->required();
  init->add_option("--name", arguments->name, "its name for people")->required();
  init->add_option("--id", arguments->id, "its name for commands (default: made from the name)");
  init->add_option("--depth", arguments->water_depth_m,
                   "water depth in metres (default: bathymetry in the store)")
      ->check(CLI::Range(1.0, 11000.0));
  init->add_option("--timezone", arguments->time_zone,
                   "IANA name, e.g. Europe/Paris: local time is shown beside UTC");
  init->callback([arguments, &context] { run_site_init(*arguments, context); });
}

}  // namespace slackwater::api
