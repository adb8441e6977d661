#include "twin/inspection/instrument/view.h"

#include <algorithm>
#include <cmath>

#include "twin/inspection/instrument/footprint.h"
#include "twin/inspection/instrument/quality.h"

namespace slackwater::twin {
namespace {

/// One look, on its way to its candidates.
struct Look {
  const Instrument& instrument;
  Pose before;
  const Pose& now;
  const Surface& surface;
  const ViewIndex& index;
  const Clarity& clarity;
  std::vector<SeenPatch>& candidates;

  void add(std::uint32_t patch, const Pose& pose, double share) const {
    const Patch& p = surface.patches[patch];
    if (const auto quality = quality_of(instrument, pose, clarity, p.centre_m, p.normal))
      candidates.push_back({patch, *quality, share});
  }
  /// Visits the patches of all blocks that `may_hold` lets pass.
  template <typename MayHold, typename Visit>
  void for_patches(double slack_m, const MayHold& may_hold, const Visit& visit) const {
    for (const ViewIndex::Block& block : index.blocks) {
      const double off_m = length_of(block.centre_m - now.position_m);
      if (off_m - block.radius_m - slack_m > instrument.most_range_m) continue;
      if (off_m + block.radius_m + slack_m < instrument.least_range_m) continue;
      if (!may_hold(block)) continue;
      for (std::uint32_t i = block.first; i < block.end; ++i) visit(index.patches[i]);
    }
  }
};

void gather(const FrameFootprint& frame, const Look& look) {
  look.for_patches(
      0,
      [&](const ViewIndex::Block& block) {
        return may_hold(frame, look.now, block.centre_m, block.radius_m);
      },
      [&](std::uint32_t patch) {
        if (holds(frame, look.now, look.surface.patches[patch].centre_m))
          look.add(patch, look.now, 1);
      });
}

void gather(const RoundFootprint& /*round*/, const Look& look) {
  look.for_patches(
      0, [](const ViewIndex::Block&) { return true; },
      [&](std::uint32_t patch) { look.add(patch, look.now, 1); });
}

void gather(const FanFootprint& fan, const Look& look) {
  Pose before = look.before;
  const Pose& now = look.now;
  // A fan has no front: one that is turned about its axis is the same.
  if (dot(before.right, now.right) < 0) before.right = -1.0 * before.right;
  constexpr double most_turned_cosine = 0.5;
  if (dot(before.axis, now.axis) < most_turned_cosine ||
      dot(before.right, now.right) < most_turned_cosine)
    return;
  look.for_patches(
      length_of(now.position_m - before.position_m),
      [&](const ViewIndex::Block& block) {
        const double a = ahead_of_fan_m(before, block.centre_m);
        const double b = ahead_of_fan_m(now, block.centre_m);
        return !(std::min(a, b) > block.radius_m || std::max(a, b) < -block.radius_m);
      },
      [&](std::uint32_t patch) {
        const Triple<double>& centre_m = look.surface.patches[patch].centre_m;
        const double a = ahead_of_fan_m(before, centre_m);
        const double b = ahead_of_fan_m(now, centre_m);
        if ((a > 0) == (b > 0)) return;
        const double share = a / (a - b);
        const Pose pose = pose_between(before, now, share);
        if (holds(fan, pose, centre_m)) look.add(patch, pose, share);
      });
}

/// One reading: it stands for all patches of the surface about the place that is touched.
void touch(const SpotFootprint& spot, const Look& look, const ViewedSurface& viewed,
           std::vector<SeenPatch>& seen) {
  const Ray ray{look.now.position_m, look.now.axis};
  const auto hit = viewed.caster.first_hit(ray, look.instrument.most_range_m);
  if (!hit || hit->mesh != viewed.mesh) return;
  const std::uint32_t touched = viewed.surface.patch_of[hit->triangle];
  if (touched == no_patch) return;
  const Triple<double> at_m = ray.from_m + hit->range_m * ray.direction;
  const auto quality = quality_of(look.instrument, look.now, look.clarity, at_m,
                                  viewed.surface.patches[touched].normal);
  if (!quality) return;
  seen.push_back({touched, *quality, 1});
  for (const ViewIndex::Block& block : look.index.blocks) {
    if (length_of(block.centre_m - at_m) - block.radius_m > spot.speaks_for_m) continue;
    for (std::uint32_t i = block.first; i < block.end; ++i) {
      const std::uint32_t patch = look.index.patches[i];
      const Triple<double>& centre_m = viewed.surface.patches[patch].centre_m;
      if (patch != touched && length_of(centre_m - at_m) <= spot.speaks_for_m)
        seen.push_back({patch, *quality, 1});
    }
  }
}

bool is_hidden(const Look& look, const SeenPatch& candidate, const RayCaster& caster) {
  const Patch& patch = look.surface.patches[candidate.patch];
  const Triple<double> from_m =
      look.before.position_m + candidate.share * (look.now.position_m - look.before.position_m);
  const double range_m = candidate.quality.range_m;
  const double short_m = std::max<double>(patch.width_m, patch.height_m) / 20;
  const Ray ray{from_m, (1 / range_m) * (patch.centre_m - from_m)};
  return caster.is_blocked(ray, range_m - short_m);
}

}  // namespace

void view(const Instrument& instrument, const Pose& before, const Pose& now,
          const ViewedSurface& viewed, const Clarity& clarity, const RayBudget& budget,
          ViewScratch& scratch, std::vector<SeenPatch>& seen) {
  scratch.candidates.clear();
  seen.clear();
  const Look look{instrument,        before, now, viewed.surface, viewed.index, clarity,
                  scratch.candidates};
  if (const auto* spot = std::get_if<SpotFootprint>(&instrument.footprint)) {
    scratch.rays = 1;
    touch(*spot, look, viewed, seen);
    return;
  }
  if (const auto* frame = std::get_if<FrameFootprint>(&instrument.footprint)) gather(*frame, look);
  if (const auto* fan = std::get_if<FanFootprint>(&instrument.footprint)) gather(*fan, look);
  if (const auto* round = std::get_if<RoundFootprint>(&instrument.footprint)) gather(*round, look);
  const std::size_t n = scratch.candidates.size();
  const std::size_t m = std::min(n, budget.most_rays);
  scratch.rays = m;
  for (std::size_t k = 0; k < m; ++k) {
    const SeenPatch& candidate = scratch.candidates[m == n ? k : (k * n / m + budget.look % n) % n];
    if (!is_hidden(look, candidate, viewed.caster)) seen.push_back(candidate);
  }
}

}  // namespace slackwater::twin
