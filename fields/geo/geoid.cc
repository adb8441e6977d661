#include "fields/geo/geoid.h"

#include <proj.h>

#include <cmath>
#include <memory>

#include "fields/base/error.h"

namespace slackwater {

double geoid_height_m(const GeoPoint& point) {
  const std::unique_ptr<PJ_CONTEXT, decltype(&proj_context_destroy)> context(proj_context_create(),
                                                                             &proj_context_destroy);
  proj_log_level(context.get(), PJ_LOG_NONE);
  const std::unique_ptr<PJ, decltype(&proj_destroy)> shift(
      proj_create(context.get(), "+proj=vgridshift +grids=egm96_15.gtx +multiplier=1"),
      &proj_destroy);
  const PJ_COORD out =
      shift ? proj_trans(shift.get(), PJ_FWD,
                         proj_coord(point.longitude.radians(), point.latitude.radians(), 0, 0))
            : proj_coord(HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL);
  if (!std::isfinite(out.lpz.z)) {
    throw Error(ErrorKind::unavailable,
                "the height of the geoid is not known: PROJ has no grid egm96_15.gtx; install the "
                "package proj-data");
  }
  return out.lpz.z;
}

}  // namespace slackwater
