#include "twin/inspection/surface/surface.h"

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::twin {

const char* name_of(SurfaceKind kind) noexcept {
  switch (kind) {
    case SurfaceKind::monopile:
      return "monopile";
    case SurfaceKind::transition_piece:
      return "transition_piece";
    case SurfaceKind::tower:
      return "tower";
    case SurfaceKind::nacelle:
      return "nacelle";
    case SurfaceKind::blade:
      return "blade";
    case SurfaceKind::anodes:
      return "anodes";
    case SurfaceKind::mooring_line:
      return "mooring_line";
    case SurfaceKind::cable:
      return "cable";
    case SurfaceKind::bed:
      return "bed";
    case SurfaceKind::water:
      return "water";
  }
  return "";
}

double Surface::area_m2() const noexcept {
  double sum_m2 = 0;
  for (const Patch& patch : patches) sum_m2 += patch.area_m2;
  return sum_m2;
}

void expect_closed(const Surface& surface) {
  if (!is_closed(surface.mesh))
    throw Error(ErrorKind::invalid_input,
                surface.name + ": does not close: an edge belongs to other than two triangles; " +
                    "correct its sizes");
  if (const double enclosed_m3 = volume_m3(surface.mesh); !(enclosed_m3 > 0))
    throw Error(ErrorKind::invalid_input,
                formatted("{}: encloses {:g} m3, its triangles face inward; correct its sizes",
                          surface.name, enclosed_m3));
}

}  // namespace slackwater::twin
