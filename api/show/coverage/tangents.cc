#include "api/show/coverage/tangents.h"

#include <algorithm>
#include <cmath>

namespace slackwater::api {

SheetTangents tangents_of(const std::vector<const CoveragePatch*>& patches) {
  SheetTangents tangents;
  if (patches.size() < 3) return tangents;
  double along = 0, down = 0;
  Vector3<Enu> centre{0, 0, 0};
  const double share = 1 / static_cast<double>(patches.size());
  for (const CoveragePatch* p : patches) {
    along += share * p->along_m;
    down += share * p->down_m;
    centre = centre + share * p->centre_m;
  }
  double aa = 0, ad = 0, dd = 0;
  Vector3<Enu> pa{0, 0, 0}, pd{0, 0, 0};
  for (const CoveragePatch* p : patches) {
    const double a = p->along_m - along, d = p->down_m - down;
    aa += a * a;
    ad += a * d;
    dd += d * d;
    pa = pa + a * (p->centre_m - centre);
    pd = pd + d * (p->centre_m - centre);
  }
  const double square = aa * dd - ad * ad;
  if (!(square > 1e-9 * aa * dd)) return tangents;
  tangents.along = (dd / square) * pa - (ad / square) * pd;
  tangents.down = (aa / square) * pd - (ad / square) * pa;
  const auto is_near_one = [](double size) { return size > 0.6 && size < 1.4; };
  tangents.is_known = is_near_one(tangents.along.norm()) && is_near_one(tangents.down.norm());
  return tangents;
}

SheetPlace sheet_place(const InspectionCoverage& coverage, const Vector3<Enu>& place_m) {
  const CoveragePatch* nearest = coverage.nearest_patch(place_m);
  if (nearest == nullptr) return {};
  SheetPlace place{nearest->along_m, nearest->down_m, nearest->normal};
  std::vector<const CoveragePatch*> about;
  for (const CoveragePatch& patch : coverage.patches)
    if (std::abs(patch.along_m - nearest->along_m) < 1.5 * nearest->width_m &&
        std::abs(patch.down_m - nearest->down_m) < 1.5 * nearest->height_m)
      about.push_back(&patch);
  const SheetTangents tangents = tangents_of(about);
  if (!tangents.is_known) return place;
  const Vector3<Enu> off = place_m - nearest->centre_m;
  const auto part = [&](const Vector3<Enu>& tangent, double side_m) {
    return std::clamp(dot(off, tangent) / dot(tangent, tangent), -side_m / 2, side_m / 2);
  };
  place.along_m += part(tangents.along, nearest->width_m);
  place.down_m += part(tangents.down, nearest->height_m);
  return place;
}

}  // namespace slackwater::api
