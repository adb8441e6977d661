#include "api/perception/corrosion_by_colour.h"
#include "api/perception/crack_by_percolation.h"
#include "api/perception/network.h"
#include "api/program/named_sheet.h"
#include "api/program/paths.h"
#include "fields/base/advice.h"

namespace slackwater::api {

std::unique_ptr<Detector> load_detector(const std::string& name_or_file) {
  const std::filesystem::path named = data_folder() / "detectors" / (name_or_file + ".yaml");
  const bool is_named =
      name_or_file.find('/') == std::string::npos && std::filesystem::exists(named);
  const std::filesystem::path file = is_named ? named : std::filesystem::path(name_or_file);
  const Config config = load_sheet("detectors", "--by", name_or_file, {});
  (void)config.text("name");
  (void)config.text("source");
  const std::string by = config.text("by");
  std::unique_ptr<Detector> detector;
  if (by == "colour") {
    detector = read_colour_detector(config);
  } else if (by == "percolation") {
    detector = read_percolation_detector(config);
  } else if (by == "network") {
    detector = read_network(config, file.parent_path());
  } else {
    config.refuse("by", "found " + by + ", expected colour, percolation or network");
  }
  config.expect_all_read();
  return detector;
}

}  // namespace slackwater::api
