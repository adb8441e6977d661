#include "twin/scenario/lay_out_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/make_surface.h"
#include "twin/inspection/surface/usual_sizes.h"
#include "twin/mission/work_pattern.h"
#include "twin/scenario/laid_out_task.h"

namespace slackwater::twin {
namespace {

/// depth_m or height_m.
void put_z(double z_m, YamlValue& value) {
  if (z_m < 0)
    value.put("height_m", to_micrometre(-z_m));
  else
    value.put("depth_m", to_micrometre(z_m));
}

YamlValue level_of(double z_m) {
  YamlValue value;
  put_z(z_m, value);
  return value;
}

YamlValue place_of(const Triple<double>& at_m) {
  YamlValue value;
  value.put("north_m", to_micrometre(at_m.x)).put("east_m", to_micrometre(at_m.y));
  put_z(at_m.z, value);
  return value;
}

/// An entry of a scenario while it is laid out.
class SurfaceLayout {
 public:
  SurfaceLayout(const Config& entry, const WorkSite& site, const WorkTurbine& turbine)
      : entry_(entry), site_(site), turbine_(turbine) {}

  YamlValue lay_out() {
    const std::string word = entry_.text("kind");
    const SurfaceKind kind = surface_kind_of(word, entry_, "kind");
    switch (kind) {
      case SurfaceKind::monopile:
        put_axis();
        put("radius_m", turbine_.radius_m);
        put_levels(0, turbine_.foot_m);
        break;
      case SurfaceKind::transition_piece:
        put_axis();
        put("radius_m", turbine_.radius_m + usual::transition_wider_m);
        put("landing_deg", turbine_.landing_rad * 180 / constants::pi);
        put_levels(turbine_.top_m, std::min(usual::transition_foot_depth_m, turbine_.foot_m));
        break;
      case SurfaceKind::tower:
        put_axis();
        put("radius_m", turbine_.radius_m);
        put_levels(has_levels() ? 0 : hub_z_m() + usual::tower_below_hub_m, turbine_.top_m);
        break;
      case SurfaceKind::nacelle: {
        put_axis();
        put("height_m", -hub_z_m());
        const double scale =
            turbine_.rotor_radius_m > 0 ? turbine_.rotor_radius_m / usual::rotor_radius_m : 1;
        put("length_m", scale * usual::nacelle_length_m);
        put("width_m", scale * usual::nacelle_width_m);
        put("tall_m", scale * usual::nacelle_height_m);
        put("ahead_m", scale * usual::nacelle_ahead_m);
        break;
      }
      case SurfaceKind::blade:
        put_axis();
        put("height_m", -hub_z_m());
        if (!(turbine_.rotor_radius_m > 0))
          entry_.refuse("kind", "the site gives no rotor_diameter_m; add it to the site");
        put("tip_m", turbine_.rotor_radius_m);
        name_ = "blade " + std::to_string(entry_.integer("blade", 1, 3));
        break;
      case SurfaceKind::anodes:
        put_axis();
        put("radius_m", turbine_.radius_m);
        put("first_bearing_deg", turbine_.landing_rad * 180 / constants::pi);
        put_levels(5, turbine_.foot_m - 3);
        break;
      case SurfaceKind::mooring_line:
        put_mooring();
        break;
      case SurfaceKind::cable:
        put_cable();
        break;
      case SurfaceKind::bed:
        put_axis();
        put("depth_m", turbine_.bed_m);
        put("radius_m", turbine_.radius_m);
        break;
      case SurfaceKind::water:
        if (entry_.has("corners")) break;
        put_axis();
        put("radius_m", usual::watch_radius_m);
        put("inner_m", turbine_.radius_m);
        break;
    }
    YamlValue surface;
    surface.put("kind", word);
    surface.put("name", entry_.has("name") ? entry_.value("name")
                                           : YamlValue(owner_ + (name_.empty() ? word : name_)));
    for (std::size_t i = 0; i < sizes_.items().size(); ++i)
      surface.put(sizes_.keys()[i], sizes_.items()[i]);
    for (const std::string& key : entry_.keys())
      if (!placed_.contains(key) && entry_.has(key)) surface.put(key, entry_.value(key));
    return surface;
  }

 private:
  void put_value(const std::string& key, YamlValue value) {
    sizes_.put(key, std::move(value));
    placed_.insert(key);
  }
  /// Unless the entry has a size of its own.
  void put(const std::string& key, double value) {
    if (!entry_.has(key)) put_value(key, to_micrometre(value));
  }
  void put_axis() {
    put("north_m", turbine_.north_m);
    put("east_m", turbine_.east_m);
  }
  bool has_levels() const { return entry_.has("from"); }
  void put_levels(double from_m, double to_m) {
    const auto level = [&](const char* key, double usual_m) {
      const auto own = entry_.optional_child(key);
      put_value(key, level_of(own ? read_level(*own, turbine_) : usual_m));
    };
    level("from", from_m);
    level("to", to_m);
  }
  double hub_z_m() const {
    if (turbine_.hub_m < 0) return turbine_.hub_m;
    entry_.refuse("kind",
                  "the site gives turbine " + turbine_.id + " no hub_height_m; add it to the site");
  }

  void put_mooring() {
    const std::string id = entry_.text("mooring");
    const auto found = std::find_if(turbine_.moorings.begin(), turbine_.moorings.end(),
                                    [&](const MooringLine& line) { return line.id == id; });
    if (found == turbine_.moorings.end())
      entry_.refuse("mooring", "found " + id + ", which turbine " + turbine_.id + " does not have");
    name_ = id;
    placed_.insert("mooring");
    put_value("fairlead", place_of(found->fairlead_m));
    put_value("anchor", place_of(found->anchor_m));
  }

  void put_cable() {
    const std::string id = entry_.text("cable");
    const auto found = std::find_if(site_.cables.begin(), site_.cables.end(),
                                    [&](const WorkCable& cable) { return cable.id == id; });
    if (found == site_.cables.end()) {
      std::vector<std::string> known;
      for (const WorkCable& cable : site_.cables) known.push_back(cable.id);
      entry_.refuse("cable", "found " + id + ", the site has " +
                                 (known.empty() ? std::string("no cables") : joined(known, ", ")));
    }
    owner_.clear();
    name_ = "cable " + id;
    placed_.insert("cable");
    put("off_ends_m", usual::off_ends_m);
    put("burial_m", found->burial_m.value_or(usual::burial_m));
    std::vector<YamlValue> points;
    for (const Triple<double>& at : found->route_m) points.push_back(place_of(at));
    put_value("route", std::move(points));
  }

  const Config& entry_;
  const WorkSite& site_;
  const WorkTurbine& turbine_;
  std::string owner_ = turbine_.id + "/";
  std::string name_;  ///< empty: its kind
  YamlValue sizes_;
  std::set<std::string> placed_{"kind", "name"};
};

}  // namespace

YamlValue lay_out_surface(const Config& entry, const WorkSite& site, const WorkTurbine& turbine) {
  return SurfaceLayout(entry, site, turbine).lay_out();
}

}  // namespace slackwater::twin
