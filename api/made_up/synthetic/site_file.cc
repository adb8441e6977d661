#include <fstream>
#include <sstream>

#include "api/made_up/synthetic/product_files.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

/// A made-up farm about the site: sizes are those of the NREL 5 MW reference turbine (Jonkman et
/// al. 2009) on a monopile of 6 m; nothing of it stands there.
std::string farm_yaml(const GeoPoint& site) {
  const auto place = [&](double north_deg, double east_deg) {
    std::ostringstream out;
    out << "latitude_deg: " << site.latitude_deg() + north_deg
        << ", longitude_deg: " << site.longitude_deg() + east_deg;
    return out.str();
  };
  return "hub_height_m: 90\n"
         "rotor_diameter_m: 126\n"
         "landing_deg: 180\n"
         "foundation: {kind: monopile, diameter_m: 6, top_height_m: 20}\n"
         "turbines:\n"
         "  - {id: A01, " +
         place(0, 0) +
         "}\n"
         "  - {id: A02, " +
         place(0.0009, 0.0095) +
         "}\n"
         "cables:\n"
         "  - {id: A01-A02, from: A01, to: A02, via: [{" +
         place(0.0003, 0.005) +
         "}], burial_depth_m: 1}\n"
         "tasks: [blade_scan, tower_tp_check, scour_survey, cp_anode, cable_burial, biofouling, "
         "access_window, mob_drill]\n";
}

}  // namespace

std::filesystem::path write_site_yaml(const SyntheticOcean& ocean,
                                      const std::filesystem::path& folder,
                                      const std::string& more) {
  std::filesystem::create_directories(folder);
  auto path = folder / "synthetic.yaml";
  const GeoPoint site = ocean.settings().site;
  std::ofstream out(path);
  out << "id: synthetic\n"
         "name: Synthetic bay (off Saint-Brieuc)\n"
      << "latitude_deg: " << site.latitude_deg() << "\n"
      << "longitude_deg: " << site.longitude_deg() << "\n"
      << "water_depth_m: " << ocean.settings().site_depth_m << "\n"
      << farm_yaml(site) << more;
  out.close();
  if (!out) {
    throw Error(ErrorKind::unavailable,
                "writing " + path.string() +
                    " failed; a writable folder was expected; check its rights and space");
  }
  return path;
}

}  // namespace slackwater::api
