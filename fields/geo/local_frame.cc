#include "fields/geo/local_frame.h"

#include <proj.h>

#include <string>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater {

struct LocalFrame::State {
  GeoPoint origin;
  PJ_CONTEXT* context = nullptr;
  PJ* transform = nullptr;
  ~State() {
    if (transform != nullptr) proj_destroy(transform);
    if (context != nullptr) proj_context_destroy(context);
  }
};

LocalFrame::LocalFrame(const GeoPoint& origin) : state_(std::make_unique<State>()) {
  state_->origin = origin;
  state_->context = proj_context_create();
  const std::string text = formatted(
      "+proj=pipeline +step +proj=cart +ellps=WGS84 "
      "+step +proj=topocentric +ellps=WGS84 +lon_0={:.15g} +lat_0={:.15g} +h_0=0",
      origin.longitude_deg(), origin.latitude_deg());
  state_->transform = proj_create(state_->context, text.c_str());
  if (state_->transform == nullptr) {
    throw Error(ErrorKind::internal, "PROJ refused '" + text + "'");
  }
}

LocalFrame::~LocalFrame() = default;
LocalFrame::LocalFrame(LocalFrame&&) noexcept = default;
LocalFrame& LocalFrame::operator=(LocalFrame&&) noexcept = default;

const GeoPoint& LocalFrame::origin() const noexcept { return state_->origin; }

Vector3<Enu> LocalFrame::to_local(const GeoPoint& point, double height_m) const {
  const PJ_COORD out =
      proj_trans(state_->transform, PJ_FWD,
                 proj_coord(point.longitude.radians(), point.latitude.radians(), height_m, 0));
  return {out.xyz.x, out.xyz.y, out.xyz.z};
}

LocalFrame::Geodetic LocalFrame::to_geodetic(const Vector3<Enu>& position) const {
  const PJ_COORD out = proj_trans(state_->transform, PJ_INV,
                                  proj_coord(position.x(), position.y(), position.z(), 0));
  return {GeoPoint::from_degrees(Angle::from_radians(out.lpz.phi).degrees(),
                                 Angle::from_radians(out.lpz.lam).degrees()),
          out.lpz.z};
}

}  // namespace slackwater
