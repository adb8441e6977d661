#include "twin/render/light/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/parallel.h"
#include "twin/inspection/instrument/seen_light.h"
#include "twin/render/light/albedo.h"
#include "twin/render/light/counted_noise.h"
#include "twin/render/light/fading.h"

namespace slackwater::twin {
namespace {

constexpr double white = 1 / usual_reflectance;
constexpr double water_index = 1.34;
constexpr double from_above = 0.75;  // how much more of the light in water

/// Gauss and Legendre's, of -1 to 1; the other four lie across 0.
struct Node {
  double at;
  double weight;
};
constexpr std::array nodes{
    Node{0.1834346424956498, 0.3626837833783620}, Node{0.5255324099163290, 0.3137066458778873},
    Node{0.7966664774136267, 0.2223810344533745}, Node{0.9602898564975363, 0.1012285362903763}};

/// The edge of a lamp's beam, as cosines from its axis.
struct BeamEdge {
  double full = 0;  ///< within: all of it
  double dark = 0;  ///< beyond: nothing
  explicit BeamEdge(const Lamp& lamp) noexcept {
    constexpr double right_angle = 1.5707963267948966;
    if (lamp.half_beam_rad >= right_angle) return;
    dark = std::cos(lamp.half_beam_rad);
    full = std::cos(0.9 * lamp.half_beam_rad);
  }
  /// The cosine, and what the edge leaves of it.
  [[nodiscard]] double lit(double cosine) const noexcept {
    if (!(cosine > dark)) return 0;
    if (cosine >= full) return cosine;
    const double t = (cosine - dark) / (full - dark);
    return cosine * t * t * (3 - 2 * t);
  }
};

/// From where to where a ray is within a lamp's beam; nothing: to is not beyond from.
struct LitSpan {
  double from_m = 0;
  double to_m = 0;

  /// The beam is a cone, C = cos^2 of its half angle: along the ray, with w = s d - t the way from
  /// the lamp, within it (w . a)^2 - C w^2 = A s^2 + 2 B s + D > 0 and w . a > 0.
  LitSpan(const Lamp& lamp, const BeamEdge& edge, const Ray& ray, const Triple<double>& to_lamp,
          double range_m) noexcept
      : to_m(range_m) {
    const double along = dot(ray.direction, lamp.axis), before = -dot(to_lamp, lamp.axis);
    if (!(edge.dark > 0)) {
      // Half of space: where along s + before > 0.
      if (along > 0)
        from_m = std::max(from_m, -before / along);
      else if (along < 0)
        to_m = std::min(to_m, -before / along);
      else if (!(before > 0))
        to_m = from_m;
      return;
    }
    const double c = edge.dark * edge.dark;
    const double square = along * along - c;
    const double half = along * before + c * dot(to_lamp, ray.direction);
    const double whole = before * before - c * dot(to_lamp, to_lamp);
    const double root2 = half * half - square * whole;
    if (std::abs(square) < 1e-12 || !(root2 > 0)) {
      if (square < 0) to_m = from_m;
      return;
    }
    const double root = std::sqrt(root2);
    const double one = (-half - root) / square, two = (-half + root) / square;
    if (square < 0) {
      from_m = std::max(from_m, std::min(one, two));
      to_m = std::min(to_m, std::max(one, two));
      if (!(along * 0.5 * (one + two) + before > 0)) to_m = from_m;
    } else if (along > 0) {
      from_m = std::max(from_m, std::max(one, two));
    } else {
      to_m = std::min(to_m, std::min(one, two));
    }
  }
};

/// The way of a look past a lamp, cut into the points of its integral.
struct LookPastLamp {
  std::array<double, 8> lit{};    ///< of each point, with its weight
  std::array<double, 8> way_m{};  ///< out and back
  bool is_dark = true;

  LookPastLamp(const Lamp& lamp, const BeamEdge& edge, const Ray& ray, double range_m) noexcept {
    const Triple<double> to_lamp = lamp.position_m - ray.from_m;
    const double nearest_m = dot(to_lamp, ray.direction);
    const Triple<double> off = to_lamp - nearest_m * ray.direction;
    constexpr double least_m = 1e-3;  // a lamp in the line of sight would blind it
    const double h2 = std::max(dot(off, off), least_m * least_m);
    const auto sum_at = [&](double s) {
      const double past = s - nearest_m;
      const double aside = std::sqrt(past * past + h2);
      return past >= 0 ? past + aside : h2 / (aside - past);
    };
    const LitSpan span(lamp, edge, ray, to_lamp, range_m);
    if (!(span.to_m > span.from_m)) return;
    is_dark = false;
    const double along = dot(ray.direction, lamp.axis), before = dot(to_lamp, lamp.axis);
    const double first = logarithm(sum_at(span.from_m));
    const double half = 0.5 * (logarithm(sum_at(span.to_m)) - first);
    std::array<double, 8> p;
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = -(first + half * (1 + (i % 2 == 0 ? -1 : 1) * nodes[i / 2].at));
    fade(p);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double other = h2 / p[i];
      const double from_lamp_m = 0.5 * (p[i] + other), per_m = 1 / from_lamp_m;
      const double s = nearest_m + 0.5 * (p[i] - other);
      const double cosine = (s * along - before) * per_m;
      lit[i] = half * nodes[i / 2].weight * edge.lit(cosine) * per_m;
      way_m[i] = s + from_lamp_m;
    }
  }
  /// Of each colour by its beam attenuation.
  [[nodiscard]] Bands sums(const Bands& c) const noexcept {
    Bands all{};
    if (is_dark) return all;
    std::array<double, 24> left;
    for (std::size_t k = 0; k < all.size(); ++k)
      for (std::size_t i = 0; i < lit.size(); ++i) left[8 * k + i] = c[k] * way_m[i];
    // A look without end goes farther than exp(-700).
    constexpr double most = 700;
    if (*std::max_element(left.begin(), left.end()) < most)
      fade(left);
    else
      for (double& one : left) one = fading(one);
    for (std::size_t k = 0; k < all.size(); ++k)
      for (std::size_t i = 0; i < lit.size(); ++i) all[k] += lit[i] * left[8 * k + i];
    return all;
  }
};

/// The normal of a face at a place, rounded off towards its neighbours'.
class SmoothNormals {
 public:
  explicit SmoothNormals(const TriangleMesh& mesh) : mesh_(mesh) {
    if (mesh.triangles.size() > smooth_as_they_are) return;
    corners_.resize(mesh.corners.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triple<double> area = mesh.area_vector_m2(t);
      for (const std::uint32_t corner : mesh.triangles[t])
        corners_[corner] = corners_[corner] + area;
    }
  }
  /// Unit, outward. @param face  unit, of the triangle; kept at an edge of more than 37 degrees
  [[nodiscard]] Triple<double> at(std::size_t triangle, const Triple<double>& at_m,
                                  const Triple<double>& face) const noexcept {
    if (corners_.empty()) return face;
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const Triple<double> from = mesh_.corner_m(a);
    const Triple<double> ab = mesh_.corner_m(b) - from, ac = mesh_.corner_m(c) - from;
    const Triple<double> n = cross(ab, ac), at = at_m - from;
    const double whole = dot(n, n);
    const double weight_b = dot(n, cross(at, ac)) / whole;
    const double weight_c = dot(n, cross(ab, at)) / whole;
    const auto unit_at = [&](std::uint32_t corner) {
      const double length = length_of(corners_[corner]);
      const Triple<double> one = length > 0 ? (1 / length) * corners_[corner] : face;
      return dot(one, face) > smooth_cosine ? one : face;
    };
    const Triple<double> mixed =
        (1 - weight_b - weight_c) * unit_at(a) + weight_b * unit_at(b) + weight_c * unit_at(c);
    return (1 / length_of(mixed)) * mixed;
  }

 private:
  static constexpr double smooth_cosine = 0.8;
  static constexpr std::size_t smooth_as_they_are = 100000;
  const TriangleMesh& mesh_;
  std::vector<Triple<double>> corners_;
};

class Painter {
 public:
  Painter(const RenderScene& scene, const Lighting& lighting, const Pinhole& camera,
          const FrameHits& hits, LightFrame& frame)
      : scene_(scene), lighting_(lighting), camera_(camera), hits_(hits), frame_(frame) {
    for (const Lamp& lamp : lighting.lamps) edges_.emplace_back(lamp);
    is_under_water_ = camera.position_m().z > scene.surface_m;
    for (const SeenThing& thing : scene.things) normals_.emplace_back(thing.mesh);
    marks_.resize(scene.things.size());
    for (const DefectMark& mark : scene.marks) marks_[mark.thing].push_back(&mark);
  }

  void paint_row(int j) {
    for (int i = 0; i < camera_.wide(); ++i) {
      const auto at = static_cast<std::size_t>(j) * static_cast<std::size_t>(camera_.wide()) +
                      static_cast<std::size_t>(i);
      const Bands light = light_along(camera_.ray(i, j), at);
      frame_.light[at] = {static_cast<float>(light[0]), static_cast<float>(light[1]),
                          static_cast<float>(light[2])};
    }
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
      light = of_place(ray, pixel, range_m);
    else if (!is_under_water_)
      return sky(ray.direction);
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
      return sky({ray.direction.x, ray.direction.y, 0})[k] * (1 - fading(c * range_m));
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
  [[nodiscard]] Bands of_place(const Ray& ray, std::size_t pixel, double range_m) const {
    const SeenThing& thing = scene_.things[hits_.mesh[pixel]];
    const Triple<double> at_m = ray.from_m + range_m * ray.direction;
    Triple<double> face = thing.mesh.area_vector_m2(hits_.triangle[pixel]);
    face = (1 / length_of(face)) * face;
    Triple<double> n = normals_[hits_.mesh[pixel]].at(hits_.triangle[pixel], at_m, face);
    if (dot(face, ray.direction) > 0) n = -1.0 * n;
    if (dot(face, ray.direction) > 0) face = -1.0 * face;
    // Rounded off, a face that is seen could turn away at its outline.
    if (!(dot(n, ray.direction) < 0)) n = face;
    if (thing.seen_class == SeenClass::water)
      return is_under_water_ ? surface_from_below(ray, at_m, n) : surface_from_above(ray, n);
    const DefectMark* mark = nullptr;
    for (const DefectMark* one : marks_[hits_.mesh[pixel]])
      if (one->holds(at_m)) mark = one;
    const Bands albedo = albedo_at(thing, mark, at_m, lighting_.seed);
    const double facing = faces_day(at_m, n, face);
    Bands light{};
    for (std::size_t k = 0; k < light.size(); ++k) light[k] = facing * day(at_m, k);
    for (std::size_t l = 0; l < lighting_.lamps.size(); ++l) add_lamp(l, at_m, n, face, light);
    for (std::size_t k = 0; k < light.size(); ++k) light[k] *= white * albedo[k];
    return light;
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

  [[nodiscard]] Bands sky(const Triple<double>& direction) const noexcept {
    const double sine = std::max(0.0, -direction.z);
    const double bright = lighting_.air.daylight * white * 9 / 7 * (1 + 2 * sine) / 3;
    if (!(lighting_.sky.beam > 0)) return {bright, bright, bright};
    const double blue = 1 - (1 - sine) * (1 - sine);
    // No brighter than the sky's own share, paler to the horizon.
    const double of_sky = bright * (1 - 0.7 * lighting_.sky.beam);
    return {of_sky * (1 - 0.55 * blue), of_sky * (1 - 0.25 * blue), of_sky};
  }

  [[nodiscard]] Bands surface_from_above(const Ray& ray, const Triple<double>& n) const noexcept {
    const double cosine = -dot(ray.direction, n);
    const double off = 1 - cosine, square = off * off;
    const double mirrored = 0.02 + 0.98 * square * square * off;
    Bands light = sky(ray.direction + (2 * cosine) * n);
    const ColouredClarity& water = lighting_.water;
    for (std::size_t k = 0; k < light.size(); ++k) {
      const double absorbed =
          std::max(water.backscatter_per_m,
                   0.83 * water.diffuse_attenuation_per_m[k] - water.backscatter_per_m);
      const double back = absorbed > 0 ? 0.33 * water.backscatter_per_m / absorbed : 0;
      light[k] = mirrored * light[k] + (1 - mirrored) * 0.54 * back * white * water.daylight;
    }
    return light;
  }

  [[nodiscard]] Bands surface_from_below(const Ray& ray, const Triple<double>& at_m,
                                         const Triple<double>& n) const noexcept {
    const double cosine = -dot(ray.direction, n);
    const double beyond = 1 - water_index * water_index * (1 - cosine * cosine);
    Bands light{};
    if (beyond > 0) {
      const double leaving = std::sqrt(beyond), off = 1 - leaving, square = off * off;
      const double through = (1 - 0.02 - 0.98 * square * square * off) * water_index * water_index;
      const Triple<double> out = water_index * ray.direction + (water_index * cosine - leaving) * n;
      light = sky(out);
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
  std::vector<SmoothNormals> normals_;
  std::vector<std::vector<const DefectMark*>> marks_;
  bool is_under_water_ = false;
};

/// sRGB's numbers of linear values in equal steps.
const std::vector<std::uint8_t>& transfer() {
  static const std::vector<std::uint8_t> table = [] {
    constexpr std::size_t steps = 1U << 14U;
    std::vector<std::uint8_t> made(steps + 1);
    for (std::size_t i = 0; i <= steps; ++i) {
      const double x = static_cast<double>(i) / steps;
      const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
      made[i] = static_cast<std::uint8_t>(std::lround(255 * y));
    }
    return made;
  }();
  return table;
}

double mean_of(const LightFrame& frame, double most) {
  double sum = 0;
  for (const auto& light : frame.light)
    for (const float one : light) sum += std::min<double>(one, most);
  return frame.light.empty() ? 0 : sum / (3 * static_cast<double>(frame.light.size()));
}

}  // namespace

double lamp_veil_along_per_m(const Lamp& lamp, const Ray& ray, double range_m,
                             double beam_attenuation_per_m) noexcept {
  return LookPastLamp(lamp, BeamEdge(lamp), ray, range_m)
      .sums({beam_attenuation_per_m, beam_attenuation_per_m, beam_attenuation_per_m})[green];
}

LightFrame light_of(const RenderScene& scene, const Lighting& lighting, const Pinhole& camera,
                    const FrameHits& hits, int threads) {
  LightFrame frame;
  frame.wide = camera.wide();
  frame.high = camera.high();
  frame.light.resize(hits.pixels());
  Painter painter(scene, lighting, camera, hits, frame);
  for_all(static_cast<std::size_t>(frame.high), threads,
          [&](std::size_t j) { painter.paint_row(static_cast<int>(j)); });
  return frame;
}

Picture developed(const LightFrame& light, const Sensor& sensor, std::uint64_t seed, int threads) {
  Picture picture;
  picture.wide = light.wide;
  picture.high = light.high;
  picture.rgb.resize(3 * light.light.size());
  const double mean = mean_of(light, sensor.full_light) / sensor.full_light;
  picture.gain =
      std::clamp(mean > 0 ? sensor.mean_level / mean : 1.0, 1 / sensor.most_gain, sensor.most_gain);
  const double exposed = std::min(1.0, picture.gain), amplified = std::max(1.0, picture.gain);
  const auto& table = transfer();
  const double steps = static_cast<double>(table.size() - 1);
  const auto row = 3 * static_cast<std::size_t>(light.wide);
  for_all(static_cast<std::size_t>(light.high), threads, [&](std::size_t j) {
    for (std::size_t at = j * row; at < (j + 1) * row; ++at) {
      const double electrons =
          exposed * light.light[at / 3][at % 3] / sensor.full_light * sensor.full_well_e;
      const double sd = std::sqrt(electrons + sensor.read_noise_e * sensor.read_noise_e);
      const double noisy = electrons + sd * normal_at(noise_key(seed, at));
      const double value = std::clamp(amplified * noisy / sensor.full_well_e, 0.0, 1.0);
      picture.rgb[at] = table[static_cast<std::size_t>(std::lround(value * steps))];
    }
  });
  return picture;
}

}  // namespace slackwater::twin
