#include "twin/inspection/surface/make_surface.h"

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/surface_builder.h"

namespace slackwater::twin {
namespace {

bool is_solid(SurfaceKind kind) {
  return kind != SurfaceKind::cable && kind != SurfaceKind::bed && kind != SurfaceKind::water;
}

}  // namespace

Surface made(const PlannedSurface& planned, double patch_m) {
  double side_m = planned.patch_m.value_or(patch_m);
  for (;;) {
    try {
      Surface surface =
          std::visit([&](const auto& sizes) { return make(sizes, side_m); }, planned.sizes);
      surface.name = planned.name;
      if (is_solid(surface.kind)) expect_closed(surface);
      return surface;
    } catch (const TooManyPatches&) {
      if (planned.patch_m)
        throw Unmakeable{"patch_m",
                         formatted("found {:g} m, which makes more than {} patches or {} "
                                   "triangles; take larger ones",
                                   *planned.patch_m, TooManyPatches::most_patches,
                                   TooManyPatches::most_triangles)};
      side_m *= 1.25;
    }
  }
}

Surface make_surface(const PlannedSurface& planned, double patch_m) {
  return with_context("surface " + planned.name, [&] {
    try {
      return made(planned, patch_m);
    } catch (const Unmakeable& size) {
      refuse("inspection.surfaces: " + size.key + ": " + size.why);
    }
  });
}

void expect_goes_down(const Upright& upright) {
  if (!(upright.bottom_m > upright.top_m))
    throw Unmakeable{"to", formatted("at {:g} m is not below from, at {:g} m (counted downwards); "
                                     "give the upper edge first",
                                     upright.bottom_m, upright.top_m)};
}

}  // namespace slackwater::twin
