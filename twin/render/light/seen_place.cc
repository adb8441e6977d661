#include "twin/render/light/seen_place.h"

#include "twin/render/light/mark_share.h"

namespace slackwater::twin {

SeenPlaces::SeenPlaces(const RenderScene& scene, const Pinhole& camera)
    : scene_(scene), camera_(camera), marks_(scene.things.size()) {
  for (const SeenThing& thing : scene.things) normals_.emplace_back(thing.mesh);
  for (const DefectMark& mark : scene.marks) marks_[mark.thing].push_back(&mark);
}

SeenPlace SeenPlaces::at(const Ray& ray, const FrameHits& hits, std::size_t pixel) const {
  const std::uint32_t number = hits.mesh[pixel], triangle = hits.triangle[pixel];
  SeenPlace place{scene_.things[number], ray.from_m + hits.range_m[pixel] * ray.direction, {}, {}};
  const Triple<double> outward = place.thing.mesh.area_vector_m2(triangle);
  place.face = (1 / length_of(outward)) * outward;
  place.normal = normals_[number].at(triangle, place.at_m, place.face);
  if (dot(place.face, ray.direction) > 0) {
    place.normal = -1.0 * place.normal;
    place.face = -1.0 * place.face;
  }
  // Rounded off, a face that is seen could turn away at its outline.
  if (!(dot(place.normal, ray.direction) < 0)) place.normal = place.face;
  if (marks_[number].empty()) return place;
  const PixelFootprint footprint(camera_, place.at_m, place.face);
  for (const DefectMark* one : marks_[number]) {
    const double share = share_of(*one, footprint);
    if (!(share > 0 && share >= place.mark_share)) continue;
    place.mark = one;
    place.mark_share = share;
  }
  return place;
}

}  // namespace slackwater::twin
