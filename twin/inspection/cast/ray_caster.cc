#include "twin/inspection/cast/ray_caster.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "twin/inspection/cast/triangle_range.h"

namespace slackwater::twin {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// How far a box stands off what it holds, of the scene's size: single precision is wrong by less
/// than a quarter of it in what is rounded here: a box (1 in 2^24), a ray's start (1) and what its
/// direction makes of that on the way through the scene (4). What Embree adds between ray and box
/// it allows for itself (RTC_SCENE_FLAG_ROBUST).
constexpr double stand_off = 0x1p-19;

struct MeshCopy {
  Triple<double> origin_m;      ///< NED of the run
  Triple<double> from_scene_m;  ///< the same, from the scene's origin
  double off_m = 0;             ///< of each box
  std::vector<TriangleCorners> triangles;
};

/// One ray on its way, with what it met so far; Embree hands it to our functions as its context.
struct Query {
  RTCIntersectContext context;
  const Ray* ray = nullptr;
  double begins_m = 0;  ///< Embree counts range from here
  double slack_m = 0;
  double most_range_m = 0;
  CastHit best;
  bool is_hit = false;
};

void box_of_triangle(const RTCBoundsFunctionArguments* asked) {
  const auto& mesh = *static_cast<const MeshCopy*>(asked->geometryUserPtr);
  const TriangleCorners& t = mesh.triangles[asked->primID];
  const auto low = [&](std::size_t i, double shift) {
    return static_cast<float>(std::min({t[0][i], t[1][i], t[2][i]}) + shift - mesh.off_m);
  };
  const auto high = [&](std::size_t i, double shift) {
    return static_cast<float>(std::max({t[0][i], t[1][i], t[2][i]}) + shift + mesh.off_m);
  };
  RTCBounds& box = *asked->bounds_o;
  box.lower_x = low(0, mesh.from_scene_m.x);
  box.lower_y = low(1, mesh.from_scene_m.y);
  box.lower_z = low(2, mesh.from_scene_m.z);
  box.upper_x = high(0, mesh.from_scene_m.x);
  box.upper_y = high(1, mesh.from_scene_m.y);
  box.upper_z = high(2, mesh.from_scene_m.z);
}

std::optional<double> range_of(const void* mesh_copy, std::uint32_t triangle, const Ray& ray) {
  const auto& mesh = *static_cast<const MeshCopy*>(mesh_copy);
  return range_within(mesh.triangles[triangle], {ray.from_m - mesh.origin_m, ray.direction});
}

/// A range as Embree counts it, never too short.
float range_for_embree(const Query& query, double range_m) {
  const double counted_m = (range_m - query.begins_m) * (1 + stand_off) + query.slack_m;
  return static_cast<float>(std::min<double>(counted_m, std::numeric_limits<float>::max()));
}

void meet(const RTCIntersectFunctionNArguments* asked) {
  if (asked->valid[0] == 0) return;
  auto& query = *reinterpret_cast<Query*>(asked->context);
  const auto range_m = range_of(asked->geometryUserPtr, asked->primID, *query.ray);
  if (!range_m || *range_m > query.most_range_m) return;
  const CastHit hit{asked->geomID, asked->primID, *range_m};
  const auto rank = [](const CastHit& h) { return std::tie(h.range_m, h.mesh, h.triangle); };
  if (query.is_hit && !(rank(hit) < rank(query.best))) return;
  query.best = hit;
  query.is_hit = true;
  reinterpret_cast<RTCRayHit*>(asked->rayhit)->ray.tfar = range_for_embree(query, *range_m);
}

void be_blocked(const RTCOccludedFunctionNArguments* asked) {
  if (asked->valid[0] == 0) return;
  auto& query = *reinterpret_cast<Query*>(asked->context);
  const auto range_m = range_of(asked->geometryUserPtr, asked->primID, *query.ray);
  if (!range_m || *range_m > query.most_range_m) return;
  query.is_hit = true;
  reinterpret_cast<RTCRay*>(asked->ray)->tfar = -std::numeric_limits<float>::infinity();
}

void expect_sound(const TriangleMesh& mesh) {
  for (const TriangleMesh::Corner& corner : mesh.corners)
    expects(std::isfinite(corner[0]) && std::isfinite(corner[1]) && std::isfinite(corner[2]),
            "a mesh has finite corners");
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      expects(corner < mesh.corners.size(), "a triangle has corners of its mesh");
}

}  // namespace

struct RayCaster::Scene {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<MeshCopy> meshes;
  Triple<double> origin_m;  ///< NED of the run; the others from here
  Triple<double> low_m{endless, endless, endless};
  Triple<double> high_m{-endless, -endless, -endless};
  double off_m = 0;

  Scene() = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  void copy(std::span<const TriangleMesh> given) {
    if (!given.empty()) origin_m = given.front().origin_m;
    for (const TriangleMesh& mesh : given) {
      expect_sound(mesh);
      MeshCopy& made = meshes.emplace_back();
      made.origin_m = mesh.origin_m;
      made.from_scene_m = mesh.origin_m - origin_m;
      for (const auto& [a, b, c] : mesh.triangles) {
        made.triangles.push_back({mesh.corners[a], mesh.corners[b], mesh.corners[c]});
        for (const auto& at : made.triangles.back()) widen(made.from_scene_m, at);
      }
    }
    const double size_m =
        std::max({std::abs(low_m.x), std::abs(low_m.y), std::abs(low_m.z), std::abs(high_m.x),
                  std::abs(high_m.y), std::abs(high_m.z), 1e-3});
    off_m = stand_off * (has_triangles() ? size_m : 1);
    for (MeshCopy& mesh : meshes) mesh.off_m = off_m;
  }
  void widen(const Triple<double>& from_scene_m, const std::array<float, 3>& at) {
    const Triple<double> p = from_scene_m + Triple<double>{at[0], at[1], at[2]};
    low_m = {std::min(low_m.x, p.x), std::min(low_m.y, p.y), std::min(low_m.z, p.z)};
    high_m = {std::max(high_m.x, p.x), std::max(high_m.y, p.y), std::max(high_m.z, p.z)};
  }
  [[nodiscard]] bool has_triangles() const noexcept { return low_m.x <= high_m.x; }

  void refuse_what_failed() const {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    const bool is_full = error == RTC_ERROR_OUT_OF_MEMORY;
    throw Error(
        is_full ? ErrorKind::unavailable : ErrorKind::internal,
        is_full ? "no memory is left for casting rays; inspect with larger patches"
                : "Embree does not work here: error " + std::to_string(static_cast<int>(error)));
  }

  void build(const std::string& settings) {
    // One thread: a scene takes milliseconds, and nobody is to find threads that he did not start.
    device = rtcNewDevice((settings.empty() ? "threads=1" : "threads=1," + settings).c_str());
    refuse_what_failed();
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      if (meshes[i].triangles.empty()) continue;
      RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
      rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(meshes[i].triangles.size()));
      rtcSetGeometryUserData(geometry, &meshes[i]);
      rtcSetGeometryBoundsFunction(geometry, box_of_triangle, nullptr);
      rtcSetGeometryIntersectFunction(geometry, meet);
      rtcSetGeometryOccludedFunction(geometry, be_blocked);
      rtcCommitGeometry(geometry);
      rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(i));
      rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene);
    refuse_what_failed();
  }

  /// Begins a ray where it comes near the scene, so that single precision is about the scene's
  /// size and not about how far off the ray starts. False where it passes the scene by.
  bool begin(const Ray& ray, double most_range_m, Query& query, RTCRay& begun) const {
    if (!has_triangles()) return false;
    const Triple<double> from = ray.from_m - origin_m;
    double first = 0;
    double last = most_range_m;
    const auto clip = [&](double at, double along, double low, double high) {
      if (along == 0) {
        if (!(at >= low - off_m && at <= high + off_m)) last = -1;
        return;
      }
      const double a = (low - off_m - at) / along;
      const double b = (high + off_m - at) / along;
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
    };
    clip(from.x, ray.direction.x, low_m.x, high_m.x);
    clip(from.y, ray.direction.y, low_m.y, high_m.y);
    clip(from.z, ray.direction.z, low_m.z, high_m.z);
    if (!(first <= last)) return false;
    query.ray = &ray;
    query.begins_m = first;
    query.slack_m = 4 * off_m;
    query.most_range_m = most_range_m;
    query.is_hit = false;
    const Triple<double> at = from + first * ray.direction;
    begun.org_x = static_cast<float>(at.x);
    begun.org_y = static_cast<float>(at.y);
    begun.org_z = static_cast<float>(at.z);
    begun.tnear = 0;
    begun.dir_x = static_cast<float>(ray.direction.x);
    begun.dir_y = static_cast<float>(ray.direction.y);
    begun.dir_z = static_cast<float>(ray.direction.z);
    begun.time = 0;
    begun.tfar = range_for_embree(query, last);
    begun.mask = ~0U;
    begun.id = 0;
    begun.flags = 0;
    return std::isfinite(begun.org_x) && std::isfinite(begun.org_y) && std::isfinite(begun.org_z);
  }
};

RayCaster::RayCaster(std::span<const TriangleMesh> meshes, const std::string& device_settings)
    : scene_(std::make_unique<Scene>()) {
  scene_->copy(meshes);
  scene_->build(device_settings);
}

RayCaster::~RayCaster() = default;

std::optional<CastHit> RayCaster::first_hit(const Ray& ray, double most_range_m) const {
  Query query;
  RTCRayHit cast;
  if (!scene_->begin(ray, most_range_m, query, cast.ray)) return std::nullopt;
  rtcInitIntersectContext(&query.context);
  cast.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  cast.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->scene, &query.context, &cast);
  if (!query.is_hit) return std::nullopt;
  return query.best;
}

// One at a time: Embree's packets take rays that run side by side, and of those the half of the
// time is spent in our own arithmetic.
void RayCaster::first_hits(std::span<const Ray> rays, double most_range_m,
                           std::span<std::optional<CastHit>> hits) const {
  expects(rays.size() == hits.size(), "a place for the hit of each ray");
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = first_hit(rays[i], most_range_m);
}

bool RayCaster::is_blocked(const Ray& ray, double most_range_m) const {
  Query query;
  RTCRay cast;
  if (!scene_->begin(ray, most_range_m, query, cast)) return false;
  rtcInitIntersectContext(&query.context);
  rtcOccluded1(scene_->scene, &query.context, &cast);
  return query.is_hit;
}

}  // namespace slackwater::twin
