#include "twin/render/light/growth.h"

#include "fields/base/numbers/random.h"
#include "twin/render/light/albedo.h"

namespace slackwater::twin {
namespace {

constexpr double deepest_m = 20, patch_m = 0.7, stretch_m = 1.1;

Bands between(const Bands& a, const Bands& b, double share) noexcept {
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])};
}

Bands colour_of(const Triple<double>& at_m, std::uint64_t seed) noexcept {
  const std::uint64_t kinds = split_mix_64(seed ^ 0x51ED), within = split_mix_64(seed ^ 0x6A0B);
  const double kind = value_noise(at_m, stretch_m, kinds);
  if (kind < 0.45) return albedo_of(Material::growth, at_m, seed);
  if (kind < 0.52)  // mussels
    return between({0.015, 0.016, 0.02}, {0.09, 0.09, 0.10},
                   step_between(0.35, 0.75, value_noise(at_m, 0.02, within)));
  if (kind < 0.58)  // soft growth
    return between({0.09, 0.06, 0.035}, {0.36, 0.24, 0.14},
                   step_between(0.3, 0.7, value_noise(at_m, 0.06, within)));
  return between({0.10, 0.10, 0.08}, {0.46, 0.44, 0.38},  // barnacles
                 step_between(0.5, 0.6, value_noise(at_m, 0.015, within)));
}

}  // namespace

Growth growth_at(const Triple<double>& at_m, double amount, std::uint64_t seed) noexcept {
  if (!(at_m.z > 0) || at_m.z > deepest_m || !(amount > 0)) return {};
  const double bare = 0.95 - amount + 0.2 * at_m.z / deepest_m;
  const double share =
      step_between(bare, bare + 0.12, value_noise(at_m, patch_m, split_mix_64(seed ^ 0x6707)));
  if (!(share > 0)) return {};
  return {share, colour_of(at_m, seed)};
}

}  // namespace slackwater::twin
