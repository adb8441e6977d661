#include "fields/site/write_site.h"

#include "fields/base/text.h"
#include "fields/base/yaml_value.h"

namespace slackwater {

std::string new_site_yaml(const Site& site, std::string_view depth_source) {
  std::string yaml = "id: " + in_line(site.id) + "\nname: " + quoted_yaml(site.name) + "\n" +
                     formatted("latitude_deg: {:.6g}\nlongitude_deg: {:.7g}\n",
                               site.point.latitude_deg(), site.point.longitude_deg());
  if (site.water_depth_m)
    yaml += formatted("water_depth_m: {:.1f}  # {}\n", *site.water_depth_m, depth_source);
  else
    yaml += "# water_depth_m: 35  # not known: no bathymetry is stored for this place\n";
  if (site.time_zone) yaml += "timezone: " + site.time_zone->name() + "\n";
  return yaml;
}

}  // namespace slackwater
