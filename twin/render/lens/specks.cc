#include "twin/render/lens/specks.h"

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "twin/render/light/fading.h"

namespace slackwater::twin {
namespace {

/// Knuth's product of even numbers, in steps that no exponential leaves the range of.
std::size_t poisson(double mean, Rng& rng) {
  constexpr double most_of_step = 50;
  std::size_t count = 0;
  while (mean > 0) {
    const double ends = fading(std::min(mean, most_of_step));
    mean -= most_of_step;
    for (double product = 1 - rng.uniform(); product > ends; product *= 1 - rng.uniform()) ++count;
  }
  return count;
}

}  // namespace

double volume_in_view_m3(const Pinhole& camera, double near_m, double far_m) noexcept {
  return camera.wide() / camera.focal_u() * (camera.high() / camera.focal_v()) *
         (far_m * far_m * far_m - near_m * near_m * near_m) / 3;
}

std::vector<Speck> specks_in_view(const Specks& specks, const Pinhole& camera, std::uint64_t seed,
                                  const char* stream) {
  Rng rng(seed, stream);
  const double near = specks.nearest_m * specks.nearest_m * specks.nearest_m;
  const double far = specks.reach_m * specks.reach_m * specks.reach_m;
  std::vector<Speck> seen(
      poisson(specks.per_m3 * volume_in_view_m3(camera, specks.nearest_m, specks.reach_m), rng));
  for (Speck& speck : seen) {
    speck.u = rng.uniform(0, camera.wide());
    speck.v = rng.uniform(0, camera.high());
    speck.depth_m = std::cbrt(rng.uniform(near, far));
  }
  return seen;
}

SpeckDisc::SpeckDisc(const Pinhole& camera, const Speck& speck, double diameter_m)
    : wide_(camera.wide()),
      high_(camera.high()),
      column_(static_cast<int>(speck.u)),
      row_(static_cast<int>(speck.v)),
      u_(speck.u),
      v_(speck.v) {
  const double radius_px = 0.5 * camera.focal_u() * diameter_m / speck.depth_m;
  drawn_px_ = std::max(0.5, radius_px);
  reach_ = static_cast<int>(std::ceil(drawn_px_ + 0.5));
  double all = 0;
  for (int j = row_ - reach_; j <= row_ + reach_; ++j)
    for (int i = column_ - reach_; i <= column_ + reach_; ++i) all += covered(i, j);
  scale_ = constants::pi * radius_px * radius_px / all;
}

}  // namespace slackwater::twin
