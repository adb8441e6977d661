#include "twin/render/light/infrared_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/parallel.h"
#include "twin/render/light/albedo.h"
#include "twin/render/light/counted_noise.h"
#include "twin/render/light/fading.h"
#include "twin/render/light/seen_place.h"

namespace slackwater::twin {
namespace {

constexpr double diffuse_way = 1.66;
constexpr double netd_of_k = 300;
constexpr double fog_per_m = 3.0 / 1000;

/// What a place sends, and what it is.
struct SentHeat {
  double radiance = 0;
  double temperature_k = std::numeric_limits<double>::quiet_NaN();
  double emissivity = std::numeric_limits<double>::quiet_NaN();
};

class HeatPainter {
 public:
  HeatPainter(const RenderScene& scene, const Pinhole& camera, const InfraredLight& light,
              const InfraredSensor& sensor)
      : places_(scene, camera),
        light_(light),
        band_(sensor.from_m, sensor.to_m),
        of_air_(band_.of(light.warmth.air_k)),
        of_sea_(band_.of(light.warmth.of(Material::water).temperature_k)),
        of_cloud_(band_.of(light.warmth.cloud_k)) {
    // What the whole air overhead lets through; the least keeps the logarithm finite.
    constexpr double least = 1e-12;
    overhead_ = -logarithm(std::max(least, 1 - band_.of(light.warmth.sky_overhead_k) / of_air_));
    attenuation_per_m_ = light.warmth.attenuation_per_m;
    if (light.visible_attenuation_per_m >= fog_per_m)
      attenuation_per_m_ += light.visible_attenuation_per_m;
  }

  [[nodiscard]] const BandRadiance& band() const noexcept { return band_; }

  [[nodiscard]] SentHeat sky(const Triple<double>& direction) const noexcept {
    SentHeat sent;
    constexpr double flattest = 1e-3;
    const double sine = std::max(flattest, -direction.z);
    sent.radiance = light_.is_overcast ? of_cloud_ : of_air_ * (1 - fading(overhead_ / sine));
    return sent;
  }

  [[nodiscard]] SentHeat of_place(const Ray& ray, const FrameHits& hits, std::size_t pixel) const {
    const SeenPlace place = places_.at(ray, hits, pixel);
    const SeenThing& thing = place.thing;
    const Triple<double>& n = place.normal;
    const SurfaceWarmth& warmth = light_.warmth.of(material_at(thing, place.mostly()));
    SentHeat sent;
    sent.temperature_k = warmth.temperature_k + warmed_k(warmth, place.at_m, n, place.face);
    sent.emissivity = warmth.emissivity;
    double falls_on = 0;
    if (thing.seen_class == SeenClass::water) {
      const double cosine = -dot(ray.direction, n);
      const double off = 1 - cosine, square = off * off, squarely = 1 - warmth.emissivity;
      sent.emissivity = (1 - squarely) * (1 - square * square * off);
      falls_on = sky(ray.direction + (2 * cosine) * n).radiance;
    } else {
      const double of_sky = 0.5 * (1 - n.z);
      const double whole_sky =
          light_.is_overcast ? of_cloud_ : of_air_ * (1 - fading(diffuse_way * overhead_));
      falls_on = of_sky * whole_sky + (1 - of_sky) * of_sea_;
    }
    const double left = fading(attenuation_per_m_ * hits.range_m[pixel]);
    const double sends =
        sent.emissivity * band_.of(sent.temperature_k) + (1 - sent.emissivity) * falls_on;
    sent.radiance = left * sends + (1 - left) * of_air_;
    return sent;
  }

 private:
  [[nodiscard]] double warmed_k(const SurfaceWarmth& warmth, const Triple<double>& at_m,
                                const Triple<double>& n, const Triple<double>& face) const {
    constexpr double off_m = 1e-3, to_sky_m = 1e4, stated_for_w_m2 = 1000;
    const double on_face = dot(n, light_.sky.to_sun);
    if (light_.is_overcast || !(warmth.in_sun_k > 0 && light_.beam_w_m2 > 0 && on_face > 0))
      return 0;
    // A face that is rounded off is in no shadow of its own (light_frame.cc).
    if (dot(face, light_.sky.to_sun) > 0 &&
        light_.shadows.is_blocked({at_m + off_m * face, light_.sky.to_sun}, to_sky_m))
      return 0;
    return warmth.in_sun_k * on_face * light_.beam_w_m2 / stated_for_w_m2;
  }

  SeenPlaces places_;
  const InfraredLight& light_;
  BandRadiance band_;
  double of_air_, of_sea_, of_cloud_;
  double overhead_ = 0;
  double attenuation_per_m_ = 0;
};

}  // namespace

InfraredFrame infrared_of(const RenderScene& scene, const InfraredLight& light,
                          const InfraredSensor& sensor, const Pinhole& camera,
                          const FrameHits& hits, std::uint64_t seed, int threads) {
  const HeatPainter painter(scene, camera, light, sensor);
  const double noise = sensor.netd_k * painter.band().slope(netd_of_k);
  InfraredFrame frame;
  frame.wide = camera.wide();
  frame.high = camera.high();
  frame.radiance.resize(hits.pixels());
  frame.apparent_k.resize(hits.pixels());
  frame.temperature_k.resize(hits.pixels());
  frame.emissivity.resize(hits.pixels());
  for_all(static_cast<std::size_t>(frame.high), threads, [&](std::size_t j) {
    for (int i = 0; i < frame.wide; ++i) {
      const std::size_t at = j * static_cast<std::size_t>(frame.wide) + static_cast<std::size_t>(i);
      const Ray ray = camera.ray(i, static_cast<int>(j));
      const SentHeat sent =
          hits.is_hit(at) ? painter.of_place(ray, hits, at) : painter.sky(ray.direction);
      frame.radiance[at] = static_cast<float>(sent.radiance);
      frame.apparent_k[at] = static_cast<float>(
          painter.band().temperature_k(sent.radiance + noise * normal_at(noise_key(seed, at))));
      frame.temperature_k[at] = static_cast<float>(sent.temperature_k);
      frame.emissivity[at] = static_cast<float>(sent.emissivity);
    }
  });
  return frame;
}

}  // namespace slackwater::twin
