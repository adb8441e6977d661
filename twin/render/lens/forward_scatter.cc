#include "twin/render/lens/forward_scatter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/base/parallel.h"
#include "twin/render/light/fading.h"

namespace slackwater::twin {
namespace {

constexpr std::size_t levels = 8;
constexpr double most_optical_way = 8;

using Layer = std::vector<std::array<double, 3>>;

/// Half of an even kernel, from its middle: the share of a normal distribution in each pixel.
std::vector<double> half_kernel(double sd_px) {
  constexpr double out_to_sd = 4;
  std::vector<double> half{1};
  const int reach = std::max(1, static_cast<int>(std::ceil(out_to_sd * sd_px)));
  for (int i = 1; i <= reach; ++i) half.push_back(fading(0.5 * i * i / (sd_px * sd_px)));
  double all = half[0];
  for (std::size_t i = 1; i < half.size(); ++i) all += 2 * half[i];
  for (double& one : half) one /= all;
  return half;
}

/// A place beyond either end of so many, mirrored at the end's outer edge.
std::size_t mirrored(long place, long count) noexcept {
  const long round = 2 * count;
  const long within = ((place % round) + round) % round;
  return static_cast<std::size_t>(within < count ? within : round - 1 - within);
}

/// Each line of a layer laid out by a kernel. @param step  from one place of a line to the next
void lay_out(Layer& layer, const std::vector<double>& half, std::size_t lines, std::size_t places,
             std::size_t line_step, std::size_t step, int threads) {
  for_all(lines, threads, [&](std::size_t line) {
    std::vector<std::array<double, 3>> out(places);
    const auto count = static_cast<long>(places);
    for (std::size_t place = 0; place < places; ++place)
      for (long k = 1 - static_cast<long>(half.size()); k < static_cast<long>(half.size()); ++k) {
        const std::size_t from = mirrored(static_cast<long>(place) + k, count);
        const auto& light = layer[line * line_step + from * step];
        const double weight = half[static_cast<std::size_t>(std::abs(k))];
        for (std::size_t c = 0; c < light.size(); ++c) out[place][c] += weight * light[c];
      }
    for (std::size_t place = 0; place < places; ++place)
      layer[line * line_step + place * step] = out[place];
  });
}

}  // namespace

LightFrame scattered_forwards(const LightFrame& light, const ForwardScatter& scatter,
                              const Pinhole& camera, const FrameHits& hits,
                              double attenuation_per_m, int threads) {
  const auto wide = static_cast<std::size_t>(light.wide);
  const auto high = static_cast<std::size_t>(light.high);
  // By the level's number, from 1: 0 stays where it is.
  const double widest_px = camera.focal_u() * scatter.spread_rad * std::sqrt(most_optical_way);
  const auto width_of = [&](std::size_t level) {
    return widest_px * static_cast<double>(level) / static_cast<double>(levels);
  };
  std::vector<Layer> layers(levels + 1, Layer(light.light.size()));
  std::vector<double> most(levels + 1, 0.0);
  for (std::size_t at = 0; at < light.light.size(); ++at) {
    const double way =
        hits.is_hit(at) ? std::min(most_optical_way, attenuation_per_m * hits.range_m[at]) : 0;
    const double share = 1 - fading(scatter.per_length * way);
    const double width_px = camera.focal_u() * scatter.spread_rad * std::sqrt(way);
    const auto below = static_cast<std::size_t>(
        std::min(static_cast<double>(levels - 1),
                 widest_px > 0 ? width_px / widest_px * static_cast<double>(levels) : 0.0));
    const double narrow = width_of(below), broad = width_of(below + 1);
    const double of_broad =
        broad > narrow ? (width_px * width_px - narrow * narrow) / (broad * broad - narrow * narrow)
                       : 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto whole = static_cast<double>(light.light[at][c]);
      layers[0][at][c] += (1 - share) * whole;
      layers[below][at][c] += share * (1 - of_broad) * whole;
      layers[below + 1][at][c] += share * of_broad * whole;
    }
    most[below] = std::max(most[below], share * (1 - of_broad));
    most[below + 1] = std::max(most[below + 1], share * of_broad);
  }
  for (std::size_t level = 1; level <= levels; ++level) {
    if (!(most[level] > 0)) continue;
    const std::vector<double> half = half_kernel(width_of(level));
    lay_out(layers[level], half, high, wide, wide, 1, threads);
    lay_out(layers[level], half, wide, high, 1, wide, threads);
  }
  LightFrame out = light;
  for (std::size_t at = 0; at < light.light.size(); ++at)
    for (std::size_t c = 0; c < 3; ++c) {
      double sum = 0;
      for (const Layer& layer : layers) sum += layer[at][c];
      out.light[at][c] = static_cast<float>(sum);
    }
  return out;
}

}  // namespace slackwater::twin
