#include "twin/render/light/light_frame.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/parallel.h"
#include "twin/inspection/instrument/seen_light.h"
#include "twin/render/light/albedo.h"
#include "twin/render/light/fading.h"
#include "twin/render/light/lamp_veil.h"
#include "twin/render/light/seen_place.h"
#include "twin/render/light/sky_light.h"
#include "twin/render/light/sun_glint.h"

namespace slackwater::twin {
namespace {

constexpr double water_index = 1.34;
constexpr double from_above = 0.75;  // how much more of the light in water

class Painter {
 public:
  Painter(const RenderScene& scene, const Lighting& lighting, const Pinhole& camera,
          const FrameHits& hits, LightFrame& frame)
      : scene_(scene),
        lighting_(lighting),
        camera_(camera),
        hits_(hits),
        frame_(frame),
        places_(scene, camera) {
    for (const Lamp& lamp : lighting.lamps) edges_.emplace_back(lamp);
    is_under_water_ = camera.position_m().z > scene.surface_m;
  }

  void paint(std::size_t pixel) {
    const auto wide = static_cast<std::size_t>(camera_.wide());
    const Bands light = light_along(
        camera_.ray(static_cast<int>(pixel % wide), static_cast<int>(pixel / wide)), pixel);
    frame_.light[pixel] = {static_cast<float>(light[0]), static_cast<float>(light[1]),
                           static_cast<float>(light[2])};
  }

 private:
  [[nodiscard]] const ColouredClarity& medium() const noexcept {
    return is_under_water_ ? lighting_.water : lighting_.air;
  }
  [[nodiscard]] double depth_m(const Triple<double>& at_m) const noexcept {
    return std::max(0.0, at_m.z - scene_.surface_m);
  }
  [[nodiscard]] double day(const Triple<double>& at_m, std::size_t colour) const noexcept {
    const ColouredClarity& clarity = medium();
    return clarity.daylight * fading(clarity.diffuse_attenuation_per_m[colour] * depth_m(at_m));
  }

  [[nodiscard]] Bands light_along(const Ray& ray, std::size_t pixel) const {
    const ColouredClarity& clarity = medium();
    // Beyond a way on which e^-40 is left, water is without end.
    constexpr double without_end_m = 1e4;
    const bool is_hit = hits_.is_hit(pixel);
    const double range_m = is_hit ? hits_.range_m[pixel] : without_end_m;
    Bands light{};
    if (is_hit)
      light = of_place(ray, pixel);
    else if (!is_under_water_)
      return sky_light(lighting_, ray.direction);
    for (std::size_t k = 0; k < light.size(); ++k) {
      const double c = clarity.beam_attenuation_per_m[k];
      if (is_hit) light[k] *= fading(c * range_m);
      light[k] += day_veil(ray, range_m, k);
    }
    add_lamp_veil(ray, range_m, light);
    return light;
  }

  [[nodiscard]] double day_veil(const Ray& ray, double range_m, std::size_t k) const noexcept {
    const ColouredClarity& clarity = medium();
    const double c = clarity.beam_attenuation_per_m[k];
    if (!is_under_water_)
      return sky_light(lighting_, {ray.direction.x, ray.direction.y, 0})[k] *
             (1 - fading(c * range_m));
    const double rate = c + clarity.diffuse_attenuation_per_m[k] * ray.direction.z;
    return day(ray.from_m, k) * c * faded_length_m(rate, range_m);
  }

  void add_lamp_veil(const Ray& ray, double range_m, Bands& light) const {
    const ColouredClarity& clarity = medium();
    if (!(clarity.backscatter_per_m > 0)) return;
    for (std::size_t l = 0; l < lighting_.lamps.size(); ++l) {
      const Lamp& lamp = lighting_.lamps[l];
      const LookPastLamp look(lamp, edges_[l], ray, range_m);
      const double share =
          lamp.range_m * lamp.range_m * clarity.backscatter_per_m / (2 * usual_reflectance);
      const Bands sums = look.sums(clarity.beam_attenuation_per_m);
      for (std::size_t k = 0; k < light.size(); ++k) light[k] += share * sums[k];
    }
  }

  /// Of the place that a pixel meets, there.
  [[nodiscard]] Bands of_place(const Ray& ray, std::size_t pixel) const {
    const auto [thing, at_m, face, n, mark, mark_share] = places_.at(ray, hits_, pixel);
    if (thing.seen_class == SeenClass::water)
      return is_under_water_ ? surface_from_below(ray, at_m, n)
                             : sea_light(lighting_, ray.direction, n);
    const Bands albedo = albedo_of_pixel(thing, at_m, mark, mark_share);
    const double facing = faces_day(at_m, n, face);
    Bands light{};
    for (std::size_t k = 0; k < light.size(); ++k) light[k] = facing * day(at_m, k);
    for (std::size_t l = 0; l < lighting_.lamps.size(); ++l) add_lamp(l, at_m, n, face, light);
    for (std::size_t k = 0; k < light.size(); ++k) light[k] *= whites_light * albedo[k];
    return light;
  }

  [[nodiscard]] Bands albedo_of_pixel(const SeenThing& thing, const Triple<double>& at_m,
                                      const DefectMark* mark, double mark_share) const {
    const auto albedo = [&](const DefectMark* of) {
      return albedo_at(thing, of, at_m, lighting_.growth, lighting_.seed);
    };
    if (mark == nullptr || mark_share >= 1) return albedo(mark);
    const Bands bare = albedo(nullptr), marked = albedo(mark);
    Bands both{};
    for (std::size_t k = 0; k < both.size(); ++k)
      both[k] = bare[k] + mark_share * (marked[k] - bare[k]);
    return both;
  }

  [[nodiscard]] double faces_day(const Triple<double>& at_m, const Triple<double>& n,
                                 const Triple<double>& face) const {
    if (is_under_water_) return 1 - from_above * n.z;
    const Sky& sky = lighting_.sky;
    double facing = (1 - sky.beam) * 0.5 * (1 - n.z);
    const double on_face = dot(n, sky.to_sun);
    if (sky.beam > 0 && on_face > 0 && !is_in_shadow(at_m, face, sky.to_sun, 1e4))
      facing += sky.beam * on_face / std::max(0.05, -sky.to_sun.z);
    return facing;
  }
  /// Whether something stands in the light. A face that is turned away a little, but lit where its
  /// edge is rounded off, is in no shadow of its own.
  [[nodiscard]] bool is_in_shadow(const Triple<double>& at_m, const Triple<double>& face,
                                  const Triple<double>& to_light, double most_m) const {
    constexpr double off_m = 1e-3;
    return dot(face, to_light) > 0 &&
           lighting_.shadows.is_blocked({at_m + off_m * face, to_light}, most_m);
  }

  void add_lamp(std::size_t l, const Triple<double>& at_m, const Triple<double>& n,
                const Triple<double>& face, Bands& light) const {
    const Lamp& lamp = lighting_.lamps[l];
    const Triple<double> way = at_m - lamp.position_m;
    const double far_m = std::max(1e-3, length_of(way));
    const double on_face = -dot(way, n) / far_m;
    const double lit = edges_[l].lit(dot(way, lamp.axis) / far_m);
    if (!(on_face > 0 && lit > 0)) return;
    if (is_in_shadow(at_m, face, (-1 / far_m) * way, far_m - 2e-3)) return;
    const double share = lamp.range_m / far_m;
    const ColouredClarity& clarity = medium();
    for (std::size_t k = 0; k < light.size(); ++k)
      light[k] += share * share * lit * on_face * fading(clarity.beam_attenuation_per_m[k] * far_m);
  }

  [[nodiscard]] Bands surface_from_below(const Ray& ray, const Triple<double>& at_m,
                                         const Triple<double>& n) const noexcept {
    const double cosine = -dot(ray.direction, n);
    const double beyond = 1 - water_index * water_index * (1 - cosine * cosine);
    Bands light{};
    if (beyond > 0) {
      const double leaving = std::sqrt(beyond);
      const double through = (1 - mirrored_share(leaving)) * water_index * water_index;
      const Triple<double> out = water_index * ray.direction + (water_index * cosine - leaving) * n;
      light = sky_light(lighting_, out);
      for (double& one : light) one *= through;
      return light;
    }
    const Triple<double> down = ray.direction + (2 * cosine) * n;
    for (std::size_t k = 0; k < light.size(); ++k) {
      const double c = lighting_.water.beam_attenuation_per_m[k];
      const double rate = c + lighting_.water.diffuse_attenuation_per_m[k] * down.z;
      light[k] = day(at_m, k) * c * faded_length_m(rate, 1e4);
    }
    return light;
  }

  const RenderScene& scene_;
  const Lighting& lighting_;
  const Pinhole& camera_;
  const FrameHits& hits_;
  LightFrame& frame_;
  std::vector<BeamEdge> edges_;
  SeenPlaces places_;
  bool is_under_water_ = false;
};

}  // namespace

LightFrame light_of(const RenderScene& scene, const Lighting& lighting, const Pinhole& camera,
                    const FrameHits& hits, int threads) {
  LightFrame frame;
  frame.wide = camera.wide();
  frame.high = camera.high();
  frame.light.resize(hits.pixels());
  Painter painter(scene, lighting, camera, hits, frame);
  const auto wide = static_cast<std::size_t>(frame.wide);
  for_all(static_cast<std::size_t>(frame.high), threads, [&](std::size_t row) {
    for (std::size_t i = 0; i < wide; ++i) painter.paint(row * wide + i);
  });
  return frame;
}

void light_again(LightFrame& frame, const std::vector<std::size_t>& pixels,
                 const RenderScene& scene, const Lighting& lighting, const Pinhole& camera,
                 const FrameHits& hits, int threads) {
  Painter painter(scene, lighting, camera, hits, frame);
  constexpr std::size_t at_once = 1024;
  for_all((pixels.size() + at_once - 1) / at_once, threads, [&](std::size_t part) {
    const std::size_t to = std::min(pixels.size(), (part + 1) * at_once);
    for (std::size_t i = part * at_once; i < to; ++i) painter.paint(pixels[i]);
  });
}

}  // namespace slackwater::twin
