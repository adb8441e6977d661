#include "twin/render/ranging/side_scan.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/parallel.h"
#include "twin/render/ranging/echo.h"

namespace slackwater::twin {
namespace {

/// The angles that a ray stands for, below the plane of axis and right, and its own.
struct RayOfFan {
  double steep_rad = 0;
  double middle_rad = 0;
  double flat_rad = 0;
};

std::vector<RayOfFan> rays_of(const SideScanSheet& sheet) {
  constexpr double most_cotangent = 20;  // 2.9 degrees
  const double grazing_rad = std::atan(1 / most_cotangent);
  const double reach_rad = 0.5 * cast_widths * sheet.upright_rad;
  const double steepest_rad = std::min(0.5 * constants::pi, sheet.depression_rad + reach_rad);
  const double flattest_rad = std::max(-0.5 * constants::pi, sheet.depression_rad - reach_rad);
  const bool is_steep = steepest_rad > grazing_rad, is_flat = flattest_rad < grazing_rad;
  const int steep = !is_steep ? 0 : is_flat ? 3 * sheet.rays / 4 : sheet.rays;
  std::vector<RayOfFan> rays;
  const auto angle_of = [](double cotangent) { return std::atan2(1, cotangent); };
  const double from = 1 / std::tan(steepest_rad);
  const double to = 1 / std::tan(std::max(flattest_rad, grazing_rad));
  for (int k = 0; k < steep; ++k) {
    const auto at = [&](double step) { return angle_of(from + (to - from) * step / steep); };
    rays.push_back({at(k), at(k + 0.5), at(k + 1)});
  }
  const int flat = sheet.rays - steep;
  const double top_rad = std::min(steepest_rad, grazing_rad);
  for (int k = 0; k < flat; ++k) {
    const auto at = [&](double step) { return top_rad + (flattest_rad - top_rad) * step / flat; };
    rays.push_back({at(k), at(k + 0.5), at(k + 1)});
  }
  return rays;
}

/// The echoes of one slice of one side.
struct SliceEcho {
  std::vector<double> sum;
  std::vector<double> most;  ///< of one ray
  std::vector<std::uint16_t> instance;

  explicit SliceEcho(std::size_t bins) : sum(bins, 0.0), most(bins, 0.0), instance(bins, 0) {}

  /// Evenly from one range to another.
  void lay(double from_m, double to_m, double echo, double bin_m, double least_m,
           std::uint16_t thing) {
    constexpr double least_wide_m = 1e-9;
    if (from_m > to_m) std::swap(from_m, to_m);
    if (to_m - from_m < least_wide_m) to_m = from_m + least_wide_m;
    const double per_m = echo / (to_m - from_m);
    const double near_m = std::max(from_m, least_m);
    const double far_m = std::min(to_m, bin_m * static_cast<double>(sum.size()));
    if (!(near_m < far_m)) return;
    const auto first = static_cast<std::size_t>(near_m / bin_m);
    for (std::size_t bin = first; bin < sum.size(); ++bin) {
      const double begins_m = bin_m * static_cast<double>(bin);
      if (begins_m >= far_m) break;
      const double share_m = std::min(far_m, begins_m + bin_m) - std::max(near_m, begins_m);
      if (!(share_m > 0)) continue;
      const double part = per_m * share_m;
      sum[bin] += part;
      if (part > most[bin]) {
        most[bin] = part;
        instance[bin] = thing;
      }
    }
  }
};

}  // namespace

Triple<double> side_scan_direction(const Pose& pose, ScanSide side, double below_rad,
                                   double along_rad) noexcept {
  const double to_right = side == ScanSide::starboard ? 1 : -1;
  const Triple<double> down = cross(pose.axis, pose.right);
  const double across = std::cos(along_rad);
  return (across * std::cos(below_rad) * to_right) * pose.right +
         (across * std::sin(below_rad)) * down + std::sin(along_rad) * pose.axis;
}

SideScanPing side_scanned(const RenderScene& scene, const RayCaster& caster,
                          const SideScanSheet& sheet, const Pose& pose, double least_range_m,
                          double most_range_m, std::uint64_t seed, int threads) {
  constexpr double just_beyond = 1.1;  // what a ray stands for may begin within the longest range
  constexpr double most_stretch = 2;   // of a ray's range, where it all but touches a plane
  const auto bins = static_cast<std::size_t>(sheet.bins);
  const auto slices = static_cast<std::size_t>(sheet.slices);
  SideScanPing ping;
  ping.bins = sheet.bins;
  ping.bin_m = most_range_m / sheet.bins;
  const std::vector<RayOfFan> rays = rays_of(sheet);
  const double mu = std::pow(10.0, sheet.mackenzie_db / 10);
  const double taken_per_m = ping.taken_per_m = taken_both_ways_per_m(sheet.absorption_db_m);
  std::vector<double> along(slices), wide(slices);
  double all = 0;
  for (std::size_t i = 0; i < slices; ++i) {
    along[i] = cast_widths * sheet.beam_rad *
               ((static_cast<double>(i) + 0.5) / static_cast<double>(slices) - 0.5);
    wide[i] = pattern_both_ways(along[i], sheet.beam_rad) * std::cos(along[i]);
    all += wide[i];
  }
  for (double& one : wide) one *= sheet.beam_rad / all;

  std::vector<SliceEcho> echoes(2 * slices, SliceEcho(bins));
  for_all(echoes.size(), threads, [&](std::size_t part) {
    const auto side = static_cast<ScanSide>(part / slices);
    const std::size_t slice = part % slices;
    const auto towards = [&](double below_rad) {
      return side_scan_direction(pose, side, below_rad, along[slice]);
    };
    for (const RayOfFan& one : rays) {
      const Ray ray{pose.position_m, towards(one.middle_rad)};
      const auto hit = caster.first_hit(ray, just_beyond * most_range_m);
      if (!hit) continue;
      const double r = hit->range_m;
      const Triple<double> normal = scene.things[hit->mesh].mesh.area_vector_m2(hit->triangle);
      const double towards_it = dot(normal, ray.direction);
      const double weight =
          mu * wide[slice] * (one.steep_rad - one.flat_rad) *
          pattern_both_ways(one.middle_rad - sheet.depression_rad, sheet.upright_rad);
      const double echo = thrown_back(weight, scene, ray, *hit, taken_per_m);
      // Where the plane that it meets is at an angle.
      const auto range_at = [&](double below_rad) {
        const double share = dot(normal, towards(below_rad)) / towards_it;
        return share > 1 / most_stretch ? r / share : most_stretch * r;
      };
      echoes[part].lay(range_at(one.steep_rad), range_at(one.flat_rad), echo, ping.bin_m,
                       least_range_m, static_cast<std::uint16_t>(hit->mesh + 1));
    }
  });

  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t bin = 0; bin < bins; ++bin) {
      double sum = 0, most = 0;
      std::uint16_t thing = 0;
      for (std::size_t slice = 0; slice < slices; ++slice) {
        const SliceEcho& echo = echoes[side * slices + slice];
        sum += echo.sum[bin];
        if (echo.most[bin] > most) {
          most = echo.most[bin];
          thing = echo.instance[bin];
        }
      }
      ping.mean.push_back(static_cast<float>(sum));
      ping.intensity.push_back(
          static_cast<float>(speckled(sum, sheet.noise_floor, noise_key(seed, side, bin))));
      ping.instance.push_back(thing);
    }
  return ping;
}

}  // namespace slackwater::twin
