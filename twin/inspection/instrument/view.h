#pragma once
#include <cstdint>
#include <vector>

#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/instrument/look.h"
#include "twin/inspection/instrument/view_index.h"

namespace slackwater::twin {

/// A surface as it is looked at: all of one run, and none of it changes.
struct ViewedSurface {
  const Surface& surface;
  const ViewIndex& index;   ///< of the surface
  const RayCaster& caster;  ///< the surface and whatever else stands about
  std::uint32_t mesh = 0;   ///< which of the caster's the surface is
};

/// How many rays a look may cost.
struct RayBudget {
  std::size_t most_rays = 2000;
  std::uint64_t look = 0;  ///< its number, so that each look leaves out others
};

struct SeenPatch {
  std::uint32_t patch = 0;
  LookQuality quality;
  double share = 1;  ///< when on the way from the pose before, 0, to the pose now, 1
};

/// What a look needs beside its answer; kept from look to look it asks nothing of the heap.
struct ViewScratch {
  std::vector<SeenPatch> candidates;
  std::size_t rays = 0;  ///< that the look cast
};

/// Which patches an instrument sees in one look, and how well.
///
/// A patch is a candidate where the footprint holds its centre and the centre is in range, faces
/// the instrument and is not dark (`quality_of`); it is seen where nothing stands between. The ray
/// to its centre stops 1/20 of the patch's longer side short of it, so that the patch does not hide
/// itself.
///
/// - frame, round: as they are at the pose now.
/// - fan: swept from the pose before to the pose now. A patch is crossed where its way ahead of the
///   fan changes sign, and is measured once, from the pose between, in proportion. Nothing is swept
///   where the fan turned by more than 60 degrees from look to look.
/// - spot: the patch that the axis meets, measured where it meets it, and with it those whose
///   middles are as near as the reading speaks for.
///
/// With more candidates than rays, n > m, the look casts at the candidates floor(k n/m) + look
/// (mod n), k = 0 ... m - 1, in the order of the index, in which neighbours are near each other:
/// the rays lie about evenly, and n/m looks cast at all of them. A fan crosses a patch but once:
/// whoever sweeps with few rays takes large patches.
///
/// @param before  where the last look was taken from; of the first look, `now`
/// @param seen    replaced; in the order of the index
void view(const Instrument& instrument, const Pose& before, const Pose& now,
          const ViewedSurface& viewed, const Clarity& clarity, const RayBudget& budget,
          ViewScratch& scratch, std::vector<SeenPatch>& seen);

}  // namespace slackwater::twin
