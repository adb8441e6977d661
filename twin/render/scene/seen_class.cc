#include "twin/render/scene/seen_class.h"

namespace slackwater::twin {

const char* name_of(SeenClass seen) noexcept {
  constexpr std::array<const char*, seen_classes> names{
      "nothing", "monopile",  "transition_piece", "tower",  "nacelle",
      "blade",   "anodes",    "mooring_line",     "cable",  "bed",
      "water",   "structure", "vehicle",          "vessel", "tether"};
  return names[static_cast<std::size_t>(seen)];
}

SeenClass class_of(SurfaceKind kind) noexcept {
  return static_cast<SeenClass>(static_cast<int>(kind) + 1);
}
static_assert(static_cast<int>(SeenClass::water) == static_cast<int>(SurfaceKind::water) + 1);

const char* name_of(Material material) noexcept {
  constexpr std::array<const char*, materials> names{
      "none", "yellow_paint", "grey_paint", "gelcoat", "steel", "concrete", "anode",
      "sand", "rubber",       "plastic",    "water",   "rust",  "growth",   "crack"};
  return names[static_cast<std::size_t>(material)];
}

Material usual_material_of(SurfaceKind kind) noexcept {
  switch (kind) {
    case SurfaceKind::monopile:
    case SurfaceKind::mooring_line:
      return Material::steel;
    case SurfaceKind::transition_piece:
      return Material::yellow_paint;
    case SurfaceKind::tower:
    case SurfaceKind::nacelle:
      return Material::grey_paint;
    case SurfaceKind::blade:
      return Material::gelcoat;
    case SurfaceKind::anodes:
      return Material::anode;
    case SurfaceKind::cable:
    case SurfaceKind::bed:  // the corridor of bed above a cable, and the bed
      return Material::sand;
    case SurfaceKind::water:
      return Material::water;
  }
  return Material::none;
}

}  // namespace slackwater::twin
