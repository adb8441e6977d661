#include "twin/render/light/albedo.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/numbers/random.h"
#include "twin/render/light/growth.h"

namespace slackwater::twin {
namespace {

struct Look {
  Bands dark{};
  Bands light{};
  double length_m = 1;  ///< of its largest blotches
};

constexpr std::array<Look, materials> looks{
    Look{{0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, 1},             // none
    Look{{0.55, 0.40, 0.05}, {0.65, 0.48, 0.07}, 2},       // yellow_paint
    Look{{0.50, 0.51, 0.52}, {0.58, 0.59, 0.60}, 3},       // grey_paint
    Look{{0.70, 0.70, 0.69}, {0.76, 0.76, 0.75}, 3},       // gelcoat
    Look{{0.07, 0.075, 0.07}, {0.15, 0.15, 0.135}, 0.5},   // steel
    Look{{0.30, 0.29, 0.27}, {0.40, 0.39, 0.36}, 0.4},     // concrete
    Look{{0.28, 0.29, 0.30}, {0.45, 0.46, 0.47}, 0.1},     // anode
    Look{{0.20, 0.17, 0.13}, {0.30, 0.26, 0.20}, 0.6},     // sand
    Look{{0.04, 0.04, 0.04}, {0.06, 0.06, 0.06}, 0.3},     // rubber
    Look{{0.45, 0.10, 0.05}, {0.55, 0.14, 0.06}, 0.5},     // plastic
    Look{{0.02, 0.03, 0.03}, {0.02, 0.03, 0.03}, 1},       // water
    Look{{0.16, 0.06, 0.025}, {0.42, 0.17, 0.06}, 0.05},   // rust
    Look{{0.05, 0.07, 0.03}, {0.24, 0.22, 0.13}, 0.08},    // growth
    Look{{0.008, 0.008, 0.008}, {0.02, 0.02, 0.02}, 0.01}  // crack
};

/// Of the corner of a cube, 0 to 1. @param column  mixed from its first two numbers
double corner_value(std::uint64_t column, std::int64_t z) noexcept {
  return static_cast<double>(split_mix_64(column ^ static_cast<std::uint64_t>(z)) >> 11U) * 0x1p-53;
}

double one_octave(const Triple<double>& p, std::uint64_t seed) noexcept {
  const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
  const auto eased = [](double t) { return t * t * (3 - 2 * t); };
  const double u = eased(p.x - fx), v = eased(p.y - fy), w = eased(p.z - fz);
  const auto x = static_cast<std::int64_t>(fx), y = static_cast<std::int64_t>(fy),
             z = static_cast<std::int64_t>(fz);
  const auto mix = [](std::uint64_t with, std::int64_t number) {
    return split_mix_64(with ^ static_cast<std::uint64_t>(number));
  };
  const std::uint64_t first = mix(seed, x), next = mix(seed, x + 1);
  const std::array<std::uint64_t, 4> columns{mix(first, y), mix(next, y), mix(first, y + 1),
                                             mix(next, y + 1)};
  const auto along_x = [&](std::size_t row, std::int64_t at) {
    const double from = corner_value(columns[row], at);
    return from + u * (corner_value(columns[row + 1], at) - from);
  };
  const double a = along_x(0, z), b = along_x(2, z), c = along_x(0, z + 1), d = along_x(2, z + 1);
  const double near = a + v * (b - a), far = c + v * (d - c);
  return near + w * (far - near);
}

Bands mixed(const Bands& a, const Bands& b, double share) noexcept {
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])};
}

/// How a weld changes what the steel throws back: bright by its ripples, dark along its toes.
double share_at_weld(SeenClass seen, const Triple<double>& at_m, std::uint64_t seed) noexcept {
  if (seen != SeenClass::monopile && seen != SeenClass::transition_piece &&
      seen != SeenClass::tower)
    return 1;
  constexpr double can_m = 3, half_m = 0.012, toe_m = 0.003;
  const double off_m = std::abs(at_m.z - can_m * std::round(at_m.z / can_m));
  if (off_m > half_m) return 1;
  if (off_m > half_m - toe_m) return 0.45;
  return 0.8 + 0.5 * value_noise(at_m, 0.008, split_mix_64(seed ^ 0x3E1D));
}

Material material_of(DefectKind kind) noexcept {
  switch (kind) {
    case DefectKind::corrosion:
    case DefectKind::chain_wear:
      return Material::rust;
    case DefectKind::marine_growth:
      return Material::growth;
    case DefectKind::crack:
    case DefectKind::missing_fastener:
      return Material::crack;
    case DefectKind::leading_edge_erosion:
      return Material::concrete;  // filler and laminate under the gelcoat
    case DefectKind::anode_loss:
      return Material::steel;
    case DefectKind::burial_loss:
      return Material::rubber;
    case DefectKind::scour:
      return Material::sand;
  }
  return Material::none;
}

}  // namespace

double value_noise(const Triple<double>& at_m, double length_m, std::uint64_t seed) noexcept {
  double sum = 0, weight = 0.5, whole = 0;
  Triple<double> p = (1 / length_m) * at_m;
  for (std::uint64_t octave = 0; octave < 4; ++octave) {
    sum += weight * one_octave(p, seed + octave);
    whole += weight;
    weight *= 0.5;
    p = 2.0 * p;
  }
  return sum / whole;
}

Bands albedo_of(Material material, const Triple<double>& at_m, std::uint64_t seed) noexcept {
  const Look& look = looks[static_cast<std::size_t>(material)];
  if (look.dark == look.light) return look.dark;
  const std::uint64_t own = split_mix_64(seed + static_cast<std::uint64_t>(material));
  return mixed(look.dark, look.light,
               step_between(0.3, 0.7, value_noise(at_m, look.length_m, own)));
}

double step_between(double from, double to, double x) noexcept {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Material material_at(const SeenThing& thing, const DefectMark* mark) noexcept {
  return mark != nullptr ? material_of(mark->kind) : thing.material;
}

Bands albedo_at(const SeenThing& thing, const DefectMark* mark, const Triple<double>& at_m,
                double growth, std::uint64_t seed) noexcept {
  if (mark != nullptr) return albedo_of(material_of(mark->kind), at_m, seed);
  Bands own = albedo_of(thing.material, at_m, seed);
  const bool is_painted = thing.material == Material::yellow_paint;
  if (thing.material == Material::steel || is_painted || thing.material == Material::grey_paint) {
    const double left = share_at_weld(thing.seen_class, at_m, seed);
    for (double& one : own) one *= left;
  }
  const bool is_grown =
      thing.material == Material::steel || is_painted || thing.material == Material::anode;
  if (!is_grown) return own;
  const Growth grown = growth_at(at_m, growth, seed);
  return grown.share > 0 ? mixed(own, grown.albedo, grown.share) : own;
}

}  // namespace slackwater::twin
