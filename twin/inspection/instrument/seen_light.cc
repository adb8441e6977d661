#include "twin/inspection/instrument/seen_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "twin/inspection/instrument/clarity.h"

namespace slackwater::twin {
namespace {

/// Gauss and Legendre's, of -1 to 1; the other four lie across 0.
struct Node {
  double at;
  double weight;
};
constexpr std::array nodes{
    Node{0.1834346424956498, 0.3626837833783620}, Node{0.5255324099163290, 0.3137066458778873},
    Node{0.7966664774136267, 0.2223810344533745}, Node{0.9602898564975363, 0.1012285362903763}};

/// Light of the place and of the water before it.
struct Shares {
  double place = 0;
  double veil = 0;

  [[nodiscard]] SeenLight seen() const noexcept {
    const double all = place + veil;
    return {std::min(1.0, all), all > 0 ? place / all : 0};
  }
  /// Contrast times light.
  [[nodiscard]] double shows() const noexcept { return place / std::max(1.0, place + veil); }
};

double lamp_on_place(const Instrument& instrument, double c, double range_m) noexcept {
  const double from_lamp_m = std::hypot(range_m, instrument.lamp_aside_m);
  const double share = instrument.lamp_range_m / from_lamp_m;
  return share * share * (range_m / from_lamp_m) * transmission(c, from_lamp_m);
}

double lamp_on_water(const Instrument& instrument, const Clarity& clarity,
                     double range_m) noexcept {
  if (!(clarity.backscatter_per_m > 0)) return 0;
  return instrument.lamp_range_m * instrument.lamp_range_m * clarity.backscatter_per_m /
         (2 * usual_reflectance) *
         lamp_veil_per_m(clarity.beam_attenuation_per_m, instrument.lamp_aside_m, range_m);
}

}  // namespace

SeenLight seen_light(const Instrument& instrument, const Clarity& clarity, double depth_m,
                     double range_m) noexcept {
  if (!works_by_light(instrument.kind)) return {};
  const double c = clarity.beam_attenuation_per_m;
  const double left = transmission(c, range_m);
  if (instrument.kind == InstrumentKind::lidar) return {1, left * left};
  if (!instrument.needs_light) return {1, left};
  const double day =
      clarity.daylight * transmission(clarity.diffuse_attenuation_per_m, std::max(depth_m, 0.0));
  const Shares by_day{day * left, day * (1 - left)};
  if (!(instrument.lamp_range_m > 0)) return by_day.seen();
  const Shares by_both{by_day.place + lamp_on_place(instrument, c, range_m) * left,
                       by_day.veil + lamp_on_water(instrument, clarity, range_m)};
  return (by_both.shows() > by_day.shows() ? by_both : by_day).seen();
}

double lamp_veil_per_m(double beam_attenuation_per_m, double aside_m, double range_m) noexcept {
  // With p = s + s_l, dp = p / s_l ds: 2 (p^2 - h^2) / (p^2 + h^2)^2 exp(-c p) dp.
  const double h2 = aside_m * aside_m;
  const double first = std::log(aside_m);
  const double half = 0.5 * (std::log(range_m + std::hypot(range_m, aside_m)) - first);
  double sum = 0;
  for (const Node& node : nodes)
    for (const double at : {-node.at, node.at}) {
      const double p = std::exp(first + half * (1 + at));
      const double around = p * p + h2;
      sum += node.weight * 2 * (p * p - h2) * p / (around * around) *
             transmission(beam_attenuation_per_m, p);
    }
  return half * sum;
}

bool is_lost(double contrast) noexcept {
  constexpr double rounding = 1e-12;
  return contrast < black_disc_contrast * (1 - rounding);
}

}  // namespace slackwater::twin
