#include "twin/mission/cable_of_site.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fields/base/text.h"
#include "twin/clearance/nearest_pass.h"

namespace slackwater::twin {
namespace {

/// In the plane: the bed has one depth.
double distance_m(const WorkCable& cable, const WorkTurbine& turbine) {
  const Triple<double> at_m{turbine.north_m, turbine.east_m, 0};
  const auto flat = [](const Triple<double>& p) { return Triple<double>{p.x, p.y, 0}; };
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < cable.route_m.size(); ++i)
    least_m = std::min(
        least_m,
        least_between(flat(cable.route_m[i - 1]) - at_m, flat(cable.route_m[i]) - at_m).distance_m);
  return least_m;
}

std::string known_of(const WorkSite& site) {
  std::vector<std::string> known;
  for (const WorkCable& cable : site.cables)
    known.push_back(cable.id + " (" + name_of(cable.role) + ")");
  return known.empty() ? std::string("no cables") : joined(known, ", ");
}

const WorkCable& named(const Config& entry, const WorkSite& site) {
  const std::string id = entry.text("cable");
  for (const WorkCable& cable : site.cables)
    if (cable.id == id) return cable;
  entry.refuse("cable", "found " + id + ", the site has " + known_of(site));
}

}  // namespace

const char* name_of(CableRole role) noexcept {
  return role == CableRole::array ? "array" : "export";
}

bool names_cable(const Config& entry) { return entry.has("cable") || entry.has("cable_role"); }

const WorkCable& cable_of_site(const Config& entry, const WorkSite& site,
                               const WorkTurbine& turbine) {
  const auto role = entry.optional_text("cable_role");
  if (role && entry.has("cable"))
    entry.refuse("cable_role", "found beside `cable`; give the cable's id, or its role");
  if (!role) return named(entry, site);
  if (*role != name_of(CableRole::array) && *role != name_of(CableRole::to_shore))
    entry.refuse("cable_role", "found " + *role + ", expected array or export");
  const WorkCable* nearest = nullptr;
  double least_m = std::numeric_limits<double>::infinity();
  for (const WorkCable& cable : site.cables) {
    if (*role != name_of(cable.role)) continue;
    const double away_m = distance_m(cable, turbine);
    if (away_m >= least_m) continue;
    least_m = away_m;
    nearest = &cable;
  }
  if (nearest == nullptr)
    entry.refuse("cable_role", "found " + *role + ", the site has " + known_of(site) +
                                   "; add such a cable to the site (`cables`, page on sites)");
  return *nearest;
}

}  // namespace slackwater::twin
