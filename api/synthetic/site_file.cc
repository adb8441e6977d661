#include <fstream>

#include "api/synthetic/product_files.h"
#include "fields/base/error.h"

namespace slackwater::api {

std::filesystem::path write_site_yaml(const SyntheticOcean& ocean,
                                      const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  auto path = folder / "synthetic.yaml";
  std::ofstream out(path);
  out << "id: synthetic\n"
         "name: Synthetic bay (off Saint-Brieuc)\n"
      << "latitude_deg: " << ocean.settings().site.latitude_deg() << "\n"
      << "longitude_deg: " << ocean.settings().site.longitude_deg() << "\n"
      << "water_depth_m: " << ocean.settings().site_depth_m << "\n";
  out.close();
  if (!out) {
    throw Error(ErrorKind::unavailable,
                "writing " + path.string() +
                    " failed; a writable folder was expected; check its rights and space");
  }
  return path;
}

}  // namespace slackwater::api
