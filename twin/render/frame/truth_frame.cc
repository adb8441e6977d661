#include "twin/render/frame/truth_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/parallel.h"

namespace slackwater::twin {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// The marks of each thing.
std::vector<std::vector<std::uint16_t>> marks_by_thing(const RenderScene& scene) {
  std::vector<std::vector<std::uint16_t>> by_thing(scene.things.size());
  for (std::size_t i = 0; i < scene.marks.size(); ++i)
    by_thing[scene.marks[i].thing].push_back(static_cast<std::uint16_t>(i + 1));
  return by_thing;
}

/// Where the place of a triangle is when the triangle is elsewhere.
Triple<double> carried(const TriangleMesh& mesh, const TriangleMesh& then, std::size_t triangle,
                       const Triple<double>& at_m) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Triple<double> from = mesh.corner_m(a);
  const Triple<double> ab = mesh.corner_m(b) - from, ac = mesh.corner_m(c) - from;
  const Triple<double> n = cross(ab, ac), at = at_m - from;
  const double whole = dot(n, n);
  const double weight_b = dot(n, cross(at, ac)) / whole;
  const double weight_c = dot(n, cross(ab, at)) / whole;
  const Triple<double> then_from = then.corner_m(a);
  return then_from + weight_b * (then.corner_m(b) - then_from) +
         weight_c * (then.corner_m(c) - then_from);
}

/// One picture's truth while its rows are filled in.
class Filling {
 public:
  Filling(const RenderScene& scene, const Pinhole& camera, const FrameHits& hits,
          const OtherMoment* other, TruthFrame& frame)
      : scene_(scene),
        camera_(camera),
        hits_(hits),
        other_(other),
        frame_(frame),
        marks_(marks_by_thing(scene)) {}

  void fill_row(int j) {
    for (int i = 0; i < camera_.wide(); ++i) {
      const auto at = static_cast<std::size_t>(j) * static_cast<std::size_t>(camera_.wide()) +
                      static_cast<std::size_t>(i);
      if (hits_.is_hit(at)) fill(at, i, j);
    }
  }

 private:
  void fill(std::size_t at, int i, int j) {
    const Ray ray = camera_.ray(i, j);
    const double range_m = hits_.range_m[at];
    const std::uint32_t thing = hits_.mesh[at];
    const SeenThing& seen = scene_.things[thing];
    const Triple<double> place_m = ray.from_m + range_m * ray.direction;
    frame_.range_m[at] = static_cast<float>(range_m);
    frame_.depth_m[at] = static_cast<float>(range_m * dot(ray.direction, camera_.axis()));
    frame_.instance[at] = static_cast<std::uint16_t>(thing + 1);
    frame_.seen_class[at] = seen.seen_class;
    for (const std::uint16_t mark : marks_[thing])
      if (scene_.marks[mark - 1U].holds(place_m)) frame_.defect[at] = mark;
    Triple<double> normal = seen.mesh.area_vector_m2(hits_.triangle[at]);
    const double towards = dot(normal, ray.direction);
    normal = ((towards > 0 ? -1 : 1) / length_of(normal)) * normal;
    frame_.normal[at] = {static_cast<float>(dot(normal, camera_.right())),
                         static_cast<float>(dot(normal, camera_.down())),
                         static_cast<float>(dot(normal, camera_.axis()))};
    if (other_ == nullptr) return;
    const Triple<double> then_m =
        carried(seen.mesh, other_->scene.things[thing].mesh, hits_.triangle[at], place_m);
    if (const auto then = other_->camera.place_of(then_m))
      frame_.flow[at] = {static_cast<float>(then->u - (i + 0.5)),
                         static_cast<float>(then->v - (j + 0.5))};
  }
  const RenderScene& scene_;
  const Pinhole& camera_;
  const FrameHits& hits_;
  const OtherMoment* other_;
  TruthFrame& frame_;
  std::vector<std::vector<std::uint16_t>> marks_;
};

}  // namespace

void find_hits_of(const RenderScene& scene, const Pinhole& camera, double most_range_m, int threads,
                  FrameHits& hits) {
  std::vector<const TriangleMesh*> meshes;
  for (const SeenThing& thing : scene.things) meshes.push_back(&thing.mesh);
  find_first_hits(camera, meshes, most_range_m, threads, hits);
}

TruthFrame truth_of(const RenderScene& scene, const Pinhole& camera, double most_range_m,
                    int threads, FrameHits& hits, const OtherMoment* other) {
  constexpr std::size_t most = 65535;
  expects(scene.things.size() < most && scene.marks.size() < most,
          "things and marks of a scene have numbers of 16 bits");
  if (other != nullptr) {
    expects(other->scene.things.size() == scene.things.size(), "the same things at both moments");
    for (std::size_t i = 0; i < scene.things.size(); ++i)
      expects(other->scene.things[i].mesh.corners.size() == scene.things[i].mesh.corners.size(),
              "the same triangles at both moments");
  }
  find_hits_of(scene, camera, most_range_m, threads, hits);
  TruthFrame frame;
  frame.wide = camera.wide();
  frame.high = camera.high();
  frame.range_m.assign(hits.pixels(), none);
  frame.depth_m.assign(hits.pixels(), none);
  frame.instance.assign(hits.pixels(), 0);
  frame.seen_class.assign(hits.pixels(), SeenClass::nothing);
  frame.defect.assign(hits.pixels(), 0);
  frame.normal.assign(hits.pixels(), {0, 0, 0});
  if (other != nullptr) frame.flow.assign(hits.pixels(), {none, none});
  Filling filling(scene, camera, hits, other, frame);
  for_all(static_cast<std::size_t>(frame.high), threads,
          [&](std::size_t j) { filling.fill_row(static_cast<int>(j)); });
  return frame;
}

}  // namespace slackwater::twin
