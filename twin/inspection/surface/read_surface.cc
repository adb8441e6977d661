#include <algorithm>
#include <array>
#include <utility>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/planned_surface.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/surface_builder.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {
namespace {

using constants::degree;
constexpr Range from_origin{-1e6, 1e6};
constexpr Range a_bearing{-360, 360};
constexpr Range a_size{0.001, 500};
constexpr double check_patch_m = 2;  // of surfaces that are made to see whether they can be

/// The keys of an entry, and what its site states where it does not say so itself.
template <typename Sizes>
class SizeKeys {
 public:
  SizeKeys(const Config& entry, const Sizes* stated) : entry_(entry), stated_(stated) {}

  double number(const char* key, double Sizes::*size, Range range) const {
    return stated_ && !entry_.has(key) ? stated_->*size : entry_.number(key, range);
  }
  std::optional<double> number(const char* key, std::optional<double> Sizes::*size,
                               Range range = a_size) const {
    const auto own = entry_.optional_number(key, range);
    return own || !stated_ ? own : stated_->*size;
  }
  std::optional<double> angle_rad(const char* key, std::optional<double> Sizes::*size,
                                  Range range_deg = a_bearing) const {
    const auto own_deg = entry_.optional_number(key, range_deg);
    if (own_deg) return *own_deg * degree;
    return stated_ ? stated_->*size : std::nullopt;
  }
  /// With the levels that a site states.
  Upright upright() const;
  /// north_m, east_m, and depth_m or height_m.
  Triple<double> point(Triple<double> Sizes::*place) const;

 private:
  const Config& entry_;
  const Sizes* stated_;
};

double read_z(const Config& level) {
  const auto deep = level.optional_number("depth_m", {0, 12000});
  const auto high = level.optional_number("height_m", {0, 500});
  if (deep.has_value() == high.has_value())
    level.refuse("depth_m", "give one of depth_m and height_m");
  return deep ? *deep : 0 - *high;
}

Triple<double> read_place(const Config& place) {
  return {place.number("north_m", from_origin), place.number("east_m", from_origin), read_z(place)};
}

template <typename Sizes>
Upright SizeKeys<Sizes>::upright() const {
  Upright upright = stated_ ? stated_->upright : Upright{};
  const auto read = [&](const char* key, double& value) {
    if (!stated_ || entry_.has(key)) value = entry_.number(key, from_origin);
  };
  read("north_m", upright.north_m);
  read("east_m", upright.east_m);
  if (!stated_) {
    upright.top_m = read_z(entry_.child("from"));
    upright.bottom_m = read_z(entry_.child("to"));
  }
  return upright;
}

template <typename Sizes>
Triple<double> SizeKeys<Sizes>::point(Triple<double> Sizes::*place) const {
  if (!stated_) return read_place(entry_);
  Triple<double> at_m = stated_->*place;
  at_m.x = entry_.optional_number("north_m", from_origin).value_or(at_m.x);
  at_m.y = entry_.optional_number("east_m", from_origin).value_or(at_m.y);
  if (entry_.has("depth_m") || entry_.has("height_m")) at_m.z = read_z(entry_);
  return at_m;
}

Arc read_arc(const Config& entry) {
  if (!entry.has("bearings_deg")) return {};
  const std::vector<double> bearings = entry.numbers("bearings_deg", {-360, 720});
  if (bearings.size() != 2)
    entry.refuse("bearings_deg", formatted("found {} bearings, expected two: from where to where, "
                                           "clockwise",
                                           bearings.size()));
  const double arc_deg = bearings[1] - bearings[0];
  if (!(arc_deg > 0 && arc_deg <= 360))
    entry.refuse("bearings_deg", formatted("goes round by {:g} degrees, expected more than 0 and "
                                           "at most 360; across north write [350, 370]",
                                           arc_deg));
  return {bearings[0] * degree, arc_deg * degree};
}

MonopileSizes read_sizes(const Config& entry, const MonopileSizes* stated) {
  const SizeKeys keys(entry, stated);
  return {keys.upright(), keys.number("radius_m", &MonopileSizes::radius_m, {0.05, 50}),
          read_arc(entry)};
}

TransitionPieceSizes read_sizes(const Config& entry, const TransitionPieceSizes* stated) {
  using Sizes = TransitionPieceSizes;
  const SizeKeys keys(entry, stated);
  Sizes piece;
  piece.upright = keys.upright();
  piece.radius_m = keys.number("radius_m", &Sizes::radius_m, {0.2, 50});
  piece.flange_width_m = keys.number("flange_width_m", &Sizes::flange_width_m);
  piece.flange_thickness_m = keys.number("flange_thickness_m", &Sizes::flange_thickness_m);
  piece.bolts = entry.optional_integer("bolts", 0, 1000);
  piece.landing_rad = keys.angle_rad("landing_deg", &Sizes::landing_rad);
  if (piece.landing_rad)
    piece.fender_radius_m = keys.number("fender_radius_m", &Sizes::fender_radius_m);
  return piece;
}

TowerSizes read_sizes(const Config& entry, const TowerSizes* stated) {
  const SizeKeys keys(entry, stated);
  return {keys.upright(), keys.number("radius_m", &TowerSizes::radius_m, {0.05, 50}),
          keys.number("top_radius_m", &TowerSizes::top_radius_m), read_arc(entry)};
}

NacelleSizes read_sizes(const Config& entry, const NacelleSizes* stated) {
  using Sizes = NacelleSizes;
  const SizeKeys keys(entry, stated);
  Sizes nacelle;
  nacelle.hub_m = keys.point(&Sizes::hub_m);
  nacelle.rotor_faces_rad = entry.number("rotor_faces_deg", a_bearing) * degree;
  nacelle.length_m = keys.number("length_m", &Sizes::length_m);
  nacelle.width_m = keys.number("width_m", &Sizes::width_m);
  nacelle.tall_m = keys.number("tall_m", &Sizes::tall_m);
  nacelle.ahead_m = keys.number("ahead_m", &Sizes::ahead_m, {-100, 100});
  const double wide_m = nacelle.width_m.value_or(usual::nacelle_width_m);
  nacelle.roof_rise_m = keys.number("roof_rise_m", &Sizes::roof_rise_m, {0, 0.5 * wide_m});
  return nacelle;
}

BladeSizes read_sizes(const Config& entry, const BladeSizes* stated) {
  using Sizes = BladeSizes;
  const SizeKeys keys(entry, stated);
  constexpr Range thick{0.05, 0.9};
  Sizes blade;
  blade.rotor_faces_rad = entry.number("rotor_faces_deg", a_bearing) * degree;
  blade.rotor_azimuth_rad = keys.angle_rad("rotor_azimuth_deg", &Sizes::rotor_azimuth_rad);
  blade.blade = entry.integer("blade", 1, 3);
  blade.hub_m = keys.point(&Sizes::hub_m);
  blade.overhang_m = keys.number("overhang_m", &Sizes::overhang_m, {0, 50});
  blade.tip_m = keys.number("tip_m", &Sizes::tip_m, {1, 200});
  blade.root_m = keys.number("root_m", &Sizes::root_m, {0, 200});
  blade.chord_m = keys.number("chord_m", &Sizes::chord_m, {0.05, 20});
  blade.tip_chord_m = keys.number("tip_chord_m", &Sizes::tip_chord_m, {0.02, 20});
  blade.root_thickness = keys.number("root_thickness", &Sizes::root_thickness, thick);
  blade.tip_thickness = keys.number("tip_thickness", &Sizes::tip_thickness, thick);
  blade.twist_rad = keys.angle_rad("twist_deg", &Sizes::twist_rad, {-90, 90});
  blade.pitch_rad = keys.angle_rad("pitch_deg", &Sizes::pitch_rad, {-180, 180});
  blade.camber = keys.number("camber", &Sizes::camber, {0, 0.1});
  return blade;
}

AnodesSizes read_sizes(const Config& entry, const AnodesSizes* stated) {
  using Sizes = AnodesSizes;
  const SizeKeys keys(entry, stated);
  Sizes anodes;
  anodes.upright = keys.upright();
  anodes.radius_m = keys.number("radius_m", &Sizes::radius_m, {0.05, 50});
  anodes.bars = entry.optional_integer("bars", 1, 200);
  anodes.rows = entry.optional_integer("rows", 1, 200);
  anodes.first_bearing_rad = keys.angle_rad("first_bearing_deg", &Sizes::first_bearing_rad);
  anodes.length_m = keys.number("length_m", &Sizes::length_m, {0.05, 10});
  anodes.width_m = keys.number("width_m", &Sizes::width_m, {0.02, 2});
  anodes.off_m = keys.number("off_m", &Sizes::off_m, {0.01, 5});
  return anodes;
}

MooringLineSizes read_sizes(const Config& entry, const MooringLineSizes* stated) {
  using Sizes = MooringLineSizes;
  const SizeKeys keys(entry, stated);
  Sizes line = stated ? *stated : Sizes{};
  if (!stated) {
    line.fairlead_m = read_place(entry.child("fairlead"));
    line.anchor_m = read_place(entry.child("anchor"));
  }
  line.radius_m = keys.number("radius_m", &Sizes::radius_m, {0.005, 2});
  line.share = keys.number("share", &Sizes::share, {0.001, 1});
  return line;
}

CableSizes read_sizes(const Config& entry, const CableSizes* stated) {
  using Sizes = CableSizes;
  constexpr Range buried{0, 20};
  const SizeKeys keys(entry, stated);
  Sizes cable = stated ? *stated : Sizes{};
  cable.burial_m = keys.number("burial_m", &Sizes::burial_m, buried);
  if (!stated)
    for (const Config& point : entry.children("route"))
      cable.route.push_back({read_place(point), point.optional_number("burial_m", buried)});
  cable.off_ends_m = keys.number("off_ends_m", &Sizes::off_ends_m, {0, 5000});
  cable.corridor_m = keys.number("corridor_m", &Sizes::corridor_m, {0.1, 500});
  cable.radius_m = keys.number("radius_m", &Sizes::radius_m, {0.005, 1});
  return cable;
}

BedSizes::Scour read_scour(const Config& entry) {
  BedSizes::Scour scour;
  scour.depth_m = entry.number("depth_m", {0, 100});
  if (entry.has("width_m") && entry.has("slope_deg"))
    entry.refuse("slope_deg", "found beside width_m; give one of them");
  const auto rad = [&](const char* key, Range range_deg) -> std::optional<double> {
    const auto deg = entry.optional_number(key, range_deg);
    return deg ? std::optional(degree * *deg) : std::nullopt;
  };
  scour.slope_rad = rad("slope_deg", {5, 45});
  scour.width_m = entry.optional_number("width_m", {0.1, 500});
  scour.skew = entry.optional_number("skew", {0, 0.9});
  scour.deepest_rad = rad("deepest_deg", a_bearing);
  return scour;
}

BedSizes read_sizes(const Config& entry, const BedSizes* stated) {
  using Sizes = BedSizes;
  const SizeKeys keys(entry, stated);
  Sizes bed;
  bed.foot_m = keys.point(&Sizes::foot_m);
  bed.radius_m = keys.number("radius_m", &Sizes::radius_m, {0.05, 50});
  if (const auto scour = entry.optional_child("scour")) bed.scour = read_scour(*scour);
  bed.outer_m = keys.number("outer_m", &Sizes::outer_m, {0.1, 5000});
  return bed;
}

WaterSizes read_sizes(const Config& entry, const WaterSizes* stated) {
  const bool has_corners = entry.has("corners");
  const bool has_radius = entry.has("radius_m") || (stated && !has_corners);
  if (has_corners == has_radius) entry.refuse("radius_m", "give one of radius_m and corners");
  WaterSizes water;
  if (has_corners) {
    for (const Config& corner : entry.children("corners"))
      water.corners.push_back(
          {corner.number("north_m", from_origin), corner.number("east_m", from_origin), 0});
    return water;
  }
  using Disc = WaterSizes::Disc;
  const SizeKeys<Disc> keys(entry, stated ? &*stated->disc : nullptr);
  water.disc = Disc{keys.number("north_m", &Disc::north_m, from_origin),
                    keys.number("east_m", &Disc::east_m, from_origin),
                    keys.number("radius_m", &Disc::radius_m, {1, 20000}),
                    keys.number("inner_m", &Disc::inner_m, {0, 20000})};
  return water;
}

using AnySizes = decltype(PlannedSurface::sizes);

/// The sizes that are the I-th of them.
template <std::size_t I = 0>
AnySizes read_any(std::size_t kind, const Config& entry, const AnySizes* stated) {
  if constexpr (I + 1 < std::variant_size_v<AnySizes>) {
    if (I != kind) return read_any<I + 1>(kind, entry, stated);
  }
  return read_sizes(entry, stated ? &std::get<I>(*stated) : nullptr);
}

PlannedSurface read_entry(const Config& entry, const PlannedSurface* stated) {
  const SurfaceKind kind = surface_kind_of(entry.text("kind"), entry, "kind");
  PlannedSurface planned;
  planned.name =
      entry.optional_text("name").value_or(stated ? stated->name : std::string(name_of(kind)));
  return with_context("surface " + planned.name, [&] {
    planned.patch_m = entry.optional_number("patch_m", {0.005, 500});
    planned.sizes =
        read_any(static_cast<std::size_t>(kind), entry, stated ? &stated->sizes : nullptr);
    try {
      (void)made(planned, check_patch_m);
    } catch (const Unmakeable& size) {
      entry.refuse(size.key, size.why);
    }
    return std::move(planned);
  });
}

constexpr std::array kinds{SurfaceKind::monopile,     SurfaceKind::transition_piece,
                           SurfaceKind::tower,        SurfaceKind::nacelle,
                           SurfaceKind::blade,        SurfaceKind::anodes,
                           SurfaceKind::mooring_line, SurfaceKind::cable,
                           SurfaceKind::bed,          SurfaceKind::water};

}  // namespace

PlannedSurface read_surface(const Config& entry) { return read_entry(entry, nullptr); }

PlannedSurface read_surface(const Config& entry, const PlannedSurface& stated) {
  return read_entry(entry, &stated);
}

SurfaceKind surface_kind_of(std::string_view word, const Config& config, std::string_view key) {
  std::vector<std::string> known;
  for (const SurfaceKind kind : kinds) {
    if (word == name_of(kind)) return kind;
    known.emplace_back(name_of(kind));
  }
  const auto nearest = nearest_word(word, known);
  config.refuse(key, "found " + std::string(word) + ", expected one of " + joined(known, ", ") +
                         (nearest ? "; did you mean " + *nearest + "?" : ""));
}

}  // namespace slackwater::twin
