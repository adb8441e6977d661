#include <optional>
#include <utility>
#include <vector>

#include "twin/inspection/surface/planned_surface.h"
#include "twin/scenario/write_conduct.h"
#include "twin/scenario/write_number.h"

namespace slackwater::twin {
namespace {

/// The keys of an entry: what is nothing is left out.
class SurfaceEntry {
 public:
  SurfaceEntry& put(const char* key, const std::optional<double>& number) {
    return number ? put(key, YamlValue(*number)) : *this;
  }
  SurfaceEntry& put(const char* key, const std::optional<int>& count) {
    return count ? put(key, YamlValue(static_cast<double>(*count))) : *this;
  }
  SurfaceEntry& put(const char* key, YamlValue value) {
    value_.put(key, std::move(value));
    return *this;
  }
  SurfaceEntry& put_angle(const char* key, const std::optional<double>& rad) {
    return rad ? put(key, YamlValue(degrees_for(*rad))) : *this;
  }
  SurfaceEntry& put_place(const Triple<double>& at_m) {
    value_.put("north_m", at_m.x).put("east_m", at_m.y);
    put_level(at_m.z, value_);
    return *this;
  }
  SurfaceEntry& put_axis(const Upright& upright, double radius_m) {
    value_.put("north_m", upright.north_m).put("east_m", upright.east_m).put("radius_m", radius_m);
    return *this;
  }
  SurfaceEntry& put_levels(const Upright& upright) {
    value_.put("from", level_value(upright.top_m)).put("to", level_value(upright.bottom_m));
    return *this;
  }
  SurfaceEntry& put_arc(const Arc& arc) {
    if (arc != Arc{}) value_.put("bearings_deg", bearings_value(arc.from_rad, arc.arc_rad));
    return *this;
  }
  YamlValue take() { return std::move(value_); }

 private:
  YamlValue value_;
};

void put_sizes(const MonopileSizes& pile, SurfaceEntry& entry) {
  entry.put_axis(pile.upright, pile.radius_m).put_levels(pile.upright).put_arc(pile.arc);
}

void put_sizes(const TransitionPieceSizes& piece, SurfaceEntry& entry) {
  entry.put_axis(piece.upright, piece.radius_m)
      .put_angle("landing_deg", piece.landing_rad)
      .put_levels(piece.upright)
      .put("bolts", piece.bolts)
      .put("flange_width_m", piece.flange_width_m)
      .put("flange_thickness_m", piece.flange_thickness_m)
      .put("fender_radius_m", piece.fender_radius_m);
}

void put_sizes(const TowerSizes& tower, SurfaceEntry& entry) {
  entry.put_axis(tower.upright, tower.radius_m)
      .put_levels(tower.upright)
      .put("top_radius_m", tower.top_radius_m)
      .put_arc(tower.arc);
}

void put_sizes(const NacelleSizes& nacelle, SurfaceEntry& entry) {
  entry.put_place(nacelle.hub_m)
      .put("length_m", nacelle.length_m)
      .put("width_m", nacelle.width_m)
      .put("tall_m", nacelle.tall_m)
      .put("ahead_m", nacelle.ahead_m)
      .put_angle("rotor_faces_deg", nacelle.rotor_faces_rad)
      .put("roof_rise_m", nacelle.roof_rise_m);
}

void put_sizes(const BladeSizes& blade, SurfaceEntry& entry) {
  entry.put_place(blade.hub_m)
      .put("tip_m", YamlValue(blade.tip_m))
      .put("blade", std::optional(blade.blade))
      .put_angle("rotor_faces_deg", blade.rotor_faces_rad)
      .put_angle("rotor_azimuth_deg", blade.rotor_azimuth_rad)
      .put("overhang_m", blade.overhang_m)
      .put("root_m", blade.root_m)
      .put("chord_m", blade.chord_m)
      .put("tip_chord_m", blade.tip_chord_m)
      .put("root_thickness", blade.root_thickness)
      .put("tip_thickness", blade.tip_thickness)
      .put_angle("twist_deg", blade.twist_rad)
      .put_angle("pitch_deg", blade.pitch_rad)
      .put("camber", blade.camber);
}

void put_sizes(const AnodesSizes& anodes, SurfaceEntry& entry) {
  entry.put_axis(anodes.upright, anodes.radius_m)
      .put_angle("first_bearing_deg", anodes.first_bearing_rad)
      .put_levels(anodes.upright)
      .put("bars", anodes.bars)
      .put("rows", anodes.rows)
      .put("length_m", anodes.length_m)
      .put("width_m", anodes.width_m)
      .put("off_m", anodes.off_m);
}

void put_sizes(const MooringLineSizes& line, SurfaceEntry& entry) {
  entry.put("fairlead", place_value(line.fairlead_m))
      .put("anchor", place_value(line.anchor_m))
      .put("radius_m", line.radius_m)
      .put("share", line.share);
}

void put_sizes(const CableSizes& cable, SurfaceEntry& entry) {
  std::vector<YamlValue> route;
  for (const CableSizes::Point& point : cable.route) {
    YamlValue& value = route.emplace_back(place_value(point.bed_m));
    if (point.burial_m) value.put("burial_m", *point.burial_m);
  }
  entry.put("off_ends_m", cable.off_ends_m)
      .put("burial_m", cable.burial_m)
      .put("route", YamlValue(std::move(route)))
      .put("corridor_m", cable.corridor_m)
      .put("radius_m", cable.radius_m);
}

void put_sizes(const BedSizes& bed, SurfaceEntry& entry) {
  entry.put_place(bed.foot_m).put("radius_m", YamlValue(bed.radius_m)).put("outer_m", bed.outer_m);
  if (!bed.scour) return;
  SurfaceEntry scour;
  scour.put("depth_m", YamlValue(bed.scour->depth_m))
      .put("width_m", bed.scour->width_m)
      .put_angle("slope_deg", bed.scour->slope_rad)
      .put("skew", bed.scour->skew)
      .put_angle("deepest_deg", bed.scour->deepest_rad);
  entry.put("scour", scour.take());
}

void put_sizes(const WaterSizes& water, SurfaceEntry& entry) {
  if (const auto& disc = water.disc) {
    entry.put("north_m", YamlValue(disc->north_m))
        .put("east_m", YamlValue(disc->east_m))
        .put("inner_m", disc->inner_m)
        .put("radius_m", YamlValue(disc->radius_m));
    return;
  }
  std::vector<YamlValue> corners;
  for (const Triple<double>& corner_m : water.corners) corners.push_back(plan_value(corner_m));
  entry.put("corners", YamlValue(std::move(corners)));
}

}  // namespace

YamlValue surface_value(const PlannedSurface& surface) {
  SurfaceEntry entry;
  entry.put("kind", YamlValue(name_of(surface.kind()))).put("name", YamlValue(surface.name));
  std::visit([&](const auto& sizes) { put_sizes(sizes, entry); }, surface.sizes);
  entry.put("patch_m", surface.patch_m);
  return entry.take();
}

}  // namespace slackwater::twin
