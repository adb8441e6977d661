#include "twin/inspection/surface/make_surface.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/surface_builder.h"

namespace slackwater::twin {
namespace {

using Make = Surface (*)(const Config& config, double patch_m);

struct Shape {
  SurfaceKind kind;
  Make make;
  bool is_solid;
};
constexpr std::array<Shape, 10> shapes{
    {{SurfaceKind::monopile, make_monopile, true},
     {SurfaceKind::transition_piece, make_transition_piece, true},
     {SurfaceKind::tower, make_tower, true},
     {SurfaceKind::nacelle, make_nacelle, true},
     {SurfaceKind::blade, make_blade, true},
     {SurfaceKind::anodes, make_anodes, true},
     {SurfaceKind::mooring_line, make_mooring_line, true},
     {SurfaceKind::cable, make_cable, false},
     {SurfaceKind::bed, make_bed, false},
     {SurfaceKind::water, make_water, false}}};

const Shape& shape_of(SurfaceKind kind) {
  return *std::find_if(shapes.begin(), shapes.end(),
                       [&](const Shape& shape) { return shape.kind == kind; });
}

Surface made(const Config& config, const Shape& shape, double patch_m) {
  const auto own_m = config.optional_number("patch_m", {0.005, 500});
  double side_m = own_m.value_or(patch_m);
  for (;;) {
    try {
      return shape.make(config, side_m);
    } catch (const TooManyPatches&) {
      if (own_m)
        config.refuse("patch_m", formatted("found {:g} m, which makes more than {} patches or {} "
                                           "triangles; take larger ones",
                                           *own_m, TooManyPatches::most_patches,
                                           TooManyPatches::most_triangles));
      side_m *= 1.25;
    }
  }
}

}  // namespace

Surface make_surface(const Config& config, double patch_m) {
  const SurfaceKind kind = surface_kind_of(config.text("kind"), config, "kind");
  const std::string name = config.optional_text("name").value_or(name_of(kind));
  return with_context("surface " + name, [&] {
    const Shape& shape = shape_of(kind);
    Surface surface = made(config, shape, patch_m);
    surface.name = name;
    if (shape.is_solid) expect_closed(surface);
    return surface;
  });
}

SurfaceKind surface_kind_of(std::string_view word, const Config& config, std::string_view key) {
  std::vector<std::string> known;
  for (const Shape& shape : shapes) {
    if (word == name_of(shape.kind)) return shape.kind;
    known.emplace_back(name_of(shape.kind));
  }
  const auto nearest = nearest_word(word, known);
  config.refuse(key, "found " + std::string(word) + ", expected one of " + joined(known, ", ") +
                         (nearest ? "; did you mean " + *nearest + "?" : ""));
}

}  // namespace slackwater::twin
