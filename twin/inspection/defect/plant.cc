#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/inspection/defect/defect_plan.h"
#include "twin/sensor/noise.h"

namespace slackwater::twin {
namespace {

/// Where defects of one entry can be, with the area up to and with each patch.
struct Ground {
  struct Piece {
    std::size_t surface = 0;
    std::size_t patch = 0;
  };
  std::vector<Piece> pieces;
  std::vector<double> area_to_m2;
};

std::string named(const PlannedDefects& entry, std::size_t number) {
  return formatted("defects, entry {} ({})", number + 1, name_of(entry.kind));
}

[[noreturn]] void refuse(const PlannedDefects& entry, std::size_t number, const std::string& why) {
  throw Error(ErrorKind::invalid_input, named(entry, number) + ": " + why);
}

std::string words_for_surfaces(DefectKind kind) {
  std::vector<std::string> words;
  for (const SurfaceKind surface : surfaces_of(kind)) words.emplace_back(name_of(surface));
  return joined(words, ", ");
}

std::size_t surface_named(const PlannedDefects& entry, std::size_t number,
                          std::span<const Surface> surfaces) {
  std::vector<std::string> known;
  for (const Surface& surface : surfaces) known.push_back(surface.name);
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (surfaces[s].name != entry.surface) continue;
    if (!may_sit_on(entry.kind, surfaces[s].kind))
      refuse(entry, number,
             formatted("found it on {}, a {}; expected it on one of: {}", entry.surface,
                       name_of(surfaces[s].kind), words_for_surfaces(entry.kind)));
    return s;
  }
  refuse(entry, number,
         formatted("found no surface {}; this run has {}", entry.surface,
                   known.empty() ? "none" : joined(known, ", ")));
}

Ground ground_of(const PlannedDefects& entry, std::size_t number, std::span<const Surface> surfaces,
                 const DefectFacts::OfKind& facts) {
  const bool is_any = entry.surface.empty();
  const std::size_t only = is_any ? 0 : surface_named(entry, number, surfaces);
  Ground ground;
  double area_m2 = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (is_any ? !may_sit_on(entry.kind, surfaces[s].kind) : s != only) continue;
    for (std::size_t p = 0; p < surfaces[s].patches.size(); ++p) {
      const Patch& patch = surfaces[s].patches[p];
      if (-patch.centre_m.z > facts.up_to_height_m || patch.down_m > facts.from_top_m) continue;
      area_m2 += patch.area_m2;
      ground.pieces.push_back({s, p});
      ground.area_to_m2.push_back(area_m2);
    }
  }
  if (!(area_m2 > 0))
    refuse(entry, number,
           is_any ? formatted("no surface of this run has room for it; it needs one of: {}",
                              words_for_surfaces(entry.kind))
                  : formatted("{} has no patch where this kind is found", entry.surface));
  return ground;
}

Ground::Piece picked(const Ground& ground, double share) {
  const double area_m2 = share * ground.area_to_m2.back();
  const auto at = std::upper_bound(ground.area_to_m2.begin(), ground.area_to_m2.end() - 1, area_m2);
  return ground.pieces[static_cast<std::size_t>(at - ground.area_to_m2.begin())];
}

double along_of(const PlannedDefects& entry, std::size_t number, const Surface& surface) {
  const Sheet& sheet = surface.sheet;
  if (!sheet.is_all_round)
    refuse(entry, number,
           formatted("{} does not go round an upright axis, so that it has no bearings; give "
                     "along_m and down_m",
                     surface.name));
  const double turn = 2 * constants::pi;
  const double round = (entry.place->bearing_rad - sheet.first_bearing_rad) / turn;
  return (round - std::floor(round)) * sheet.width_m;
}

Ground::Piece placed(const PlannedDefects& entry, std::size_t number,
                     std::span<const Surface> surfaces) {
  const std::size_t s = surface_named(entry, number, surfaces);
  const Surface& surface = surfaces[s];
  const DefectPlace& place = *entry.place;
  const double along_m = place.is_by_bearing ? along_of(entry, number, surface) : place.along_m;
  const double down_m = place.is_by_bearing ? place.z_m - surface.sheet.top_z_m : place.down_m;
  const auto patch = patch_at(surface, along_m, down_m);
  if (!patch)
    refuse(entry, number,
           formatted("found it {:g} m along and {:g} m down, off {}, whose sheet is {:g} m by "
                     "{:g} m; place it on the surface",
                     along_m, down_m, surface.name, surface.sheet.width_m, surface.sheet.height_m));
  return {s, *patch};
}

/// Evenly over the logarithm.
double between(const Range& span, double share) {
  return span.low == span.high ? span.low : span.low * std::pow(span.high / span.low, share);
}

void expect_room(const PlannedDefects& entry, std::size_t number, const Defect& defect,
                 const Surface& surface) {
  const double longest_m = std::max(surface.sheet.width_m, surface.sheet.height_m);
  if (defect.size_m <= longest_m) return;
  refuse(entry, number,
         formatted("found a size of {:.3g} m, larger than {}, {:g} m at most; give a smaller "
                   "size_m",
                   defect.size_m, surface.name, longest_m));
}

}  // namespace

std::optional<std::size_t> patch_at(const Surface& surface, double along_m,
                                    double down_m) noexcept {
  constexpr double rounding_m = 1e-6;  // widths are in single precision
  std::optional<std::size_t> nearest;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < surface.patches.size(); ++p) {
    const Patch& patch = surface.patches[p];
    double aside_m = along_m - patch.along_m;
    if (surface.sheet.is_all_round) aside_m = std::remainder(aside_m, surface.sheet.width_m);
    aside_m = std::abs(aside_m);
    const double off_m = std::abs(down_m - patch.down_m);
    if (aside_m > 0.5 * static_cast<double>(patch.width_m) + rounding_m ||
        off_m > 0.5 * static_cast<double>(patch.height_m) + rounding_m)
      continue;
    const double away_m = std::hypot(aside_m, off_m);
    if (away_m < nearest_m) {
      nearest_m = away_m;
      nearest = p;
    }
  }
  return nearest;
}

std::vector<Defect> plant(const DefectPlan& plan, std::span<const Surface> surfaces,
                          const DefectFacts& facts, std::uint64_t seed) {
  std::vector<Defect> defects;
  std::array<std::size_t, defect_kinds> before{};
  for (std::size_t e = 0; e < plan.entries.size(); ++e) {
    const PlannedDefects& entry = plan.entries[e];
    const DefectFacts::OfKind& of = facts.of(entry.kind);
    if (entry.count == 0) continue;
    const Ground ground = entry.place ? Ground{} : ground_of(entry, e, surfaces, of);
    for (std::size_t i = 0; i < entry.count; ++i) {
      const std::size_t ordinal = before[static_cast<std::size_t>(entry.kind)]++;
      NoiseStream chance(seed, formatted("inspection/plant/{}/{}", name_of(entry.kind), ordinal));
      const double where = chance.uniform();
      const Ground::Piece piece = entry.place ? placed(entry, e, surfaces) : picked(ground, where);
      Defect defect;
      defect.number = static_cast<std::uint32_t>(defects.size());
      defect.kind = entry.kind;
      defect.surface = piece.surface;
      defect.patch = piece.patch;
      defect.size_m = between(entry.size_m.value_or(of.size_m), chance.uniform());
      defect.severity = between(entry.severity.value_or(of.severity), chance.uniform());
      expect_room(entry, e, defect, surfaces[piece.surface]);
      defects.push_back(defect);
    }
  }
  return defects;
}

}  // namespace slackwater::twin
