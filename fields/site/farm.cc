#include "fields/site/farm.h"

#include <algorithm>
#include <set>

#include "fields/base/config.h"
#include "fields/base/text.h"

namespace slackwater {
namespace {

constexpr Range hub_range{10, 400};
constexpr Range rotor_range{10, 400};
constexpr Range bearing_range{-360, 360};

std::vector<Mooring> read_moorings(const Config& turbine, const std::optional<Foundation>& on) {
  std::vector<Mooring> lines;
  for (const Config& entry : turbine.children("moorings")) {
    if (!on || on->kind != FoundationKind::floating)
      turbine.refuse("moorings",
                     "found on a turbine whose foundation does not float; give it "
                     "foundation: {kind: floating, ...}, or leave them out");
    lines.push_back({entry.text("id"), entry.number("bearing_deg", bearing_range),
                     entry.number("anchor_distance_m", {10, 5000}),
                     entry.number("fairlead_depth_m", {0, 100})});
    if (lines.back().anchor_distance_m <= 0.5 * on->diameter_m)
      entry.refuse("anchor_distance_m", "is inside the foundation");
    for (std::size_t i = 0; i + 1 < lines.size(); ++i)
      if (lines[i].id == lines.back().id)
        entry.refuse("id", "found " + lines.back().id + " twice; name each line differently");
  }
  return lines;
}

}  // namespace

GeoPoint read_point(const Config& config) {
  return GeoPoint::from_degrees(config.number("latitude_deg", {-90, 90}),
                                config.number("longitude_deg", {-180, 360}));
}

const char* name_of(FoundationKind kind) noexcept {
  switch (kind) {
    case FoundationKind::monopile:
      return "monopile";
    case FoundationKind::jacket:
      return "jacket";
    case FoundationKind::floating:
      return "floating";
  }
  return "unknown";
}

std::optional<Foundation> read_foundation(const Config& config) {
  const auto c = config.optional_child("foundation");
  if (!c) return std::nullopt;
  const std::string kind = c->text("kind");
  Foundation foundation;
  foundation.top_height_m = c->number("top_height_m", {1, 60});
  if (kind == "monopile") {
    foundation.diameter_m = c->number("diameter_m", {1, 20});
  } else if (kind == "jacket") {
    foundation.kind = FoundationKind::jacket;
    foundation.diameter_m = c->number("width_m", {2, 80});
  } else if (kind == "floating") {
    foundation.kind = FoundationKind::floating;
    foundation.diameter_m = c->number("diameter_m", {1, 150});
    foundation.draught_m = c->number("draught_m", {1, 150});
  } else {
    c->refuse("kind", "found " + kind + ", expected monopile, jacket or floating");
  }
  return foundation;
}

std::vector<TurbinePlace> read_turbines(const Config& site) {
  const std::optional<Foundation> common = read_foundation(site);
  const auto landing = site.optional_number("landing_deg", bearing_range);
  const auto rotor = site.optional_number("rotor_diameter_m", rotor_range);
  const auto hub = site.optional_number("hub_height_m", hub_range);
  std::vector<TurbinePlace> turbines;
  std::set<std::string> ids;
  for (const Config& entry : site.children("turbines")) {
    TurbinePlace turbine;
    turbine.id = entry.text("id");
    if (!ids.insert(turbine.id).second)
      entry.refuse("id", "found " + turbine.id + " twice; name each turbine differently");
    turbine.point = read_point(entry);
    turbine.water_depth_m = entry.optional_number("water_depth_m", {1, 11000});
    turbine.foundation = read_foundation(entry);
    if (!turbine.foundation) turbine.foundation = common;
    turbine.hub_height_m = entry.optional_number("hub_height_m", hub_range);
    if (!turbine.hub_height_m) turbine.hub_height_m = hub;
    turbine.rotor_diameter_m = entry.optional_number("rotor_diameter_m", rotor_range);
    if (!turbine.rotor_diameter_m) turbine.rotor_diameter_m = rotor;
    turbine.landing_deg = entry.optional_number("landing_deg", bearing_range);
    if (!turbine.landing_deg) turbine.landing_deg = landing;
    turbine.moorings = read_moorings(entry, turbine.foundation);
    if (turbine.hub_height_m && turbine.foundation &&
        *turbine.hub_height_m <= turbine.foundation->top_height_m)
      entry.refuse("hub_height_m",
                   formatted("found {:g} m, not above the foundation's top at {:g} m",
                             *turbine.hub_height_m, turbine.foundation->top_height_m));
    turbines.push_back(std::move(turbine));
  }
  return turbines;
}

std::vector<CableRoute> read_cables(const Config& site, const std::vector<TurbinePlace>& turbines) {
  std::vector<CableRoute> cables;
  for (const Config& entry : site.children("cables")) {
    CableRoute cable;
    cable.id = entry.text("id");
    for (const CableRoute& other : cables)
      if (other.id == cable.id)
        entry.refuse("id", "found " + cable.id + " twice; name each cable differently");
    const auto end = [&](const char* key) {
      const auto id = entry.optional_text(key);
      if (!id) return;
      const auto found = std::find_if(turbines.begin(), turbines.end(),
                                      [&](const TurbinePlace& t) { return t.id == *id; });
      if (found == turbines.end())
        entry.refuse(key, "found " + *id + ", which is no turbine of this site");
      cable.route.push_back(found->point);
    };
    end("from");
    for (const Config& via : entry.children("via")) cable.route.push_back(read_point(via));
    end("to");
    if (cable.route.size() < 2)
      entry.refuse("via", "a cable has two ends; give from and to, or two places and more");
    cable.burial_depth_m = entry.optional_number("burial_depth_m", {0, 20});
    cables.push_back(std::move(cable));
  }
  return cables;
}

}  // namespace slackwater
